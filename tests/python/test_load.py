"""alembert.load: cache, processes side by side, URDF, errors."""
import os
import pathlib
import subprocess
import sys
import warnings

import alembert
import numpy as np
import pytest
from conftest import ROOT

URDF = """<robot name="stick"><link name="base"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link><link name="rod"><inertial><origin xyz="0 0 -0.5"/><mass value="{mass}"/>
<inertia ixx="0.1" iyy="0.1" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="2" effort="1" velocity="1"/></joint></robot>"""


def folders(cache):
    return sorted(path.name for path in cache.iterdir())


def test_what_is_in_the_cache_is_not_compiled_again(tmp_path, monkeypatch):
    pendulum = ROOT / "mechanisms" / "pendulum.yaml"
    first = alembert.load(pendulum, cache=tmp_path)
    assert len(folders(tmp_path)) == 1
    stamp = os.stat(first.__file__).st_mtime_ns
    assert alembert.load(pendulum, cache=tmp_path) is first
    assert os.stat(first.__file__).st_mtime_ns == stamp and len(folders(tmp_path)) == 1
    assert alembert.load(pendulum, "inverse_dynamics", cache=tmp_path) is not first
    assert len(folders(tmp_path)) == 2
    monkeypatch.setenv("CFLAGS", "-O1 -DNDEBUG")
    assert alembert.load(pendulum, "inverse_dynamics", cache=tmp_path) is not first
    assert len(folders(tmp_path)) == 3
    monkeypatch.setenv("CFLAGS", "--no-such-flag")
    with pytest.raises(alembert.Error, match="no-such-flag"):
        alembert.load(pendulum, "bias", cache=tmp_path)
    monkeypatch.delenv("CFLAGS")
    other = tmp_path / "p.yaml"
    other.write_text(pendulum.read_text() + "\n# another text\n")
    alembert.load(other, cache=tmp_path / "c")
    alembert.load(pendulum, cache=tmp_path / "c")
    assert len(folders(tmp_path / "c")) == 2
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    alembert.load(pendulum, "default")
    assert len(folders(tmp_path / "home" / "alembert")) == 1


