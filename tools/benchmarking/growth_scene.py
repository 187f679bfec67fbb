"""Scenes of any size as binary glTF: 25 bumpy spheres of plastic, mirror and glass on a waved ground, by numpy."""

import json
import math
import pathlib
import struct

import numpy

from benchmarking.study_scene import GRID, GROUND_HALF_WIDTH, SPACING
from scene_making import pictures

FLOAT, UNSIGNED_INT = 5126, 5125
GROUND_SHARE = 1.0 / 6.0  # of the triangles
PICTURE_SIZE = 64
# In the order in which materials get them.
TEXTURE_SLOTS = ("baseColorTexture", "metallicRoughnessTexture", "normalTexture", "emissiveTexture")


def grid_triangles(rows: int, columns: int) -> numpy.ndarray:
    """Two triangles for each cell of a grid of (rows + 1) x (columns + 1) vertices: [2 rows columns][3]."""
    first = (numpy.arange(rows)[:, None] * (columns + 1) + numpy.arange(columns)[None, :]).reshape(-1)
    a, b, c, d = first, first + 1, first + columns + 1, first + columns + 2
    return numpy.stack([numpy.stack([a, c, d], 1), numpy.stack([a, d, b], 1)], 1).reshape(-1, 3).astype(numpy.uint32)


def vertex_normals(positions: numpy.ndarray, triangles: numpy.ndarray) -> numpy.ndarray:
    """Unit normals: of a vertex the sum over its triangles, each as long as its area."""
    v0, v1, v2 = (positions[triangles[:, corner]] for corner in range(3))
    faces = numpy.cross(v1 - v0, v2 - v0)
    sums = numpy.stack([sum(numpy.bincount(triangles[:, corner], faces[:, axis], len(positions)) for corner in range(3))
                        for axis in range(3)], 1)
    return sums / numpy.maximum(numpy.linalg.norm(sums, axis=1, keepdims=True), 1e-30)


def bumpy_sphere(rows: int) -> tuple:
    """Positions, triangles and uv of a sphere of `rows` x 2 `rows` cells, of which those at the poles are one triangle."""
    columns = 2 * rows
    t, p = numpy.meshgrid(numpy.linspace(0.0, numpy.pi, rows + 1), numpy.linspace(0.0, 2.0 * numpy.pi, columns + 1), indexing="ij")
    radius = 1.0 + 0.03 * numpy.sin(9.0 * t) * numpy.sin(7.0 * p)
    positions = numpy.stack([radius * numpy.sin(t) * numpy.cos(p), radius * numpy.cos(t), -radius * numpy.sin(t) * numpy.sin(p)], -1)
    triangles = grid_triangles(rows, columns)
    # The upper triangle of a cell has two corners at the pole in the first row, the lower one in the last.
    return positions.reshape(-1, 3), numpy.concatenate([triangles[:2 * columns:2], triangles[2 * columns:-2 * columns],
                                                        triangles[-2 * columns + 1::2]]), grid_uv(rows, columns)


def grid_uv(rows: int, columns: int) -> numpy.ndarray:
    v, u = numpy.meshgrid(numpy.linspace(0.0, 4.0, rows + 1), numpy.linspace(0.0, 8.0, columns + 1), indexing="ij")
    return numpy.stack([u, v], -1).reshape(-1, 2)


def waved_ground(cells: int) -> tuple:
    z, x = numpy.meshgrid(*[numpy.linspace(-GROUND_HALF_WIDTH, GROUND_HALF_WIDTH, cells + 1)] * 2, indexing="ij")
    positions = numpy.stack([x, -1.1 + 0.06 * numpy.sin(1.3 * x) * numpy.cos(1.1 * z), z], -1).reshape(-1, 3)
    return positions, grid_triangles(cells, cells), grid_uv(cells, cells)


