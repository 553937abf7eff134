"""Runs and their results."""
from __future__ import annotations

import fcntl
import gc
import os
import signal
import subprocess
import sys
import tarfile
import threading

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT

TABLES = ("series.csv", "stations.csv", "rollers.csv", "route.csv", "inputs.csv")


def test_a_run_is_that_of_the_command(pull, by_command, tmp_path):
    result = hawser.run(pull, set={"friction.mu": 0.25}, out=tmp_path / "by-python")
    folder = by_command(pull, "--set", "friction.mu=0.25")
    for name in TABLES:
        assert (result.folder / name).read_bytes() == (folder / name).read_bytes(), name
    assert result.outcome == "finished"
    assert hawser.Result(folder).summary["pull_force"] == result.summary["pull_force"]
    assert result.summary["pull_force"]["steady_mean_N"] == pytest.approx(0.25 * 200 * 9.81, rel=0.02)


def test_tables(pull):
    result = hawser.run(pull)
    assert list(result.series.columns[:2]) == ["time_s", "winch_force_N"]
    assert result.series["time_s"].is_monotonic_increasing and result.series["time_s"].iloc[-1] == 2
    middle = result.stations.set_index("name").loc["middle"]
    assert middle["s_m"] == 7 and middle["mean_N"] == pytest.approx(middle["reference_N"], rel=0.05)
    assert result.rollers["rating_N"].eq(5000).all() and result.rollers["steady_N"].max() > 190
    assert result.inputs.set_index("key").loc["friction.mu", "value"] == "0.2"
    assert result.limits.empty and result.events.empty and result.conveyors.empty and result.modes.empty
    assert result.trust["holds"].dtype == bool
    assert result.verdict.word == "NOT TRUSTED" and result.verdict.safe is None and not result.verdict.trusted


def test_limits_and_verdict():
    result = hawser.run(DATA / "limits.yaml")
    limits = result.limits.set_index("name")
    assert result.verdict.safe is bool(all(limits["ok"].dropna()))
    assert str(result.verdict).startswith(result.verdict.word)
    judged = limits[limits["ok"].notna()]
    assert (judged["ok"].astype(bool) == (judged["margin"] >= 0)).all()
    page = result._repr_html_()
    assert result.verdict.word in page and "<table" in page and "pull" in page


@pytest.mark.parametrize("text, word, safe, trusted", [
    ("SAFE: all 6 limits hold", "SAFE", True, True), ("NOT SAFE: 1 of 12 limits broken", "NOT SAFE", False, True),
    ("NOT JUDGED: the case has no section 'limits'", "NOT JUDGED", None, True),
    ("NOT TRUSTED: energy; 2 more", "NOT TRUSTED", None, False)])
def test_verdicts_for_programs(text, word, safe, trusted):
    verdict = hawser.Verdict(text)
    assert (verdict.word, verdict.safe, verdict.trusted) == (word, safe, trusted)


def test_states(pull):
    xarray = pytest.importorskip("xarray")
    states = hawser.run(pull, set={"output.states": "250 ms"}).states
    assert isinstance(states, xarray.Dataset)
    assert states["position"].dims == ("time", "segment", "xyz") and states["position"].shape == (9, 20, 3)
    assert states["tension"].shape == (9, 21) and states["tension"].attrs["units"] == "N"
    assert states["roller_load"].sel(roller="R5").shape == (9,)
    moved = states["position"].sel(xyz="x").isel(segment=19)
    assert float(moved[-1] - moved[0]) == pytest.approx(0.15, rel=0.02)  # half a second of ramp


