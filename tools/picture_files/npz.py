"""Reads the arrays of a NumPy .npz file without NumPy (NumPy documentation, numpy.lib.format)."""

import ast
import struct
import zipfile

CODES = {"<f8": "d", "<f4": "f", "<f2": "e", "|b1": "?", "|u1": "B", "<i4": "i", "<u4": "I", "<i8": "q"}


def read_npz(path) -> dict[str, tuple[tuple, tuple]]:
    """(shape, flat values in C order) by name. ValueError for a type that is not read here or Fortran order."""
    arrays = {}
    with zipfile.ZipFile(path) as archive:
        for entry in archive.namelist():
            content = archive.read(entry)
            wide = content[6] > 1
            length, = struct.unpack_from("<I" if wide else "<H", content, 8)
            start = (12 if wide else 10) + length
            header = ast.literal_eval(content[start - length:start].decode("latin-1"))
            if header["descr"] not in CODES or header["fortran_order"]:
                raise ValueError(f"{path}: {entry}: {header} is not read here")
            count = 1
            for side in header["shape"]:
                count *= side
            arrays[entry.removesuffix(".npy")] = (
                header["shape"], struct.unpack_from(f"<{count}{CODES[header['descr']]}", content, start))
    return arrays
