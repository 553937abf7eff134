"""Handles that defend themselves: cases in many threads, in other processes and under set=; results that leave their process; call-backs
that take themselves away; texts, numbers and files that are none. The old wrong value stands beside each."""
from __future__ import annotations

import copy
import gc
import multiprocessing
import os
import pickle
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import hawser
import numpy as np
import pytest
from conftest import ROOT
from test_case import PULL


def total(case, **options) -> float:
    return hawser.theory(case, **options).facts["reference_total_N"]


def test_a_case_stays_as_it_is_under_set(pull):
    case = hawser.Case(pull)
    assert total(case) == pytest.approx(784.8)
    assert total(case, set={"friction.mu": 0.5}) == pytest.approx(1962)
    assert total(case) == pytest.approx(784.8)  # 1962 before: set= changed the caller's case
    with pytest.raises(hawser.CaseError):
        case.set({"friction.mu": 0.5, "friction..x": 1})
    assert total(case) == pytest.approx(784.8)  # all of the settings or none


def test_one_case_in_many_threads(pull):
    """Runs and theory, each with a friction of its own. Before: 390 N for 190 N, aborts, faults."""
    case, frictions = hawser.Case(pull), (0.1, 0.2, 0.3, 0.4)
    alone = {mu: (total(pull, set={"friction.mu": mu}), hawser.run(pull, set={"friction.mu": mu}).series["winch_force_N"].tolist())
             for mu in frictions}

    def work(mu: float) -> tuple[float, list[float]]:
        return total(case, set={"friction.mu": mu}), hawser.run(case, set={"friction.mu": mu}).series["winch_force_N"].tolist()

    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(work, frictions * 2))
    assert together == [alone[mu] for mu in frictions * 2]
    assert alone[0.1][0] == pytest.approx(392.4) and alone[0.1][1][-1] == pytest.approx(196, rel=0.05)


def test_a_case_is_set_while_others_use_it(pull):
    """Each call works on the case as it was when the call began."""
    case = hawser.Case(pull)
    with ThreadPoolExecutor(3) as pool:
        found = [pool.submit(total, case) for _ in range(60)]
        for k in range(60):
            case.set({"friction.mu": (0.2, 0.4)[k % 2]})
    assert {round(f.result(), 1) for f in found} <= {784.8, 1569.6}
    case._setting.acquire()  # another thread is in set()
    with pytest.raises(RuntimeError, match="another thread"):
        case.set({"friction.mu": 0.1})


@pytest.mark.parametrize("twin", [copy.copy, copy.deepcopy, hawser.Case.copy, lambda case: pickle.loads(pickle.dumps(case))])
def test_copies_of_a_case(pull, twin):
    case = hawser.Case(pull, set={"friction.mu": 0.3})
    other = twin(case).set({"title": "another"})
    case.set({"friction.mu": 0.1})
    assert (other["friction.mu"], case["friction.mu"], other["title"]) == (0.3, 0.1, "another")
    assert case.get("title") != "another" and other.name == case.name
    with pytest.raises(hawser.CaseError) as found:
        other.set({"friction.mu": "much"}).check()
    assert found.value.key == "friction.mu"
    with pytest.raises(hawser.CaseError, match="cannot write"):  # its own file, also of a copy, is not written over
        hawser.Case.fmu(twin(hawser.Case(pull)), pull)


def test_a_case_goes_to_other_processes(pull, tmp_path, monkeypatch):
    """It could not be pickled. What it includes is found from there, too; a message has the file and the key, but no line that is wrong."""
    (tmp_path / "own.yaml").write_text("cables: {ours: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n")
    case = hawser.Case({**PULL, "include": ["own.yaml"], "cables": {"power": {"type": "ours"}}}, folder=tmp_path)
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert pool.submit(hawser.theory, case, set={"friction.mu": 0.1}).result().facts["reference_total_N"] == pytest.approx(392.4)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(hawser.CaseError) as found:
        pickle.loads(pickle.dumps(hawser.Case(pull, set={"friction.mu": "much"}))).check()
    assert (found.value.file, found.value.line, found.value.key) == (pull, None, "friction.mu")


