"""Archives of several cases against the standard, by an importer that shares nothing with the product: the description by
the rules of FMI 2.0 and 3.0, and the library through ctypes, with prototypes of its own.

Usage: check_fmu.py PROGRAM SOURCE_DIR
"""
import ctypes
import html
import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile

import units_by_hand

CASES = ("cli-pull", "limits-conveyor", "reel-payout", "surfaces", "rod-end", "full-tension", "route-clothoid")
TYPES = {2: {"Real", "Integer", "Boolean", "String", "Enumeration"}, 3: {"Float64", "Int32", "Boolean", "String", "Enumeration"}}
BASE = {"kg", "m", "s", "A", "K", "mol", "cd", "rad"}
# Which elements stand in the description, in this order, and which must be there.
ORDER = ["ModelExchange", "CoSimulation", "ScheduledExecution", "UnitDefinitions", "TypeDefinitions", "LogCategories",
         "DefaultExperiment", "VendorAnnotations", "ModelVariables", "ModelStructure", "Annotations"]
NEEDED = {"CoSimulation", "ModelVariables", "ModelStructure"}
# Causality, variability, initial: the combinations of the standard's tables that a description of co-simulation may use
# (2.0: section 2.2.7; 3.0: section 2.4.7.4), and whether there is a start.
ALLOWED = {("independent", "continuous", None): False,
           ("parameter", "fixed", "exact"): True, ("parameter", "tunable", "exact"): True,
           ("input", "continuous", None): True, ("input", "discrete", None): True,
           ("output", "continuous", "calculated"): False, ("output", "discrete", "calculated"): False}
complaints = []


def expect(ok, what):
    if not ok:
        complaints.append(what)


class Variable:
    def __init__(self, element, value, index):
        self.name, self.index = element.get("name"), index
        self.reference = int(element.get("valueReference"))
        self.kind = (element.get("causality"), element.get("variability"), element.get("initial"))
        self.type, self.start, self.unit = value.tag, value.get("start"), value.get("unit")
        self.least, self.most = (None if value.get(k) is None else float(value.get(k)) for k in ("min", "max"))
        self.declared, self.description = value.get("declaredType"), element.get("description")


