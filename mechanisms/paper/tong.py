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
"""

BAR = """\
    mass: m
    inertia: {xx: m*0.00003, yy: m*h^2/3, zz: m*h^2/3}
"""


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
  - name: b1
    transform:
      - rotate: {axis: y, angle: tilt}
      - rotate: {axis: y, angle: q}
"""
    text += BAR
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
            text += BAR
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
