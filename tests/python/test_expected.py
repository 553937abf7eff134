"""What people who know Python expect, and did not get: each with the old result beside the right one."""
from __future__ import annotations

import json
import os
import pathlib
import subprocess
import sys

import hawser
import numpy as np
import pytest
import yaml
from conftest import DATA, ROOT

PACKAGE = str(pathlib.Path(hawser.__file__).parents[1])


@pytest.fixture(scope="module")
def conveyors() -> hawser.Simulation:
    simulation = hawser.Simulation(ROOT / "cases" / "conveyors.yaml")
    simulation.advance(2.0)
    return simulation


@pytest.fixture
def plan(pull) -> dict:
    return {"title": "From a dict", "case": pull, "parameters": {"mu": {"key": "friction.mu", "values": [0.1, 0.2]}}, "grid": ["mu"]}


# --------------------------------------------------------------------------------------------------- dicts and paths


@pytest.mark.parametrize("value, planar", [(False, "off"), ("no", "off"), ("off", "off"), (True, "on"), ("yes", "on"), ("auto", "auto")])
def test_planar_takes_a_boolean(pull, value, planar):
    """'value 'false': expected one of auto, on, off', also of `planar: false` in a file."""
    summaries = [hawser.Simulation(pull, set={"solver.planar": setting}).summary for setting in (value, planar)]
    assert summaries[0]["planar"] is summaries[1]["planar"] is (planar != "off")
    assert summaries[0]["planar_why"] == summaries[1]["planar_why"]
    case = {**yaml.safe_load(pathlib.Path(pull).read_text()), "solver": {"planar": value}}
    assert hawser.Simulation(case).summary["planar"] is (planar != "off")
    assert value in hawser.schema()["$defs"]["solver"]["properties"]["planar"]["enum"] + ["yes", "no"]
    with pytest.raises(hawser.CaseError, match="expected one of auto, on, off"):
        hawser.Case(pull, set={"solver.planar": "maybe"}).check()


def test_a_rope_that_is_one_has_all_words_for_it():
    """`rope: yes` was refused, `rope: true` not."""
    case = yaml.safe_load((ROOT / "cases" / "conveyors.yaml").read_text())
    for word in (True, "yes", "on", "true"):
        case["chain"][1]["rope"] = word
        hawser.Case(case).check()


def test_a_study_from_a_dict(plan, tmp_path):
    """TypeError: expected str, bytes or os.PathLike object, not dict."""
    study = hawser.study(plan, tmp_path / "out")
    assert study.samples["reference_total_N"].to_numpy() == pytest.approx([392.4, 784.8], rel=1e-6)
    again = hawser.study(plan, tmp_path / "out")  # goes on with what is there
    assert again.samples.equals(study.samples) and again.report(tmp_path / "page.html").read_bytes() == (tmp_path / "out" / "study.html").read_bytes()
    with pytest.raises(hawser.CaseError, match="another study"):
        hawser.study({**plan, "parameters": {"mu": {"key": "friction.mu", "values": [0.1, 0.3]}}}, tmp_path / "out")
    assert hawser.Study(tmp_path / "out").report(tmp_path / "page.html").exists()  # whose file is still its own


def test_a_study_of_a_case_that_is_a_dict(plan, pull, tmp_path):
    case = hawser.Case(pull).set({"cables.power.mass": "40 kg/m"})
    values = {"limits.conductor": {"material": "copper", "area": "800 mm2"}, "solver.planar": False}  # C takes texts in one line
    for k, base in enumerate((case, case.as_dict())):
        study = hawser.study({**plan, "case": base, "set": values}, tmp_path / f"out{k}")
        assert study.samples["reference_total_N"].to_numpy() == pytest.approx([784.8, 1569.6], rel=1e-6)
        assert "margin_pull" in study.samples.columns


