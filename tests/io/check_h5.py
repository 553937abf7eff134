"""results.h5 by readers of others: netCDF's library, xarray, h5py and ParaView (by results.xdmf), each where it is there; skipped (77)
without all of them.

Format 1 had texts of one length, of which netCDF's library freed what was not its own (the process ended with "free(): invalid
pointer"), no dimension scales (dimensions were phony_dim_29, phony_dim_31 ...) and `unit` where others look for `units`. Format 2 had
scales in the root group alone, and each state a second time for ParaView.

Usage: check_h5.py PROGRAM SOURCE_DIR
"""
import importlib
import pathlib
import shutil
import subprocess
import sys
import tempfile


def there(name):
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


netCDF4, xarray, h5py = there("netCDF4"), there("xarray"), there("h5py")
complaints = []
SHAPES = {"position": ("time", "segment", "xyz"), "quaternion": ("time", "segment", "wxyz"), "tension": ("time", "joint"),
          "roller_load": ("time", "roller"), "roller_force": ("time", "roller", "xyz"), "winch_force": ("time",), "roller_s": ("roller",),
          "roller_name": ("roller", "letter")}
GROUPS = {"chain": {"diameter": ("segment",), "piece_name": ("piece_number", "letter")},
          "geometry/route": {"s": ("s",), "position": ("s", "xyz"), "line": ("element", "end")},
          "geometry/rollers": {"name": ("roller", "letter"), "axis": ("roller", "xyz")},
          "geometry/conveyors": {"points": ("conveyor", "coordinate")},
          "geometry/mesh": {"points": ("point", "xyz"), "triangles": ("triangle", "corner")},
          "envelope/arc": {"tension_max": ("s",)}, "envelope/place": {"s": ("s",), "tension_max": ("s",)}}
UNITS = {"position": "m", "tension": "N", "time": "s", "curvature": "1/m", "velocity": "m/s"}
ROLLERS = ["R1", "R2"]  # the first of tests/data/limits-conveyor.yaml


def expect(ok, what):
    if not ok:
        complaints.append(what)


def by_netcdf(path):
    def walk(group):
        """Every value of every variable is read, and no dimension is without a name; returns how many variables there are."""
        n = 0
        for name, variable in group.variables.items():
            variable[...]
            expect(not any("phony" in axis for axis in variable.dimensions), f"netCDF4: {group.path}/{name} has {variable.dimensions}")
            n += 1
        return n + sum(walk(inner) for inner in group.groups.values())
    with netCDF4.Dataset(path) as data:
        for name, axes in SHAPES.items():
            expect(data[name].dimensions == axes, f"netCDF4: {name} has the dimensions {data[name].dimensions}")
        for group, sets in GROUPS.items():
            for name, axes in sets.items():
                expect(data[group][name].dimensions == axes, f"netCDF4: {group}/{name} has {data[group][name].dimensions}")
        for name, unit in UNITS.items():
            expect(data[name].units == unit, f"netCDF4: {name} is in {data[name].units}")
        expect(data.format == 3, f"netCDF4: format {data.format}") if "format" in data.ncattrs() else expect(False, "no format")
        names = netCDF4.chartostring(data["roller_name"][:])
        expect(list(names[:2]) == ROLLERS, f"netCDF4: rollers {list(names[:2])}")
        expect(walk(data) > 60, "netCDF4: few variables")


def by_xarray(path):
    with xarray.open_dataset(path, engine="netcdf4" if netCDF4 else "h5netcdf") as data:
        expect(data.position.dims == SHAPES["position"], f"xarray: {data.position.dims}")
        expect(data.tension.attrs["units"] == "N", "xarray: no units")
        late = data.sel(segment=3).isel(time=-1).position
        expect(late.shape == (3,), f"xarray: a place of shape {late.shape}")
        expect([bytes(n).decode() for n in data.roller_name.values[:2]] == ROLLERS, f"xarray: rollers {data.roller_name.values[:2]}")


    for group, name in (("envelope/place", "tension_max"), ("geometry/route", "curvature")):
        with xarray.open_dataset(path, group=group, engine="netcdf4") as data:
            there = data[name].dropna("s")
            expect(float(there.sel(s=there.s[-1] + 1, method="nearest")) == float(there[-1]), f"xarray: {group} has no places")


