"""Scenes at which the numeric levels part: the same picture at --accuracy fast and robust shows what the level is for."""

import math
import random

from scene_making import meshes
from scene_making.gltf import SceneFile
from scene_making.studies import board, glass_extensions, ground

# The sheet's vertices lie on the rays through the pixel centres of an image of this size, seen with SHEET_DEGREES.
SHEET_SIZE = (128, 96)
SHEET_DEGREES = 40.0


def edge_leaks() -> bytes:
    """A closed, bumpy sheet each of whose vertices lies on the ray through a pixel's centre: a ray that slips through
    between triangles sees the white behind."""
    scene = SceneFile("edge_leaks")
    eye, target = (3.1, 2.3, 4.7), (0.2, 0.1, -0.3)
    forward = meshes.unit(meshes.subtract(target, eye))
    right = meshes.unit(meshes.cross(forward, (0.0, 1.0, 0.0)))
    up = meshes.cross(right, forward)
    width, height = SHEET_SIZE
    step = 2.0 * math.tan(math.radians(SHEET_DEGREES) / 2) / height
    depth = random.Random(1)
    sheet = meshes.Mesh()
    rows, columns = range(-1, height + 1), range(-1, width + 1)  # one more all around: the rim lies outside the image
    for row in rows:
        for column in columns:
            across = meshes.scale(right, (column + 0.5 - width / 2) * step)
            along = meshes.scale(up, (height / 2 - row - 0.5) * step)
            direction = meshes.add(forward, meshes.add(across, along))
            sheet.positions.append(meshes.add(eye, meshes.scale(direction, 4.0 + depth.random())))
    for row in range(len(rows) - 1):
        for column in range(len(columns) - 1):
            a = row * len(columns) + column
            below = a + len(columns)
            sheet.triangles += [(a, below, a + 1), (a + 1, below, below + 1)]
    dark = scene.add_material("dark", (0.05, 0.08, 0.15), doubleSided=True, extensions={"KHR_materials_unlit": {}})
    scene.add_node("sheet", mesh=scene.add_mesh("sheet", (sheet, dark)))
    scene.add_camera("view", eye, target, degrees=SHEET_DEGREES)
    return scene.to_bytes()


def far_camera() -> bytes:
    """A ball seen from 100 km through a telescope: where a place is the eye plus t times the direction, it is off the
    surface by more than a fixed offset covers."""
    scene = SceneFile("far_camera")
    clay = scene.add_material("clay", (0.8, 0.5, 0.3), roughness=1.0)
    ground(scene, scene.add_material("plane", (0.7, 0.7, 0.7)))
    scene.add_node("ball", mesh=scene.add_mesh("ball", (meshes.icosphere(4), clay)), translation=[0, 1, 0])
    scene.add_light("lamp", "point", (1, 1, 1), 60.0, at=(-2.5, 3.5, 2.5))
    scene.add_camera("view", (3e4, 4e4, 86602.54), (0, 0.8, 0), degrees=0.0022)
    return scene.to_bytes()


def axis_parallel() -> bytes:
    """Towers on a square, seen along -Z: the rays of the middle row and column of an image of odd size have components
    of exactly 0, and those to a light straight above have two."""
    scene = SceneFile("axis_parallel")
    ground(scene, scene.add_material("square", (0.7, 0.7, 0.68)), 24.0)
    stone = scene.add_material("stone", (0.75, 0.5, 0.35))
    heights = random.Random(2)
    towers = [meshes.moved(meshes.box((1.2, height, 1.2)), (2.0 * column, height / 2, -2.0 * row))
              for row in range(4) for column in range(-3, 4)
              for height in [0.5 + 0.5 * row + heights.random()]]
    slab = meshes.moved(meshes.box((9.0, 0.2, 1.0)), (0.0, 3.2, 1.5))
    scene.add_node("towers", mesh=scene.add_mesh("towers", (meshes.merged(*towers, slab), stone)))
    scene.add_camera("view", (0, 2, 9), (0, 2, 0), degrees=40)
    return scene.to_bytes()


def thin_glass() -> bytes:
    """Glass of ior 1.000001 under a wall that is bright above and dark below, seen at less than a tenth of a degree: what the
    glass reflects goes from all to nothing within the picture."""
    scene = SceneFile("thin_glass")
    glass = scene.add_material("glass", (1, 1, 1), roughness=0.0, extensions=glass_extensions(1.000001, 2.0))
    scene.add_node("slab", mesh=scene.add_mesh("slab", (meshes.box((400, 2, 4000)), glass)), translation=[0, -1, 0])
    for name, color, y in (("bright", (0.9, 0.8, 0.5), 20.0), ("dark", (0.02, 0.05, 0.15), -20.0)):
        paint = scene.add_material(name, color, extensions={"KHR_materials_unlit": {}})
        wall = meshes.quad((0, y, -2100), (400, 0, 0), (0, 40, 0))
        scene.add_node(name, mesh=scene.add_mesh(name, (wall, paint)))
    scene.add_camera("view", (0, 0.3, 1900), (0, -0.8, 0), degrees=0.07)
    return scene.to_bytes()


def sharp_highlight() -> str:
    """A mirror-smooth floor of Blinn exponent 1e6, an OBJ file because glTF has no exponents."""
    return ("# A floor whose highlight, a hundredth of a degree wide, is all of the picture.\n"
            "mtllib sharp_highlight.mtl\no floor\nv -50 0 -50\nv 50 0 -50\nv 50 0 50\nv -50 0 50\nvn 0 1 0\n"
            "usemtl polished\nf 1//1 4//1 3//1 2//1\n")


SHARP_HIGHLIGHT_MATERIALS = ("newmtl polished\nKd 0.02 0.02 0.03\nKs 0.9 0.9 0.9\nNs 1000000\nillum 2\n")