def test_processes_at_once_share_a_cache(tmp_path):
    code = (f"import sys; sys.path.insert(0, {str(ROOT / 'src' / 'python')!r}); import alembert\n"
            f"m = alembert.load({str(ROOT / 'mechanisms' / 'double_pendulum.yaml')!r}, cache={str(tmp_path)!r})\n"
            "print(m.mass_matrix(m.initial_coordinates).sum())")
    running = [subprocess.Popen([sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
               for _ in range(3)]
    said = [process.communicate() for process in running]
    assert [process.returncode for process in running] == [0, 0, 0], said
    assert len({out for out, _ in said}) == 1
    assert len(folders(tmp_path)) == 1


def test_urdf(tmp_path):
    robot = tmp_path / "stick.urdf"
    robot.write_text(URDF.format(mass=2))
    m = alembert.load(robot, cache=tmp_path / "cache")
    assert (m.name, m.nq) == ("stick", 1) and m.upper_limits.tolist() == [2]
    assert np.allclose(m.mass_matrix([0.3]), 0.1 + 2 * 0.25)
    free = alembert.load(robot, cache=tmp_path / "cache", root="floating")
    assert free.nv > m.nv
    robot.write_text(URDF.format(mass=3))
    assert np.allclose(alembert.load(robot, cache=tmp_path / "cache").mass_matrix([0.3]), 0.1 + 3 * 0.25)


MJCF = """<mujoco model="stick"><compiler angle="radian"/><worldbody><include file="rod.xml"/></worldbody></mujoco>"""
ROD = """<mujocoinclude><body name="rod"><joint name="hinge" axis="0 1 0"/><inertial pos="0 0 -0.5" mass="{mass}" diaginertia="0.1 0.1 0.01"/>
</body></mujocoinclude>"""
SDF = """<sdf version="1.9"><model name="stick"><joint name="hinge" type="revolute"><parent>world</parent><child>rod</child>
<axis><xyz>0 1 0</xyz></axis></joint><link name="rod"><inertial><pose>0 0 -0.5 0 0 0</pose><mass>{mass}</mass>
<inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.01</izz></inertia></inertial></link></model></sdf>"""


@pytest.mark.parametrize("name, files", [
    ("stick.xml", {"stick.xml": MJCF, "rod.xml": ROD}),
    ("stick.sdf", {"stick.sdf": SDF}),
    ("stick", {"stick": "\ufeff" + URDF}),
    ("stick.xml", {"stick.xml": URDF}),
])
def test_robots_of_all_formats_and_the_files_they_include(tmp_path, name, files):
    for mass in (2, 3):
        for file, text in files.items():
            (tmp_path / file).write_text(text.replace("{mass}", str(mass)))
        m = alembert.load(tmp_path / name, "default", cache=tmp_path / "cache")
        assert m.name == "stick" and np.allclose(m.mass_matrix([0.3]), 0.1 + mass * 0.25)
    assert alembert.load(tmp_path / name, "default", cache=tmp_path / "cache") is m
    assert alembert.load(tmp_path / name, "default", cache=tmp_path / "cache", importing=["--no-friction"]).nv == 1
    # Two steps of the semi-implicit Euler method.
    q, qd = 0.3, 0.0
    for _ in range(2):
        M, c = m.mass_matrix_and_bias([q], [qd])
        qd -= 0.01 * c[0] / M[0, 0]
        q += 0.01 * qd
    assert np.allclose(alembert.rollout(m, [0.3], [0.0], step=0.01, steps=2).q, q, rtol=1e-14)


def test_bodies_of_opensim(tmp_path):
    muscles = ROOT / "tests" / "osim" / "models" / "muscles"
    m = alembert.load(muscles.with_suffix(".osim"), "default", cache=tmp_path)
    same = alembert.load(muscles.with_suffix(".yaml"), "default", cache=tmp_path)
    state = m.initial_coordinates, m.initial_speeds
    assert m.coordinate_names == same.coordinate_names and m.parameter_names == same.parameter_names
    assert np.array_equal(m.bias(*state), same.bias(*state)) and np.any(m.bias(*state) != 0)


def test_errors_have_the_text_of_the_generator(tmp_path, monkeypatch):
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text((ROOT / "mechanisms" / "pendulum.yaml").read_text().replace("    mass:", "    maas:", 1))
    with pytest.raises(alembert.Error, match=r"wrong\.yaml:\d+:\d+: error: .*maas"):
        alembert.load(wrong, cache=tmp_path / "cache")
    assert folders(tmp_path / "cache") == []
    with pytest.raises(alembert.Error, match="inverse_dynamics"):
        alembert.load(ROOT / "mechanisms" / "pendulum.yaml", "inverse_dynamix", cache=tmp_path / "cache")
    with pytest.raises(FileNotFoundError):
        alembert.load(tmp_path / "none.yaml")
    with pytest.raises(ValueError, match="for robots"):
        alembert.load(ROOT / "mechanisms" / "pendulum.yaml", root="floating")
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(alembert.Error, match="no-such-compiler: .*Set CC to a C compiler"):
        alembert.load(ROOT / "mechanisms" / "pendulum.yaml", cache=tmp_path / "cache")
    monkeypatch.setenv("ALEMBERT_EXECUTABLE", "no-such-command")
    with pytest.raises(alembert.Error, match="ALEMBERT_EXECUTABLE is no-such-command"):
        alembert.load(ROOT / "mechanisms" / "pendulum.yaml", cache=tmp_path / "cache")


def test_warnings_are_given_each_time(tmp_path):
    robot = tmp_path / "stick.urdf"
    robot.write_text(URDF.format(mass=0).replace('"0.1"', '"0"').replace('"0.01"', '"0"'))
    for _ in range(2):
        with pytest.warns(UserWarning, match="warning") as warned:
            alembert.load(robot, cache=tmp_path / "cache")
        # Those of importing and those of generating name the robot's file, not one that is gone.
        said = str(warned[0].message)
        assert f"{robot}, imported:" in said and f"{robot}:" in said and "building-" not in said
    same = tmp_path / "same.urdf"
    same.write_text(robot.read_text())
    with pytest.warns(UserWarning, match=f"{same}, imported:"):
        alembert.load(same, cache=tmp_path / "cache")
    with pytest.raises(alembert.Error, match=f"{same}, imported:.*the build expects") as refused:
        alembert.load(same, cache=tmp_path / "cache", options=("--expected-name", "other"))
    assert "building-" not in str(refused.value)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        alembert.load(robot, cache=tmp_path / "cache", massless="armature=0.1")
