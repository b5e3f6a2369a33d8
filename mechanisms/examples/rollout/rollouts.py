"""Four thousand throws of a free body, drawn by seed, on the workers of Dask at the address given, or on two of this machine.
How far do they fly? Cut off and called again, it does what is missing."""
import pathlib
import sys
import tempfile

import alembert
import numpy as np

CENTRE = np.array([0.05, -0.03, 0.08])  # of mass, m, in the body


def throws(rng, n):
    """n starts: speeds of centre of mass, m/s, and of rotation, rad/s."""
    q = np.tile([0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 1.0], (n, 1))
    qd = np.column_stack([rng.uniform(4, 8, n), rng.normal(0, 0.5, n), rng.uniform(2, 6, n), rng.normal(0, 5, (n, 3))])
    return {"q": q, "qd": qd}


def main(address, folder):
    from distributed import Client, LocalCluster

    body = alembert.load(pathlib.Path(__file__).with_name("free_body.yaml"))
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) if address is None else Client(address) as place:
        with Client(place) if address is None else place as client:
            ends = alembert.rollout(body, throws, count=4096, seed=7, steps=3000, step=1e-3, method="rk4",
                                    within={"q": ([-100, -100, 0, -2, -2, -2, -2], 100)}, client=client, out=folder).read()
    flown, t = ends.q[:, -1, 0], 1e-3 * ends.steps[:, None]
    print(f"{len(flown)} throws fly {flown.mean():.2f} m, the longest {flown.max():.2f} m; {ends.stopped.sum()} have landed")
    # However a body spins, its centre of mass flies along a parabola.
    qd = np.concatenate([throws(np.random.default_rng([7, shard]), 1024)["qd"] for shard in range(4)])
    pose = body.body_poses(ends.q[:, -1])[:, 0]
    found = pose[:, :, 3] + pose[:, :, :3] @ CENTRE
    exact = np.array([0, 0, 1.5]) + CENTRE + (qd[:, :3] + np.cross(qd[:, 3:], CENTRE)) * t - [0, 0, 9.81 / 2] * t**2
    print(f"parabolas are met to {np.abs(found - exact).max():.1e} m")
    return 0 if ends.stopped.all() and not ends.status.any() and np.abs(found - exact).max() < 1e-6 else 1


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as work:
        raise SystemExit(main(sys.argv[1] if len(sys.argv) > 1 else None, sys.argv[2] if len(sys.argv) > 2 else work))
