"""Operation counts against the number of coordinates: Table 1, Figs. 6 and 7 of Guenter and Lee.

In: the alembert command and the makers of chains. Out: Markdown and one SVG for each figure. Counts are deterministic.
"""

import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from drawing import new_figure, save

# Table 1: additions and multiplications of a chain of six revolute joints.
PAPER_TABLE_1 = {
    "inverse_dynamics": {"paper, best": (365, 328), "Balafoutis and Patel": (450, 386), "paper, worst": (971, 509)},
    "forward_dynamics": {"paper, best": (943, 818), "Balafoutis and Patel": (956, 790), "paper, worst": (2389, 1875)},
}
SIX_JOINTS = ("chain6r", "chain6r_90", "puma560")


@dataclass(frozen=True)
class Curve:
    """One curve of a figure: a family of chains, a function, how many coordinates, and the paper's axes."""

    figure: str
    family: str
    function: str
    sizes: tuple
    degree: int
    paper_sizes: tuple
    paper_axis: int


# What Fig. 7 counts: the equations to be solved, M and c; the solve comes on top. Forward dynamics as it is written is the
# shorter one of that and of articulated bodies.
EQUATIONS = "mass_matrix_and_bias"
SOLVED = "forward_dynamics --without articulation"
SHORTEST = "forward_dynamics"
LABELS = {"inverse_dynamics": "inverse dynamics", EQUATIONS: "M and c", SOLVED: "M, c and the solve", SHORTEST: "forward dynamics, the shorter way"}

CURVES = (
    Curve("6a", "revolute_chain", "inverse_dynamics", (*range(2, 13), 16, 20, 24, 30, 40, 50, 60), 1, (2, 12), 1800),
    Curve("6b", "torus_chain", "inverse_dynamics", tuple(range(6, 47, 4)), 1, (6, 46), 10000),
    Curve("7a", "revolute_chain", SOLVED, (*range(2, 13), 16, 20, 24, 30, 40, 50, 60), 2, (2, 12), 18000),
    Curve("7b", "torus_chain", SOLVED, tuple(range(6, 31, 4)), 2, (6, 30), 90000),
)


class Counter:
    """Runs `alembert report`, once for each mechanism and function."""

    def __init__(self, alembert: Path, mechanisms: Path):
        self.alembert = alembert
        self.mechanisms = mechanisms
        self.known = {}

    def of_file(self, path, function: str) -> dict:
        return self._report([str(path)], None, (str(path), function), function)

    def of_chain(self, family: str, size: int, function: str) -> dict:
        key = (family, size, function)
        if key in self.known:
            return self.known[key]
        maker = self.mechanisms / "paper" / f"{family}.py"
        description = subprocess.run(
            [sys.executable, maker, str(size)], check=True, capture_output=True, text=True
        ).stdout
        return self._report(["-"], description, key, function)

    def _report(self, arguments, text, key, function):
        if key not in self.known:
            command = [self.alembert, "report", *arguments, "--json", "--functions", *function.split()]
            done = subprocess.run(command, check=True, capture_output=True, text=True, input=text)
            self.known[key] = json.loads(done.stdout)["functions"][function.split()[0]]
        return self.known[key]


def operations(count: dict) -> int:
    return count["mul"] + count["add"]


def text_of(count: dict) -> str:
    divisions = f" + {count['div']} div" if count["div"] else ""
    return f"{count['mul']} x {count['add']} + = {operations(count)}{divisions}"


def table_1(counter: Counter) -> list:
    lines = ["## Table 1: a chain of six revolute joints", "", "| | inverse dynamics | forward dynamics |", "| --- | --- | --- |"]
    for name, (mul, add) in PAPER_TABLE_1["inverse_dynamics"].items():
        mul2, add2 = PAPER_TABLE_1["forward_dynamics"][name]
        lines.append(f"| {name} | {mul} x {add} + = {mul + add} | {mul2} x {add2} + = {mul2 + add2} |")
    for name in SIX_JOINTS:
        path = counter.mechanisms / f"{name}.yaml"
        row = [text_of(counter.of_file(path, f)) for f in ("inverse_dynamics", "forward_dynamics")]
        lines.append(f"| **mechanisms/{name}.yaml** | {row[0]} | {row[1]} |")
    general = operations(counter.of_file(counter.mechanisms / "chain6r.yaml", "inverse_dynamics"))
    lines += ["", verdict(general < 693, f"the general chain needs {general}, below the paper's best chain (693)"), ""]
    return lines


