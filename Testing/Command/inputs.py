"""Small inputs of every kind that the command reads, and broken ones, written by hand: no library is trusted here."""

import itertools
import json
import math
import struct

SUFFIXES = ["vtp", "vtu", "vtk", "vti", "mhd", "ply", "stl", "obj", "wrl", "glb"]

# An octahedron: six points, eight triangles.
POINTS = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
TRIANGLES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
SIDE = 12  # points along each edge of a volume


def words(rows):
    return "\n".join(" ".join(str(value) for value in row) for row in rows)


def distances():
    """A volume of distances to its centre, as many as SIDE cubed."""
    middle = (SIDE - 1) / 2
    places = range(SIDE)
    return [math.dist((x, y, z), (middle,) * 3) for z in places for y in places for x in places]


def labels():
    """A ball of label 2 in a ball of label 1 in nothing."""
    return bytes(2 if d < 2.5 else 1 if d < 5 else 0 for d in distances())


def vtp(points=POINTS, triangles=TRIANGLES):
    offsets = list(itertools.accumulate(len(triangle) for triangle in triangles))
    return f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{words(points)}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{words(triangles)}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{words([offsets])}</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""


def vtu():
    """Two tetrahedra with a scalar at each point."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    return f"""<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="5" NumberOfCells="2">
<PointData Scalars="heat"><DataArray type="Float32" Name="heat" format="ascii">0 1 2 3 4</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{words(points)}</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 1 2 3 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"""


def vtk():
    polygons = [(3,) + triangle for triangle in TRIANGLES]
    return f"""# vtk DataFile Version 3.0
octahedron
ASCII
DATASET POLYDATA
POINTS {len(POINTS)} float
{words(POINTS)}
POLYGONS {len(polygons)} {4 * len(polygons)}
{words(polygons)}
"""


def structured_grid():
    """A legacy file of a bent grid with a scalar at each point."""
    places = range(5)
    points = [(x, y + 0.1 * x * x, z) for z in places for y in places for x in places]
    scalars = [[x + y + z] for z in places for y in places for x in places]
    return f"""# vtk DataFile Version 3.0
bent grid
ASCII
DATASET STRUCTURED_GRID
DIMENSIONS 5 5 5
POINTS {len(points)} float
{words(points)}
POINT_DATA {len(points)}
SCALARS heat float 1
LOOKUP_TABLE default
{words(scalars)}
"""


def vti(values=None):
    last = SIDE - 1
    return f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="0 {last} 0 {last} 0 {last}" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 {last} 0 {last} 0 {last}"><PointData Scalars="distance">
<DataArray type="Float32" Name="distance" format="ascii">{words([values or distances()])}</DataArray>
</PointData></Piece></ImageData></VTKFile>
"""


def turning():
    """A vector at each point of the volume: a flow round the axis z, faster farther out."""
    middle = (SIDE - 1) / 2
    places = range(SIDE)
    return [(middle - y, x - middle, 0) for _ in places for y in places for x in places]


def flow(vectors=None, layers=SIDE):
    """A volume, or with one layer a slice, that has vectors and nothing else."""
    last = SIDE - 1
    extent = f"0 {last} 0 {last} 0 {layers - 1}"
    rows = (vectors or turning())[:SIDE * SIDE * layers]
    return f"""<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="{extent}"><PointData>
<DataArray type="Float64" Name="velocity" NumberOfComponents="3" format="ascii">{words(rows)}</DataArray>
</PointData></Piece></ImageData></VTKFile>
"""


def mhd(data_file):
    return f"""ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = False
DimSize = {SIDE} {SIDE} {SIDE}
ElementSpacing = 1 1 1
ElementType = MET_UCHAR
ElementDataFile = {data_file}
"""


def ply(points=POINTS):
    faces = [(3,) + triangle for triangle in TRIANGLES]
    return f"""ply
format ascii 1.0
element vertex {len(points)}
property float x
property float y
property float z
element face {len(faces)}
property list uchar int vertex_indices
end_header
{words(points)}
{words(faces)}
"""


