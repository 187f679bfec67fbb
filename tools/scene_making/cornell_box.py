"""cornell_box: a room after Goral, Torrance, Greenberg and Battaile (1984), with measures and colours of our own."""

import math

MATERIALS = """# Written by tools/make_scenes. CC0-1.0.
newmtl white
Kd 0.72 0.71 0.68
illum 1

newmtl red
Kd 0.60 0.07 0.06
illum 1

newmtl green
Kd 0.10 0.42 0.12
illum 1

newmtl lamp
Kd 0 0 0
Ke 4 3.6 3
illum 1

newmtl mirror
Kd 0.02 0.02 0.02
Ks 0.90 0.90 0.90
Ns 200
illum 3

newmtl satin
Kd 0.62 0.60 0.55
Ks 0.30 0.30 0.30
Ns 40
illum 2
"""


def corner_lines(corners) -> list[str]:
    return ["v " + " ".join(f"{value + 0.0:.6g}" for value in corner) for corner in corners]


def block(name: str, material: str, center, size, height: float, degrees: float) -> list[str]:
    """A block on the floor: five faces, outside counter-clockwise, by negative indices."""
    turn = math.radians(degrees)
    feet = [(x * size / 2, z * size / 2) for x, z in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
    feet = [(round(center[0] + x * math.cos(turn) + z * math.sin(turn), 6),
             round(center[1] - x * math.sin(turn) + z * math.cos(turn), 6)) for x, z in feet]
    corners = [(x, 0.0, z) for x, z in feet] + [(x, height, z) for x, z in feet]
    faces = ["-4 -3 -2 -1"] + [f"{a - 8} {(a + 1) % 4 - 8} {(a + 1) % 4 - 4} {a - 4}" for a in range(4)]
    return [f"o {name}", f"usemtl {material}", *corner_lines(corners), *[f"f {face}" for face in faces]]


def wall(name: str, material: str, corners) -> list[str]:
    """One rectangle, counter-clockwise seen from inside the room."""
    return [f"o {name}", f"usemtl {material}", *corner_lines(corners), "f -4 -3 -2 -1"]


def cornell_box() -> bytes:
    """The OBJ text: x from -1 to 1, y from 0 to 2, z from -1 (back) to 1 (open)."""
    lines = ["# Written by tools/make_scenes. CC0-1.0.", "mtllib cornell_box.mtl"]
    lines += wall("floor", "white", [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)])
    lines += wall("ceiling", "white", [(-1, 2, -1), (1, 2, -1), (1, 2, 1), (-1, 2, 1)])
    lines += wall("back wall", "white", [(-1, 0, -1), (1, 0, -1), (1, 2, -1), (-1, 2, -1)])
    lines += wall("left wall", "red", [(-1, 0, 1), (-1, 0, -1), (-1, 2, -1), (-1, 2, 1)])
    lines += wall("right wall", "green", [(1, 0, -1), (1, 0, 1), (1, 2, 1), (1, 2, -1)])
    lines += wall("lamp", "lamp", [(-0.3, 1.99, -0.3), (0.3, 1.99, -0.3), (0.3, 1.99, 0.3), (-0.3, 1.99, 0.3)])
    lines += block("tall block", "mirror", (-0.36, -0.32), 0.56, 1.25, 20)
    lines += block("short block", "satin", (0.38, 0.30), 0.58, 0.60, -17)
    return ("\n".join(lines) + "\n").encode()
