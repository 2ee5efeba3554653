# SPDX-License-Identifier: MIT
"""The arrays of VTK's XML files: as text, or appended in base64 after zlib has compressed them."""
import base64
import zlib

import numpy

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int8": "<i1", "Int16": "<i2", "Int32": "<i4",
         "Int64": "<i8", "UInt8": "<u1", "UInt16": "<u2", "UInt32": "<u4", "UInt64": "<u8"}


def read_array(root, tag):
    """The numbers of a DataArray, flat. root: the VTKFile. Raises ValueError for what it cannot
    read, with a sentence that says what."""
    kind = tag.get("format", "ascii")
    try:
        if kind == "ascii":
            return numpy.array((tag.text or "").split(), dtype=float)
        if kind == "appended":
            return _appended(root, tag)
    except (ValueError, KeyError, IndexError, zlib.error) as fault:
        raise ValueError(f"{kind} data '{tag.get('Name')}' that are no numbers ({fault})") from fault
    raise ValueError(f"{kind} data, where ascii or appended is expected")


def _appended(root, tag):
    data = root.find("AppendedData")
    if data is None or data.get("encoding") != "base64" or \
            root.get("header_type") != "UInt64" or root.get("compressor") != "vtkZLibDataCompressor":
        raise ValueError("not in base64, compressed by zlib with headers of UInt64")
    text = data.text.strip()[1:]  # begins with an underscore
    at = int(tag.get("offset"))
    # Header and blocks are encoded each by itself.
    blocks = int(numpy.frombuffer(base64.b64decode(text[at:at + 12])[:8], "<u8")[0])
    begin = at + _characters(8 * (3 + blocks))
    sizes = numpy.frombuffer(base64.b64decode(text[at:begin]), "<u8")[3:]
    packed = base64.b64decode(text[begin:begin + _characters(int(sizes.sum()))])
    ends = numpy.cumsum(sizes).astype(int)
    whole = b"".join(zlib.decompress(packed[end - int(size):end])
                     for size, end in zip(sizes, ends))
    return numpy.frombuffer(whole, TYPES[tag.get("type")])


def _characters(count):
    return (count + 2) // 3 * 4
