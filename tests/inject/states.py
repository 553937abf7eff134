"""The sets of a file of HDF5, by ctypes: two files of the same contents need not be the same bytes."""
import ctypes
import ctypes.util
import functools
import tempfile


@functools.lru_cache(1)
def library():
    """HDF5, or None where it is not found."""
    name = ctypes.util.find_library("hdf5_serial") or ctypes.util.find_library("hdf5")
    if not name:
        return None
    h5 = ctypes.CDLL(name)
    for function in ("H5Fopen", "H5Dopen2", "H5Dget_space"):
        getattr(h5, function).restype = ctypes.c_int64
    h5.H5Sget_simple_extent_npoints.restype = ctypes.c_int64
    h5.H5open()
    return h5


def names(h5, file):
    """Of all sets."""
    found = []
    visitor = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int64, ctypes.c_char_p, ctypes.c_void_p, ctypes.c_void_p)
    h5.H5Lvisit(ctypes.c_int64(file), 0, 0, visitor(lambda _, name, info, user: found.append(name) or 0), None)
    return found


def one(h5, file, name):
    """A set's numbers as bytes; None if it is no set of numbers."""
    there = h5.H5Dopen2(ctypes.c_int64(file), name, ctypes.c_int64(0))
    if there < 0:
        return None
    space = h5.H5Dget_space(ctypes.c_int64(there))
    n = h5.H5Sget_simple_extent_npoints(ctypes.c_int64(space))
    values = (ctypes.c_double * max(n, 1))()
    number = ctypes.c_int64.in_dll(h5, "H5T_NATIVE_DOUBLE_g")
    bad = h5.H5Dread(ctypes.c_int64(there), number, ctypes.c_int64(0), ctypes.c_int64(0), ctypes.c_int64(0), values)
    h5.H5Sclose(ctypes.c_int64(space))
    h5.H5Dclose(ctypes.c_int64(there))
    return (n, None if bad < 0 else bytes(values))


@functools.lru_cache(8)
def contents(data):
    """All sets by name; None where there is no HDF5, {} of what is no such file."""
    h5 = library()
    if not h5:
        return None
    h5.H5Eset_auto2(ctypes.c_int64(0), None, None)  # of this thread
    with tempfile.NamedTemporaryFile(suffix=".h5") as file:
        file.write(data)
        file.flush()
        opened = h5.H5Fopen(file.name.encode(), 0, ctypes.c_int64(0))
        if opened < 0:
            return {}
        found = {name: one(h5, opened, name) for name in names(h5, opened)}
        h5.H5Fclose(ctypes.c_int64(opened))
    return found
