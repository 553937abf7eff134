"""Results folders from somebody else: nothing outside is read, nothing hangs (SECURITY.md). Each was read before, or waited for ever."""
import json
import os
import pathlib
import shutil
import signal

import h5py
import numpy as np
import pytest

import hawser
from conftest import DATA

SECRET = b"root:x:SECRET-OF-READER\n"
TABLES = ("series", "stations", "rollers", "inputs", "route")


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hostile")
    (folder / "secret").write_bytes(SECRET * 64)
    hawser.run(DATA / "cli-pull.yaml", out=folder / "good", set={"run.duration": "200 ms", "run.steady_from": "100 ms"})
    summary = json.loads((folder / "good" / "summary.json").read_text())
    del summary["run"], summary["files"]  # by which a changed file is known
    (folder / "good" / "summary.json").write_text(json.dumps(summary))
    return folder / "good"


@pytest.fixture()
def bad(good):
    shutil.rmtree(good.parent / "bad", ignore_errors=True)
    return pathlib.Path(shutil.copytree(good, good.parent / "bad"))


@pytest.fixture(autouse=True)
def no_hang():
    signal.alarm(60)  # against hangs alone
    yield
    signal.alarm(0)


def set_replaced(file, name, kind, secret):
    """One set of results.h5 that leads to another file."""
    shape, attributes = file[name].shape, dict(file[name].attrs)
    del file[name]
    if kind == "external storage":
        plist = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        plist.set_external(os.fsencode(secret), 0, 8 * shape[0])
        h5py.h5d.create(file.id, name.encode(), h5py.h5t.IEEE_F64LE, h5py.h5s.create_simple(shape), plist)
    elif kind in ("external link", "virtual"):
        with h5py.File(secret.with_suffix(".h5"), "w") as other:
            other["t"] = np.frombuffer((SECRET * 64)[:8 * shape[0]], dtype="f8")
        if kind == "external link":
            file[name] = h5py.ExternalLink(secret.with_suffix(".h5"), "/t")
            return
        layout = h5py.VirtualLayout(shape=shape, dtype="f8")
        layout[:] = h5py.VirtualSource(str(secret.with_suffix(".h5")), "t", shape=shape)
        file.create_virtual_dataset(name, layout)
    elif kind == "soft link":
        file[name] = h5py.SoftLink("/time")
        return
    else:  # never written: 128 GiB of zeros
        file.create_dataset(name, (shape[0], 2**33), dtype="f8", chunks=(1, 1 << 20))
    for key, value in attributes.items():
        file[name].attrs[key] = value


@pytest.mark.parametrize("kind", ["external storage", "external link", "virtual", "soft link", "never written"])
def test_states_are_the_files_own(bad, kind):
    assert len(hawser.Result(bad).states["winch_force"]) > 1
    with h5py.File(bad / "results.h5", "r+") as file:
        set_replaced(file, "winch_force", kind, bad.parent / "secret")
    with pytest.raises(hawser.CaseError, match="winch_force"):
        print(hawser.Result(bad).states)


def test_names_are_the_files_own(bad):
    with h5py.File(bad.parent / "names.h5", "w") as other, h5py.File(bad / "results.h5", "r+") as file:
        other["n"] = np.array([b"SECRETNAME"] * len(file["roller_name"]), dtype="S64")
        del file["roller_name"]
        file["roller_name"] = h5py.ExternalLink(bad.parent / "names.h5", "/n")
    with pytest.raises(hawser.CaseError, match="roller_name"):
        print(hawser.Result(bad).states)


@pytest.mark.parametrize("what", ["link", "fifo", "folder"])
def test_tables_are_the_folders_own(bad, what):
    """Looked at as the folder is opened, and exchanged afterwards."""
    result = hawser.Result(bad)
    for name in (*TABLES, "summary", "states"):
        path = bad / {"summary": "summary.json", "states": "results.h5"}.get(name, f"{name}.csv")
        path.unlink()
        if what == "link":
            path.symlink_to(bad.parent / "secret")
        elif what == "fifo":
            os.mkfifo(path)
        else:
            path.mkdir()
        with pytest.raises(hawser.CaseError, match="within results"):
            print(getattr(result, name))


def test_a_study_is_the_folders_own(bad):
    (bad / "samples.csv").symlink_to(bad.parent / "secret")
    with pytest.raises(hawser.CaseError, match="within results"):
        print(hawser.Study(bad).samples)
    (bad / "summary.json").unlink()
    os.mkfifo(bad / "summary.json")
    with pytest.raises(hawser.CaseError, match="within results"):
        print(hawser.Study(bad).summary)


def test_a_copy_keeps_links(bad, tmp_path):
    (bad / "notes.txt").symlink_to(bad.parent / "secret")
    hawser.Result(bad).save(tmp_path / "saved")
    assert (tmp_path / "saved" / "notes.txt").is_symlink()