def test_files_of_a_dict_stand_beside_a_folder(plan, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with_file = hawser.Case(ROOT / "cases" / "theory" / "route-table.yaml")
    study = hawser.study({**plan, "case": with_file}, "out")
    alone = [hawser.theory(with_file, set={"friction.mu_d": mu, "friction.mu_s": mu}).facts["reference_total_N"] for mu in (0.1, 0.2)]
    assert len(study.samples) == 2 and len(alone) == 2
    assert len(hawser.study({**plan, "case": "cases/huangjiahu.yaml"}, "here", folder=ROOT).samples) == 2
    with pytest.raises(hawser.CaseError, match="cannot be opened"):
        hawser.study({**plan, "case": "cases/huangjiahu.yaml"}, "there")


def test_an_error_in_a_dict_has_its_key_and_no_file(plan, tmp_path):
    with pytest.raises(hawser.CaseError, match="<dict>.*no parameter has this name") as found:
        hawser.study({**plan, "grid": ["mi"]}, tmp_path / "out")
    assert (found.value.file, found.value.line, found.value.key) == (None, None, "grid.0")


def test_a_job_from_a_dict():
    """As above; and of YAML 1.1 `on: R1` is {True: "R1"}: 'key 'True': unknown key'."""
    path = ROOT / "cases" / "jobs" / "ducts.yaml"
    plan = yaml.safe_load(path.read_text())
    assert any(True in pull for pull in plan["pulls"])
    job = hawser.job(plan, folder=path.parent)
    assert job.pulls.equals(hawser.job(path).pulls) and job.verdict == hawser.job(path).verdict
    with pytest.raises(hawser.CaseError, match="<dict>") as found:
        hawser.job({"pulls": [{"name": "A", "friction": {"mu": -1}}]})
    assert found.value.file is None
    with pytest.raises(FileNotFoundError):
        hawser.job("no-such-job.yaml")


def test_compare_takes_folders(by_command, pull, tmp_path):
    folder = by_command(pull)
    assert "<html" in hawser.compare([folder, hawser.run(pull)], tmp_path / "page.html").read_text()[:200]


# ------------------------------------------------------------------------------------------------------- by name


def test_a_roller_by_its_name(conveyors):
    """There was an array, and who wanted one roller of it had to count. (A sample that is held stays good meanwhile.)"""
    look = conveyors.sample()
    names = list(conveyors.rollers["name"])
    for name in (names[0], names[7], names[-1]):
        roller = conveyors.roller(name)
        assert roller.force == look.roller_load[names.index(name)] == pytest.approx(np.linalg.norm(roller.vector))
        assert roller.so_far["s_m"] == conveyors.rollers["s_m"][names.index(name)]
    assert look.t == 2.0
    with pytest.raises(KeyError, match=f"no roller 'R99': did you mean 'R9'"):
        conveyors.roller("R99")


def test_machines_and_the_winch_by_name(conveyors):
    first = conveyors.conveyor("first")
    assert first.force == pytest.approx(900, rel=1e-4) == first.now["force_N"]  # 2 * 0.3 * 1.5 kN
    assert conveyors.conveyor("second").so_far["from_m"] == 55.2 and conveyors.machine("second").force == pytest.approx(500, rel=1e-4)
    assert conveyors.winch.force == conveyors.sample().winch_force and conveyors.winch.speed == pytest.approx(0.1)
    with pytest.raises(KeyError, match="no conveyor 'frist': did you mean 'first'"):
        conveyors.conveyor("frist")
    with pytest.raises(KeyError, match="no surface 'floor': there is none"):
        conveyors.surface("floor")


def test_two_conveyors_of_one_name():
    """The second one's force came without a word."""
    case = hawser.Case(ROOT / "cases" / "conveyors.yaml")
    case.set({"conveyors.second.name": "first"})
    simulation = hawser.Simulation(case)
    for find in (simulation.conveyor, simulation.machine):
        with pytest.raises(KeyError, match="2 .*s are called 'first'"):
            find("first")


def test_surfaces_and_results_by_name():
    simulation = hawser.Simulation(DATA / "picture.yaml")
    result = simulation.run()
    for k, name in enumerate(simulation.surfaces["name"]):
        surface, look = simulation.surface(name), simulation.sample()
        assert (surface.force, surface.friction) == (look.surface_normal[k], look.surface_friction[k])
        assert (surface.line_load, surface.so_far["normal_N"]) == (look.surface_line_load[k], simulation.surfaces["normal_N"][k])
        assert result.surface(name)["name"] == name
    name = result.rollers["name"][3]
    assert result.roller(name)["peak_N"] == result.rollers["peak_N"][3]
    with pytest.raises(KeyError, match="no conveyor"):
        result.conveyor("first")


def test_a_closed_simulation_has_no_things(pull):
    simulation = hawser.Simulation(pull)
    roller = simulation.roller("R3")
    assert roller.force == 0 and "R3" in repr(roller)
    simulation.close()
    with pytest.raises(RuntimeError, match="closed"):
        roller.force


# ------------------------------------------------------------------------------------------------------- looking


def test_everything_says_what_it_is(pull, plan, tmp_path):
    """A study, a job and a certificate were `<hawser.studies.Study object at 0x7f3084ca2e50>`; a figure was its whole SVG."""
    result = hawser.run(pull)
    study = hawser.study(plan, tmp_path / "out")
    things = [result, result.plot(), study, hawser.theory(pull), hawser.Case(pull), hawser.job(ROOT / "cases" / "jobs" / "ducts.yaml"),
              hawser.Simulation(pull), hawser.Simulation(pull).sample(), hawser.Simulation(pull).winch]
    for thing in things:
        assert " object at 0x" not in repr(thing) and "\n" not in repr(thing) and len(repr(thing)) < 300
    assert repr(study) == f"<hawser study in '{tmp_path}/out': 2 of 2 samples>"


def test_notebooks_show_verdict_and_table(plan, tmp_path):
    result = hawser.run(DATA / "limits.yaml")
    for thing, verdict in ((result, result.verdict), (hawser.theory(DATA / "limits.yaml"), "SAFE"), (hawser.study(plan, tmp_path / "out"), "2 of 2"),
                           (hawser.job(ROOT / "cases" / "jobs" / "ducts.yaml"), "SAFE")):
        shown = thing._repr_html_()
        assert verdict in shown and "<table" in shown and "<script" not in shown
    hostile = hawser.run(DATA / "limits.yaml", set={"title": "'<script>alert(1)</script>'"})
    assert "<script" not in hostile._repr_html_() + hawser.theory(DATA / "limits.yaml", set={"title": "'<script>'"})._repr_html_()


def test_a_sample_as_xarray(conveyors):
    pytest.importorskip("xarray")
    found = conveyors.sample().to_xarray()
    assert found["roller_force"].dims == ("roller", "xyz") and found["quaternion"].dims == ("segment", "wxyz") and found["tension"].dims == ("joint",)
    assert found["position"].sel(xyz="z").values == pytest.approx(conveyors.sample().position[:, 2]) and found.attrs["t"] == 2.0


def test_without_xarray_an_error_says_what_to_install(conveyors, monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(ImportError, match="python3-xarray"):
        conveyors.sample().to_xarray()


# ------------------------------------------------------------------------------------------------ programs around it


def test_no_call_warns(plan, pull, tmp_path):
    """Each study warned: "RuntimeWarning: 'hawser.studies' found in sys.modules after import of package 'hawser'"."""
    text = (f"import hawser\nif __name__ == '__main__':\n    print(len(hawser.study({plan!r}, 'out').samples))\n    r = hawser.run({pull!r}); r.states; r.limits; repr(r)\n"
            f"    hawser.theory({pull!r})._repr_html_(); hawser.job({str(ROOT / 'cases/jobs/ducts.yaml')!r})._repr_html_()\n")
    (tmp_path / "script.py").write_text(text)
    done = subprocess.run([sys.executable, "-W", "error", "script.py"], cwd=tmp_path, capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": PACKAGE, "PYTHONWARNINGS": "error"})
    assert (done.returncode, done.stdout, done.stderr) == (0, "2\n", "")


def test_the_command_line_by_python(program, pull, tmp_path):
    """No module named hawser.__main__; 'hawser' is a package and cannot be directly executed."""
    def said(*command: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([*command, "theory", pull, "--format", "json"], capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "PYTHONPATH": PACKAGE})

    by_python = said(sys.executable, "-m", "hawser")
    assert by_python.returncode == 0 and json.loads(by_python.stdout) == json.loads(said(program).stdout)
    wrong = subprocess.run([sys.executable, "-m", "hawser", "run", "no-such.yaml"], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": PACKAGE})
    assert wrong.returncode == 2 and "no-such.yaml" in wrong.stderr


def test_the_program_of_the_path_must_be_of_this_version(tmp_path, monkeypatch):
    from hawser import __main__ as line

    monkeypatch.setattr(line, "__file__", str(tmp_path / "__main__.py"))  # a package without the program
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(FileNotFoundError, match="no program 'hawser'"):
        line.program()
    other = tmp_path / "hawser"
    for version, fine in (("0.0.1", False), (hawser.__version__, True)):
        other.write_text(f"#!/bin/sh\necho hawser {version}\n")
        other.chmod(0o755)
        if fine:
            assert line.program() == str(other)
        else:
            with pytest.raises(RuntimeError, match="0.0.1, and this package"):
                line.program()
