"""Tests of the tests: small mistakes are put into the code, and some test has to fail.

All mistakes of a sample are compiled in at once, each behind a switch that the environment sets, so that one build does.
A first run of every test tells which mistakes it reaches; each mistake is then tried with those tests alone.

Usage: mutants.py make   [--count N] [--seed S] [--folders F ...]     a tree with N mistakes in build/mutants, built
                         [--labels L ...]                             only the tests of these labels
                         [--each]                                     N of each folder
       mutants.py run    [--jobs J] [--minutes M]                     tries them; goes on where it was stopped
                         [--labels L ...] [--shortest S] [--longest S] with the tests of these labels that take so many seconds; the
                         [--again] [--sanitized]                      survivors of what was tried before alone; those once more, built
                                                                      with the sanitizers that the project's own tests run under, to
                                                                      which reading past an array, or losing memory, is a failure
       mutants.py renew  [--labels L ...]                             takes the tests as they are committed now, for `run --again`
       mutants.py report                                              shares by folder, and what survived
With --faults each of them works on faults of memory instead, in build/faults: reading or writing past an end, use after free, values that
nobody has set, shifts by too much, as many of each kind; built like the preset `asan`. `run` tries the tests of the default tier,
`run --full --again` then those of `full` with what survived.
Needs python3-clang-14 (installed by scripts/setup.sh --mutants); run it with /usr/bin/python3.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
FAULTS = "--faults" in sys.argv
WORK = ROOT / "build" / ("faults" if FAULTS else "mutants")
TREE, MISTAKES, RESULTS = (WORK / name for name in ("tree", "mistakes.json", "results.jsonl"))
BUILD, SANITIZED = WORK / "build", WORK / "sanitized"
SANITIZERS = " -g -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined"  # CMakePresets.json, debug
FOLDERS = ["core", "contact", "linsolve", "theory", "sim", "io", "survey", "study", "fmi"]
LABELS = [*FOLDERS, "support", "validation", *(["fuzz"] if FAULTS else [])]
OTHER = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "/", "/": "*",
         "&&": "||", "||": "&&", "+=": "-=", "-=": "+="}
SIZES = {"calloc": (0, "-"), "malloc": (0, "-"), "realloc": (1, "-"), "memcpy": (2, "+"), "memmove": (2, "+"), "memset": (2, "+")}
DEEPEST = 2  # mistakes within one another: each doubles the text it stands in

SWITCH_H = """#ifndef HAWSER_MISTAKE_H
#define HAWSER_MISTAKE_H
extern int hawser_mistake;                 /* the one that is made; -1: none */
extern unsigned char *hawser_mistakes_met; /* NULL, or a place for each */
static inline int mistake_(int k)
{
    if (hawser_mistakes_met) hawser_mistakes_met[k] = 1;
    return hawser_mistake == k;
}
#endif
"""
SWITCH_C = """#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
int hawser_mistake = -1;
unsigned char *hawser_mistakes_met = NULL;
__attribute__((constructor(101))) static void mistakes_begin(void) /* before the program's own */
{
    const char *const which = getenv("HAWSER_MISTAKE"), *const met = getenv("HAWSER_MISTAKES_MET");
    if (which) hawser_mistake = atoi(which);
    const int file = met ? open(met, O_RDWR) : -1;
    if (file < 0) return;
    void *const at = mmap(NULL, (size_t)%d, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (at != MAP_FAILED) hawser_mistakes_met = at;
}
"""


# ------------------------------------------------------------------------------------------------ finding places


class Place:
    """Where a mistake can be made: what[start:end] of a file becomes write(inside), a function of its parts' text."""

    def __init__(self, kind, start, end, parts, say):
        self.kind, self.start, self.end, self.parts, self.say, self.number = kind, start, end, parts, say, None

    def write(self, text, parts):
        k = f"mistake_({self.number})"
        if self.kind == "statement":
            return f"if (!{k}) {parts[0]}"
        if self.kind == "operator":
            left, operator, right = parts
            return f"({k} ? (({left}) {OTHER[operator]} ({right})) : ({left} {operator} {right}))"
        if self.kind == "sign":
            return f"({k} ? ({parts[0]}) : ({text[self.start]}({parts[0]})))"
        if self.kind in ("past end", "size", "shift"):
            return f"(({parts[0]}) {self.say} * {k})"
        if self.kind == "after free":
            return f"if ({k}) {parts[1]} {parts[0]} if (!{k}) {parts[1]}"
        if self.kind == "not set":
            return f"{parts[0]}; if (!{k}) __builtin_memset(&{self.say}, 0, sizeof {self.say});"
        if self.kind == "not cleared":
            return f"({k} ? malloc(({parts[0]}) * ({parts[1]})) : calloc({parts[0]}, {parts[1]}))"
        return f"({k} ? ({parts[0]}) + 1 : ({parts[0]}))"  # a number


class Finder:
    """The places of one file, from clang's tree of a source that is it or includes it."""

    def __init__(self, path, unit):
        from clang import cindex
        self.kinds, self.path, self.text, self.places = cindex.CursorKind, path, path.read_text(), []
        for cursor in unit.cursor.get_children():
            where = cursor.location.file
            if where and pathlib.Path(where.name) == path and cursor.kind == self.kinds.FUNCTION_DECL:
                for child in cursor.get_children():
                    if child.kind == self.kinds.COMPOUND_STMT:
                        self.visit(child)

    @staticmethod
    def span(cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def visit(self, cursor):
        kinds, children = self.kinds, list(cursor.get_children())
        if cursor.kind == kinds.VAR_DECL:
            if cursor.storage_class.name == "STATIC":
                return
            children = children[-1:] if "=" in self.text[slice(*self.span(cursor))] and children else []
        if cursor.kind == kinds.CASE_STMT:
            children = children[1:]
        if self.text.startswith("__builtin", self.span(cursor)[0]):
            return
        if cursor.kind.name in ("CXX_UNARY_EXPR", "STATIC_ASSERT", "ENUM_DECL"):  # constants to the compiler
            return
        (self.take_fault if FAULTS else self.take)(cursor, children)
        for child in children:
            if cursor.kind == kinds.COMPOUND_STMT and not FAULTS:
                self.take_statement(child)
            self.visit(child)

    def take(self, cursor, children):
        kinds = self.kinds
        if cursor.kind in (kinds.BINARY_OPERATOR, kinds.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
            self.take_operator(cursor, *children)
        elif cursor.kind == kinds.UNARY_OPERATOR and len(children) == 1:
            self.take_sign(cursor, children[0])
        elif cursor.kind in (kinds.INTEGER_LITERAL, kinds.FLOATING_LITERAL):
            start, end = self.span(cursor)
            written = self.text[start:end]
            before, after = self.text[:start].rstrip()[-1:], self.text[end:].lstrip()
            if re.fullmatch(r"[0-9][0-9a-zA-Z.+-]*", written) and not (before == "[" and re.match(r"\]\s*=[^=]", after)):
                self.places.append(Place("number", start, end, [(start, end)], f"{written} -> {written} + 1"))

    def take_operator(self, cursor, left, right):
        (start, end), (l0, l1), (r0, r1) = self.span(cursor), self.span(left), self.span(right)
        if not (start == l0 < l1 < r0 < r1 == end):
            return  # a macro's
        operator = re.sub(r"/\*.*?\*/", "", self.text[l1:r0], flags=re.S).strip()
        pointers = [c.type.get_canonical().kind.name in ("POINTER", "CONSTANTARRAY", "INCOMPLETEARRAY") for c in (left, right)]
        if operator not in OTHER or (operator in "+-*/" and any(pointers)):
            return
        self.places.append(Place("operator", start, end, [(l0, l1), operator, (r0, r1)], f"{operator} -> {OTHER[operator]}"))

    def take_sign(self, cursor, child):
        (start, end), (c0, c1) = self.span(cursor), self.span(child)
        if c1 == end and self.text[start] in "-!" and self.text[start + 1:c0].strip() == "":
            self.places.append(Place("sign", start, end, [(c0, c1)], f"'{self.text[start]}' dropped"))

    def take_statement(self, child):
        kinds = self.kinds
        (start, end) = self.span(child)
        semicolon = re.match(r"\s*;", self.text[end:])
        assigns = child.kind in (kinds.BINARY_OPERATOR, kinds.COMPOUND_ASSIGNMENT_OPERATOR)
        if semicolon and end > start and (assigns or child.kind == kinds.CALL_EXPR) and self.text[start:start + 1].isidentifier() \
                and not self.text[start:end].startswith(("assert", "free", "va_")):
            self.places.append(Place("statement", start, end + semicolon.end(), [(start, end + semicolon.end())], "left out"))

    def take_fault(self, cursor, children):
        """A loop that goes one further along an array, a size that is one less than needed, a shift by 64 more."""
        kinds, text = self.kinds, self.text
        if cursor.kind == kinds.FOR_STMT:
            for child in children[:-1]:
                parts = list(child.get_children())
                if child.kind == kinds.BINARY_OPERATOR and len(parts) == 2 and self.between(*parts) == "<" \
                        and re.search(rf"\[[^]]*\b{re.escape(self.written(parts[0]))}\b", self.written(children[-1])):
                    self.take_part("past end", parts[1], "+ 1")
        elif cursor.kind == kinds.BINARY_OPERATOR and len(children) == 2 and self.between(*children) in ("<<", ">>"):
            self.take_part("shift", children[1], "+ 64")
        elif cursor.kind == kinds.CALL_EXPR and cursor.spelling in SIZES and self.written(cursor).startswith(cursor.spelling):
            which, sign = SIZES[cursor.spelling]
            arguments = list(cursor.get_arguments())
            self.take_part("size", arguments[which], f"{sign} 1")
            if cursor.spelling == "calloc":
                self.places.append(Place("not cleared", *self.span(cursor), [self.span(a) for a in arguments], ""))
        elif cursor.kind == kinds.COMPOUND_STMT:
            for before, child in zip([None, *children], children):
                self.take_free(before, child)
                variable = list(child.get_children())[-1] if child.kind == kinds.DECL_STMT else None
                begin = re.fullmatch(r"([^,=()]+?) = \{0\};", self.written(child))
                if variable is not None and begin and not re.search(r"\b(const|static)\b", begin[1]):
                    start, end = self.span(child)
                    self.places.append(Place("not set", start, end, [(start, start + len(begin[1]))], variable.spelling))

    def take_free(self, before, child):
        """What is freed before the statement that uses it last."""
        kinds, text = self.kinds, self.text
        freed = re.fullmatch(r"free\((.+)\)", self.written(child))
        if before is None or not freed or before.kind in (kinds.DECL_STMT, kinds.RETURN_STMT) \
                or not re.search(rf"\b{re.escape(freed[1])}\b", self.written(before)):
            return
        parts = [(start, end + len(re.match(r"\s*;|", text[end:])[0])) for start, end in map(self.span, (before, child))]
        self.places.append(Place("after free", parts[0][0], parts[1][1], parts, ""))

    def take_part(self, kind, cursor, say):
        start, end = self.span(cursor)
        if start < end:
            self.places.append(Place(kind, start, end, [(start, end)], say))

    def written(self, cursor):
        return self.text[slice(*self.span(cursor))]

    def between(self, left, right):
        return self.text[self.span(left)[1]:self.span(right)[0]].strip()


# ------------------------------------------------------------------------------------------------ writing them in


def render(text, start, end, places):
    """text[start:end] with the places in it switched; places: sorted by start, then by the longer."""
    out, at = [], start
    while places:
        place = places[0]
        inside = [p for p in places[1:] if p.end <= place.end]
        places = places[1 + len(inside):]
        parts = [p if isinstance(p, str) else render(text, *p, [q for q in inside if p[0] <= q.start and q.end <= p[1]])
                 for p in place.parts]
        out += [text[at:place.start], place.write(text, parts)]
        at = place.end
    return "".join(out) + text[at:end]


def nested(places):
    """Those that are not too deep within one another."""
    kept, open_ends = [], []
    for place in sorted(places, key=lambda p: (p.start, -p.end)):
        open_ends = [e for e in open_ends if e > place.start]
        if len(open_ends) < DEEPEST:
            kept.append(place)
            open_ends.append(place.end)
    return kept


def flags_of(path, commands):
    """Compiler flags of a source file."""
    best = commands.get(path) or next(iter(commands.values()))
    return [w for w in best.split() if w.startswith(("-I", "-D", "-isystem", "-m")) or w.startswith("/usr/include")] + ["-xc", "-std=gnu17"]


def find_all(folders):
    """Places of the folders' sources, and of their headers as the first source that includes each sees them."""
    from clang import cindex
    database = json.loads((BUILD / "compile_commands.json").read_text())
    commands = {pathlib.Path(e["file"]): e["command"].replace("\\\"", "\"") for e in database}
    places = {}
    for folder in folders:
        for path in sorted((TREE / folder).rglob("*.c")):
            if path.name == "mistake.c":
                continue  # the switch itself
            unit = cindex.Index.create().parse(str(path), args=flags_of(path, commands), options=0)
            headers = {pathlib.Path(os.path.normpath(i.include.name)) for i in unit.get_includes()}
            for file in [path, *sorted(h for h in headers if h.is_relative_to(TREE / folder))]:
                if file not in places:
                    places[file] = nested(Finder(file, unit).places)
    return {file: found for file, found in places.items() if found}


def configure(build=BUILD):
    flags = "-O1 -w -include " + str(WORK / "mistake.h") + (SANITIZERS if build == SANITIZED else "")
    options = []
    if FAULTS:
        presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
        asan = next(p["cacheVariables"] for p in presets if p["name"] == "asan")
        options = [f"-D{key}={asan[key]}" for key in ("CMAKE_C_FLAGS", "HAWSER_ONE_ISA")]
        flags = flags.replace("-O1", "-g1")
    subprocess.run(["cmake", "-S", TREE, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DHAWSER_BENCH=OFF", *options,
                    "-DCMAKE_C_FLAGS_RELWITHDEBINFO=" + flags,
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], check=True, stdout=subprocess.DEVNULL)


def write_tree(chosen, texts):
    for path, text in texts.items():
        places = sorted((p for p in chosen.get(path, []) if p.number is not None), key=lambda p: (p.start, -p.end))
        rendered = render(text, 0, len(text), places)
        if rendered != path.read_text():  # what stays needs no building
            path.write_text(rendered)


def targets(labels):
    """What has to be built for the tests of these labels; everything for those that all of them are."""
    return ["--target", *(f"tests_{label}" for label in labels)] if set(labels) != set(LABELS) else []


def build_without(chosen, texts, labels):
    """Builds; what does not compile is no mistake that anybody could make, and is dropped with its line."""
    for _ in range(40):
        done = subprocess.run(["cmake", "--build", BUILD, "-j2", *targets(labels), "--", "-k", "0"], capture_output=True, text=True)
        if done.returncode == 0:
            return
        bad = {(pathlib.Path(m[1]), int(m[2])) for m in re.finditer(r"^(/\S+?):(\d+):\d+: error", done.stdout, re.M)}
        dropped = 0
        for path, line in bad:
            for place in chosen.get(path, []):
                lines = range(texts[path].count("\n", 0, place.start) + 1, texts[path].count("\n", 0, place.end) + 2)
                if place.number is not None and line in lines:
                    place.number = None
                    dropped += 1
        if not dropped:
            print(done.stdout[-3000:])
            raise SystemExit("the tree does not build, and not because of a mistake")
        print(f"{dropped} places do not compile and are dropped")
        write_tree(chosen, texts)
    raise SystemExit("the tree does not build")


def make(args):
    shutil.rmtree(WORK, ignore_errors=True)
    TREE.mkdir(parents=True)
    archive = subprocess.run(["git", "-C", ROOT, "archive", "HEAD"], check=True, capture_output=True).stdout
    subprocess.run(["tar", "-C", TREE, "-xf", "-"], input=archive, check=True)
    (WORK / "mistake.h").write_text(SWITCH_H)
    (TREE / "core" / "base" / "mistake.c").write_text(SWITCH_C % (args.count * len(args.folders)))
    configure()
    places = find_all(args.folders)
    everything = [(path, place) for path, found in places.items() for place in found]
    random.Random(args.seed).shuffle(everything)
    if FAULTS:  # as many of each kind
        seen = collections.Counter()
        ranks = {id(place): seen.update([place.kind]) or seen[place.kind] for _, place in everything}
        everything.sort(key=lambda e: ranks[id(e[1])])
    groups = [[e for e in everything if e[0].is_relative_to(TREE / f)] for f in args.folders] if args.each else [everything]
    taken = [e for group in groups for e in group[:args.count]]
    print(f"{len(everything)} places in {len(places)} files; {len(taken)} are taken")
    chosen = collections.defaultdict(list)
    for number, (path, place) in enumerate(taken):
        place.number = number
        chosen[path].append(place)
    texts = {path: path.read_text() for path in chosen}
    write_tree(chosen, texts)
    build_without(chosen, texts, args.labels)
    mistakes = [{"number": p.number, "file": str(path.relative_to(TREE)), "line": texts[path].count("\n", 0, p.start) + 1,
                 "kind": p.kind, "say": p.say, "text": texts[path][p.start:p.end].split("\n")[0][:100]}
                for path, found in chosen.items() for p in found if p.number is not None]
    MISTAKES.write_text(json.dumps(mistakes, indent=0))
    print(f"{len(mistakes)} mistakes are built in {BUILD}")


def renew(args):
    """Other tests for the mistakes that there are; which of them meet which is found out anew."""
    archive = subprocess.run(["git", "-C", ROOT, "archive", "HEAD", "tests"], check=True, capture_output=True).stdout
    subprocess.run(["tar", "-C", TREE, "-xmf", "-"], input=archive, check=True)
    configure()
    subprocess.run(["cmake", "--build", BUILD, "-j2", *targets(args.labels)], check=True, stdout=subprocess.DEVNULL)
    for build in (BUILD, SANITIZED):
        (build / "met.json").unlink(missing_ok=True)


# ------------------------------------------------------------------------------------------------ trying them


def tests_of_build(build, wanted, full=False):
    listed = json.loads(subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True,
                                       text=True).stdout)
    tests = []
    for test in listed["tests"]:
        properties = {p["name"]: p["value"] for p in test["properties"]}
        labels = properties.get("LABELS", [])
        if "command" in test and any(l in wanted for l in labels) and (full or "full" not in labels):
            tests.append({"name": test["name"], "command": test["command"], "folder": labels[0],
                          "cwd": properties.get("WORKING_DIRECTORY", str(build))})
    return tests


def waits(pid):
    """Processor time that a process has used, in ticks, if all of its threads sleep; None: one works, or it has ended."""
    try:
        tasks = [(task / "stat").read_text().rsplit(")", 1)[1].split() for task in pathlib.Path(f"/proc/{pid}/task").iterdir()]
    except OSError:
        return None
    return sum(int(t[11]) + int(t[12]) for t in tasks) if all(t[0] == "S" for t in tasks) else None


def attempt(test, environment, limit):
    """Whether the test passes with this environment within `limit` s of processor time (a machine that is busy with other things
    kills no mistake; what sleeps and uses none waits for ever), and how much it took, s."""
    def limited():
        os.nice(10)
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))
    before, asleep = resource.getrusage(resource.RUSAGE_CHILDREN), []
    options = {"ASAN_OPTIONS": "detect_leaks=1:strict_string_checks=1:quarantine_size_mb=32"}  # scripts/test.sh
    process = subprocess.Popen(test["command"], cwd=test["cwd"], env={**options, **os.environ, **environment}, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, preexec_fn=limited)
    while process.poll() is None:
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            used = waits(process.pid)
            asleep = [*asleep, used] if used is not None and asleep[-1:] in ([], [used]) else []
            if len(asleep) > 4:
                process.kill()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return process.returncode == 0, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def reached(build, tests, count, shortest, longest):
    """Times of the tests that pass without a mistake, and the mistakes that each meets; what was found out once is kept."""
    met_file, known_file = build / "met", build / "met.json"
    known = json.loads(known_file.read_text()) if known_file.exists() else {}
    for test in tests:
        if test["name"] not in known:
            met_file.write_bytes(bytes(count))
            passed, seconds = attempt(test, {"HAWSER_MISTAKES_MET": str(met_file)}, 300)
            met = [k for k, byte in enumerate(met_file.read_bytes()) if byte]
            known[test["name"]] = {"passed": passed, "seconds": seconds, "meets": met}
            known_file.write_text(json.dumps(known))
        found = known[test["name"]]
        test["seconds"], test["meets"] = found["seconds"], set(found["meets"])
        if not found["passed"]:
            print(f"{test['name']}: left out (fails without a mistake)")
        if not found["passed"] or not shortest <= found["seconds"] < longest:
            test["meets"] = set()
    return [t for t in tests if t["meets"]]


