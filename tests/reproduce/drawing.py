"""Figures that come out the same, byte for byte, for the same numbers."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "alembert"
matplotlib.rcParams["font.size"] = 9

import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)


def new_figure():
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    axes.grid(alpha=0.3)
    return axes, figure


def save(figure, path):
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
