"""Cases, their settings and what is wrong with them; theory."""
from __future__ import annotations

import json
import subprocess

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT

POWER = {"EA": "50 MN", "GA": "20 MN", "GJ": "8 kN m2", "EI": "10 kN m2", "d": "90 mm", "mass": "20 kg/m"}
PULL = {"title": "From a dict", "cables": {"power": POWER},
        "chain": [{"cable": "power", "length": "10 m", "segment": "500 mm"}],
        "route": {"head_at": "12 m", "pieces": [{"straight": "20 m", "name": "row"}]},
        "rollers": {"along": {"spacing": "1 m"}}, "friction": {"mu": 0.2},
        "drive": {"winch": {"speed": "6 m/min", "to": "1 s"}}, "run": {"duration": "2 s", "steady_from": "1500 ms"}}


def test_the_same_case_from_file_text_and_dict(pull):
    text = open(pull).read()
    found = [hawser.Case(source).describe() for source in (pull, text, PULL)]
    assert found[0] == found[1]
    assert {**found[2], "title": ""} == {**found[0], "title": ""}
    assert found[2]["title"] == "From a dict"
    assert found[0]["segments"] == 20


@pytest.mark.parametrize("value", [0.3, "0.3", np.float64(0.3)])
def test_settings(pull, value):
    assert hawser.Case(pull, set={"friction.mu": value}).describe()["friction"] == 0.3
    assert hawser.Case(pull).set({"friction.mu": 1}).set({"friction.mu": value}).describe()["friction"] == 0.3


def test_numbers_are_si():
    case = hawser.Case({**PULL, "run": {"duration": 2.0, "steady_from": np.float64(1.5)}, "route": {"head_at": 12, "pieces": [{"straight": 20}]}})
    found = case.describe()
    assert (found["duration_s"], found["steady_from_s"], found["route_length_m"]) == (2, 1.5, 20)


def test_settings_of_other_kinds(pull):
    case = hawser.Case(pull, set={"solver.relax": False, "route.pieces": [{"straight": "30 m"}], "rollers": {"along": {"spacing": "2 m"}}})
    assert case.describe()["route_length_m"] == 30
    assert case.describe()["rollers"] == 16
    for wrong in ({1, 2}, object()):
        with pytest.raises(TypeError, match="a case cannot hold"):
            case.set({"friction.mu": wrong})
    with pytest.raises(ValueError):
        case.set({"friction.mu": float("nan")})


def test_a_wrong_value_has_its_file_key_and_line():
    path = str(DATA / "wrong-unit.yaml")
    with pytest.raises(hawser.CaseError, match="unknown unit 'mn'") as found:
        hawser.Case(path).check()
    assert (found.value.file, found.value.key, found.value.line) == (path, "chain.0.segment", 7)
    assert "500 mn" in open(path).read().splitlines()[6]


def test_a_wrong_setting_has_its_key(pull):
    with pytest.raises(hawser.CaseError) as found:
        hawser.Case(pull, set={"friction.mu": "much"}).check()
    assert (found.value.file, found.value.key, found.value.line) == (None, "friction.mu", None)
    with pytest.raises(hawser.CaseError, match="did you mean 'friction'") as found:
        hawser.run(pull, set={"frictoin.mu": 0.2})
    assert found.value.key == "frictoin"


def test_a_wrong_dict_has_its_key():
    with pytest.raises(hawser.CaseError) as found:
        hawser.run({**PULL, "friction": {"mu": -1}})
    assert (found.value.file, found.value.key, found.value.line) == (None, "friction.mu", None)
    assert isinstance(found.value, ValueError)


def test_what_is_no_case(tmp_path):
    with pytest.raises(hawser.CaseError, match="cannot be opened") as found:
        hawser.Case(tmp_path / "none.yaml")
    assert found.value.file == str(tmp_path / "none.yaml")
    with pytest.raises(hawser.CaseError, match="a case is a map") as found:
        hawser.Case("- a\n- b\n")
    assert found.value.line == 1
    with pytest.raises(hawser.CaseError) as found:
        hawser.Case("a: [1\nb: 2\n")
    assert found.value.line in (1, 2) and found.value.file == "<text>"
    with pytest.raises(TypeError):
        hawser.Case(7)


def test_a_text_finds_its_files_in_its_folder(tmp_path):
    (tmp_path / "own.yaml").write_text(json.dumps({"cables": {"ours": POWER}}))
    case = {**PULL, "include": ["own.yaml"], "cables": {"power": {"type": "ours"}}}
    with pytest.raises(hawser.CaseError, match="include"):
        hawser.Case(case).check()
    assert hawser.Case(case, folder=tmp_path).describe()["segments"] == 20


def test_theory_is_that_of_the_command(program):
    path = str(ROOT / "cases" / "theory" / "planner.yaml")
    said = json.loads(subprocess.run([program, "theory", path, "--format", "json"], capture_output=True, check=True).stdout)
    theory = hawser.theory(path)
    assert theory.data == said
    assert theory.facts["backward_total_N"] == said["backward_total_N"]
    assert list(theory.stations["reference_N"]) == [row["reference_N"] for row in said["stations"]]
    assert set(theory.names) == {key for key, value in said.items() if isinstance(value, list)}
    assert theory.verdict("forward").word == "NOT SAFE" and theory.verdict("backward").safe is False
    assert theory.limits.query("direction == 'forward' and name == 'restart'")["margin"].item() < 0
    assert "Ducts, four bends and a pit" in str(theory) and "<b>forward NOT SAFE" in theory._repr_html_()
    with pytest.raises(KeyError, match="pieces"):
        theory["no such table"]


def test_theory_without_a_bend_is_mu_m_g(pull):
    theory = hawser.theory(pull, set={"friction.mu": 0.25})
    assert theory.facts["reference_total_N"] == pytest.approx(0.25 * 20 * 9.81 * 20, rel=1e-6)
    assert hawser.theory(pull).limits.empty


def test_equipment(pull):
    table = hawser.Case(pull).equipment()
    assert list(table["kind"]) == 21 * ["roller"] + ["winch"]
    assert table["station_m"].tolist() == [*range(21), 20]


def test_names_of_any_alphabet(pull):
    case = hawser.Case({**PULL, "title": "Überlandtrasse 黄家湖"})
    assert case.simulation().title == "Überlandtrasse 黄家湖"
    assert repr(case) == "hawser.Case('<dict>')"
    assert "Überlandtrasse" in str(case)
