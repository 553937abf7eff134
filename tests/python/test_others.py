"""Routes of files, the catalogue, certificates, studies."""
from __future__ import annotations

import json
import os
import signal
import subprocess

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT


def test_routes_of_a_drawing(tmp_path):
    found = hawser.routes(ROOT / "cases" / "routes" / "tunnel.dxf")
    route = next(r for r in found if r.problem is None)
    assert route.length == pytest.approx(route.figures["length_m"], rel=1e-3)
    s = np.linspace(0, route.length, 200)
    places = route.at(s)
    assert places["position"].shape == (200, 3)
    assert np.linalg.norm(places["tangent"], axis=1) == pytest.approx(np.ones(200))
    steps = np.linalg.norm(np.diff(places["position"], axis=0), axis=1)
    assert steps.sum() == pytest.approx(route.length, rel=1e-3)
    assert places["position"][0] == pytest.approx(np.array(route.figures["start_m"]), abs=1e-6)
    assert route.at(1.0)["position"].shape == (3,)
    least = 1 / np.linalg.norm(places["curvature"], axis=1).max()
    assert least >= 0.99 * route.figures["least_radius_m"]
    bends = route.bends
    assert len(bends) > 0 and bends["radius_m"].min() == pytest.approx(route.figures["least_radius_m"])
    assert bends["length_m"].to_numpy() == pytest.approx(np.abs(bends["turn"]) * bends["radius_m"])
    route.write(tmp_path / "route.csv")
    again = hawser.routes(tmp_path / "route.csv")
    assert again[0].length == pytest.approx(route.length, rel=1e-6)
    assert repr(again[0]).startswith("<hawser route ")


def test_routes_by_options():
    path = ROOT / "cases" / "routes" / "tunnel.csv"
    forth, back = hawser.routes(path)[0], hawser.routes(path, reverse=True)[0]
    assert back.at(0.0)["position"] == pytest.approx(forth.at(forth.length)["position"], abs=1e-3)
    with pytest.raises(hawser.CaseError, match="no such"):
        hawser.routes(path, name="no such line")
    with pytest.raises(hawser.CaseError):
        hawser.routes(ROOT / "none.dxf")


def test_the_catalogue(program):
    said = subprocess.run([program, "library", "--format", "json"], capture_output=True, check=True).stdout
    whole = hawser.library()
    assert len(whole) == len(json.loads(said)["entries"]) > 100
    cables = hawser.library("cables", "630")
    assert set(cables["kind"]) == {"cables"} and cables["name"].str.contains("630").all()
    for of in ("case", "study", "job", "summary"):
        assert hawser.schema(of) == json.loads(subprocess.run([program, "schema", of], capture_output=True, check=True).stdout)
    assert hawser.schema() == hawser.schema("case")
    with pytest.raises(ValueError, match="allowed are case, study, job, summary"):
        hawser.schema("pull")
    with pytest.raises(hawser.CaseError, match="no such kind|cables"):
        hawser.library("no such kind")


def test_a_job(tmp_path, program):
    path = ROOT / "cases" / "jobs" / "ducts.yaml"
    job = hawser.job(path)
    said = json.loads(subprocess.run([program, "job", path, "--format", "json"], capture_output=True, check=True).stdout)
    assert job.data == said | {"title": job.data["title"]} and str(job.verdict) == "NOT SAFE"
    assert list(job.pulls["name"]) == ["S1", "S2", "S3", "S4", "S5", "S6"] and len(job.reels) == 4 and len(job.bays) == 7
    assert job.page(tmp_path / "job.html").stat().st_size > 100_000 and job.workbook(tmp_path / "job.xlsx").is_file()
    assert "6 pulls: 5 SAFE, 1 NOT SAFE" in str(job)
    with pytest.raises(hawser.OutputError):
        job.page(tmp_path / "none" / "job.html")


def test_a_measured_pull(tmp_path, program):
    """What the command says of the same, and what options change."""
    result = hawser.run(ROOT / "cases" / "huangjiahu.yaml", set={"run.duration": "12 s", "run.steady_from": "6 s"}, out=tmp_path / "pull")
    log = ROOT / "cases" / "studies" / "pull.csv"
    said = subprocess.run([program, "compare", str(tmp_path / "pull"), str(log), "--json"], capture_output=True, check=True).stdout
    found = result.against(log, page=tmp_path / "page.html")
    assert found == json.loads(said)
    assert (tmp_path / "page.html").read_text().startswith("<!doctype html>")
    assert result.against(log, band=0.5) != found
    with pytest.raises(ValueError, match="length"):
        result.against(log, align="luck")
    with pytest.raises(hawser.CaseError):
        result.against(tmp_path / "none.csv")


def test_a_mock_up_unit(tmp_path, program):
    """The bytes that the command writes."""
    path = DATA / "hold-tension.yaml"
    for version in (2, 3):
        subprocess.run([program, "fmu", str(path), "--fmi", str(version), "-o", str(tmp_path / "command.fmu")], capture_output=True, check=True)
        assert hawser.Case(path).fmu(tmp_path / "python.fmu", version=version) == tmp_path / "python.fmu"
        assert (tmp_path / "python.fmu").read_bytes() == (tmp_path / "command.fmu").read_bytes()
    with pytest.raises(hawser.CaseError, match="FMI"):
        hawser.Case(path).fmu(tmp_path / "python.fmu", version=1)