def try_one(mistake, tests):
    folder = mistake["file"].split("/")[0]
    meeting = sorted((t for t in tests if mistake["number"] in t["meets"]), key=lambda t: (t["folder"] != folder, t["seconds"]))
    for test in meeting:
        passed, _ = attempt(test, {"HAWSER_MISTAKE": str(mistake["number"])}, 10 * test["seconds"] + 5)
        if not passed:
            return {**mistake, "outcome": "killed", "by": test["name"]}
    return {**mistake, "outcome": "survived" if meeting else "not met"}


def latest():
    """The last that is known of each mistake that was tried."""
    lines = RESULTS.read_text().splitlines() if RESULTS.exists() else []
    return {result["number"]: result for result in map(json.loads, lines)}


def run(args):
    mistakes, known, build = json.loads(MISTAKES.read_text()), latest(), SANITIZED if args.sanitized else BUILD
    if args.sanitized:
        configure(build)
        subprocess.run(["cmake", "--build", build, "-j2", *targets(args.labels)], check=True, stdout=subprocess.DEVNULL)
    tests = reached(build, tests_of_build(build, args.labels, args.full), max(m["number"] for m in mistakes) + 1, args.shortest, args.longest)
    end = time.monotonic() + 60 * args.minutes
    outcomes = {None} if not (args.again or args.sanitized) else {"survived", "not met"}
    todo = [m for m in sorted(mistakes, key=lambda m: m["number"]) if known.get(m["number"], {}).get("outcome") in outcomes]
    print(f"{len(tests)} tests, {len(todo)} mistakes to try", flush=True)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool, RESULTS.open("a") as file:
        def guarded(mistake):
            return try_one(mistake, tests) if time.monotonic() < end else None
        for result in pool.map(guarded, todo):
            before = known.get(result["number"], {}).get("outcome") if result else None
            if result and result["outcome"] not in (before, "not met" if before == "survived" else before):  # by other tests: as it was
                file.write(json.dumps({**result, "sanitized": args.sanitized}) + "\n")
                file.flush()
    report(args)


