#!/usr/bin/env python3
"""Writes report.md: every table and figure of section 6 of Guenter and Lee, and Fig. 8, made anew.

Called by the CMake target `reproduce`. Exit code 1 if a claim falls short.
"""

import argparse
import sys
import time
from pathlib import Path

import counts
import motion
import timing


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("alembert", "mechanisms", "out"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("--measure", type=Path, help="the program measure_chains; no times without it")
    parser.add_argument("--seconds", type=float, default=60, help="length of the simulations")
    parser.add_argument("--samples", type=int, default=20, help="states of each motion at which a tangent step is tried")
    parser.add_argument("--largest", type=int, default=60, help="no chains of more coordinates")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()

    def progress(what):
        print(f"[{time.monotonic() - started:6.1f} s] {what}", file=sys.stderr, flush=True)

    counter = counts.Counter(arguments.alembert, arguments.mechanisms)
    lines = ["# What the paper shows, shown again", ""]
    lines += ["Made by `cmake --workflow --preset reproduce`. Operations are multiplications and additions as `alembert report` counts them."]
    lines += ["The paper: B. Guenter and S.-H. Lee, *Symbolic Lagrangian Multibody Dynamics*.", ""]
    progress("Table 1")
    lines += counts.table_1(counter)
    lines += counts.figures(counter, arguments.out, arguments.largest, progress)
    if arguments.measure:
        progress("times")
        lines += timing.section(arguments.measure, arguments.out)
    lines += motion.section(arguments.alembert, arguments.mechanisms / "paper", arguments.seconds, arguments.samples, arguments.out, progress)

    report = arguments.out / "report.md"
    report.write_text("\n".join(lines) + "\n")
    short = [line for line in lines if "**Falls short**" in line]
    print("\n".join(short) if short else "every claim holds")
    print(f"report: {report}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