def test_a_certificate():
    seen = []
    certificate = hawser.certify(DATA / "certify.yaml", progress=seen.append)
    figures = certificate.figures.set_index("name")
    assert certificate.certified and certificate.verdict.startswith("CERTIFIED: ")
    assert (figures["bar"] <= figures["allowed"]).all() and "pull, mean" in figures.index
    assert len(certificate.runs) >= 3 and certificate.verdict in str(certificate)
    assert seen and 0 <= seen[-1].done <= 1
    with pytest.raises(hawser.Stopped):
        hawser.certify(DATA / "certify.yaml", progress=lambda now: True)
    with pytest.raises(hawser.CaseError, match="tolerance"):
        hawser.certify(DATA / "certify.yaml", tolerance=2)


STUDY = """
title: Friction of a short pull
case: {case}
parameters:
  friction: {{key: friction.mu, values: [0.1, 0.2, 0.3]}}
grid: [friction]
fidelity: theory
"""


@pytest.fixture
def file(tmp_path, pull):
    path = tmp_path / "study.yaml"
    path.write_text(STUDY.format(case=pull))
    return path


def test_a_study(file, tmp_path):
    seen = []
    study = hawser.study(file, tmp_path / "out", jobs=2, progress=seen.append)
    assert list(study.samples["friction"]) == [0.1, 0.2, 0.3]
    force = study.samples["reference_total_N"]
    assert force.to_numpy() == pytest.approx(3924 * np.array([0.1, 0.2, 0.3]), rel=1e-6)
    assert study.summary["done"] == 3 and str(study) == study.answer != ""
    assert seen[-1]["done"] == 3
    assert list(hawser.Study(tmp_path / "out").samples["friction"]) == [0.1, 0.2, 0.3]


def test_the_page_of_a_study(file, tmp_path):
    study = hawser.study(file, tmp_path / "out")
    page = study.report(tmp_path / "page.html")
    assert page.read_bytes() == (tmp_path / "out" / "study.html").read_bytes()


def test_sensitivities(pull):
    theory = hawser.Case(pull).sensitivities()
    assert len(theory.names) > 0 and "friction" in str(theory)
    run = hawser.Case(pull).sensitivities("friction.mu")["sensitivities"]
    here = hawser.Case(pull).sensitivities("all")["sensitivities"]
    by = here[(here["key"] == "friction.mu") & (here["figure"] == "pull")]
    assert set(run["key"]) == {"friction.mu"} < set(here["key"])
    # a position and the mean of the steady window, of 10 m of 20 kg/m
    assert by["slope_N_per_unit"].iloc[0] == pytest.approx(20 * 10 * 9.81, rel=0.05)
    with pytest.raises(hawser.CaseError, match="friction.my"):
        hawser.Case(pull).sensitivities("friction.my")


def test_studies_that_are_wrong(file, tmp_path):
    with pytest.raises(hawser.CaseError) as found:
        file.write_text(file.read_text().replace("fidelity: theory", "fidelity: hearsay"))
        hawser.study(file, tmp_path / "out")
    assert (found.value.file, found.value.key) == (str(file), "fidelity") and found.value.line > 0
    with pytest.raises(FileNotFoundError, match="no study"):
        hawser.Study(tmp_path)


def test_a_study_is_stopped(file, tmp_path):
    file.write_text(file.read_text().replace("fidelity: theory", "fidelity: run").replace("[0.1, 0.2, 0.3]", str([k / 1000 for k in range(1, 400)])))
    with pytest.raises(hawser.Stopped):
        hawser.study(file, tmp_path / "out", progress=lambda now: now["done"] > 0)
    done = hawser.Study(tmp_path / "out").summary["done"]
    assert 0 < done < 399

    def press(now):
        if now["done"] > done:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        hawser.study(file, tmp_path / "out", progress=press)
    assert hawser.Study(tmp_path / "out").summary["done"] >= done


def test_crew_sheet_and_place(tmp_path):
    """A side for the crew; the case with pits that keep its limits, which broken ones did not."""
    text = (ROOT / "docs" / "tutorial" / "duct.yaml").read_text(encoding="utf-8")
    path = tmp_path / "duct.yaml"
    path.write_text(text, encoding="utf-8")
    case = hawser.Case(path)
    assert "Where somebody stands" in case.crew_sheet(tmp_path / "crew.html").read_text(encoding="utf-8")
    rows = case.place("pits", to=tmp_path / "pits.yaml").set_index("with")
    assert rows.verdict_code["nothing"] == "not_safe" and rows.verdict_code["pits"] == "safe"
    assert hawser.Case(tmp_path / "pits.yaml").theory().facts["verdict_code"] == "safe"
    with pytest.raises(ValueError, match="allowed are"):
        case.place("ropes")