class Writer:
    """The document and the binary chunk while they grow."""

    def __init__(self):
        self.parts, self.length = [], 0
        self.document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                         "materials": [], "accessors": [], "bufferViews": [],
                         "extensionsUsed": ["KHR_materials_transmission", "KHR_materials_ior"]}

    def add_view(self, content: bytes) -> int:
        self.document["bufferViews"].append({"buffer": 0, "byteOffset": self.length, "byteLength": len(content)})
        self.parts.append(content + bytes(-len(content) % 4))
        self.length += len(self.parts[-1])
        return len(self.document["bufferViews"]) - 1

    def add_accessor(self, rows: numpy.ndarray, kind: str, component: int) -> int:
        values = rows.astype("<f4" if component == FLOAT else "<u4")
        entry = {"bufferView": self.add_view(values.tobytes()), "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            entry["min"], entry["max"] = values.min(0).tolist(), values.max(0).tolist()
        self.document["accessors"].append(entry)
        return len(self.document["accessors"]) - 1

    def add_mesh(self, shape: tuple, materials: list) -> list:
        """One mesh for each material, all of the same accessors; their indices."""
        positions, triangles, uv = shape
        attributes = {"POSITION": self.add_accessor(positions, "VEC3", FLOAT),
                      "NORMAL": self.add_accessor(vertex_normals(positions, triangles), "VEC3", FLOAT),
                      "TEXCOORD_0": self.add_accessor(uv, "VEC2", FLOAT)}
        corners = self.add_accessor(triangles.reshape(-1), "SCALAR", UNSIGNED_INT)
        first = len(self.document["meshes"])
        self.document["meshes"] += [{"primitives": [{"attributes": attributes, "indices": corners, "material": material}]}
                                    for material in materials]
        return list(range(first, first + len(materials)))

    def add_node(self, mesh: int, place=(0.0, 0.0, 0.0)) -> None:
        self.document["scenes"][0]["nodes"].append(len(self.document["nodes"]))
        self.document["nodes"].append({"mesh": mesh, "translation": list(place)})

    def add_instances(self, mesh: int, places: numpy.ndarray, turns: numpy.ndarray, sizes: numpy.ndarray) -> None:
        """`mesh` at many places in one node, each turned by a unit quaternion and scaled (EXT_mesh_gpu_instancing)."""
        attributes = {"TRANSLATION": self.add_accessor(places, "VEC3", FLOAT), "ROTATION": self.add_accessor(turns, "VEC4", FLOAT),
                      "SCALE": self.add_accessor(numpy.repeat(sizes[:, None], 3, 1), "VEC3", FLOAT)}
        self.document["scenes"][0]["nodes"].append(len(self.document["nodes"]))
        self.document["nodes"].append({"mesh": mesh, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": attributes}}})
        if "EXT_mesh_gpu_instancing" not in self.document["extensionsUsed"]:
            self.document["extensionsUsed"].append("EXT_mesh_gpu_instancing")

    def add_textures(self, count: int) -> None:
        """Gives every material textures in its first `count` slots."""
        images = [pictures.checker((230, 200, 180), (90, 110, 140)), pictures.checker((255, 220, 0), (255, 120, 0)),
                  pictures.normal_map(PICTURE_SIZE, lambda x, y: ((x // 8) + (y // 8)) % 2, 0.5), pictures.checker((60, 20, 0), (0, 0, 0))]
        self.document["images"] = [{"mimeType": "image/png", "bufferView": self.add_view(png)} for png in images[:count]]
        self.document["textures"] = [{"source": image} for image in range(count)]
        for material in self.document["materials"]:
            for slot, name in enumerate(TEXTURE_SLOTS[:count]):
                owner = material["pbrMetallicRoughness"] if slot < 2 else material
                owner[name] = {"index": slot}
                if name == "emissiveTexture":
                    material["emissiveFactor"] = [1.0, 1.0, 1.0]

    def write(self, path: pathlib.Path) -> None:
        self.document["buffers"] = [{"byteLength": self.length}]
        text = json.dumps(self.document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with path.open("wb") as file:
            file.write(struct.pack("<IIIII", 0x46546C67, 2, 28 + len(text) + self.length, len(text), 0x4E4F534A) + text)
            file.write(struct.pack("<II", self.length, 0x004E4942))
            file.writelines(self.parts)


def rows_of(triangle_count: float) -> int:
    """Rows of a sphere of about so many triangles: 4 rows (rows - 1)."""
    return max(2, round((triangle_count / 4.0) ** 0.5 + 0.5))


def add_materials(writer: Writer, glass: bool = True) -> None:
    """Those of the ground, of plastic, of a mirror and of glass."""
    clear = {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": 1.5}} if glass else {}
    for color, metallic, roughness, extensions in (((0.6, 0.6, 0.55, 1.0), 0.0, 1.0, {}), ((0.8, 0.25, 0.2, 1.0), 0.0, 0.5, {}),
                                                   ((0.9, 0.9, 0.9, 1.0), 1.0, 0.0, {}), ((1.0, 1.0, 1.0, 1.0), 0.0, 0.0, clear)):
        writer.document["materials"].append({"pbrMetallicRoughness": {
            "baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}, "extensions": extensions})


def write_scene(path: pathlib.Path, triangle_count: int, texture_count: int = 0, glass: bool = True) -> None:
    """About `triangle_count` triangles, with `texture_count` textures per material (0 to 4)."""
    rows = rows_of((1.0 - GROUND_SHARE) * triangle_count / GRID**2)
    cells = max(2, round((GROUND_SHARE * triangle_count / 2.0) ** 0.5))
    writer = Writer()
    add_materials(writer, glass)
    writer.add_node(writer.add_mesh(waved_ground(cells), [0])[0])
    # A shape of its own for each sphere: nothing is shared, so memory grows as in a scene that has no repeats.
    for index in range(GRID * GRID):
        row, column = divmod(index, GRID)
        mesh = writer.add_mesh(bumpy_sphere(rows), [1 + index % 3])[0]
        writer.add_node(mesh, (SPACING * (column - GRID // 2), 0.0, SPACING * (row - GRID // 2)))
    if texture_count:
        writer.add_textures(texture_count)
    writer.write(path)


def write_instances(path: pathlib.Path, mesh_triangles: int, instance_count: int) -> None:
    """One sphere of about `mesh_triangles` triangles in three materials at `instance_count` places in all, turned and scaled."""
    writer = Writer()
    add_materials(writer)
    side = math.ceil(instance_count ** 0.5)
    positions, triangles, uv = waved_ground(8)
    writer.add_node(writer.add_mesh((positions * [side * SPACING / GROUND_HALF_WIDTH, 1.0, side * SPACING / GROUND_HALF_WIDTH],
                                     triangles, uv), [0])[0])
    random = numpy.random.default_rng(1)
    index = numpy.arange(instance_count)
    places = numpy.stack([SPACING * (index % side - (side - 1) / 2), numpy.zeros(instance_count), SPACING * (index // side - (side - 1) / 2)], 1)
    turns = random.normal(size=(instance_count, 4))
    turns /= numpy.linalg.norm(turns, axis=1, keepdims=True)
    sizes = random.uniform(0.7, 1.0, instance_count)
    for kind, mesh in enumerate(writer.add_mesh(bumpy_sphere(rows_of(mesh_triangles)), [1, 2, 3])):
        chosen = index % 3 == kind
        if chosen.any():
            writer.add_instances(mesh, places[chosen], turns[chosen], sizes[chosen])
    writer.write(path)
