"""FMPy, an importer of others, finds nothing wrong in our units, loads them and steps them, alone and with a controller of
somebody else's. Skipped (77) where it cannot be imported; its source in PYTHONPATH will do.

Usage: check_fmpy.py PROGRAM SOURCE_DIR CONTROLLER
"""
import contextlib
import io
import itertools
import pathlib
import subprocess
import sys
import tempfile

try:
    with contextlib.redirect_stdout(io.StringIO()):  # it says that a library of its own is not there, which only formats messages
        import fmpy
        import fmpy.fmi3
        import fmpy.validation
        import lark  # noqa: F401, for the grammar of names
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

CASES = ("cli-pull", "limits-conveyor", "reel-payout", "surfaces", "rod-end", "full-tension", "route-clothoid")


def slave(archive, folder):
    """An instance of a unit of version 3.0 at the start of its steps, and its references by name."""
    description = fmpy.read_model_description(archive)
    fmpy.extract(archive, unzipdir=folder)
    one = fmpy.fmi3.FMU3Slave(guid=description.guid, unzipDirectory=folder, modelIdentifier=description.coSimulation.modelIdentifier)
    one.instantiate()
    one.enterInitializationMode()
    one.exitInitializationMode()
    return one, {v.name: v.valueReference for v in description.modelVariables}


def held(pull, controller, folder):
    """The force at 5 s, held by the controller from 2 s on."""
    one, of = slave(pull, f"{folder}/pull")
    other, other_of = slave(controller, f"{folder}/controller")
    interval = 0.05
    one.setFloat64([of["inputs.ramp"]], [interval])
    one.doStep(0, 2)
    for k in range(60):
        t = 2 + interval * k
        step = 2 + interval * (k + 1) - t
        other.setFloat64([other_of["force"]], one.getFloat64([of["winch.force"]]))
        other.doStep(t, step)
        one.setFloat64([of["winch.speed"]], other.getFloat64([other_of["speed"]]))
        one.doStep(t, step)
    (force,) = one.getFloat64([of["winch.force"]])
    for instance in (one, other):
        instance.terminate()
        instance.freeInstance()
    return force


def main(program, source, controller):
    complaints = list(fmpy.validation.validate_fmu(controller))
    data = pathlib.Path(source, "tests", "data")
    for name, version in itertools.product(CASES, ("2", "3")):
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/{name}.fmu"
            subprocess.run([program, "fmu", str(data / f"{name}.yaml"), "--fmi", version, "-q", "-o", path], check=True)
            complaints += [f"{name}, {version}: {c}" for c in fmpy.validation.validate_fmu(path)]
            rows = fmpy.simulate_fmu(path, stop_time=0.06, output_interval=0.02)
            if len(rows) != 4:
                complaints.append(f"{name}, {version}: {len(rows)} rows")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "fmu", str(data / "hold-tension.yaml"), "-q", "-o", f"{folder}/pull.fmu"], check=True)
        force = held(f"{folder}/pull.fmu", controller, folder)
        print(f"FMPy {fmpy.__version__}: {2 * len(CASES)} units; held at {force:.1f} N of 800 N")
        if abs(force - 800) > 8:
            complaints.append(f"the controller does not hold the force: {force} N")
    for complaint in complaints[:40]:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
