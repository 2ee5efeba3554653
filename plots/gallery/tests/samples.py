# SPDX-License-Identifier: MIT
"""A mesh in the forms that a VTU file can have, and a program that stands in for dsc_scene."""
import base64
import os
import struct
import sys
import zlib

import numpy

# A unit square in four triangles about its centre; the two on the right are of phase 1.
POINTS = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0]], dtype="f8")
CORNERS = numpy.array([0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4], dtype="i8")
PHASES = numpy.array([0, 1, 1, 0], dtype="u4")
VALUES = numpy.array([0, 1, 1, 0, 0.5], dtype="f8")
ARRAYS = (("PointData", "value", "Float64", VALUES), ("CellData", "phase", "UInt32", PHASES),
          ("Points", "Points", "Float64", POINTS), ("Cells", "connectivity", "Int64", CORNERS),
          ("Cells", "types", "UInt8", numpy.full(4, 5, dtype="u1")))


def _packed(data, compressed, header, block=24):
    """(header, data) of a binary array; blocks are small, so that there are several."""
    if not compressed:
        return struct.pack("<" + header, len(data)), data
    blocks = [data[k:k + block] for k in range(0, len(data), block)]
    packed = [zlib.compress(b) for b in blocks]
    last = len(data) % block
    return struct.pack(f"<{3 + len(blocks)}{header}", len(blocks), block, last,
                       *map(len, packed)), b"".join(packed)


def vtu(form="ascii", encoding="raw", compressed=False, header="Q", arrays=ARRAYS):
    """The bytes of a file; form: ascii, binary or appended."""
    appended, parts = b"", {}
    for place, name, kind, values in arrays:
        text, more = "", ""
        if form == "ascii":
            text = " ".join(repr(v) for v in values.ravel().tolist())
        else:
            head, data = _packed(values.tobytes(), compressed, header)
            if form == "binary" or encoding == "base64":
                whole = base64.b64encode(head) + base64.b64encode(data) if compressed else \
                    base64.b64encode(head + data)
            else:
                whole = head + data
            if form == "binary":
                text = whole.decode()
            else:
                more = f' offset="{len(appended)}"'
                appended += whole
        width = ' NumberOfComponents="3"' if name == "Points" else ""
        parts.setdefault(place, []).append(
            f'<DataArray type="{kind}" Name="{name}"{width} format="{form}"{more}>{text}'
            "</DataArray>")
    inside = "".join(f"<{p}>{''.join(items)}</{p}>" for p, items in parts.items())
    kinds = f' header_type="{"UInt64" if header == "Q" else "UInt32"}"'
    kinds += ' compressor="vtkZLibDataCompressor"' if compressed else ""
    start = (f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"'
             f"{kinds}><UnstructuredGrid><Piece>{inside}</Piece></UnstructuredGrid>").encode()
    if form == "appended":
        start += f'<AppendedData encoding="{encoding}">\n_'.encode() + appended
        start += b"\n</AppendedData>"
    return start + b"</VTKFile>\n"


PROGRAM = '''#!{python}
import json, os, shutil, sys
words = sys.argv[1:]
if words == ["list"]:
    print("swirl   turns; keys: h\\ntranslation  goes\\nbroken  fails")
    sys.exit(0)
if words == ["run", "--help"]:
    print("Options:\\n{at}  --every INT  steps")
    sys.exit(0)
def given(name, other=None):
    return words[words.index(name) + 1] if name in words else other
scene = words[1]
if scene == "broken":
    sys.exit("dsc_scene: 1 triangle was inverted")
steps, dt = 10, 0.1
with open(given("--json", os.devnull), "w") as file:
    json.dump({{"scene": scene, "steps": steps, "strategy": "sequential", "triangles_first": 4,
               "triangles_last": 6, "area_ratio": 0.99, "sd_last": 0.01, "area_exact_last": 0.5,
               "sd_rel_last": 0.02, "inverted": 0, "unreached": 0, "wall_s": 0.25, "cpu_s": 0.2,
               "machine": "a machine", "commit": "c0ffee",
               "parameters": {{"h": 0.5, "dt": dt, "integrator": "rk4", "insertion": "cubic"}},
               "histograms": {{"area": {{"edges": [0, 1, 2, 4], "counts": [1, 2, 1]}}}}}}, file)
every = int(given("--every", "1"))
if "--series" in words:
    with open(given("--series"), "w") as file:
        file.write("step,time,triangles\\n")
        for step in sorted({{*range(0, steps + 1, every), steps}}):
            file.write(f"{{step}},{{step * dt}},{{4 + step}}\\n")
if "--frames" in words:
    os.makedirs(given("--frames"))
    numbers = [0, 4, 10]
    if "--at" in words:
        numbers = [next(k for k in range(steps + 1) if k * dt >= float(t))
                         for t in given("--at").split(",")]
    for k in numbers:
        name = f"{{scene}}_sequential_{{k:05d}}.vtu"
        shutil.copy({frame!r}, os.path.join(given("--frames"), name))
'''


def program(folder, takes_times):
    """Writes the program that stands in for dsc_scene and returns its path."""
    frame = os.path.join(folder, "frame.vtu")
    with open(frame, "wb") as file:
        file.write(vtu())
    path = os.path.join(folder, "dsc_scene")
    with open(path, "w", encoding="utf-8") as file:
        file.write(PROGRAM.format(python=sys.executable, frame=frame,
                                  at="  --at TEXT  times\\n" if takes_times else ""))
    os.chmod(path, 0o755)
    return path