class Description:
    """What modelDescription.xml says, held against the rules on the way."""

    def __init__(self, text, where):
        self.root, self.where = ElementTree.fromstring(text), where
        self.version = int(float(self.root.get("fmiVersion")))
        self.token = self.root.get("guid" if self.version == 2 else "instantiationToken")
        self.identifier = self.root.find("CoSimulation").get("modelIdentifier")
        elements = self.root.find("ModelVariables")
        self.variables = [Variable(e, e[0] if self.version == 2 else e, i + 1) for i, e in enumerate(elements)]

    def expect(self, ok, what):
        expect(ok, f"{self.where}: {what}")

    def check(self):
        tags = [e.tag for e in self.root]
        self.expect(tags == sorted(tags, key=ORDER.index), f"elements in another order: {tags}")
        self.expect(NEEDED <= set(tags), f"an element is missing: {tags}")
        self.expect(self.root.get("fmiVersion") in ("2.0", "3.0"), "no version")
        self.expect(re.fullmatch(r"[A-Za-z_]\w*", self.identifier, re.A), f"{self.identifier} is no name of C's")
        self.expect(self.root.get("modelName") and self.token, "no name or no token")
        self.check_names()
        self.check_descriptions()
        self.check_units()
        self.check_variables()
        self.check_structure()

    def check_units(self):
        units = [u.get("name") for u in self.root.iter("Unit")]
        used = {v.unit for v in self.variables} - {None}
        self.expect(len(units) == len(set(units)), "a unit is defined twice")
        self.expect(set(units) == used, f"units defined {sorted(units)}, used {sorted(used)}")
        for u in self.root.iter("Unit"):
            base = u.find("BaseUnit")
            self.expect(set(base.keys()) <= BASE | {"factor", "offset"}, f"unit of {base.keys()}")
            self.expect(all(re.fullmatch(r"-?\d+", base.get(p)) for p in BASE & set(base.keys())), f"powers {base.attrib}")
            said = (float(base.get("factor", 1)), tuple(int(base.get(k, 0)) for k in ("kg", "m", "s", "rad")))
            self.expect(said == units_by_hand.unit(u.get("name")), f"unit {u.get('name')} is said to be {base.attrib}")
            self.expect(float(base.get("offset", 0)) == 0, f"unit {u.get('name')} has an offset")

    def check_quantities(self):
        """A parameter's unit and start against the text that the case writes ("80 mm"); returns how many were compared."""
        n = 0
        for v in self.variables:
            written = re.search(r", ([-+0-9.e]+) ?([A-Za-z%][^,]*)\)$", v.description or "")
            if v.kind[0] != "parameter" or not written or "slope" in v.name:
                continue
            factor, powers = units_by_hand.unit(written.group(2))
            mine = units_by_hand.unit(v.unit or "1")
            value = float(written.group(1)) * factor
            self.expect(powers == mine[1], f"{v.name}: has unit {v.unit}, the case writes {written.group(2)}")
            self.expect(math.isclose(float(v.start), value, rel_tol=1e-12), f"{v.name}: starts at {v.start}, not {value}")
            n += 1
        return n

    def check_columns(self, columns):
        """An output's unit against that of the results' column of the same quantity; returns how many were compared."""
        n, others = 0, {"winch.rope_speed": "winch_speed_m_per_s", "winch.reference": "reference_N", "cable.head": "head_at_m"}
        bare = {re.sub(r"_(?:[A-Za-z0-9]+_per_[a-z]+|N_m|N|m|s|W)$", "", c): c for c in columns}
        for v in self.variables:
            key = re.sub(r"^(?:conveyors|motors|rollers|surfaces|reel|cable)\.", "", v.name).replace("'", "").replace(".", "_")
            mine = others.get(v.name) if others.get(v.name) in columns else bare.get(key)
            if v.kind[0] != "output" or not mine:
                continue
            self.expect(units_by_hand.unit(v.unit or "1") == units_by_hand.column(mine), f"{v.name} has {v.unit}, the column is {mine}")
            n += 1
        return n

    def check_names(self):
        """The grammar of structured names (2.0: 2.2.9; 3.0: 2.4.7.5.1); no name is a leaf and a branch."""
        step = r"(?:[A-Za-z_]\w*|'[-\w!#$%&()*+,./:;<>=?@\[\]^{}|~ ]+')(?:\[\d+\])?"
        self.expect(self.root.get("variableNamingConvention") == "structured", "names are not said to be structured")
        names = {v.name for v in self.variables}
        for name in names:
            self.expect(re.fullmatch(rf"{step}(?:\.{step})*", name, re.A), f"{name!r} is no structured name")
            steps = re.findall(rf"{step}\.?", name, re.A)
            for k in range(1, len(steps)):
                branch = "".join(steps[:k]).rstrip(".")
                self.expect(branch not in names, f"{branch} is a variable, and a branch with {name}")

    def check_descriptions(self):
        """43 of 74 said "a length of the case" or "now"."""
        for v in self.variables:
            said = re.sub(r" \(.*\)$", "", v.description or "")
            self.expect(len(said) > 8 and " " in said and not re.match(r"an? .* of the case", said), f"{v.name}: {v.description!r} says nothing")

    def check_variables(self):
        names, references = [v.name for v in self.variables], [v.reference for v in self.variables]
        self.expect(len(set(names)) == len(names), "a name stands twice")
        self.expect(len(set(references)) == len(references), "a value reference stands twice")
        self.expect(sum(v.kind[0] == "independent" for v in self.variables) == 1, "not one independent variable")
        types = {t.get("name") for tag in ("SimpleType", "EnumerationType") for t in self.root.iter(tag)}
        for v in self.variables:
            self.expect(v.type in TYPES[self.version], f"{v.name}: no type {v.type}")
            self.expect(not re.search(r"[\r\n\t]", v.name), f"{v.name!r}: controls in a name")
            self.expect(v.kind in ALLOWED, f"{v.name}: {v.kind} do not go together")
            self.expect((v.start is not None) == ALLOWED.get(v.kind), f"{v.name}: start {v.start}")
            self.expect(v.kind[1] != "continuous" or v.type in ("Real", "Float64"), f"{v.name}: continuous {v.type}")
            self.expect(v.type != "Enumeration" or v.declared in types, f"{v.name}: type {v.declared} is not defined")
            if v.start is not None and v.type in ("Real", "Float64"):
                low, high = v.least if v.least is not None else -math.inf, v.most if v.most is not None else math.inf
                self.expect(low <= float(v.start) <= high, f"{v.name}: start {v.start} is not in {low} .. {high}")

    def check_structure(self):
        structure = self.root.find("ModelStructure")
        outputs = [v.index if self.version == 2 else v.reference for v in self.variables if v.kind[0] == "output"]
        if self.version == 2:
            found = {tag: [int(u.get("index")) for u in structure.find(tag)] for tag in ("Outputs", "InitialUnknowns")}
            known = [u.get("dependencies") for u in structure.find("Outputs")]
        else:
            found = {tag: [int(u.get("valueReference")) for u in structure.findall(tag)] for tag in ("Output", "InitialUnknown")}
            known = [u.get("dependencies") for u in structure.findall("Output")]
        self.expect(set(known) == {""}, f"outputs depend on {set(known)}")
        for tag, indices in found.items():
            self.expect(indices == outputs, f"{tag} are not the outputs")


