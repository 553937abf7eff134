"""results.h5 by readers of others: netCDF's library, xarray and h5py, each where it is there; skipped (77) without all of them.

Format 1 had texts of one length, of which netCDF's library freed what was not its own (the process ended with "free(): invalid
pointer"), no dimension scales (dimensions were phony_dim_29, phony_dim_31 ...) and `unit` where others look for `units`.

Usage: check_h5.py PROGRAM SOURCE_DIR
"""
import importlib
import pathlib
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
UNITS = {"position": "m", "tension": "N", "time": "s", "curvature": "1/m", "velocity": "m/s"}
ROLLERS = ["R1", "R2"]  # the first of tests/data/limits-conveyor.yaml


def expect(ok, what):
    if not ok:
        complaints.append(what)


def by_netcdf(path):
    def walk(group):
        """Every value of every variable is read; returns how many variables there are."""
        n = 0
        for variable in group.variables.values():
            variable[...]
            n += 1
        return n + sum(walk(inner) for inner in group.groups.values())
    with netCDF4.Dataset(path) as data:
        for name, axes in SHAPES.items():
            expect(data[name].dimensions == axes, f"netCDF4: {name} has the dimensions {data[name].dimensions}")
        for name, unit in UNITS.items():
            expect(data[name].units == unit, f"netCDF4: {name} is in {data[name].units}")
        expect(data.format == 2, f"netCDF4: format {data.format}") if "format" in data.ncattrs() else expect(False, "no format")
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


def by_h5py(path):
    with h5py.File(path) as file:
        expect(int(file.attrs["format"]) == 2, "h5py: no format")
        scales = [list(axis.keys()) for axis in file["position"].dims]
        expect(scales[0] == ["time"] and scales[1] == ["segment"] and len(scales[2]) == 1, f"h5py: scales {scales}")
        expect(file["position"].attrs["units"] in ("m", b"m") and "unit" not in file["position"].attrs, "h5py: units")
        expect([bytes(row.tobytes()).rstrip(b"\0").decode() for row in file["roller_name"][:2]] == ROLLERS, "h5py: rollers")
        used = len(file["time"].attrs["REFERENCE_LIST"])
        expect(used == sum("time" in [k for a in d.dims for k in a.keys()] for d in file.values() if isinstance(d, h5py.Dataset)),
               f"h5py: the times are said to be of {used} sets")


def main(program, source):
    readers = {name: reader for name, module, reader in (("netCDF4", netCDF4, by_netcdf), ("xarray", xarray and netCDF4, by_xarray),
                                                         ("h5py", h5py, by_h5py)) if module}
    if not readers:
        print("skipped: neither netCDF4 nor h5py")
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
