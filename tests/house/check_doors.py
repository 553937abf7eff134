"""Files of results folders are opened, renamed and deleted by core/base/file alone, and objects of HDF5 that are read by
io/results/hdf5.c, of Python by hawser/_door.py: whoever made a folder may have put anything into it.

Usage: check_doors.py ROOT
"""
import pathlib
import re
import sys

import tree

OPENS = re.compile(r"\b(fopen|freopen|open|openat|creat|rename|renameat2?|unlink|unlinkat|remove|rmdir|mkdir|mkdirat|mkstemp|mkostemps?"
                   r"|mkdtemp|opendir|scandir|truncate|link|symlink|json_load_file|json_dump_file)\s*\(")
CONTAINERS = re.compile(r"\b(H5Fopen|H5Fcreate|H5Dopen2?|H5Gopen2?|H5Oopen\w*|H5Aopen\w*|H5Lexists|H5Lget_info\w*|H5Pset_elink\w*)\s*\(")

# What opens files, and why that is not within a results folder that somebody else may have made.
FILES = {
    "core/file.c": "the door itself",
    "cli/inspect.c": "theory --crew FILE: named by the user",
    "cli/main.c": "/dev/null",
    "cli/pdf.c": "/dev/null; the PDF beside its name, new and under a random one",
    "fmi/archive.c": "an archive, which the user names; its own temporary folder",
    "io/case/library.c": "the catalogue",
    "io/results/results_file.c": "the folder itself, which the user names, and those above it",
    "io/case/yaml.c": "a case, which the user names",
    "study/evaluate.c": "files of a case",
    "survey/input.c": "a route's file, which the user names",
    "survey/write.c": "a route's file, which the user names",
}
# What opens objects of HDF5: those it has made itself, or resumes after the door has checked them all.
OBJECTS = {
    "io/results/hdf5.c": "the door itself",
    "io/results/hdf5.c": "a file by its descriptor",
    "io/results/results_h5.c": "the file that it writes",
    "io/results/states_data.c": "groups that it has made",
    "study/table.c": "a file by its descriptor",
}
# Of Python: what opens a file by its name, and lines that do so with a file of their own.
BY_NAME = re.compile(r"(?<![\w.])open\(|\.(read_text|read_bytes)\(|os\.open\(|h5py\.File\(|pd\.read_csv\(|file\[")
OWN_FILES = ("file.read_bytes() for file in self.folder.rglob", "pathlib.Path(scratch)", "held(self.folder) as held_file", "io.BytesIO(_door.read(")


def check_python(root):
    complaints = []
    for path in sorted(pathlib.Path(root, "python", "hawser").glob("*.py")):
        for k, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if path.name != "_door.py" and BY_NAME.search(line) and not any(own in line for own in OWN_FILES):
                complaints.append(f"python/hawser/{path.name}:{k}: a file past _door.py")
    return complaints


def check(root):
    complaints = check_python(root)
    for path in tree.sources(root, [top for top in tree.BELOW if top != "include"] + ["cli", "mpi"]):
        if not path.endswith(".c"):
            continue
        code = tree.code_only(tree.read(root, path))
        for calls, allowed, door in ((OPENS, FILES, "core/base/file"), (CONTAINERS, OBJECTS, "io/results/hdf5.c")):
            if path in allowed:
                continue
            complaints += [f"{path}: {m.group(1)}() past {door}" for m in calls.finditer(code)]
    return sorted(set(complaints))


if __name__ == "__main__":
    sys.exit(tree.report("doors", check(sys.argv[1])))
