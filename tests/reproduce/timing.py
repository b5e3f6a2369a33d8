"""Time of the motion equations and of the Cholesky solve: section 6 of Guenter and Lee.

In: the program measure_chains. Out: Markdown and a plot. Times are of the machine that makes the report.
"""

import json
import subprocess
from pathlib import Path

import numpy as np

from drawing import new_figure, save

# Section 6, one core of a 2.66 GHz Core 2; the solve is printed as 1.3e-3 ms. Microseconds.
PAPER_EQUATIONS, PAPER_SOLVE, PAPER_CROSSING = 20.0, 1.3, 200


def crossing(sizes, equations, solve):
    """Coordinates at which the solve takes as long as the equations: a quadratic and a cubic through the times."""
    quadratic = np.polyfit(sizes, equations, 2, w=1 / np.asarray(equations))
    cubic = np.polyfit(sizes, solve, 3, w=1 / np.asarray(solve))
    n = np.arange(2, 2001)
    above = n[np.polyval(cubic, n) > np.polyval(quadratic, n)]
    return (int(above[0]) if len(above) else None), quadratic, cubic


def section(measure: Path, out: Path) -> list:
    rows = json.loads(subprocess.run([measure], check=True, capture_output=True, text=True).stdout)
    sizes = [row["coordinates"] for row in rows]
    equations = [row["equations"] / 1000 for row in rows]
    solve = [row["solve"] / 1000 for row in rows]
    lines = ["## Time of the torus chains", "", "Medians on the machine that made this report, double precision, one thread.", ""]
    lines += ["| coordinates | M and c, us | Cholesky solve, us |", "| --- | --- | --- |"]
    lines += [f"| {n} | {e:.3f} | {s:.3f} |" for n, e, s in zip(sizes, equations, solve)]
    meet, quadratic, cubic = crossing(sizes, equations, solve)
    at14 = sizes.index(14)
    lines += [
        "",
        f"- Chain of 14: {equations[at14]:.2f} us for the motion equations and {solve[at14]:.2f} us for the solve "
        f"(the paper: {PAPER_EQUATIONS:g} and {PAPER_SOLVE:g} us on one core of a 2.66 GHz Core 2).",
    ]
    if meet is None:
        lines.append("- The solve stays below the equations up to 2,000 coordinates, by the curves fitted.")
    else:
        how = "measured range" if meet <= max(sizes) else "extrapolated"
        lines.append(f"- The solve takes as long as the equations at about {meet} coordinates ({how}; the paper estimates {PAPER_CROSSING} for its longer equations).")
    axes, figure = new_figure()
    dense = np.linspace(min(sizes), max(sizes), 200)
    for times, curve, label in ((equations, quadratic, "M and c"), (solve, cubic, "Cholesky solve")):
        points = axes.plot(sizes, times, "o", label=label)[0]
        axes.plot(dense, np.polyval(curve, dense), "-", linewidth=1, color=points.get_color())
    axes.set(xlabel="generalized coordinates", ylabel="microseconds", yscale="log")
    axes.legend()
    save(figure, out / "time.svg")
    return lines + ["", "![time](time.svg)", ""]
