"""Two hundred seated legs kick at once, each with another activation of the quadriceps; the hamstrings brake.
The work of the muscles must become the energy of the leg. `knee.py kicks.png` draws some of the kicks, by matplotlib."""
import pathlib
import sys

import alembert
import numpy as np

knee = alembert.load(pathlib.Path(__file__).with_name("knee.yaml"))
frame = knee.frame_names.index
# Origin, insertion, greatest force (N), length at which it is greatest (m).
QUADRICEPS = frame("patella"), frame("tibia_front"), 2500, 0.13
HAMSTRINGS = frame("ischium"), frame("tibia_back"), 1500, 0.42
ACTIVATION = np.linspace(0.1, 0.6, 200)


def length_of(muscle, F, J):
    """From origin to insertion, m, and its derivative by q."""
    origin, insertion, *_ = muscle
    line = F[:, insertion, :, 3] - F[:, origin, :, 3]
    moves = J[:, insertion, 3:, 0] - J[:, origin, 3:, 0]
    length = np.linalg.norm(line, axis=1)
    return length, np.sum(line * moves, axis=1) / length


def pull(muscle, activation, F, J, qd):
    """The generalized force of a muscle: a force along the line from origin to insertion."""
    _, _, strongest, rest = muscle
    length, arm = length_of(muscle, F, J)
    stretch = (length - rest) / (0.5 * rest)
    return -arm * activation * strongest * np.exp(-stretch**2) / (1 + np.exp(-4 * arm * qd[:, 0]))


def muscles(t, q, qd):
    F, J = knee.frame_poses(q), knee.frame_jacobians(q)
    kick, brake = np.exp(-(((t - 0.25) / 0.1) ** 2)), 0.3 * np.exp(-(((t - 0.4) / 0.1) ** 2))
    tau = pull(QUADRICEPS, ACTIVATION * kick, F, J, qd) + pull(HAMSTRINGS, brake, F, J, qd)
    return tau[:, None]


def rates(t, state):
    """Of q, qd and the work of the muscles, which are integrated together."""
    q, qd, _ = state
    tau = muscles(t, q, qd)
    return np.array([qd, knee.forward_dynamics(q, qd, tau), tau * qd])


def forward(W):
    """Of the shank, degrees from the vertical."""
    shank = W[:, knee.body_names.index("shank")]
    return np.degrees(np.arctan2(shank[:, 2, 0], shank[:, 0, 0]))


def arm(muscle, F, J):
    """Moment arm about the shank's axis of rotation: by how much the muscle shortens with the angle, m."""
    return length_of(muscle, F, J)[1] / J[:, muscle[1], 1, 0]


def draw(path, times, angles):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (kicks, arms) = pyplot.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for i in range(0, len(ACTIVATION), 33):
        kicks.plot(times, angles[:, i], label=f"{ACTIVATION[i]:.2f}", color=pyplot.cm.viridis(i / 200))
    kicks.set(xlabel="time [s]", ylabel="shank from the vertical [deg]", title="kicks")
    kicks.legend(title="activation", fontsize="small", loc="lower left")
    q = np.linspace(0.85, 2.3, 60)[:, None]
    F, J = knee.frame_poses(q), knee.frame_jacobians(q)
    for name, muscle in (("quadriceps", QUADRICEPS), ("hamstrings", HAMSTRINGS)):
        arms.plot(forward(knee.body_poses(q)), 1000 * arm(muscle, F, J), label=name)
    arms.set(xlabel="shank from the vertical [deg]", ylabel="moment arm [mm]", title="moment arms")
    arms.legend(fontsize="small")
    figure.savefig(path, dpi=110)


def main():
    count, h = len(ACTIVATION), 2e-3
    state = np.zeros((3, count, 1))
    state[0] = 1.66  # the shank hangs
    start = knee.energy(state[0], state[1]).sum(axis=1)
    angles = []
    for k in range(300):
        t = k * h
        k1 = rates(t, state)
        k2 = rates(t + h / 2, state + h / 2 * k1)
        k3 = rates(t + h / 2, state + h / 2 * k2)
        k4 = rates(t + h, state + h * k3)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        angles.append(forward(knee.body_poses(state[0])))
    highest = np.max(angles, axis=0)
    if len(sys.argv) > 1:
        draw(sys.argv[1], h * np.arange(1, 301), np.array(angles))
    gained = knee.energy(state[0], state[1]).sum(axis=1) - start
    print("activation  highest shank [deg]  work [J]")
    for i in range(0, count, 33):
        print(f"{ACTIVATION[i]:10.2f} {highest[i]:20.1f} {state[2, i, 0]:9.3f}")
    error = np.abs(gained - state[2, :, 0]).max()
    print(f"energy gained and work differ by {error:.1e} J")
    return 0 if error < 1e-3 else 1


if __name__ == "__main__":
    raise SystemExit(main())