class Library:
    """An instance, driven through ctypes; log: what it says."""

    def __init__(self, path, description, folder, token):
        self.d, self.log = description, []
        self.library = ctypes.CDLL(str(path))
        self.prefix = f"fmi{description.version}"
        self.boolean = ctypes.c_int if description.version == 2 else ctypes.c_bool
        if description.version == 2:
            class Calls(ctypes.Structure):
                _fields_ = [(name, ctypes.c_void_p) for name in ("logger", "allocate", "free", "finished", "environment")]
            self.calls = Calls()
            uri = pathlib.Path(folder, "resources").as_uri()
            self.c = self.call("Instantiate", b"x", 1, token.encode(), uri.encode(), ctypes.byref(self.calls), 0, 0,
                               answer=ctypes.c_void_p)
        else:
            def say(_, status, category, message):
                self.log.append((status, category, message))
            self.say = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)(say)
            resources = f"{folder}/resources/"
            self.c = self.call("InstantiateCoSimulation", b"x", token.encode(), resources.encode(), False, False, False, False, None,
                               ctypes.c_size_t(0), None, self.say, None, answer=ctypes.c_void_p)

    def call(self, name, *arguments, answer=ctypes.c_int):
        function = getattr(self.library, self.prefix + name)
        function.restype = answer
        fixed = [ctypes.c_double(a) if isinstance(a, float) else ctypes.c_bool(a) if isinstance(a, bool) else a for a in arguments]
        return function(*fixed)

    def here(self, name, *arguments):
        return self.call(name, ctypes.c_void_p(self.c), *arguments)

    def begin(self):
        if self.d.version == 2:
            first = self.here("SetupExperiment", 0, 0.0, 0.0, 0, 0.0) or self.here("EnterInitializationMode")
        else:
            first = self.here("EnterInitializationMode", False, 0.0, 0.0, False, 0.0)
        return first or self.here("ExitInitializationMode")

    def step(self, t, h):
        if self.d.version == 2:
            return self.here("DoStep", t, h, 1)
        flags = [ctypes.c_bool(True) for _ in range(3)]
        reached = ctypes.c_double()
        return self.here("DoStep", t, h, True, *map(ctypes.byref, flags), ctypes.byref(reached))

    def value(self, v):
        """(status, value) of a variable."""
        kinds = {"Real": ctypes.c_double, "Float64": ctypes.c_double, "Integer": ctypes.c_int, "Int32": ctypes.c_int32,
                 "Boolean": self.boolean, "String": ctypes.c_char_p}
        name, kind = v.type, kinds.get(v.type)
        if v.type == "Enumeration":
            name, kind = ("Integer", ctypes.c_int) if self.d.version == 2 else ("Int64", ctypes.c_int64)
        out, one = kind(), ctypes.c_size_t(1)
        more = () if self.d.version == 2 else (one,)
        status = self.here("Get" + name, ctypes.byref(ctypes.c_uint(v.reference)), one, ctypes.byref(out), *more)
        return status, out.value

    def set(self, v, value):
        more = () if self.d.version == 2 else (ctypes.c_size_t(1),)
        return self.here("SetReal" if self.d.version == 2 else "SetFloat64", ctypes.byref(ctypes.c_uint(v.reference)),
                         ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(value)), *more)

    def free(self):
        function = getattr(self.library, self.prefix + "FreeInstance")
        function.restype = None
        function(ctypes.c_void_p(self.c))


def drive(d, folder, library):
    """Values of all variables after three steps, with what they are at the start held against the description."""
    expect(not Library(library, d, folder, "another token").c, f"{d.where}: any token will do")
    i = Library(library, d, folder, d.token)
    if not i.c:
        expect(False, f"{d.where}: no instance: {i.log}")
        return {}
    for v in d.variables:
        if v.start is None or v.type == "Boolean":
            continue
        expect(i.value(v) == (0, float(v.start)), f"{d.where}: {v.name} does not begin at {v.start}: {i.value(v)}")
        expect(i.set(v, math.nan) == 2, f"{d.where}: {v.name} takes a NaN")
    expect(i.step(0.0, 0.01) == 3, f"{d.where}: steps before its initialization")
    i.free()
    i = Library(library, d, folder, d.token)
    expect(i.begin() == 0, f"{d.where}: does not begin: {i.log}")
    for k in range(3):
        expect(i.step(0.02 * k, 0.02 * (k + 1) - 0.02 * k) == 0, f"{d.where}: step {k}: {i.log}")
    values = {v.name: i.value(v) for v in d.variables}
    expect(all(status == 0 for status, _ in values.values()), f"{d.where}: a variable has no value: {values}")
    expect(i.here("Terminate") == 0, f"{d.where}: does not terminate")
    i.free()
    return {name: value for name, (_, value) in values.items()}


