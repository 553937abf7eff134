"""How a command ended of which a call failed, against how it ends when none does."""
import functools
import json

import states

NEAR = 16  # bytes

STATUS = {"memory": {0, 5}, "heap": {0, 5}, "disk": {0, 4}, "full": {0, 4}, "read": {0, 2, 4}, "hdf5": {0, 2, 4},
          "eintr": {0}, "short": {0}}
# One of what the message says, by kind and status.
LOST, NO_ROOM, SEEK = "Input/output error", "No space left", "Invalid argument"  # the last: what stdio says of a seek that fails
SAYS = {("memory", 5): ["out of memory"], ("heap", 5): ["out of memory"], ("disk", 4): [LOST, NO_ROOM, SEEK],
        ("full", 4): [NO_ROOM], ("read", 2): [LOST], ("read", 4): [LOST], ("hdf5", 2): [".h5"], ("hdf5", 4): [".h5"]}


# What depends on the clock on the wall.
CLOCK = {"wall_time_s", "real_time_factor", "steps_per_second", "phases", "phases_s", "performance"}


def leaves(value, path=()):
    """Each number and text of a JSON value, by its path."""
    if isinstance(value, dict):
        for key, v in value.items():
            if key not in CLOCK:
                yield from leaves(v, path + (key,))
    elif isinstance(value, list):
        for k, v in enumerate(value):
            yield from leaves(v, path + (k,))
    else:
        yield path, value


def same(name, content, first, second):
    """Whether a file is what both of the undisturbed runs have left, but for what differs between these two."""
    if name.endswith(".h5"):
        return states.contents(content) == states.contents(first)
    if first == second or content == first:
        return content == first
    if name.endswith(".json"):
        a, b, c = (dict(leaves(json.loads(x))) for x in (first, second, content))
        return a.keys() == c.keys() and all(a[k] != b.get(k) or a[k] == c[k] for k in a)
    if len(first) != len(second):
        return True
    return len(content) == len(first) and all(at in unsteady(first, second) for at in differing(first, content))


def differing(a, b):
    return [at for at, (x, y) in enumerate(zip(a, b)) if x != y]


@functools.lru_cache(16)
def unsteady(first, second):
    """Where two undisturbed runs differ, and near it: two names of runs may have digits in common."""
    return {k for at in differing(first, second) for k in range(at - NEAR, at + NEAR + 1)}


def results_of(files):
    """Without what a finer pass can be gone on with from: where removing fails it stays, for the next run to remove."""
    return {name: content for name, content in files.items()
            if name != "checkpoint.hawser" and not name.startswith(("second-pass/", "third-pass/"))}


def is_whole(files, reference):
    """Whether all files of a run are there, each with as many rows. What comes after it need not be."""
    after = (".html", "certificate.json", "sensitivities.json")

    def rows(of):
        return {name: content.count(b"\n") if name.endswith(".csv") else 0
                for name, content in results_of(of).items() if not name.endswith(after)}
    return rows(files) == rows(reference)


def differences(result, first, second):
    """Of one that says that all is well."""
    found = [] if result[1] == first[1] or first[1] != second[1] else ["says something else"]
    files = results_of(result[3])
    if b"out of memory" in files.get("samples.csv", b""):
        return []  # a sample that lacked memory is a row that says so
    # what a disk does not let go of stays where results of before wait
    odd = sorted(name for name in files.keys() ^ first[3].keys() if not name.startswith("earlier/"))
    if odd:
        return found + [f"other files than without a failure: {' '.join(odd)}"]
    for name, content in files.items():
        if name.endswith(".html") or name.startswith("earlier/"):
            continue  # it has its time, packed, and says that it has no view where HDF5 does not give it
        if not same(name, content, first[3][name], second[3][name]):
            found.append(f"{name} is not the same")
    return found


def faults(kind, result, first, second, before=()):
    """What is wrong with how it ended. first, second: undisturbed; before: the files that were there."""
    status, _, err, files = result
    if status is None:
        return ["hangs"]
    if status not in STATUS[kind]:
        return [f"status {status}: {err.strip()[-160:]}"]
    found = []
    if status and not any(words in err for words in SAYS[kind, status]):
        found.append(f"status {status} without its reason: {err.strip()[-160:]}")
    found += [f"{name} is left" for name in files if name.endswith(".part") and name not in before]
    found += [f"{name} is cut off" for name, content in files.items()
              if name.endswith(".html") and not content.rstrip().endswith(b"</html>")]
    for name, content in files.items():
        if not name.endswith((".json", ".geojson")):
            continue
        try:
            json.loads(content)
        except ValueError:
            return found + [f"{name} is cut off"]
    if not status:
        return found + differences(result, first, second)
    if "summary.json" in files and json.loads(files["summary.json"]).get("outcome") == "finished":
        # What ended may be the second pass, which leaves the results of the first as they were, a page or a certificate that
        # comes after the run, or the very last call, the folder's own fsync: results are whole then.
        unchanged = files.get("summary.json") == dict(before).get("summary.json")
        if not is_whole(files, first[3]) and not unchanged:
            found.append("summary.json says finished")
    return found
