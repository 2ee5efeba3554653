# SPDX-License-Identifier: MIT
"""Reads a mesh of triangles from a VTU file: text, or binary data (in base64 or raw, within the
arrays or appended, as it is or compressed by zlib).

The format is that of Kitware's "VTK file formats": a header of whole numbers before each array says
how many bytes follow, or the number and sizes of the compressed blocks.
"""
import base64
import binascii
import xml.etree.ElementTree as xml
import zlib
from dataclasses import dataclass, field

import numpy

TYPES = {"Float64": "f8", "Float32": "f4", "Int64": "i8", "UInt64": "u8", "Int32": "i4",
         "UInt32": "u4", "Int16": "i2", "UInt16": "u2", "Int8": "i1", "UInt8": "u1"}
TRIANGLE = 5  # VTK's number of the cell type


class BadFrame(Exception):
    """A file that is not a whole mesh of triangles; its text is one sentence."""


@dataclass
class Frame:
    """A mesh at one time."""

    points: numpy.ndarray     # n x 2
    triangles: numpy.ndarray  # m x 3, vertex numbers
    phases: numpy.ndarray     # m
    values: dict              # {name: n numbers}: the scalars at the vertices
    vectors: dict = field(default_factory=dict)  # {name: n x 2}: the vectors at the vertices


def read(path):
    """The Frame in a file. Throws BadFrame."""
    try:
        return Reader(path).frame()
    except xml.ParseError as fault:
        raise BadFrame(f"{path} is not whole XML ({fault}), so it may be truncated.") from fault
    except (KeyError, ValueError, zlib.error, binascii.Error, IndexError) as fault:
        raise BadFrame(f"{path} is not a whole VTU file: {fault}.") from fault
    except OSError as fault:
        raise BadFrame(f"{path} cannot be read: {fault.strerror}.") from fault


class Reader:
    """One file; `root` is its XML without appended data."""

    def __init__(self, path):
        self.path = path
        with open(path, "rb") as file:
            data = file.read()
        # Raw bytes are not XML: they are cut off before the rest is parsed.
        self.appended, self.encoding = b"", "raw"
        begin = data.find(b"<AppendedData")
        if begin >= 0:
            tag_end = data.index(b">", begin) + 1
            tag = data[begin:tag_end - 1].rstrip(b"/") + b"/>"
            self.encoding = xml.fromstring(tag).get("encoding", "base64")
            self.appended = data[data.index(b"_", tag_end) + 1:data.rindex(b"</AppendedData>")]
            if b"</VTKFile>" not in data[-200:]:
                raise ValueError("its end is missing")
            data = data[:begin] + b"</VTKFile>"
        self.root = xml.fromstring(data)
        self.order = ">" if self.root.get("byte_order") == "BigEndian" else "<"
        self.count = numpy.dtype(self.order + TYPES[self.root.get("header_type", "UInt32")])
        compressor = self.root.get("compressor")
        if compressor not in (None, "vtkZLibDataCompressor"):
            raise ValueError(f"its compressor is {compressor}, where vtkZLibDataCompressor or "
                             "none is expected")
        self.compressed = compressor is not None

    def frame(self):
        points = self._array("Points").reshape(-1, 3)[:, :2]
        corners = self._array("Cells", "connectivity").astype(int)
        kinds = self._array("Cells", "types").astype(int)
        phases = self._array("CellData", "phase").astype(int)
        if len(corners) != 3 * len(phases) or len(kinds) != len(phases) \
                or (kinds != TRIANGLE).any():
            raise ValueError(f"{len(phases)} phases and {len(corners)} corners are not those of "
                             "triangles alone")
        if len(corners) and not 0 <= corners.min() <= corners.max() < len(points):
            raise ValueError(f"a triangle names a vertex outside 0 to {len(points) - 1}")
        values, vectors = {}, {}
        for item in self.root.findall(".//PointData/DataArray"):
            width = int(item.get("NumberOfComponents", "1"))
            if width not in (1, 3):
                continue
            numbers = self.data(item).astype(float)
            if len(numbers) != width * len(points):
                raise ValueError(f"'{item.get('Name')}' is not "
                                 f"{'one number' if width == 1 else 'a vector'} for each vertex")
            if width == 1:
                values[item.get("Name")] = numbers
            else:
                vectors[item.get("Name")] = numbers.reshape(-1, 3)[:, :2]
        return Frame(points.astype(float), corners.reshape(-1, 3), phases, values, vectors)

    def _array(self, place, name=None):
        for item in self.root.findall(f".//{place}/DataArray"):
            if name in (None, item.get("Name")):
                return self.data(item)
        raise ValueError(f"it has no array '{name or place}'")

    def data(self, item):
        """The numbers of a DataArray, flat."""
        kind = numpy.dtype(self.order + TYPES[item.get("type", "Float64")])
        form = item.get("format", "ascii")
        if form == "ascii":
            return numpy.array((item.text or "").split(), dtype=kind)
        if form == "appended":
            source, raw = self.appended[int(item.get("offset")):], self.encoding == "raw"
        elif form == "binary":
            source, raw = (item.text or "").strip().encode("ascii"), False
        else:
            raise ValueError(f"an array's format is {form}")
        return numpy.frombuffer(self._bytes(source, raw), dtype=kind)

    def _bytes(self, source, raw):
        """The bytes of an array that begins where the source does."""
        width = self.count.itemsize

        def take(skip, size):
            """`size` bytes after `skip` bytes, each of the two encoded by itself."""
            if raw:
                part = source[skip:skip + size]
            else:
                start = 4 * -(-skip // 3)
                part = base64.b64decode(source[start:start + 4 * -(-size // 3)])[:size]
            if len(part) != size:
                raise ValueError("an array ends too early")
            return part

        def numbers(size):
            return [int(n) for n in numpy.frombuffer(take(0, size * width), dtype=self.count)]

        if not self.compressed:
            (size,) = numbers(1)
            return take(0, width + size)[width:]
        blocks, size, last = numbers(3)
        if blocks == 0:
            return b""
        packed = numbers(3 + blocks)[3:]
        data, place = take((3 + blocks) * width, sum(packed)), 0
        whole = []
        for length in packed:
            whole.append(zlib.decompress(data[place:place + length]))
            place += length
        result = b"".join(whole)
        if len(result) != size * (blocks - 1) + (last or size):
            raise ValueError("a compressed array does not have the length that it names")
        return result
