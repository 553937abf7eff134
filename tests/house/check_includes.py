"""The include rule of docs/architecture.md: strictly downward, no circles, libraries only where they belong.

Usage: check_includes.py ROOT
"""
import os
import re
import sys

import tree

# Libraries' headers, and the only places that may see them.
LIBRARIES = [
    (r"(cvode|nvector|sunlinsol|sunmatrix|sundials|kinsol|arkode|ida|sunnonlinsol)/", r"sim/solve/"),
    (r"(suitesparse/)?(klu|amd|colamd|btf|metis)\.h$", r"linsolve/"),
    (r"(lapacke|cblas|lapack)\.h$", r"linsolve/"),
    (r"meshoptimizer\.h$", r"contact/simplify\.c"),
    (r"expat\.h$", r"survey/"),
    (r"jansson\.h$", r"io/|survey/(map|gltf)\.c|study/(evaluate|workers)\.c"),
    (r"yaml\.h$", r"io/"),
    (r"hdf5\w*\.h$", r"io/|study/table\.c"),
    (r"zlib\.h$", r"io/report/"),
    (r"nlopt\.h$", r"study/maths\.c"),
    (r"zip\.h$", r"fmi/archive\.c|survey/sheet\.c|io/api/job\.c"),
    (r"shapefil\.h$", r"survey/shape\.c"),
    (r"mpi\.h$", r"mpi/"),
]


def resolve(path, name):
    """The tree's path of an included project header; public ones are found through include/."""
    return "include/" + name if name.startswith("hawser/") else name


def stage(path):
    """How far down within its folder at the top a file is, from 0; None if its sub-folder is not in the list."""
    top, *parts = path.split("/")
    part = parts[0] if len(parts) > 1 else ""
    return next((i for i, stage in enumerate(tree.STAGES[top]) if part in stage), None)


def check_project(root, path, line, target):
    """Complaints about one include of a header of the project."""
    top, below = path.split("/")[0], target.split("/")[0]
    where = f"{path}:{line}: includes {target}"
    if not os.path.isfile(os.path.join(root, target)):
        return [f"{where}, which is not a file: write the path from the root"]
    if below != top and below not in tree.BELOW[top]:
        return [f"{where}: {top}/ may include only {', '.join(tree.BELOW[top]) or 'nothing'} and itself"]
    if below == top != "include" and os.path.dirname(path) != os.path.dirname(target) and not stage(path) < stage(target):
        return [f"{where}, which does not stand below it in the list of docs/architecture.md"]
    return []


def check_library(path, line, name):
    """Complaints about one include of a library's header."""
    return [f"{path}:{line}: includes <{name}>, which belongs in {allowed} only"
            for pattern, allowed in LIBRARIES if re.match(pattern, name) and not re.match(allowed, path)]


def add_edge(graph, path, target):
    """A header and the source of the same name are one module: what either includes, both stand above."""
    above, below = (os.path.splitext(p)[0] for p in (path, target))
    if above != below:
        graph.setdefault(above, []).append(below)


def circles(graph):
    """Every circle of modules that the depth-first search meets, as 'a -> b -> a'."""
    found, state, trail = [], {}, []

    def visit(node):
        state[node] = "open"
        trail.append(node)
        for target in graph.get(node, ()):
            if state.get(target) == "open":
                found.append(" -> ".join(trail[trail.index(target):] + [target]))
            elif target not in state:
                visit(target)
        trail.pop()
        state[node] = "done"

    for node in sorted(graph):
        if node not in state:
            visit(node)
    return found


def check(root):
    complaints, graph = [], {}
    for path in tree.sources(root, tree.BELOW):
        if not path.startswith("include/") and stage(path) is None:
            complaints.append(f"{path}: its folder is not in the list of docs/architecture.md")
            continue
        for line, quoted, name in tree.includes(tree.read(root, path)):
            public = name.startswith("hawser/")
            if not quoted and not public:
                complaints += check_library(path, line, name)
                continue
            target = resolve(path, name)
            complaints += check_project(root, path, line, target)
            add_edge(graph, path, target)
    return complaints + ["circle: " + c for c in circles(graph)]


if __name__ == "__main__":
    sys.exit(tree.report("includes", check(sys.argv[1])))