def report(_):
    results = list(latest().values())
    print("| folder | tried | killed | survived | not met | killed of those met |\n|---|---|---|---|---|---|")
    for folder in sorted({r["file"].split("/")[0] for r in results}) + [""]:
        of = [r["outcome"] for r in results if r["file"].startswith(folder)]
        killed, survived = of.count("killed"), of.count("survived")
        share = 100 * killed / max(1, killed + survived)
        print(f"| {folder or 'all'} | {len(of)} | {killed} | {survived} | {of.count('not met')} | {share:.1f} % |")
    for r in sorted(results, key=lambda r: (r["file"], r["line"])):
        if r["outcome"] != "killed":
            print(f"{r['file']}:{r['line']}: {r['outcome']}: {r['say']}: {r['text']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=["make", "run", "renew", "report"])
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folders", nargs="*", default=FOLDERS)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=600)
    parser.add_argument("--labels", nargs="*", default=LABELS)
    parser.add_argument("--longest", type=float, default=30)
    parser.add_argument("--shortest", type=float, default=0)
    parser.add_argument("--each", action="store_true")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--faults", action="store_true")
    args = parser.parse_args()
    {"make": make, "run": run, "renew": renew, "report": report}[args.what](args)


if __name__ == "__main__":
    sys.exit(main())
