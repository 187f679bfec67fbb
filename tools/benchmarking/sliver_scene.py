"""The study scene with long slivers between its spheres, whose boxes overlap all over: hard on any BVH."""

import math
import random

from benchmarking import study_scene

COUNT = 20_000
LENGTH = 1.8
WIDTH = 0.0018
# Where their middles lie: around the spheres, above the ground.
LOW, HIGH = (-6.0, -0.8, -6.0), (6.0, 1.6, 6.0)


def unit_vector(source: random.Random) -> tuple:
    """Evenly over the sphere."""
    z, angle = 2.0 * source.random() - 1.0, 2.0 * math.pi * source.random()
    radius = math.sqrt(max(0.0, 1.0 - z * z))
    return radius * math.cos(angle), radius * math.sin(angle), z


def across(direction: tuple, source: random.Random) -> tuple:
    """A unit vector at a right angle to `direction`."""
    while True:
        x, y, z = unit_vector(source)
        along = x * direction[0] + y * direction[1] + z * direction[2]
        rest = tuple(a - along * d for a, d in zip((x, y, z), direction))
        if math.hypot(*rest) > 0.5:  # long enough to be made unit without loss
            return tuple(a / math.hypot(*rest) for a in rest)


def slivers(count: int = COUNT) -> study_scene.Body:
    """Triangles of LENGTH and WIDTH, each by itself, in any direction. The same for every call."""
    source = random.Random(1)
    positions, normals, triangles = [], [], []
    for _ in range(count):
        middle = [low + (high - low) * source.random() for low, high in zip(LOW, HIGH)]
        direction = unit_vector(source)
        aside = across(direction, source)
        first = len(positions)
        for along, beside in ((-0.5 * LENGTH, -0.5 * WIDTH), (-0.5 * LENGTH, 0.5 * WIDTH), (0.5 * LENGTH, 0.0)):
            positions.append(tuple(m + along * d + beside * a for m, d, a in zip(middle, direction, aside)))
        triangles.append((first, first + 1, first + 2))
        normals += study_scene.vertex_normals(positions[first:], [(0, 1, 2)])
    return study_scene.Body(study_scene.GROUND, positions, normals, triangles)


def make_bodies() -> list:
    """The study scene of 48 000 triangles and the slivers."""
    return [*study_scene.make_bodies(48_000), slivers()]
