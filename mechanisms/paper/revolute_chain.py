#!/usr/bin/env python3
"""Writes a general chain of revolute joints for any number of links, as mechanisms/chain6r.yaml is for six.

    revolute_chain.py LINKS > revolute_chain.yaml

In: the number of links, 1 to 1000. Out: a description, on standard output; the same for the same number always, and the first
links of a longer chain are those of a shorter one, but for the offset of the last. Frames are modified Denavit-Hartenberg ones
(turn and shift along x, then turn and shift along z): between neighbouring axes a generic twist and length, on the inner axes an
offset, generic centres of mass and full inertias. Gravity lies along axis 1.
"""
import argparse
import random
import sys


def link(k, last):
    """One link's geometry and mass. Its principal moments satisfy the triangle inequality by a margin that products of
    inertia of this size cannot use up."""
    draw = random.Random(1000 + k)
    lines = ["  - name: link%d" % k]
    if k > 1:
        lines += ["    parent: link%d" % (k - 1)]
    lines += ["    transform:"]
    twist, length, offset = draw.uniform(0.3, 1.2), draw.uniform(0.2, 0.9), draw.uniform(0.2, 0.8)
    if k > 1:
        lines += ["      - rotate: {axis: x, angle: %.3f}" % twist, "      - translate: [%.3f, 0, 0]" % length]
    lines += ["      - joint: {type: revolute, axis: z, coordinates: [q%d]}" % k]
    if 1 < k and not last:
        lines += ["      - translate: [0, 0, %.3f]" % offset]
    size = draw.uniform(0.15, 0.3)
    diagonal = [size * draw.uniform(0.8, 1.2) for _ in range(3)]
    products = [size * draw.uniform(0.05, 0.15) * draw.choice((-1, 1)) for _ in range(3)]
    lines += [
        "    mass: %.2f" % draw.uniform(1, 5),
        "    com: [%.3f, %.3f, %.3f]" % tuple(draw.uniform(0.02, 0.3) * draw.choice((-1, 1)) for _ in range(3)),
        "    inertia: {xx: %.4f, yy: %.4f, zz: %.4f, xy: %.4f, xz: %.4f, yz: %.4f}" % tuple(diagonal + products),
    ]
    return lines


def revolute_chain(links):
    lines = [
        "# General chain of %d revolute joints, written by revolute_chain.py %d." % (links, links),
        "alembert: 1",
        "name: revolute_chain_%d" % links,
        "description: General chain of revolute joints, with generic twists, lengths, offsets and full inertias.",
        "gravity: [0, 0, -9.81]",
        "",
        "coordinates:",
    ]
    lines += ["  - q%d" % k for k in range(1, links + 1)]
    lines += ["", "bodies:"]
    for k in range(1, links + 1):
        lines += link(k, k == links)
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Writes a general chain of revolute joints as a description for alembert.")
    parser.add_argument("links", type=int, help="1 to 1000")
    arguments = parser.parse_args()
    if not 1 <= arguments.links <= 1000:
        parser.error("the number of links must be 1 to 1000")
    sys.stdout.write(revolute_chain(arguments.links))


if __name__ == "__main__":
    main()
