"""The study scene in the three programs' own files. Positions are rounded to the same digits in all of them."""

import array
import json
import math
import struct
import pathlib

from benchmarking import study_scene
from benchmarking.study_scene import EYE, HALF_HEIGHT, LIGHT, LIGHT_CANDELA, SKY

DIGITS = 6


def text_of(vector, separator: str = " ") -> str:
    return separator.join(f"{x:.{DIGITS}f}" for x in vector)


def angle(vector) -> str:
    return f"<{text_of(vector, ',')}>"


def mtl_text(surface: study_scene.Surface) -> str:
    """illum 2 has a highlight, 3 a mirror of Ks, 7 glass with Fresnel reflection and refraction."""
    illumination = 7 if surface.ior > 0.0 else 3 if surface.mirror > 0.0 else 2
    lines = [f"newmtl {surface.name}", f"Kd {text_of(surface.diffuse)}", f"Ka {text_of((0, 0, 0))}",
             f"Ks {text_of((surface.specular,) * 3)}", f"Ns {surface.exponent:g}", f"illum {illumination}"]
    if surface.ior > 0.0:
        lines += [f"Ni {surface.ior:g}", "Tf 1 1 1"]
    return "\n".join(lines) + "\n\n"


def write_obj(bodies: list, path: pathlib.Path) -> None:
    surfaces = {body.surface.name: body.surface for body in bodies}
    path.with_suffix(".mtl").write_text("".join(mtl_text(surface) for surface in surfaces.values()))
    first = 1
    with path.open("w") as file:
        file.write(f"mtllib {path.with_suffix('.mtl').name}\n")
        for number, body in enumerate(bodies):
            file.write(f"o body{number}\nusemtl {body.surface.name}\n")
            file.writelines(f"v {text_of(position)}\n" for position in body.positions)
            file.writelines(f"vn {text_of(normal)}\n" for normal in body.normals)
            file.writelines("f " + " ".join(f"{first + c}//{first + c}" for c in corners) + "\n"
                            for corners in body.triangles)
            first += len(body.positions)


def vernier_view() -> list:
    """Camera, light and background as options of `vernier render`."""
    candela = f"{LIGHT_CANDELA:g}"
    return ["--eye", text_of(EYE, ","), "--target", text_of(study_scene.TARGET, ","),
            "--fov", f"{math.degrees(2.0 * math.atan(HALF_HEIGHT)):.9g}",
            "--light", f"point:{text_of(LIGHT, ',')}:{candela},{candela},{candela}",
            "--background", text_of(SKY, ","), "--ambient", "0,0,0"]


def povray_texture(surface: study_scene.Surface) -> str:
    """POV-Ray's `specular` is the same half-vector lobe as an MTL highlight, with the exponent 1 / roughness."""
    finish = f"ambient 0 emission 0 diffuse {1 if any(surface.diffuse) else 0}"
    if surface.specular > 0.0:
        finish += f" specular {surface.specular:g} roughness {1.0 / surface.exponent:.9g}"
    if surface.mirror > 0.0:
        finish += f" reflection {{ {surface.mirror:g} }}"
    if surface.ior > 0.0:
        glass = "texture { pigment { rgbt <0,0,0,1> } finish { %s reflection { 0, 1 fresnel on } conserve_energy } } " \
                "interior { ior %g }"
        return glass % (finish, surface.ior)
    return f"texture {{ pigment {{ rgb {angle(surface.diffuse)} }} finish {{ {finish} }} }}"


def povray_mesh(body: study_scene.Body) -> str:
    parts = [f"mesh2 {{\nvertex_vectors {{ {len(body.positions)},\n", ",\n".join(map(angle, body.positions)),
             f" }}\nnormal_vectors {{ {len(body.normals)},\n", ",\n".join(map(angle, body.normals)),
             f" }}\nface_indices {{ {len(body.triangles)},\n",
             ",\n".join(f"<{a},{b},{c}>" for a, b, c in body.triangles),
             f" }}\ninside_vector y\n{povray_texture(body.surface)}\n}}\n"]
    return "".join(parts)


