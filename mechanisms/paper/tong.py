#!/usr/bin/env python3
"""Writes the tong of Fig. 5d (Guenter and Lee, "Symbolic Lagrangian multibody dynamics") for any number of crossings.

    tong.py [CROSSINGS] > tong.yaml

In: the number of crossings of two bars, 16 unless given. Out: a description, on standard output. The bars form two zigzag chains of
joints, each angle a function of one coordinate; the loops between the chains close by themselves.
"""
import argparse
import sys

HEAD = """\
# Fig. 5d of Guenter and Lee, "Symbolic Lagrangian multibody dynamics": a tong. {bodies} bars cross in pairs; every joint between them turns
# by twice the one coordinate q, so that all loops close: bar k of one zigzag has the angle q, that of the other -q, and both centres
# are the same point. Counted as constraints on {bodies} hinges these are {loops}: two for each of {inner} rhombi, and one that
# opens the first pair evenly. A fish hangs from the tip by a universal joint: three coordinates. A weighted grip on the first
# bar balances the tong, which sways about an opening of half a radian. Written by tong.py.
alembert: 1
name: tong
description: Scissor linkage of {bodies} bars driven by one coordinate, with a fish on a universal joint at its tip.
gravity: [0, 0, -9.81]

parameters:
  h: 0.12        # m, half the length of a bar
  m: 0.2         # kg, a bar
  tilt: 0.15     # the tong points down by this angle
  grip: 3.0      # kg, weight on the first bar ...
  arm: 0.5       # ... and its distance from the pivot
  reach: 0.16    # m, from the fish's mouth to its centre of mass
  fish_mass: 0.9

coordinates:
  - {{name: q, initial: 0.95}}
  - {{name: fish_roll, initial: 0.5}}
  - {{name: fish_pitch, initial: -0.7}}

bodies:
  - name: pivot
    geometry:
      - {{cylinder: {{radius: 0.02, length: 0.09}}, transform: [{{rotate: {{axis: x, angle: pi/2}}}}], color: [0.25, 0.27, 0.3]}}
"""

BAR = """\
    mass: m
    inertia: {xx: m*0.00003, yy: m*h^2/3, zz: m*h^2/3}
"""
# The two bars of a crossing lie beside each other.
SHAPE = """\
    geometry:
      - {box: [2*h + 0.03, 0.016, 0.026], transform: [{translate: [0, %s, 0]}], color: [%s]}
"""
A, B = ("-0.01", "0.62, 0.65, 0.7"), ("0.01", "0.93, 0.72, 0.2")


def tong(crossings):
    text = HEAD.format(bodies=2 * crossings, loops=2 * (crossings - 1) + 1, inner=crossings - 1)
    text += """\
  - name: a1
    transform:
      - rotate: {axis: y, angle: tilt}
      - rotate: {axis: y, angle: -q}
    mass: m + grip
    com: [-grip*arm/(m + grip), 0, 0]
    inertia: {xx: 0.002, yy: m*h^2/3 + m*grip/(m + grip)*arm^2, zz: m*h^2/3 + m*grip/(m + grip)*arm^2}
"""
    text += SHAPE % A
    text += """\
      - {box: [arm, 0.02, 0.03], transform: [{translate: [-arm/2, -0.01, 0]}], color: [0.62, 0.65, 0.7]}
      - {sphere: 0.06, transform: [{translate: [-arm, -0.01, 0]}], color: [0.25, 0.27, 0.3]}
  - name: b1
    transform:
      - rotate: {axis: y, angle: tilt}
      - rotate: {axis: y, angle: q}
"""
    text += BAR + SHAPE % B
    for k in range(2, crossings + 1):
        for bar, before, angle in (("a", "b", "-2*q"), ("b", "a", "2*q")):
            text += """\
  - name: %s%d
    parent: %s%d
    transform:
      - translate: [h, 0, 0]
      - rotate: {axis: y, angle: %s}
      - translate: [h, 0, 0]
""" % (bar, k, before, k - 1, angle)
            text += BAR + SHAPE % (A if bar == "a" else B)
    text += """\
  - name: fish
    parent: b%d
    transform:
      - translate: [h, 0, 0]
      - rotate: {axis: y, angle: -q - tilt}     # upright again, at the end of the last bar
      - joint: {type: universal, coordinates: [fish_roll, fish_pitch]}
    mass: fish_mass
    com: [0, 0, -reach]
    inertia: {xx: fish_mass*0.0065, yy: fish_mass*0.0072, zz: fish_mass*0.0012}
    geometry:
      - {ellipsoid: [0.065, 0.035, 0.15], transform: [{translate: [0, 0, -reach]}], color: [0.9, 0.5, 0.2]}
      - {ellipsoid: [0.075, 0.008, 0.04], transform: [{translate: [0, 0, -reach - 0.17]}], color: [0.9, 0.5, 0.2]}
      - {ellipsoid: [0.05, 0.008, 0.03], transform: [{translate: [0.07, 0, -reach]}], color: [0.8, 0.4, 0.15]}
      - {sphere: 0.012, transform: [{translate: [0.022, 0.026, -0.06]}], color: [0.1, 0.1, 0.1]}
      - {sphere: 0.012, transform: [{translate: [0.022, -0.026, -0.06]}], color: [0.1, 0.1, 0.1]}
""" % crossings
    return text


def main():
    parser = argparse.ArgumentParser(description="Writes a tong as a description for alembert.")
    parser.add_argument("crossings", type=int, nargs="?", default=16, help="of two bars; 16 unless given")
    arguments = parser.parse_args()
    if arguments.crossings < 1:
        parser.error("the number of crossings must be at least 1")
    sys.stdout.write(tong(arguments.crossings))


if __name__ == "__main__":
    main()
