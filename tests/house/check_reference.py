"""The comments of the public headers and the docstrings of the Python package say what a caller must know: what can
go wrong, the unit of each number with one, the shape of each array. Usage: check_reference.py TREE"""
import ast
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packaging" / "site"))
from header import FUNCTION, comment_before, plain  # noqa: E402

NAMED = re.compile(r"_(m|m2|m3|mm|s|N|rad|deg|kg|K|Pa|Hz|J|W|N_m|N_m2|N_per_m|kg_per_m|kg_per_m3|m_per_s|rad_per_s|per_m|per_s|pct|N_per_unit|unit|MB|usd)$")
UNIT = re.compile(r"(?<![\w.])(m|mm|m2|s|N|kN|rad|kg|Hz|J|W|%|N/m|N m|N m2|m/s|rad/s|1/m|1/s|1/s2|m/s2|N s/m|unit|units|SI|share|shares|factor|ratio|times|coefficients?|over|1|radii"
                  r"|pure number|number)(?![\w])")
STRUCT = re.compile(r"^typedef struct (\w+) \{\n(.*?)^\} \1;", re.M | re.S)
MEMBER = re.compile(r"^[ ]+((?:const )?double)\b([^;]*);[ \t]*(?:/\*(.*?)\*/)?", re.M | re.S)


def of_functions(path, text):
    for m in FUNCTION.finditer(text):
        kind, name, parameters, behind = m.groups()
        told = f"{comment_before(text, m.start())} {plain(behind)}".strip()
        if name.endswith("_free") or name.endswith("_close"):
            continue
        if not told:
            yield f"{path.name}: {name}: no comment"
            continue
        if "hawser_status" in kind and not re.search(r"\bErrors?:", told):
            yield f"{path.name}: {name}: no 'Errors:'"
        if kind.strip() == "double" and not (UNIT.search(told) or NAMED.search(name)):
            yield f"{path.name}: {name}: no unit of what it returns"
        for number in re.finditer(r"\b(?:const )?double (\**)(\w+)((?:\[\w*\])*)", parameters):
            star, what, size = number.groups()
            if not (NAMED.search(what) or UNIT.search(told)):
                yield f"{path.name}: {name}: no unit of {what}"


def of_members(path, text):
    for struct in STRUCT.finditer(text):
        body, last = struct.group(2), ""
        above = comment_before(text, struct.start())
        of_all = "unit" if re.search(r"\*unit;", body) else above if re.search(r"\bunits?\b|, s;", above) else ""  # the row says which
        for m in MEMBER.finditer(body):
            told = plain(m.group(3))
            known = f"{told or last} {of_all}"
            for word in m.group(2).split(","):
                name = re.search(r"(\w+)((?:\[\w+\])*)$", word.strip())
                if not name or name.group(1) == "reserved":
                    continue
                if "*" in word and not re.search(r"\[[^\]]+\]", known):
                    yield f"{path.name}: {struct.group(1)}.{name.group(1)}: no shape"
                if not (NAMED.search(name.group(1)) or UNIT.search(known)):
                    yield f"{path.name}: {struct.group(1)}.{name.group(1)}: no unit"
            last = told or last


def said_by_python(name, node, owner):
    """What is missing in the docstring of a public function or property; an owner's docstring may name its errors."""
    told = ast.get_docstring(node) or ""
    if not told:
        yield f"{name}: no docstring"
        return
    given = {a.arg: ast.unparse(a.annotation) for a in node.args.args + node.args.kwonlyargs if a.annotation}
    kind = ast.unparse(node.returns) if node.returns else ""
    if re.search(r"\bfloat\b", kind) and not UNIT.search(told):
        yield f"{name}: no unit of what it returns"
    for what, of in given.items():
        if re.search(r"\bfloat\b", of) and not (UNIT.search(told) or NAMED.search(what)):
            yield f"{name}: no unit of {what}"
    if re.search(r"\bArray\b", kind) and not re.search(r"\[[^\]]+\]", told):
        yield f"{name}: no shape"
    raised = {ast.unparse(r.exc.func) for r in ast.walk(node) if isinstance(r, ast.Raise) and isinstance(r.exc, ast.Call)}
    for error in sorted(r for r in raised if re.fullmatch(r"\w+Error", r)):
        if error not in told:
            yield f"{name}: {error} is not named"
    calls = {ast.unparse(c.func) for c in ast.walk(node) if isinstance(c, ast.Call)}
    if "check" in calls and not re.search(r"\b\w+Error\b", f"{told} {owner}"):
        yield f"{name}: no error is named"


def of_python(path, public):
    """The public classes with their public methods and properties, and the public functions of a module."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if getattr(node, "name", None) not in public:
            continue
        if isinstance(node, ast.FunctionDef):
            yield from said_by_python(f"{path.name}: {node.name}", node, "")
        if not isinstance(node, ast.ClassDef):
            continue
        told = ast.get_docstring(node) or ""
        if not told:
            yield f"{path.name}: {node.name}: no docstring"
        for method in node.body:
            hidden = not isinstance(method, ast.FunctionDef) or method.name.startswith("_")
            if not hidden and not any(re.search(r"overload|setter", ast.unparse(d)) for d in method.decorator_list):
                yield from said_by_python(f"{path.name}: {node.name}.{method.name}", method, told)


def python_public(package):
    """The names that the package exports."""
    if not package.exists():
        return set()
    for node in ast.parse((package / "__init__.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            return set(ast.literal_eval(node.value))
    return set()


def check(tree):
    found = []
    package = pathlib.Path(tree) / "python" / "hawser"
    public = python_public(package)
    for path in sorted(package.glob("*.py")):
        found += of_python(path, public)
    for path in sorted((pathlib.Path(tree) / "include" / "hawser").glob("*.h")):
        text = path.read_text(encoding="utf-8")
        found += [*of_functions(path, text), *of_members(path, text)]
    return found


if __name__ == "__main__":
    complaints = check(sys.argv[1])
    print("\n".join(complaints))
    sys.exit(1 if complaints else 0)