def test_a_case_is_read(pull):
    case = hawser.Case(pull, set={"friction.mu": 0.25, "solver.relax": False})
    assert case["friction.mu"] == 0.25 and case["chain.0.length"] == "10 m" and case["solver.relax"] is False
    assert case["route.pieces.row.straight"] == "20 m" and isinstance(case["chain"], list)
    assert case.get("friction.mu_s") is None and case.get("friction.mu.x", 7) == 7 and case.get("chain.9", "none") == "none"
    assert "friction.mu" in case and "friction.mu_s" not in case
    with pytest.raises(KeyError, match="friction.mu_s"):
        case["friction.mu_s"]
    assert hawser.Case(case.as_dict()).describe() == {**case.describe(), "title": case["title"]}


def test_a_result_leaves_its_process(pull):
    """Its folder was gone with the process's own copy."""
    with ProcessPoolExecutor(1) as pool:
        result = pool.submit(hawser.run, pull).result()
    assert result.series["time_s"].iloc[-1] == 2 and result.verdict.word == "NOT TRUSTED"
    other = pickle.loads(pickle.dumps(result))
    assert other.folder != result.folder
    shared, folder = copy.copy(result), result.folder
    del result
    gc.collect()
    assert len(shared.stations) > 0 and len(other.stations) == len(shared.stations)
    del shared
    gc.collect()
    assert not folder.exists() and other.folder.exists()


def test_a_result_with_a_folder_takes_its_path(pull, tmp_path):
    result = hawser.run(pull, out=tmp_path / "out")
    assert pickle.loads(pickle.dumps(result)).folder == tmp_path / "out"


def test_a_forked_process_leaves_folders_and_refuses_what_is_at_work(pull):
    """A child that drops a result does not take the parent's folder away; a simulation that was at work in a thread of the parent's raises."""
    result, simulation = hawser.run(pull), hawser.Simulation(pull)
    with ThreadPoolExecutor(1) as pool:
        pool.submit(simulation._handle._lock.acquire).result()  # a call of another thread's
        child = os.fork()
        if child == 0:
            status = 1
            try:
                simulation.step()
            except RuntimeError:
                del result
                status = 0
            os._exit(status)
        assert os.waitpid(child, 0)[1] == 0
    assert result.folder.exists()


@pytest.mark.parametrize("register", ["on_log", "on_step", "on_event"])
def test_a_call_back_takes_itself_away(register):
    """And raises: the interpreter was aborted."""
    simulation, called = hawser.Simulation(PULL), []

    def once(*_: object) -> None:
        called.append(1)
        getattr(simulation, register)(None)
        gc.collect()
        raise LookupError(register)

    getattr(simulation, register)(once)
    with pytest.raises(LookupError, match=register):
        simulation.control("winch_speed", 0.1)
        simulation.advance(0.3)
    assert simulation.advance(0.5) == 0.5 and len(called) == 1  # Stopped, if it was an event's within control()


def test_a_simulation_is_neither_copied_nor_pickled(pull):
    for twin in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="state"):
            twin(hawser.Simulation(pull))


def test_a_nul_is_refused(pull, tmp_path):
    """C took it for the text's end: limits behind it were not judged, NOT SAFE became NOT JUDGED."""
    text = open(pull).read()
    with pytest.raises(hawser.CaseError, match=f"<text>:{text.count(chr(10)) + 1}: a NUL"):
        hawser.Case(text + "\0\nlimits: {}\n")
    for wrong in (lambda: hawser.Case({**PULL, "title": "a\0b"}), lambda: hawser.Case(pull, set={"title": "a\0b"})):
        with pytest.raises(hawser.CaseError, match="NUL") as found:
            wrong()
        assert found.value.key == "title"
    simulation = hawser.Simulation(pull)
    for wrong in (lambda: hawser.Case(pull + "\0"), lambda: hawser.Case(pull, set={"ti\0tle": 1}), lambda: hawser.Case(pull)["friction.mu\0x"],
                  lambda: hawser.Case(PULL, folder="/tmp\0x"), lambda: hawser.library("cables\0x"), lambda: hawser.routes("x.dxf\0"),
                  lambda: simulation.control("jam", on="R11\0"), lambda: simulation.save(f"{tmp_path}/s\0"), lambda: hawser.Result(f"{tmp_path}\0")):
        with pytest.raises(ValueError, match="NUL|null"):
            wrong()


@pytest.mark.parametrize("wrong", [{"force": [0]}, {"force": (1, 2)}, {"force": (1, 2, 3, 4)}, {"force": (1, 2, 3), "moment": (0, 0)},
                                   {"force": (1, 2, 3), "arm": 0}, {"force": "123"}, {"force": (1, 2, float("nan"))}])
