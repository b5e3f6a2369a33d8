"""Large steps: Fig. 8 of Guenter and Lee, and the same for every mechanism of mechanisms/paper.

A step in the coordinates leaves every body where its constraint lets it be. A step of the same length along the tangent, as it is
taken where constraints are equations between the coordinates of free bodies, does not: its distance from the mechanism's nearest
configuration is what a solver would have to repair.

In: the alembert command and descriptions. Out: Markdown and a picture.
"""

import csv
import json
import subprocess
from pathlib import Path

import numpy as np
import yaml

from counts import verdict
from drawing import new_figure, save

STEPS = {"1/60 s": 1 / 60, "1/30 s": 1 / 30}


class Mechanism:
    """One description: positions of its bodies' origins and speeds' effect on them, through `alembert evaluate`."""

    def __init__(self, alembert: Path, path: Path):
        self.alembert, self.path = alembert, path
        # One process for all states: deriving the equations takes longer than evaluating them.
        command = [alembert, "evaluate", path, "--json", "--effort", "0"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()

    def evaluate(self, states: list) -> list:
        results = []
        for state in states:
            self.process.stdin.write(json.dumps(state) + "\n")
            self.process.stdin.flush()
            results.append(json.loads(self.process.stdout.readline()))
        return results

    def origins(self, qs, times) -> np.ndarray:
        """Origins of all bodies, states x 3 n_bodies."""
        states = [{"q": list(map(float, q)), "t": float(t)} for q, t in zip(qs, times)]
        return np.array([[row[i] for row in result["poses"] for i in (3, 7, 11)] for result in self.evaluate(states)])

    def simulate(self, step: float, seconds: float, out: Path) -> dict:
        command = [self.alembert, "simulate", self.path, "--effort", "0", "--duration", repr(seconds), "--step", repr(step), "--every", "1", "--csv", out]
        done = subprocess.run(command, capture_output=True, text=True)
        with open(out, newline="") as file:
            rows = list(csv.reader(file))
        table = np.array(rows[1:], float)
        return {"names": rows[0], "table": table, "message": done.stderr.strip() if done.returncode else ""}


def columns(names: list) -> tuple:
    """How many coordinates and speeds a table has: columns t, q, d(q), kinetic, ..."""
    speeds = [i for i, name in enumerate(names) if name.startswith("d(")]
    return speeds[0] - 1, len(speeds)


def normalized(q, names):
    """Unit quaternions: runs of four columns NAME.x .y .z .w."""
    q = np.array(q, float)
    for i, name in enumerate(names):
        if name.endswith(".x"):
            q[..., i : i + 4] /= np.linalg.norm(q[..., i : i + 4], axis=-1, keepdims=True)
    return q


def off_manifold(mechanism: Mechanism, names, q, times, velocities, step) -> np.ndarray:
    """Distance of a tangent step from the nearest configuration, in metres, one for each state.

    Gauss-Newton on min over q' of |x(q) + h dx/dt - x(q')| with x the origins of all bodies; the distance is an upper bound where
    it has not converged.
    """
    target = mechanism.origins(q, times) + step * velocities
    guess, best = q.copy(), np.full(len(q), np.inf)
    for _ in range(8):
        here = mechanism.origins(guess, times)
        best = np.minimum(best, np.linalg.norm(target - here, axis=1))
        nudge, size = 1e-6, q.shape[1]
        shifted = normalized(np.repeat(guess, size, axis=0) + nudge * np.tile(np.eye(size), (len(q), 1)), names)
        slopes = (mechanism.origins(shifted, np.repeat(times, size)) - np.repeat(here, size, axis=0)) / nudge
        for k in range(len(q)):
            jacobian = slopes[k * size : (k + 1) * size].T
            guess[k] += np.linalg.lstsq(jacobian, target[k] - here[k], rcond=1e-9)[0]
        guess = normalized(guess, names)
    return best


def origin_velocities(mechanism: Mechanism, names, table, n_q) -> np.ndarray:
    """Velocities of the origins at the states of a table, by central differences along qdot (given by `alembert evaluate`)."""
    n_v = columns(names)[1]
    q, qd, t = table[:, 1 : 1 + n_q], table[:, 1 + n_q : 1 + n_q + n_v], table[:, 0]
    states = [{"q": list(map(float, a)), "qd": list(map(float, b)), "t": float(c)} for a, b, c in zip(q, qd, t)]
    rates = np.array([result["qdot"] for result in mechanism.evaluate(states)])
    nudge = 1e-6
    ahead = mechanism.origins(normalized(q + nudge * rates, names[1:]), t + nudge)
    behind = mechanism.origins(normalized(q - nudge * rates, names[1:]), t - nudge)
    return (ahead - behind) / (2 * nudge)


class Wire:
    """The curve of a bead's description, read and evaluated here: a check on where the generated equations put the bead."""

    def __init__(self, path: Path):
        description = yaml.safe_load(path.read_text())
        names = {"sin": np.sin, "cos": np.cos, "pi": np.pi}
        for name, value in description.get("parameters", {}).items():
            names[name] = self._value(value, names)
        self.body, factor = next(
            (i, body["transform"][0]["curve"]) for i, body in enumerate(description["bodies"]) if "curve" in str(body.get("transform", ""))
        )
        self.along, self.point, self.names = factor["along"], factor["point"], names

    @staticmethod
    def _value(expression, names):
        return eval(str(expression).replace("^", "**"), {"__builtins__": {}}, names)  # expressions of this repository

    def at(self, s) -> np.ndarray:
        s = np.asarray(s, float)
        return np.stack([self._value(e, {**self.names, self.along: s}) + 0 * s for e in self.point], axis=-1)

    def distance(self, point, near: float) -> float:
        """Distance of a point from the wire, the nearest parameter sought within 2 of `near` on grids that grow finer."""
        width = 2.0
        for _ in range(14):
            s = np.linspace(near - width, near + width, 401)
            away = np.linalg.norm(self.at(s) - point, axis=1)
            near, width = float(s[np.argmin(away)]), width / 20
        return float(away.min())


def figure_8(alembert: Path, path: Path, out: Path, work: Path) -> list:
    step = STEPS["1/30 s"]
    wire = Wire(path)
    with Mechanism(alembert, path) as bead:
        return frame_of_bead(bead, wire, step, out, work)


def frame_of_bead(bead: Mechanism, wire: Wire, step: float, out: Path, work: Path) -> list:
    result = bead.simulate(step, 60 * step, work / "bead.csv")
    table = result["table"]
    velocities = origin_velocities(bead, result["names"], table, 1)
    # The frame with the fastest bead shows the difference best.
    start = int(np.argmax(np.linalg.norm(velocities[:-1], axis=1)))
    of_bead = slice(3 * wire.body, 3 * wire.body + 3)
    place, ours = bead.origins(table[start : start + 2, 1:2], table[start : start + 2, 0])[:, of_bead]
    tangent = place + step * velocities[start, of_bead]
    near = table[start, 1]
    axes, figure = new_figure()
    curve = wire.at(np.linspace(near - np.pi, near + np.pi, 800))
    a, b = sorted(np.argsort(np.ptp(curve, axis=0))[-2:])
    axes.plot(curve[:, a], curve[:, b], "-", color="0.6", linewidth=2, label="wire")
    for point, style, label in ((place, "ko", "start of the frame"), (ours, "bo", "step of the coordinate"), (tangent, "r^", "step along the tangent")):
        axes.plot(point[a], point[b], style, label=label)
    axes.annotate("", xy=tangent[[a, b]], xytext=place[[a, b]], arrowprops={"arrowstyle": "->", "color": "r"})
    axes.set(xlabel=f"{'xyz'[a]}, m", ylabel=f"{'xyz'[b]}, m", aspect="equal")
    axes.legend(fontsize=8)
    save(figure, out / "figure_8.svg")
    off = wire.distance(ours, near)
    return [
        "## Fig. 8: a bead on a wire, one frame of 1/30 s",
        "",
        f"- From t = {table[start, 0]:.4f} s at {np.linalg.norm(velocities[start]):.2f} m/s, a step along the tangent ends {1000 * wire.distance(tangent, near):.2f} mm off the "
        f"wire, a step of the coordinate {1000 * off:.1e} mm (the wire evaluated apart from the generated equations).",
        "- " + verdict(off < 1e-9, "after one frame the bead is on the wire to rounding"),
        "",
        "![Fig. 8](figure_8.svg)",
        "",
    ]


def reason(message: str) -> str:
    """What a diagnostic says, without place, cure and line."""
    first = next(line for line in message.splitlines() if "error:" in line)
    return first.split("error: ")[-1].split(":")[0].split(";")[0]


def row_of(alembert, path, seconds, samples, work):
    with Mechanism(alembert, path) as mechanism:
        return [path.stem] + [cell(mechanism, step, seconds, samples, work) for step in STEPS.values()]


def cell(mechanism: Mechanism, step: float, seconds: float, samples: int, work: Path) -> str:
    result = mechanism.simulate(step, seconds, work / f"{mechanism.path.stem}.csv")
    names, table = result["names"], result["table"]
    n_q, n_v = columns(names)
    energy = table[:, names.index("energy")]
    scale = max(table[:, names.index("kinetic")].max(), 1e-300)
    residual = np.abs(table[:, names.index("residual")]).max() if "residual" in names else 0.0
    chosen = np.unique(np.linspace(0, len(table) - 1, samples).astype(int))
    sample = table[chosen]
    q = normalized(sample[:, 1 : 1 + n_q], names[1:])
    velocities = origin_velocities(mechanism, names, sample, n_q)
    tangent = off_manifold(mechanism, names[1:], q, sample[:, 0], velocities, step).max()
    ended = f"{seconds:g} s"
    if result["message"]:
        ended = f"stops at {table[-1, 0]:.2f} s ({reason(result['message'])})"
    return f"{ended}; {np.abs(energy - energy[0]).max() / scale:.1e}; {residual:.1e}; {1000 * tangent:.2g} mm"


def section(alembert: Path, paper: Path, seconds: float, samples: int, out: Path, progress) -> list:
    """Fig. 8 and a row for each mechanism; a tangent step is tried at so many states of each motion."""
    work = out / "motions"
    work.mkdir(exist_ok=True)
    progress("Fig. 8")
    lines = figure_8(alembert, paper / "bead_on_wire.yaml", out, work)
    lines += ["## Large steps with every mechanism", ""]
    lines += [f"Runge-Kutta steps of 1/60 s and 1/30 s for {seconds:g} s. Each cell: how far it came; the largest change of energy as a part of the largest"]
    lines += ["kinetic energy (mechanisms driven in time do not keep theirs); the largest residual of a constraint (0: all constraints are parametrised);"]
    lines += ["how far one tangent step of that length takes the bodies' origins from any configuration of the mechanism.", ""]
    lines += ["| mechanism | " + " | ".join(f"steps of {name}" for name in STEPS) + " |", "| --- | --- | --- |"]
    for path in sorted(paper.glob("*.yaml")):
        progress(f"{path.stem}, {seconds:g} s in large steps")
        lines.append("| " + " | ".join(row_of(alembert, path, seconds, samples, work)) + " |")
    return lines + [""]