def write_povray(bodies: list, path: pathlib.Path, aspect: float, bounces: int, cutoff: float) -> None:
    """Its light fades by 2 / (1 + d^2) and its diffuse surfaces are not divided by pi: hence candela / 2 pi."""
    right, up, forward = study_scene.camera_axes()
    wide = tuple(2.0 * HALF_HEIGHT * aspect * x for x in right)
    high = tuple(2.0 * HALF_HEIGHT * x for x in up)
    strength = LIGHT_CANDELA / (2.0 * math.pi)
    with path.open("w") as file:
        file.write("#version 3.7;\n"
                   f"global_settings {{ assumed_gamma 1.0 max_trace_level {bounces + 1} adc_bailout {cutoff:.9g} }}\n"
                   f"camera {{ location {angle(EYE)} direction {angle(forward)} right {angle(wide)} up {angle(high)} }}\n"
                   f"background {{ rgb {angle(SKY)} }}\n"
                   f"light_source {{ {angle(LIGHT)} rgb {strength:.9g} fade_distance 1 fade_power 2 }}\n")
        for body in bodies:
            file.write(povray_mesh(body))


def write_raw_mesh(bodies: list, path: pathlib.Path) -> None:
    """For embree_rate.cpp: two uint32 counts, float32 positions, uint32 corners, of all bodies as one mesh."""
    positions, corners, first = array.array("f"), array.array("I"), 0
    for body in bodies:
        for position in body.positions:
            positions.extend(round(x, DIGITS) for x in position)
        for triangle in body.triangles:
            corners.extend(first + corner for corner in triangle)
        first += len(body.positions)
    with path.open("wb") as file:
        array.array("I", (first, len(corners) // 3)).tofile(file)
        positions.tofile(file)
        corners.tofile(file)


def embree_view() -> list:
    """Camera and light as arguments of embree_rate."""
    right, up, forward = study_scene.camera_axes()
    return [f"{x:.9g}" for vector in (EYE, right, up, forward, LIGHT) for x in vector] + [f"{HALF_HEIGHT:g}"]


def mitsuba_surface(surface: study_scene.Surface) -> dict:
    """The nearest of Mitsuba's: a rough coat for the highlight, whose exponent n is a roughness of sqrt(2 / (n + 2))."""
    if surface.ior > 0.0:
        return {"type": "dielectric", "int_ior": surface.ior, "ext_ior": 1.0}
    if surface.mirror > 0.0:
        return {"type": "conductor", "material": "none", "specular_reflectance": {"type": "rgb", "value": [surface.mirror] * 3}}
    color = {"type": "rgb", "value": list(surface.diffuse)}
    if surface.specular > 0.0:
        return {"type": "roughplastic", "diffuse_reflectance": color, "alpha": math.sqrt(2.0 / (surface.exponent + 2.0))}
    return {"type": "diffuse", "reflectance": color}


def write_ply(bodies: list, path: pathlib.Path) -> None:
    """All of them as one mesh: float32 positions and normals, little-endian."""
    vertices, faces, first = array.array("f"), bytearray(), 0
    for body in bodies:
        for position, normal in zip(body.positions, body.normals):
            vertices.extend(round(x, DIGITS) for x in (*position, *normal))
        for triangle in body.triangles:
            faces += struct.pack("<B3I", 3, *(first + corner for corner in triangle))
        first += len(body.positions)
    properties = "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {first}\n{properties}"
              f"element face {sum(len(body.triangles) for body in bodies)}\nproperty list uchar uint vertex_indices\nend_header\n")
    path.write_bytes(header.encode("ascii") + vertices.tobytes() + bytes(faces))


def write_mitsuba(bodies: list, folder: pathlib.Path) -> None:
    """mitsuba.json for mitsuba_rate.py, and a mesh for each surface. No sky: there it would light what it surrounds."""
    surfaces = {body.surface.name: body.surface for body in bodies}
    for name in surfaces:
        write_ply([body for body in bodies if body.surface.name == name], folder / f"{name}.ply")
    (folder / "mitsuba.json").write_text(json.dumps(
        {"camera": {"eye": EYE, "target": study_scene.TARGET, "fov": math.degrees(2.0 * math.atan(HALF_HEIGHT))},
         "light": {"position": LIGHT, "candela": LIGHT_CANDELA},
         "surfaces": {name: mitsuba_surface(surface) for name, surface in surfaces.items()}}), encoding="utf-8")