def test_a_force_has_three_numbers(wrong):
    """[0] and (1, 2) were taken, with 0 for the rest."""
    simulation = hawser.Simulation(PULL)
    with pytest.raises(hawser.CaseError, match="three numbers|not finite"):
        simulation.force(1, **wrong)
    assert simulation.events.empty


@pytest.mark.parametrize("settings, key", [({"friction.mu": float("nan")}, "friction.mu"), ({"friction": {"mu": float("inf")}}, "friction.mu"),
                                           ({"chain": [{"length": np.array([1, np.nan])}]}, "chain.0.length.1")])
def test_nan_has_its_key(pull, settings, key):
    """"Out of range float values are not JSON compliant", without a key."""
    for wrong in (lambda: hawser.Case(pull, set=settings), lambda: hawser.Case({**PULL, **settings}) if "." not in next(iter(settings)) else
                  hawser.run(pull, set=settings)):
        with pytest.raises(hawser.CaseError, match="finite") as found:
            wrong()
        assert found.value.key == key


@pytest.mark.parametrize("read", [hawser.Case, hawser.run, hawser.theory, hawser.Result, hawser.Study, hawser.routes, hawser.resume,
                                  lambda path: hawser.study(path, path), lambda path: hawser.Simulation(PULL).load(path)])
def test_what_is_not_there(tmp_path, read):
    """CaseError or OutputError before."""
    with pytest.raises(FileNotFoundError) as found:
        read(tmp_path / "none")
    assert isinstance(found.value, hawser.MissingError) and isinstance(found.value, hawser.CaseError)
    assert str(found.value.filename).startswith(str(tmp_path / "none")) and "none" in str(found.value)
    assert str(pickle.loads(pickle.dumps(found.value))) == str(found.value)


def test_nothing_runs_from_the_current_folder(pull, tmp_path):
    """A json.py there ran in the study's process."""
    (tmp_path / "json.py").write_text("raise SystemExit('the json.py of this folder ran')\n")
    (tmp_path / "study.yaml").write_text(f"case: {pull}\nparameters: {{f: {{key: friction.mu, values: [0.1, 0.2]}}}}\ngrid: [f]\nfidelity: theory\n")
    (tmp_path / "main").mkdir()
    (tmp_path / "main" / "script.py").write_text("import hawser; print(hawser.study('study.yaml', 'out', jobs=1).summary['done'])\n")
    said = subprocess.run([sys.executable, "main/script.py"], cwd=tmp_path, capture_output=True, text=True)
    assert said.stdout == "2.0\n", said.stderr


def test_routes_in_many_threads():
    """Lines are made routes when they are first used, whoever is first."""
    route = hawser.routes(ROOT / "tests" / "data" / "route.dxf")[0]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: route.at(0.5)["position"].tolist(), range(40)))
    assert found == 40 * [route.at(0.5)["position"].tolist()]


def test_routes_in_a_forked_process():
    """The child waited for ever for a thread that it has not got."""
    route = hawser.routes(ROOT / "tests" / "data" / "route.dxf")[0]
    for held in (True, False):
        if held:
            route._lock.__enter__()
        child = os.fork()
        if child == 0:
            status = 1
            try:
                status = 0 if route.length > 0 and not held else 2
            except RuntimeError as why:
                status = 0 if held and "forked" in str(why) else 3
            os._exit(status)
        assert os.waitpid(child, 0)[1] == 0
        if held:
            route._lock.__exit__()
    assert route.length > 0


def test_a_resumed_case_has_no_lines(pull, tmp_path):
    """The case stands in the checkpoint in other words than in its file: the file's name stood there with lines of those."""
    text = open(pull).read()
    (tmp_path / "case.yaml").write_text(text)
    simulation = hawser.Simulation(hawser.Case(tmp_path / "case.yaml", set={"run.duration": "100 s"}))
    assert simulation.run(tmp_path / "out", progress=lambda now: time.sleep(0.3) or now.t > 0).outcome == "stopped"
    case = hawser.Case.of_run(tmp_path / "out").set({"friction.mu": 0.1})
    with pytest.raises(hawser.CaseError) as found:
        hawser.Case.of_run(tmp_path / "out").set({"friction": "{mu: 0.1, law: none}"}).check()
    assert found.value.line is None and case["friction.mu"] == 0.1