def by_h5py(path):
    with h5py.File(path) as file:
        expect(int(file.attrs["format"]) == 3, "h5py: no format")
        expect("frames" not in file, "h5py: states are there twice")
        scales = [list(axis.keys()) for axis in file["position"].dims]
        expect(scales[0] == ["time"] and scales[1] == ["segment"] and len(scales[2]) == 1, f"h5py: scales {scales}")
        expect(file["position"].attrs["units"] in ("m", b"m") and "unit" not in file["position"].attrs, "h5py: units")
        expect([bytes(row.tobytes()).rstrip(b"\0").decode() for row in file["roller_name"][:2]] == ROLLERS, "h5py: rollers")
        used = len(file["time"].attrs["REFERENCE_LIST"])
        expect(used == sum("time" in [k for a in d.dims for k in a.keys()] for d in file.values() if isinstance(d, h5py.Dataset)),
               f"h5py: the times are said to be of {used} sets")


# Run by ParaView's own Python: the states that its reader returns, in full precision.
PARAVIEW = """
import sys, paraview.simple as simple
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
def leaves(block):
    if not block.IsA("vtkMultiBlockDataSet"):
        yield block
    else:
        for i in range(block.GetNumberOfBlocks()):
            yield from leaves(block.GetBlock(i))
reader = simple.XDMFReader(FileNames=[sys.argv[1]])
reader.UpdatePipelineInformation()
for time in reader.TimestepValues:
    reader.UpdatePipeline(time)
    for grid in leaves(servermanager.Fetch(reader)):
        data = grid.GetCellData()
        if data.HasArray("tension"):
            print("state", time, *[vtk_to_numpy(a).sum().hex() for a in (grid.GetPoints().GetData(), data.GetArray("tension"))])
"""


def by_paraview(path):
    said = subprocess.run(["pvpython", "--force-offscreen-rendering", "-c", PARAVIEW, path.replace(".h5", ".xdmf")], capture_output=True,
                          text=True)
    states = [line.split()[1:] for line in said.stdout.splitlines() if line.startswith("state ")]
    expect("ERR" not in said.stderr + said.stdout and said.returncode == 0, f"ParaView: {said.stdout}{said.stderr}")
    if not h5py:
        expect(len(states) > 2, f"ParaView: {len(states)} states")
        return
    with h5py.File(path) as file:
        expect(len(states) == len(file["time"]), f"ParaView: {len(states)} states")
        for k, state in enumerate(states):
            expect(abs(float(state[0]) - file["time"][k]) < 1e-9, f"ParaView: state {k} at {state[0]}")
            for name, total, whole in (("position", state[1], file["position"][k]), ("tension", state[2], file["tension"][k][1:-1])):
                expect(abs(float.fromhex(total) - whole.sum()) <= 1e-12 * abs(whole).sum(), f"ParaView: {name} of state {k}")


def main(program, source):
    readers = {name: reader for name, module, reader in (("netCDF4", netCDF4, by_netcdf), ("xarray", xarray and netCDF4, by_xarray),
                                                         ("h5py", h5py, by_h5py), ("ParaView", shutil.which("pvpython"), by_paraview)) if module}
    if not readers:
        print("skipped: neither netCDF4 nor h5py nor ParaView")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(source, "tests", "data", "limits-conveyor.yaml")
        said = subprocess.run([program, "run", case, "-q", "--set", "output.states=100 ms", "-o", folder + "/r"], capture_output=True, text=True)
        if not pathlib.Path(folder, "r", "results.h5").exists():
            print(said.stderr)
            return 1
        for reader in readers.values():
            reader(folder + "/r/results.h5")
    for complaint in complaints:
        print(complaint)
    print("read by", ", ".join(readers))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