def archive(program, case, version, folder):
    """Writes the archive, checks what is in it, unpacks it. Returns its description and its library."""
    path = f"{folder}/{case.stem}.fmu"
    subprocess.run([program, "fmu", str(case), "--fmi", str(version), "-q", "-o", path], check=True)
    with zipfile.ZipFile(path) as z:
        where = f"{case.stem}, FMI {version}"
        expect(z.testzip() is None, f"{where}: damaged")
        d = Description(z.read("modelDescription.xml"), where)
        library = f"binaries/{'linux64' if version == 2 else 'x86_64-linux'}/{d.identifier}.so"
        names = set(z.namelist())
        page, licence = "documentation/index.html", "documentation/licenses/license.txt"
        expect({library, "resources/case.yaml", page, licence} <= names, f"{where}: holds {names}")
        expect(all(n.split("/")[0] in ("modelDescription.xml", "binaries", "resources", "documentation") for n in names), f"{where}: holds {names}")
        if {page, licence} <= names:  # none was there
            shown, texts = z.read(page).decode(), z.read(licence).decode()
            expect(all(html.escape(v.name) in shown for v in d.variables if v.name != "time"), f"{where}: the page lacks a variable")
            expect("hawser" in texts and "SUNDIALS" in texts and "KLU" in texts, f"{where}: no licences of what is inside")
        z.extractall(folder)
    return d, f"{folder}/{library}"


def columns(program, case, folder):
    """Those of series.csv of the case's first instant."""
    subprocess.run([program, "run", str(case), "-q", "-o", f"{folder}/run", "--set", "run.duration=20 ms"], check=False, capture_output=True)
    series = pathlib.Path(folder, "run", "series.csv")
    return series.read_text(encoding="utf-8").split("\n", 1)[0].split(",") if series.exists() else []


def wrong_units_are_found():
    """What the checks above are for: a description with a unit of the wrong powers, of a wrong factor, or at the wrong variable."""
    text = """<fmiModelDescription fmiVersion="3.0" instantiationToken="t"><CoSimulation modelIdentifier="x"/>
    <UnitDefinitions><Unit name="m/s"><BaseUnit m="1" s="%s"%s/></Unit></UnitDefinitions><ModelVariables>
    <Float64 name="case.drive.winch.speed" valueReference="0" causality="parameter" unit="m/s" start="0.1"
     description="Speed after the ramp (drive.winch.speed, 6 %s)"/>
    <Float64 name="winch.force" valueReference="1" causality="output" unit="%s"/></ModelVariables></fmiModelDescription>"""
    for power, factor, written, force, wrong in (("-1", "", "m/min", "N", 0), ("-2", "", "m/min", "N", 1), ("-1", ' factor="60"', "m/min", "N", 1),
                                                 ("-1", "", "m/s", "N", 1), ("-1", "", "m", "N", 2), ("-1", "", "m/min", "m/s", 1)):
        d, before = Description(text % (power, factor, written, force), "a wrong unit"), len(complaints)
        d.check_units()
        d.check_quantities()
        d.check_columns(["winch_force_N"])
        found = [c for c in complaints[before:] if "units defined" not in c]
        del complaints[before:]
        expect(len(found) == wrong, f"{power}{factor} {written} {force}: {found}")


def same(a, b):
    return a == b or (isinstance(a, float) and math.isnan(a) and math.isnan(b))


def main(program, source):
    wrong_units_are_found()
    written = shown = 0
    for name in CASES:
        case, values = pathlib.Path(source, "tests", "data", name + ".yaml"), []
        for version in (2, 3):
            with tempfile.TemporaryDirectory() as folder:
                d, library = archive(program, case, version, folder)
                expect(d.version == version, f"{d.where}: is of version {d.version}")
                d.check()
                written += d.check_quantities()
                shown += d.check_columns(columns(program, case, folder))
                values.append(drive(d, folder, library))
        expect(values[0].keys() == values[1].keys(), f"{name}: the versions have other variables")
        for key in values[0]:
            expect(same(values[0][key], values[1].get(key)), f"{name}: {key} is {values[0][key]} and {values[1].get(key)}")
    expect(written >= 250 and shown >= 20, f"units of {written} parameters and {shown} outputs were compared")
    for complaint in itertools.islice(complaints, 40):
        print(complaint)
    print("fmu:", f"{len(complaints)} complaint(s)" if complaints else "fine")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