def stl():
    facets = b"".join(
        struct.pack("<12fH", 0, 0, 0, *(value for corner in triangle for value in POINTS[corner]), 0)
        for triangle in TRIANGLES)
    return b"octahedron".ljust(80) + struct.pack("<I", len(TRIANGLES)) + facets


def obj():
    vertices = [("v",) + point for point in POINTS]
    faces = [("f",) + tuple(corner + 1 for corner in triangle) for triangle in TRIANGLES]
    return words(vertices + faces) + "\n"


def wrl():
    corners = ", ".join(" ".join(map(str, point)) for point in POINTS)
    faces = ", ".join(", ".join(map(str, triangle)) + ", -1" for triangle in TRIANGLES)
    return f"""#VRML V2.0 utf8
Shape {{
  appearance Appearance {{ material Material {{ diffuseColor 0.2 0.5 0.8 transparency 0.6 }} }}
  geometry IndexedFaceSet {{ coord Coordinate {{ point [ {corners} ] }} coordIndex [ {faces} ] }}
}}
"""


def glb(points=POINTS, **material):
    positions = b"".join(struct.pack("<3f", *point) for point in points)
    indices = b"".join(struct.pack("<3H", *triangle) for triangle in TRIANGLES)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "materials": [{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.3, 0.2, 0.5]}, **material}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(TRIANGLES), "type": "SCALAR"},
        ],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data = positions + indices
    data += b"\0" * (-len(data) % 4)
    body = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def glass(thickness=1, distance=0.4, ior=1.5, **transmission):
    """Of the extensions of glTF's materials."""
    return glb(name="glass", extensions={
        "KHR_materials_transmission": {"transmissionFactor": 0.9, **transmission},
        "KHR_materials_volume": {"thicknessFactor": thickness, "attenuationColor": [0.9, 0.4, 0.1], "attenuationDistance": distance},
        "KHR_materials_ior": {"ior": ior}})


def scene():
    return {
        "title": "Two octahedra",
        "size": [48, 32],
        "background": "#203040",
        "camera": {"direction": [1, -1, -1], "up": [0, 1, 0], "zoom": 0.9},
        "lights": [{"type": "headlight"}, {"type": "camera", "position": [1, 1, 1], "color": "gold", "intensity": 0.5}],
        "actors": [
            {"file": "ok.vtp", "color": "#ff8800", "opacity": 0.4},
            {"file": "ok.mhd", "labels": [{"value": 2, "name": "core", "color": "red", "opacity": 0.8}], "smooth": 0},
        ],
    }


def tubes():
    """A scene of streamtubes, each of its settings given."""
    settings = {"seeds": 8, "speed": 0.2, "length": 6, "radius": 0.4, "sides": 6}
    actor = {"file": "flow.vti", "color": "tomato", "opacity": 0.5, "streamtubes": settings}
    return {"size": [48, 32], "actors": [actor]}


# Two frames, with fragments on both diagonals of 4 x 3 pixels and several in one; each is frame, x, y, z, r, g, b, a. Every number is a float without rounding.
FRAGMENTS = [(7, i % 4, i % 3, 0.125 + i / 32, 0.5, 1.25, 0.0, 0.25) for i in range(9)]
FRAGMENTS += [(12, 3, 2, 0.5, 1.0, 0.0, 0.75, i / 8) for i in range(5)]
TRACE_SIZE = (4, 3)


def trace_csv(rows=FRAGMENTS, head="# size 4x3", columns="frame,x,y,z,r,g,b,a"):
    return "\n".join([head, columns, *(",".join(map(str, row)) for row in rows)]) + "\n"


def trace_binary(rows=FRAGMENTS, magic=b"FRAGMENT", version=1, size=TRACE_SIZE):
    numbers = list(dict.fromkeys(row[0] for row in rows))
    frames = [[row for row in rows if row[0] == number] for number in numbers]
    content = struct.pack("<8s4I", magic, version, *size, len(frames))
    for number, frame in zip(numbers, frames):
        content += struct.pack("<IQ", number, len(frame))
        content += b"".join(struct.pack("<2H5f", *row[1:]) for row in frame)
    return content