def fit(sizes, values, degree: int):
    """Least squares polynomial, its values, R^2 and the largest residual."""
    coefficients = np.polyfit(sizes, values, degree)
    fitted = np.polyval(coefficients, sizes)
    residual = np.asarray(values, float) - fitted
    spread = np.asarray(values, float) - np.mean(values)
    return coefficients, 1 - float(residual @ residual) / float(spread @ spread), float(np.abs(residual).max())


def polynomial(coefficients) -> str:
    powers = [f"{c:+.1f}" + ("" if p == 0 else " n" if p == 1 else f" n^{p}") for p, c in zip(range(len(coefficients) - 1, -1, -1), coefficients)]
    return " ".join(powers)


def verdict(holds: bool, what: str) -> str:
    return f"{'**Holds**' if holds else '**Falls short**'}: {what}."


def figures(counter: Counter, out: Path, largest: int, progress) -> list:
    lines = ["## Figs. 6 and 7: operations against coordinates", ""]
    for curve in CURVES:
        progress(f"Fig. {curve.figure}")
        functions = [curve.function] if curve.function == "inverse_dynamics" else [EQUATIONS, SOLVED, SHORTEST]
        sizes = [n for n in curve.sizes if n <= largest]
        axes, figure = new_figure()
        lines += [f"### Fig. {curve.figure}: {curve.family.replace('_', ' ')}, {curve.function.split()[0].replace('_', ' ')}", ""]
        for function in functions:
            values = [operations(counter.of_chain(curve.family, n, function)) for n in sizes]
            label = LABELS[function]
            axes.plot(sizes, values, "o", label=f"{label}")
            if function == SHORTEST:  # two ways: not one polynomial
                lines.append(f"- {label}:")
            else:
                coefficients, r2, worst = fit(sizes, values, 3 if function == SOLVED else curve.degree)
                dense = np.linspace(min(sizes), max(sizes), 200)
                axes.plot(dense, np.polyval(coefficients, dense), "-", linewidth=1, label=f"{polynomial(coefficients)}")
                lines.append(f"- {label}: {polynomial(coefficients)}, R^2 = {r2:.8f}, largest residual {worst:.1f} operations")
            lines.append("  - " + ", ".join(f"{n}: {v}" for n, v in zip(sizes, values)))
            if function == "inverse_dynamics":
                lines.append("  - " + verdict(r2 > 0.999, f"a straight line, R^2 = {r2:.6f} > 0.999"))
            at = dict(zip(sizes, values))
            if curve.figure == "6b" and 46 in at:
                lines.append("  - " + verdict(at[46] < 5000, f"46 coordinates need {at[46]} operations, below 5,000"))
            if curve.figure == "7b" and function == EQUATIONS and 30 in at:
                lines.append("  - " + verdict(at[30] < 20000, f"M and c of 30 coordinates need {at[30]} operations, below 20,000"))
        axes.axhline(curve.paper_axis, color="0.5", linestyle="--", linewidth=1, label=f"end of the paper's axis: {curve.paper_axis:,}")
        axes.axvspan(*curve.paper_sizes, color="0.5", alpha=0.08, label=f"the paper's coordinates: {curve.paper_sizes[0]} to {curve.paper_sizes[1]}")
        axes.set(xlabel="generalized coordinates", ylabel="multiplications and additions", ylim=(0, None))
        axes.legend(fontsize=7)
        name = f"figure_{curve.figure}.svg"
        save(figure, out / name)
        lines += ["", f"![Fig. {curve.figure}]({name})", ""]
    return lines
