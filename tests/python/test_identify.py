"""`alembert identify`: the base parameters give the forces, and the example that it writes identifies the arm."""
import json
import os
import subprocess
import sys

import alembert
import numpy as np
import pytest
from conftest import ROOT


def identify(name, *options):
    file = ROOT / "mechanisms" / f"{name}.yaml"
    done = subprocess.run([alembert.executable(), "identify", str(file), *options], capture_output=True, text=True, check=True)
    return done.stdout


def test_base_parameters_of_the_puma():
    found = json.loads(identify("puma560", "--json"))
    assert len(found["base_parameters"]) == 36  # as in the literature
    assert [name for name in found["without_effect"] if "link1" not in name] == []
    by_name = {one["name"]: {j["name"]: j["coefficient"] for j in one["joined"]} for one in found["base_parameters"]}
    # The last link: its z axis is the joint's.
    assert by_name["Ixx(link6)"] == {"Iyy(link6)": -1} and by_name["Izz(link6)"] == {}
    # An upper arm of 0.4318 m bears what is beyond the elbow.
    assert by_name["m cx(link2)"] == {f"m(link{k})": 0.4318 for k in (3, 4, 5, 6)}
    text = identify("puma560")
    assert text.startswith("puma560: 36 base parameters of 6 bodies with 60 standard parameters\n")
    assert "m cx(link2) + 0.4318 m(link3) + 0.4318 m(link4)" in text and "without effect on forces: m(link1)," in text


def test_rounding_of_an_axis_is_no_parameter(tmp_path):
    """A plate that turns about a slanted axis and slides beside it: mass, two moments, and the inertia about the axis."""
    file = tmp_path / "plate.yaml"
    file.write_text("""alembert: 1
name: plate
coordinates: [turn, slide]
bodies:
  - name: plate
    transform:
      - {rotate: {axis: [0.4204, 0.07383, 0.9644], angle: "atan2(sin(turn) + 0.279, 2 + cos(turn))*2"}}
      - {translate: ["(2 + sin(slide))^1.5/2", "-0.181", "-slide^3/6 - slide"]}
    mass: 2.2
    com: [0.1, 0.2, -0.1]
    inertia: {xx: 0.2, yy: 0.2, zz: 0.2}
""")
    done = subprocess.run([alembert.executable(), "identify", str(file), "--json"], capture_output=True, text=True, check=True)
    base = [one["name"] for one in json.loads(done.stdout)["base_parameters"]]
    assert base == ["m(plate)", "m cx(plate)", "m cy(plate)", "Ixx(plate)"]


@pytest.mark.parametrize("name", ["puma560", "tree_every_joint"])
def test_the_example_identifies(name, tmp_path):
    identify(name, "--example", str(tmp_path))
    environment = dict(os.environ, PYTHONPATH=str(ROOT / "src" / "python"), XDG_CACHE_HOME=str(tmp_path))
    done = subprocess.run([sys.executable, "-B", str(tmp_path / f"identify_{name}.py")], capture_output=True, text=True,
                          env=environment)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "by bodies that have them and could exist" in done.stdout


def test_what_cannot_be_written_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    for file, folder in ((str(ROOT / "mechanisms" / "pendulum.yaml"), str(tmp_path / "file")), ("-", str(tmp_path))):
        done = subprocess.run([alembert.executable(), "identify", file, "--example", folder], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)
        assert done.returncode == 1 and "error" in done.stderr, done.stderr


def test_base_columns_give_the_forces(tmp_path):
    name = "runtime_parameters"
    m = alembert.load(ROOT / "mechanisms" / f"{name}.yaml", "regressor", cache=tmp_path)
    found = json.loads(identify(name, "--json"))["base_parameters"]
    rng = np.random.default_rng(2)
    theta = rng.normal(size=10 * len(m.body_names))
    beta = [theta[one["column"]] + sum(j["coefficient"] * theta[j["column"]] for j in one["joined"]) for one in found]
    Y = m.regressor(*rng.normal(size=(3, 20, m.nv)))
    # Of the parameters that count.
    some = Y[:, :, [one["column"] for one in found]]
    assert np.allclose(np.dot(some, beta), np.dot(Y, theta), rtol=1e-12, atol=1e-12 * np.abs(Y).max())