def test_states_while_they_are_written(pull):
    result = hawser.run(pull)
    with open(result.folder / "results.h5", "rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        threading.Timer(0.3, fcntl.flock, (file, fcntl.LOCK_UN)).start()
        assert len(result.states["time"]) == 5
        fcntl.flock(file, fcntl.LOCK_EX)
        with pytest.raises(hawser.OutputError, match="try again"):
            hawser.Result(result.folder).states
    (result.folder / "results.h5.journal").touch()
    with pytest.raises(hawser.OutputError, match="--resume"):
        hawser.Result(result.folder).states


def test_states_without_xarray(pull, monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    states = hawser.run(pull).states
    assert isinstance(states, dict) and states["position"].shape == (5, 20, 3)
    monkeypatch.setitem(sys.modules, "h5py", None)
    with pytest.raises(ImportError, match="python3-h5py"):
        hawser.run(pull).states


def test_texts_of_tables_are_as_they_were(pull):
    result = hawser.run(pull, set={"output.stations": '[{name: "=1+1", at: 7 m}, {name: "NA", at: 8 m}]'})
    assert {"=1+1", "NA"} <= set(result.stations["name"])


def test_report_and_plots(pull, tmp_path, monkeypatch):
    result, opened = hawser.run(pull), []
    monkeypatch.setattr("webbrowser.open", opened.append)
    assert result.report() == result.folder / "report.html" and not opened
    page = result.report(tmp_path / "page.html", open=True)
    assert "A short pull" in page.read_text() and opened == [page.as_uri()]
    assert result.plot().startswith("<svg") or "<svg" in result.plot()[:200]
    assert result.plot("series")._repr_svg_() == str(result.plot("series"))
    with pytest.raises(ValueError, match="tension, series, rollers, plan"):
        result.plot("no such figure")
    both = hawser.compare([result, hawser.run(pull, set={"friction.mu": 0.3})], tmp_path / "both.html")
    assert both.stat().st_size > page.stat().st_size


def test_a_folder_of_its_own_goes_with_the_result(pull, tmp_path):
    result = hawser.run(pull)
    folder = result.folder
    kept = result.save(tmp_path / "kept")
    assert folder.is_dir()
    del result
    gc.collect()
    assert not folder.exists()
    assert len(kept.series) > 10


def test_no_results(tmp_path):
    with pytest.raises(FileNotFoundError, match="summary.json"):
        hawser.Result(tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(hawser.OutputError):
        hawser.run(DATA / "cli-pull.yaml", out=tmp_path / "file" / "below")


def test_progress(pull, capfd):
    seen = []
    assert hawser.run(pull, progress=seen.append).outcome == "finished"
    assert seen[0].t == 0 and seen[-1].t == seen[-1].end == 2
    hawser.run(pull, progress=True)
    assert "t = 2.00 s of 2 s, 100 %" in capfd.readouterr().err
    hawser.run(pull)
    assert capfd.readouterr() == ("", "")


def test_a_progress_function_stops_the_run(pull):
    result = hawser.run(pull, progress=lambda now: True)
    assert result.outcome == "stopped" and result.summary["sim_time_s"] < 2


def test_what_a_progress_function_raises(pull):
    def fail(now):
        raise LookupError("of the caller's own")

    with pytest.raises(LookupError, match="of the caller's own"):
        hawser.run(pull, progress=fail)


def test_ctrl_c_ends_a_run_and_keeps_its_results(tmp_path):
    """In a process of its own: what is computed until then is there, and the process is told as Python tells it."""
    text = "import hawser; hawser.run('cases/tunnel-879.yaml', out=%r, progress=lambda now: print(now.t, flush=True))"
    child = subprocess.Popen([sys.executable, "-c", text % str(tmp_path / "out")], cwd=ROOT, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True)
    while float(child.stdout.readline()) <= 0:  # it has begun to move
        pass
    child.send_signal(signal.SIGINT)
    _, said = child.communicate(timeout=60)
    assert "KeyboardInterrupt" in said
    result = hawser.Result(tmp_path / "out")
    assert result.outcome == "stopped"
    assert 0 < result.series["time_s"].iloc[-1] == pytest.approx(result.summary["sim_time_s"])


def test_ctrl_c_ends_an_advance():
    simulation = hawser.Simulation(ROOT / "cases" / "tunnel-879.yaml")
    timer = threading.Timer(0.4, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        simulation.advance(simulation.end_time)
    timer.join()
    reached = simulation.time
    assert 0 < reached < simulation.end_time
    assert simulation.step() > reached  # it goes on


def test_a_failed_integration_keeps_what_it_had(pull):
    few = {"solver.max_steps": 20}
    with pytest.raises(hawser.RunError) as found:
        hawser.run(pull, set=few)
    assert "t = " in str(found.value) and found.value.result.outcome == "failed"
    assert 0 < found.value.t <= found.value.result.summary["sim_time_s"] + 1e-9
    assert len(found.value.result.series) >= 1
    simulation = hawser.Simulation(pull, set=few)
    with pytest.raises(hawser.RunError):
        simulation.run_quietly()
    assert simulation.summary["outcome"] == "failed"


@pytest.mark.parametrize("number", [1, 2])
def test_states_of_older_formats(tmp_path, number):
    """Format 1: names as texts of one length and `unit` in place of `units`. Format 2: a second copy of each state in `frames`."""
    h5py = pytest.importorskip("h5py")
    with tarfile.open(DATA / f"format-{number}.tar.gz") as archive:
        archive.extractall(tmp_path)
    with h5py.File(tmp_path / f"format-{number}" / "results.h5") as file:
        assert file.attrs.get("format", 1) == number and ("frames" in file) == (number == 2)
        assert (file["roller_name"].dtype == "S64", "unit" in file["tension"].attrs) == (number == 1, number == 1)
    result = hawser.Result(tmp_path / f"format-{number}")
    assert ("format" in result.summary) == (number > 1) and result.outcome == "finished"
    states = result.states
    assert np.shape(states["position"]) == (3, 22, 3) and float(np.max(states["tension"])) == pytest.approx(1864.317, abs=1e-3)
    if hasattr(states, "coords"):
        assert list(states["roller"].values) == ["drum"] and states["tension"].attrs["units"] == "N"
