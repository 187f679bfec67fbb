"""Shapes as lists: positions, normals, uvs, colors by vertex and triangles, counter-clockwise from outside."""

import dataclasses
import math


@dataclasses.dataclass
class Mesh:
    """One primitive. Empty lists are attributes it does not have."""

    positions: list = dataclasses.field(default_factory=list)
    normals: list = dataclasses.field(default_factory=list)
    uvs: list = dataclasses.field(default_factory=list)
    colors: list = dataclasses.field(default_factory=list)
    triangles: list = dataclasses.field(default_factory=list)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(a, factor):
    return tuple(x * factor for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(a, 1.0 / math.sqrt(sum(x * x for x in a)))


def icosphere(level: int, radius: float = 1.0) -> Mesh:
    """A sphere of 20 * 4^level nearly equal triangles with smooth normals, without uvs."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
               (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    points = [unit(corner) for corner in corners]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
                 (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(add(points[a], points[b])))
            return middles[key]
        finer = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = finer
    return Mesh([scale(point, radius) for point in points], list(points), [], [], triangles)


def sheet(point_of, columns: int, rows: int, color_of=None) -> Mesh:
    """The surface point_of(u, v), u and v in [0, 1], with normals dP/du x dP/dv and uvs (u, 1 - v): v = 1 is the picture's top."""
    mesh, step = Mesh(), 1e-4
    for row in range(rows + 1):
        for column in range(columns + 1):
            u, v = column / columns, row / rows
            mesh.positions.append(point_of(u, v))
            along_u = subtract(point_of(u + step, v), point_of(u - step, v))
            # At a pole the parallel has no length: a step off the pole gives the same normal.
            if sum(x * x for x in along_u) < 1e-16:
                inward = v + step if v < 0.5 else v - step
                along_u = subtract(point_of(u + step, inward), point_of(u - step, inward))
            mesh.normals.append(unit(cross(along_u, subtract(point_of(u, v + step), point_of(u, v - step)))))
            mesh.uvs.append((u, 1 - v))
            if color_of:
                mesh.colors.append(color_of(u, v))
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            mesh.triangles += [(a, b, c), (a, c, d)]
    return mesh


def uv_sphere(radius: float, columns: int, rows: int) -> Mesh:
    """A sphere with poles on Y; v runs from the south pole (0) to the north pole (1)."""
    def point_of(u, v):
        angle, height = 2 * math.pi * u, math.pi * (v - 0.5)
        return (radius * math.cos(height) * math.cos(angle), radius * math.sin(height),
                -radius * math.cos(height) * math.sin(angle))
    return sheet(point_of, columns, rows)


def torus(ring: float, tube: float, columns: int, rows: int) -> Mesh:
    """A torus around Y, `ring` from the axis to the middle of the tube."""
    def point_of(u, v):
        around, across = 2 * math.pi * u, 2 * math.pi * v
        away = ring + tube * math.cos(across)
        return (away * math.cos(around), tube * math.sin(across), -away * math.sin(around))
    return sheet(point_of, columns, rows)


def lathe(profile: list, columns: int, uv_scale=(1.0, 1.0)) -> Mesh:
    """Turns `profile`, (radius, height) from the bottom up, around Y; every piece is smooth around and sharp along."""
    mesh, length = Mesh(), 0.0
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        piece = math.hypot(r1 - r0, y1 - y0)
        first = len(mesh.positions)
        for radius, height, v in ((r0, y0, length), (r1, y1, length + piece)):
            for column in range(columns + 1):
                angle = 2 * math.pi * column / columns
                mesh.positions.append((radius * math.cos(angle), height, -radius * math.sin(angle)))
                mesh.normals.append(unit(((y1 - y0) * math.cos(angle), r0 - r1, -(y1 - y0) * math.sin(angle))))
                mesh.uvs.append((uv_scale[0] * column / columns, -uv_scale[1] * v))
        for column in range(columns):
            a, b = first + column, first + column + 1
            c, d = b + columns + 1, a + columns + 1
            mesh.triangles += ([(a, b, c)] if r0 > 0 else []) + ([(a, c, d)] if r1 > 0 else [])
        length += piece
    return mesh


def box(size, uv_scale: float = 1.0) -> Mesh:
    """An axis-parallel box around the origin with flat faces; every face has the whole texture, times uv_scale."""
    mesh = Mesh()
    for axis in range(3):
        for side in (-1.0, 1.0):
            normal = tuple(side if index == axis else 0.0 for index in range(3))
            up = (0.0, 1.0, 0.0) if axis != 1 else (0.0, 0.0, -side)
            face = quad(scale(normal, 0.5), cross(up, normal), up, uv_scale)
            first = len(mesh.positions)
            mesh.positions += [tuple(x * s for x, s in zip(point, size)) for point in face.positions]
            mesh.normals += face.normals
            mesh.uvs += face.uvs
            mesh.triangles += [tuple(first + corner for corner in triangle) for triangle in face.triangles]
    return mesh


def quad(center, right, up, uv_scale: float = 1.0, uv_low: float = 0.0) -> Mesh:
    """A rectangle of sides `right` and `up` around `center`; seen from the front the texture stands upright."""
    r, u = scale(right, 0.5), scale(up, 0.5)
    corners = [subtract(subtract(center, r), u), subtract(add(center, r), u), add(add(center, r), u),
               add(subtract(center, r), u)]
    low, high = uv_low, uv_low + uv_scale
    return Mesh(corners, [unit(cross(right, up))] * 4, [(low, high), (high, high), (high, low), (low, low)], [],
                [(0, 1, 2), (0, 2, 3)])


def merged(*meshes: Mesh) -> Mesh:
    """All of `meshes`, which have the same attributes, as one."""
    whole = Mesh()
    for mesh in meshes:
        first = len(whole.positions)
        whole.positions += mesh.positions
        whole.normals += mesh.normals
        whole.uvs += mesh.uvs
        whole.colors += mesh.colors
        whole.triangles += [tuple(first + corner for corner in triangle) for triangle in mesh.triangles]
    return whole


def moved(mesh: Mesh, offset) -> Mesh:
    """A copy of `mesh` shifted by `offset`."""
    return dataclasses.replace(mesh, positions=[add(point, offset) for point in mesh.positions])
