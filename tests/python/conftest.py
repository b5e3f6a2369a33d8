"""Mechanisms of the catalogue as modules, compiled once for all tests."""
import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src" / "python"))
sys.dont_write_bytecode = True

import alembert  # noqa: E402

CATALOGUE = ["puma560", "tree_every_joint", "runtime_parameters", "free_body", "paper/rolling_disc", "four_bar_knee"]


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(scope="session")
def load(cache):
    return lambda name, *args, **options: alembert.load(ROOT / "mechanisms" / f"{name}.yaml", *args, cache=cache, **options)
