"""The scene that all three programs draw: bumpy spheres on a waved ground, as plain lists."""

import dataclasses
import math

GRID = 5  # spheres along each side of the grid
SPACING = 2.2
GROUND_CELLS = 64  # 2 * 64 * 64 = 8192 triangles
GROUND_HALF_WIDTH = 12.0
EYE = (7.0, 5.0, 9.0)
TARGET = (0.0, -0.3, 0.0)
HALF_HEIGHT = 0.8  # of the picture, at distance 1
LIGHT = (20.0, 30.0, 15.0)
LIGHT_CANDELA = 4500.0  # about pi times the square of the light's distance: a white surface facing it is 1
SKY = (0.35, 0.5, 0.7)


@dataclasses.dataclass(frozen=True)
class Surface:
    """What a program has to be told of a material. Colours are linear."""

    name: str
    diffuse: tuple
    specular: float
    exponent: float
    mirror: float = 0.0
    ior: float = 0.0  # above 0: glass


GROUND = Surface("ground", (0.6, 0.6, 0.55), 0.0, 1.0)
SPHERES = (Surface("plastic", (0.8, 0.25, 0.2), 0.4, 60.0), Surface("mirror", (0.0, 0.0, 0.0), 0.9, 200.0, mirror=0.9),
           Surface("glass", (0.0, 0.0, 0.0), 0.0, 1.0, ior=1.5))


@dataclasses.dataclass(frozen=True)
class Body:
    """One closed mesh or the ground: positions, a unit normal for each, triangles counter-clockwise from outside."""

    surface: Surface
    positions: list
    normals: list
    triangles: list


def vertex_normals(positions: list, triangles: list) -> list:
    """Unit normals: the sum of the normals of the triangles around a vertex, each as long as its area."""
    sums = [[0.0, 0.0, 0.0] for _ in positions]
    for triangle in triangles:
        a, b, c = (positions[corner] for corner in triangle)
        u = [b[i] - a[i] for i in range(3)]
        v = [c[i] - a[i] for i in range(3)]
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for corner in triangle:
            for i in range(3):
                sums[corner][i] += normal[i]
    return [tuple(x / math.hypot(*normal) for x in normal) for normal in sums]


def bumpy_sphere(center: tuple, rows: int, surface: Surface) -> Body:
    """A sphere of `rows` x 2 `rows` cells, radius 1 + 0.03 sin 9t sin 7p, one vertex at each pole."""
    columns = 2 * rows
    positions = [(center[0], center[1] + 1.0, center[2])]
    for row in range(1, rows):
        t = math.pi * row / rows
        for column in range(columns):
            p = 2.0 * math.pi * column / columns
            radius = 1.0 + 0.03 * math.sin(9.0 * t) * math.sin(7.0 * p)
            positions.append((center[0] + radius * math.sin(t) * math.cos(p), center[1] + radius * math.cos(t),
                              center[2] - radius * math.sin(t) * math.sin(p)))
    last = len(positions)
    positions.append((center[0], center[1] - 1.0, center[2]))
    triangles = []
    for column in range(columns):
        following = (column + 1) % columns
        triangles.append((0, 1 + column, 1 + following))
        for upper in range(1, last - columns, columns):
            a, b, c, d = upper + column, upper + following, upper + columns + column, upper + columns + following
            triangles += [(a, c, d), (a, d, b)]
        triangles.append((last, last - columns + following, last - columns + column))
    return Body(surface, positions, vertex_normals(positions, triangles), triangles)


def waved_ground() -> Body:
    """A square around the origin that the spheres touch."""
    side = GROUND_CELLS + 1
    places = [GROUND_HALF_WIDTH * (2.0 * i / GROUND_CELLS - 1.0) for i in range(side)]
    positions = [(x, -1.1 + 0.06 * math.sin(1.3 * x) * math.cos(1.1 * z), z) for z in places for x in places]
    triangles = []
    for row in range(GROUND_CELLS):
        for column in range(GROUND_CELLS):
            a = row * side + column
            triangles += [(a, a + side, a + side + 1), (a, a + side + 1, a + 1)]
    return Body(GROUND, positions, vertex_normals(positions, triangles), triangles)


def make_bodies(triangle_count: int) -> list:
    """The ground and the 25 spheres, with about `triangle_count` triangles in all (at least 8 rows a sphere)."""
    per_sphere = (triangle_count - 2 * GROUND_CELLS**2) / GRID**2
    rows = max(8, round(math.sqrt(max(per_sphere, 0.0) / 4.0) + 0.5))  # a sphere has 4 rows (rows - 1) triangles
    bodies = [waved_ground()]
    for index in range(GRID * GRID):
        row, column = divmod(index, GRID)
        center = (SPACING * (column - GRID // 2), 0.0, SPACING * (row - GRID // 2))
        bodies.append(bumpy_sphere(center, rows, SPHERES[index % len(SPHERES)]))
    return bodies


def count_triangles(bodies: list) -> int:
    return sum(len(body.triangles) for body in bodies)


def camera_axes() -> tuple:
    """Unit vectors to the right, upwards and forwards in the picture."""
    away = [t - e for t, e in zip(TARGET, EYE)]
    forward = tuple(x / math.hypot(*away) for x in away)
    across = (-forward[2], 0.0, forward[0])
    right = tuple(x / math.hypot(*across) for x in across)
    up = (right[1] * forward[2] - right[2] * forward[1], right[2] * forward[0] - right[0] * forward[2],
          right[0] * forward[1] - right[1] * forward[0])
    return right, up, forward
