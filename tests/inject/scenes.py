"""The command lines of which calls fail, and what they need and write."""
import os
import shutil
import signal
import subprocess
import tempfile
import time

SHORT = ["--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "output.states=0.1 s", "--quiet"]


class Scene:
    """A command line; {out} in it is a new folder, {before} one that `before` has filled, {out} too if the command goes on in it."""

    def __init__(self, name, words, before=None, goes_on=False):
        self.name, self.words, self.before, self.goes_on = name, words, before, goes_on
        self.command = words[0]

    def files_before(self):
        """What is there already in the folder that the command goes on in."""
        return files_of(self.before) if self.goes_on else {}

    def run(self, program, env):
        """Its end: status, what it says, files (name: bytes)."""
        with tempfile.TemporaryDirectory(prefix="hawser_inject_") as folder:
            out = os.path.join(folder, "out")
            if self.goes_on:
                shutil.copytree(self.before, out)
            elif any(w.startswith("{out}/") for w in self.words):
                os.mkdir(out)
            words = [w.replace("{out}", out).replace("{before}", self.before or "") for w in self.words]
            try:
                done = subprocess.run([program, *words], env={**env, "TMPDIR": folder}, capture_output=True, timeout=120, check=False)
            except subprocess.TimeoutExpired:
                return None, b"", "", {}
            text = done.stderr.decode("utf-8", "replace").replace(folder, "")
            return done.returncode, done.stdout.replace(folder.encode(), b""), text, files_of(out)


def files_of(out):
    files = {}
    for where, _, names in os.walk(out):
        for name in names:
            path = os.path.join(where, name)
            with open(path, "rb") as file:
                files[os.path.relpath(path, out)] = file.read()
    return files


def study(work, name, case, *lines):
    path = os.path.join(work, name + ".yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([f"case: {os.path.abspath(case)}", *lines, ""]))
    return path


def studies(work, data):
    """One of each kind, of few samples."""
    case = os.path.join(data, "limits.yaml")
    drawn = "parameters: {friction.mu: {uniform: {from: 0.1, to: 0.3}}}"
    ranged = "parameters: {friction.mu: {range: {from: 0.1, to: 0.3}}}"
    wanted = "quantities: [reference_total_N]"
    yield "drawn", study(work, "drawn", case, drawn, "monte-carlo: {samples: 4, seed: 1}", wanted)
    yield "grid", study(work, "grid", case, "parameters: {friction.mu: {values: [0.1, 0.2]}}", "grid: [friction.mu]", wanted)
    yield "sobol", study(work, "sobol", case, drawn, "sensitivity: {method: sobol, samples: 2}", wanted)
    yield "morris", study(work, "morris", case, drawn, "sensitivity: {method: morris, samples: 2}", wanted)
    yield "search", study(work, "search", case, ranged, "optimise: {least: reference_total_N, evaluations: 6, searches: 1}", wanted)
    yield "runs", study(work, "runs", os.path.join(data, "cli-pull.yaml"), "set: {run.duration: 0.1 s, run.steady_from: 0.05 s}",
                        "fidelity: run", "parameters: {friction.mu: {values: [0.1, 0.2]}}", "grid: [friction.mu]",
                        "quantities: [pull_force.steady_mean_N]")


def interrupted(program, case, folder):
    """A run of far longer than it takes to a first checkpoint, killed when it had one."""
    words = [program, "run", case, "--quiet", "-o", folder, "--set", "run.checkpoint=5 ms", "--set", "run.duration=40 s",
             "--set", "output.states=2 s", "--set", "solver.passes=1"]
    kept = os.path.join(folder, "checkpoint.hawser")
    for _ in range(50):
        with subprocess.Popen(words) as run:
            while run.poll() is None and not os.path.exists(kept):
                time.sleep(0.002)
            run.send_signal(signal.SIGKILL)
            run.wait()
        if os.path.exists(kept):
            return folder
    raise RuntimeError(f"no checkpoint in {folder} of a run that was killed")


def runs(data):
    """Of each kind one."""
    def case(name):
        return os.path.join(data, name + ".yaml")

    def run(name, file, *more):
        return Scene("run " + name, ["run", case(file), *more, "--quiet", "-o", "{out}"])
    yield run("plain", "cli-pull", *SHORT[:-1])
    yield run("reel", "reel-payout", "--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "output.states=0.1 s")
    yield run("chains", "chains", "--set", "run.duration=0.1 s", "--set", "run.steady_from=0.05 s", "--set", "output.states=0.05 s")
    yield run("rod", "rod-column")
    yield run("modes", "rod-end", "--set", "run.analysis=modes")
    yield run("positions", "positions", "--set", "run.analysis=positions", "--set", "run.positions.step=20 m")
    yield run("quasi-static", "positions", "--set", "solver.motion=quasi-static", "--set", "run.duration=6 s",
              "--set", "run.steady_from=4 s")
    yield run("certify", "cli-pull", *SHORT[:-1], "--certify")
    yield run("slopes", "cli-pull", *SHORT[:-1], "--sensitivities", "friction.mu", "--report")
    yield run("slopes of all", "cli-pull", "--sensitivities", "all")
    yield run("library", "full-library", "--set", "run.duration=0.05 s", "--set", "run.steady_from=0.02 s")
    yield run("surfaces", "surfaces", "--set", "run.duration=0.05 s", "--set", "run.steady_from=0.02 s")


def all_scenes(program, source, work):
    data = os.path.join(source, "tests", "data")
    routes = os.path.join(source, "cases", "routes")
    results = os.path.join(work, "results")
    pull = os.path.join(data, "cli-pull.yaml")
    subprocess.run([program, "run", pull, *SHORT, "-o", results], check=True)
    drawn = dict(studies(work, data))
    of_study = os.path.join(work, "study")
    subprocess.run([program, "study", drawn["drawn"], "--jobs", "1", "--quiet", "-o", of_study], check=True)
    scenes = list(runs(data))
    scenes.append(Scene("run resumed", ["run", "--resume", "{out}", "--quiet"],
                        interrupted(program, os.path.join(data, "short-pull.yaml"), os.path.join(work, "killed")), True))
    scenes.append(Scene("run again", ["run", pull, *SHORT, "-o", "{out}"], results, True))
    scenes += [
        Scene("report", ["report", "{before}", "-o", "{out}/page.html"], results),
        Scene("report of two", ["report", results, results, "-o", "{out}/page.html"]),
        Scene("report of a study", ["report", "{before}", "-o", "{out}/page.html"], of_study),
        Scene("plot", ["plot", "{before}", "-o", "{out}"], results),
        Scene("compare", ["compare", "{before}", log_of(work), "--page", "{out}/page.html"], results),
        Scene("fmu", ["fmu", pull, "-o", "{out}/pull.fmu"]),
        Scene("validate", ["validate", "--filter", "slope-at-rest"]),
        Scene("library", ["library"]),
        Scene("library cables", ["library", "cables", "--format", "json"]),
        Scene("theory json", ["theory", pull, "--format", "json"]),
        Scene("theory table", ["theory", os.path.join(data, "planner.yaml")]),
        Scene("theory slopes", ["theory", os.path.join(data, "limits.yaml"), "--sensitivities", "--crew", "{out}/crew.csv"]),
        Scene("theory bundle", ["theory", os.path.join(data, "bundle.yaml")]),
        Scene("theory route file", ["theory", os.path.join(data, "full-route-file.yaml")])]
    for name in ("limits", "full-library", "full-chains", "full-rod", "chains-rope", "route-clothoid"):
        scenes.append(Scene("check " + name, ["check", os.path.join(data, name + ".yaml")]))
    for file, to in (("csv", ".yaml"), ("geojson", ".csv"), ("gpx", ".geojson"), ("xml", ".dxf"), ("ifc", ".csv"), ("dxf", ".yaml")):
        scenes.append(Scene("route " + file, ["route", os.path.join(routes, "tunnel." + file), "-o", "{out}/line" + to,
                                              *(["--name", "CENTRE"] if file == "dxf" else [])]))
    scenes.append(Scene("check drawing", ["check", os.path.join(source, "cases", "placing", "drawn.yaml")]))
    scenes.append(Scene("route json", ["route", os.path.join(routes, "tunnel.geojson"), "--json"]))
    scenes += [Scene("study " + name, ["study", path, "--jobs", "1", "--quiet", "-o", "{out}"]) for name, path in drawn.items()]
    return scenes


def log_of(work):
    path = os.path.join(work, "log.csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write("t [s],force [kN]\n" + "".join(f"{k / 100},{1 + k / 100}\n" for k in range(30)))
    return path
