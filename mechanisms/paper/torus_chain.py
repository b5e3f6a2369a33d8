#!/usr/bin/env python3
"""Writes the torus chain of Fig. 5b (Guenter and Lee, "Symbolic Lagrangian multibody dynamics") for any number of tori.

    torus_chain.py COORDINATES [--linked] > torus_chain.yaml

In: the number of coordinates, 2 + 4 n: 6, 10, 14, ... Out: a description, on standard output. The first torus touches a frame at
rest: eq. (15) with S1 fixed, so that two coordinates are left. Each further torus touches the one before, eq. (15) with two
coordinates on each surface, and has the opposite normal (flip). With --linked the rings hang in each other like the links of a
chain: they touch on the inside, a quarter turn apart.
"""
import argparse
import sys

SURFACE = "point: [(R + r*cos({v}))*cos({u}), (R + r*cos({v}))*sin({u}), r*sin({v})], along: [{u}, {v}]"
COLORS = ("0.93, 0.72, 0.2", "0.8, 0.25, 0.2", "0.25, 0.45, 0.75", "0.3, 0.6, 0.35")


def surface(u, v, flip):
    return "surface: {" + SURFACE.format(u=u, v=v) + (", flip: true" if flip else "") + "}"


def torus_chain(coordinates, linked):
    tori = 1 + (coordinates - 2) // 4
    side = "pi + " if linked else ""  # v on the side that touches
    # (u, v) on the torus before, (w, x) on the torus itself; a little off the state of rest
    lines = [
        "# Fig. 5b of Guenter and Lee, \"Symbolic Lagrangian multibody dynamics\": a chain of tori, each in sliding contact with the one",
        "# before (eq. 15), the first with a point at rest. Written by torus_chain.py %d%s." % (coordinates, " --linked" if linked else ""),
        "alembert: 1",
        "name: torus_chain_%s%d" % ("linked_" if linked else "", coordinates),
        "description: Chain of %d %s, %d coordinates."
        % (tori, ("linked rings" if linked else "tori in contact") if tori > 1 else "torus", coordinates),
        "gravity: [0, 0, -9.81]",
        "",
        "parameters:",
        "  R: 0.5      # m, radius of the centre line",
        "  r: 0.12     # m, radius of the tube",
        "  m: 1.4",
        "",
        "coordinates:",
        "  - {name: w1, initial: 0.4}",
        "  - {name: x1, initial: %s0.5}" % side,
    ]
    for k in range(2, tori + 1):
        lines += [
            "  - {name: u%d, initial: pi + 0.1}" % k,
            "  - {name: v%d, initial: %s%s}" % (k, side, "0.3" if k % 2 == 0 else "(-0.3)" if linked else "-0.3"),
            "  - {name: w%d, initial: 0.2}" % k,
            "  - {name: x%d, initial: %s0}" % (k, side),
        ]
    lines += ["", "bodies:", "  - name: peg", "    geometry:"]
    if linked:
        lines += [
            "      - {cylinder: {radius: 0.04, length: 0.5}, transform: [{translate: [0, 0, -0.04]}, {rotate: {axis: x, angle: pi/2}}], "
            "color: [0.25, 0.27, 0.3]}"
        ]
    else:
        lines += ["      - {sphere: 0.05, transform: [{translate: [0, 0, 0.05]}], color: [0.25, 0.27, 0.3]}"]
    for k in range(1, tori + 1):
        lines += ["  - name: torus%d" % k]
        if k == 1:
            lines += ["    transform:"]
            if linked:
                lines += ["      - rotate: {axis: x, angle: pi}      # it hangs from its inside"]
            lines += ["      - inverse: [{%s}]" % surface("w1", "x1", False)]
        else:
            lines += [
                "    parent: torus%d" % (k - 1),
                "    transform:",
                "      - mate:",
                "          - %s" % surface("u%d" % k, "v%d" % k, False),
                "          - %s" % surface("w%d" % k, "x%d" % k, True),
            ]
            if linked:
                lines += ["        spin: pi/2"]
        lines += [
            "    mass: m",
            "    inertia: {xx: m*(R^2/2 + 5/8*r^2), yy: m*(R^2/2 + 5/8*r^2), zz: m*(R^2 + 3/4*r^2)}",
            "    geometry:",
            "      - {torus: {radius: R, tube: r}, color: [%s]}" % COLORS[k % 4],
            "      - {sphere: 0.04, transform: [{translate: [0, R, r]}], color: [0.25, 0.27, 0.3]}",
        ]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Writes a chain of tori as a description for alembert.")
    parser.add_argument("coordinates", type=int, help="2, 6, 10, 14, ...")
    parser.add_argument("--linked", action="store_true", help="rings that hang in each other")
    arguments = parser.parse_args()
    if arguments.coordinates < 2 or arguments.coordinates % 4 != 2:
        parser.error("the number of coordinates must be 2, 6, 10, 14, ...")
    sys.stdout.write(torus_chain(arguments.coordinates, arguments.linked))


if __name__ == "__main__":
    main()
