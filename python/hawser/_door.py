"""The door to results folders, which may be somebody else's (SECURITY.md): within one no link is followed and only files are read, and of
results.h5 only what a run writes: a file of HDF5 can have other files of the machine as its contents."""
from __future__ import annotations

import os
import pathlib
import stat
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from hawser.errors import CaseError, MissingError

if TYPE_CHECKING:
    import h5py

FILTERS = (1, 2)  # of HDF5: deflate, shuffle
CHUNK_MOST, GROWTH, SPARE = 1 << 30, 1100, 1 << 20  # bytes of a chunk, that one stored byte becomes, that may be unwritten


def opened(folder: pathlib.Path, name: str) -> BinaryIO:
    """A file of a results folder, which may itself be a link. Raises MissingError, CaseError (a link, a FIFO, a folder)."""
    path = folder / name
    root = file = -1
    try:
        root = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        file = os.open(name, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, dir_fd=root)
    except FileNotFoundError as error:
        raise MissingError(f"{path}: {error.strerror}", path) from None
    except OSError as error:
        raise CaseError(f"{path}: {'a link' if path.is_symlink() else error.strerror}, which is not read within results") from None
    finally:
        if root >= 0:
            os.close(root)
    if stat.S_ISREG(os.fstat(file).st_mode):
        return os.fdopen(file, "rb")
    os.close(file)
    raise CaseError(f"{path}: not a file, which is all that is read within results")


def read(folder: pathlib.Path, name: str) -> bytes:
    with opened(folder, name) as file:
        return file.read()


def is_there(folder: pathlib.Path, name: str) -> bool:
    return os.path.lexists(folder / name)


def is_data(data: h5py.Dataset, text: bool) -> bool:
    """Whether its values are numbers, or texts of one length, that were written into this file."""
    plist, size = data.id.get_create_plist(), data.dtype.itemsize
    kinds = data.dtype.kind == "S" if text else data.dtype.kind in "fiu"
    filters = all(plist.get_filter(k)[0] in FILTERS for k in range(plist.get_nfilters()))
    chunk = size * int(np.prod(data.chunks or (1,), dtype=object))
    written = size * int(np.prod(data.shape, dtype=object)) <= SPARE + GROWTH * data.id.get_storage_size()
    return bool(kinds and not data.is_virtual and not data.external and filters and chunk <= CHUNK_MOST and written)


def data_of(file: h5py.File, name: str, text: bool = False) -> Any:
    """A set of results.h5 by its name; None: there is none. Raises CaseError if it is nothing that a run writes."""
    import h5py

    link = file.get(name, getlink=True)
    if link is None:
        return None
    data = file[name] if isinstance(link, h5py.HardLink) else None
    if isinstance(data, h5py.Dataset) and is_data(data, text):
        return data
    raise CaseError(f"results.h5: '{name}' is no set that a run writes: it leads elsewhere, or its values are not in the file")


def names_of(file: h5py.File, name: str) -> list[bytes]:
    """A set of names of results.h5, which lie letter by letter; of format 1 they were texts of one length. Raises CaseError."""
    data = data_of(file, name, text=True)
    if data is None:
        return []
    letters = np.asarray(data)
    return list(letters) if letters.ndim == 1 else [bytes(row.tobytes()).rstrip(b"\0") for row in letters]