def histogram():
    """That of the traces."""
    return {"title": "Two frames", "size": list(TRACE_SIZE),
            "frames": [{"name": "Frame7", "pixels": [9]}, {"name": "Frame12", "pixels": [0, 0, 0, 0, 1]}]}


def write_good(folder):
    """One valid file of each kind: ok.vtp, ok.vtu, ..."""
    contents = {
        "ok.vtp": vtp(), "ok.vtu": vtu(), "ok.vtk": vtk(), "grid.vtk": structured_grid(), "ok.vti": vti(),
        "ok.mhd": mhd("ok.raw"), "ok.raw": labels(), "ok.ply": ply(), "ok.stl": stl(), "ok.obj": obj(),
        "ok.wrl": wrl(), "ok.glb": glb(), "glass.glb": glass(), "thin.glb": glass(thickness=0), "dense.glb": glass(ior=2.4),
        "painted.glb": glass(transmissionTexture={"index": 0}), "scene.json": json.dumps(scene()),
        "flow.vti": flow(), "straight.vti": flow([(0, 0, 2)] * SIDE ** 3),
        "slowing.vti": flow([(0, 0, SIDE - z) for z in range(SIDE) for _ in range(SIDE ** 2)]),
        "tubes.json": json.dumps(tubes()),
        "ok.csv": trace_csv(), "ok.trace": trace_binary(), "histogram.json": json.dumps(histogram()),
    }
    write(folder, contents)
    return contents


def write(folder, contents):
    for name, content in contents.items():
        (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)


def write_broken(folder):
    """Files with something wrong: empty, cut, garbage, and each with one fault of its own."""
    good = write_good(folder)
    garbage = bytes((i * i * 37 + i * 11 + 129) % 256 for i in range(3000))
    for suffix in SUFFIXES:
        content = good[f"ok.{suffix}"]
        content = content.encode() if isinstance(content, str) else content
        write(folder, {
            f"empty.{suffix}": b"",
            f"garbage.{suffix}": garbage,
            f"cut.{suffix}": content[:int(0.8 * len(content))],
        })
    grid = good["grid.vtk"]
    scene_text = good["scene.json"]
    write(folder, {
        "cutgrid.vtk": grid[:int(0.9 * len(grid))],
        "cut.json": scene_text[:len(scene_text) // 2],
        "cutraw.mhd": mhd("cut.raw"), "cut.raw": labels()[:500],
        "noraw.mhd": mhd("gone.raw"),
        "nocells.vtp": vtp(triangles=[]),
        "nopoints.vtp": vtp(points=[], triangles=[]),
        "wrongpoint.vtp": vtp(triangles=[(0, 1, 99)]),
        "emptycell.vtp": vtp(triangles=[(0, 1, 2), ()]),
        "nan.ply": ply([*POINTS[:2], (0, "nan", 0), *POINTS[3:]]),
        "inf.ply": ply([("inf", 0, 0), *POINTS[1:]]),
        "nan.glb": glb([*POINTS[:5], (0, 0, math.nan)]),
        "rare.glb": glass(ior=0.5), "short.glb": glass(distance=0),
        "constant.vti": vti([1] * SIDE ** 3),
        "still.vti": flow([(0, 0, 0)] * SIDE ** 3),
        "slice.vti": flow(layers=1),
        "leaving.vti": flow([(1, -1, 0)] + [(0, 0, 0)] * (SIDE ** 3 - 1)),
        "nan.vti": flow([(1, 0, 0), (0, math.nan, 0)] * (SIDE ** 3 // 2)),
        "empty.csv": "", "empty.trace": b"", "garbage.csv": garbage, "garbage.trace": garbage,
        "norows.csv": trace_csv([]), "noframes.trace": trace_binary([]),
        "cut.trace": good["ok.trace"][:-1], "cuthead.trace": good["ok.trace"][:14], "cutframe.trace": good["ok.trace"][:30],
        "longer.trace": good["ok.trace"] + b"\0",
        "huge.vti": flow([(1e308, 1e308, -1.6e308)] * SIDE ** 3),
    })
    (folder / "folder.vtp").mkdir()
    (folder / "folder.png").mkdir()
