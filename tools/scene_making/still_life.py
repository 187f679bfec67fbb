"""every_effect: a still life on a parquet table that calls for every effect the renderer has."""

import math

from scene_making import meshes, pictures
from scene_making.gltf import CLAMP, SceneFile, about
from scene_making.meshes import Mesh

TITLE = "every_effect"


def table_and_wall(scene: SceneFile):
    """The parquet and, behind it, a wall that goes from plum to slate: its vertex colours."""
    wood = scene.add_texture(scene.add_image(pictures.parquet(256, (0.60, 0.43, 0.28), (0.42, 0.27, 0.16)), "parquet"))
    floor = scene.add_material("oak parquet", texture=wood, roughness=0.42,
                               extensions={"KHR_materials_specular": {"specularFactor": 0.6}})
    table = meshes.quad((0, 0, 0.7), (9, 0, 0), (0, 0, -4.6))
    table.uvs = [(4.5 * u, 2.3 * v) for u, v in table.uvs]
    scene.add_node("table", mesh=scene.add_mesh("table", (table, floor)))
    # No higher than the camera sees: the sun comes from behind, over its edge.
    wall = meshes.sheet(lambda u, v: (14 * (u - 0.5), -1.5 + 4.0 * v, -4.4), 8, 8, wall_color)
    plaster = scene.add_material("plaster")
    scene.add_node("wall", mesh=scene.add_mesh("wall", (wall, plaster)))


def wall_color(u, v):
    """Slate at the left, plum at the right, darker towards the top."""
    left, right = (0.14, 0.24, 0.34), (0.40, 0.22, 0.28)
    return tuple((a + (b - a) * u) * (1.1 - 0.6 * v) for a, b in zip(left, right))


def spheres(scene: SceneFile):
    """Glass with a breath of green on the pedestal, a mirror on the table: one mesh for both."""
    glass = scene.add_material("glass", roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": 1.5},
        "KHR_materials_volume": {"thicknessFactor": 0.8, "attenuationDistance": 0.9,
                                 "attenuationColor": [0.62, 0.90, 0.80]}})
    mirror = scene.add_material("mirror", (0.93, 0.92, 0.90), metallic=1.0, roughness=0.0)
    ball = meshes.icosphere(4)
    clear = scene.add_mesh("glass ball", (ball, glass))
    scene.add_node("glass ball", mesh=clear, translation=[-0.42, 1.06, -0.25], scale=[0.46] * 3)
    scene.add_node("mirror ball", mesh=scene.repeat_mesh(clear, "mirror ball", mirror),
                   translation=[0.62, 0.50, -0.12], scale=[0.50] * 3)


def pedestal(scene: SceneFile):
    """A short column of carved stone: normal map of 16 bits a channel, and the occlusion in its grooves."""
    def relief(u, v):
        return 0.5 + 0.25 * math.cos(2 * math.pi * (u + v)) + 0.25 * math.cos(2 * math.pi * (u - v))
    carved = scene.add_texture(scene.add_image(pictures.deep_normal_map(64, relief, 0.14), "carving"))
    hollows = scene.add_texture(scene.add_image(
        pictures.picture(64, 64, lambda u, v: (0.35 + 0.65 * relief(u, v),), 1), "hollows"))
    stone = scene.add_material("carved limestone", (0.72, 0.66, 0.58), roughness=0.75,
                               normalTexture={"index": carved, "scale": 1.0}, occlusionTexture={"index": hollows})
    plain = scene.add_material("limestone", (0.72, 0.66, 0.58), roughness=0.75)
    base = meshes.merged(
        meshes.lathe([(0.44, 0.0), (0.44, 0.07), (0.42, 0.09), (0.36, 0.11)], 64),
        meshes.lathe([(0.36, 0.52), (0.42, 0.54), (0.44, 0.56), (0.44, 0.615), (0.42, 0.63), (0.0, 0.63)], 64))
    shaft = meshes.lathe([(0.36, 0.11), (0.36, 0.52)], 64, (16, 7))
    scene.add_node("pedestal", mesh=scene.add_mesh("pedestal", (base, plain), (shaft, stone)),
                   translation=[-0.42, 0.0, -0.25])


def ring(scene: SceneFile):
    """A copper torus that leans on the pedestal, brushed in bands: a roughness texture."""
    def bands(u, _):
        return (0.0, 0.30 + 0.22 * math.sin(2 * math.pi * u) ** 2, 1.0)
    brushed = scene.add_texture(scene.add_image(pictures.picture(64, 4, bands), "brushed bands"))
    copper = scene.add_material("brushed copper", (0.93, 0.50, 0.33), metallic=1.0, roughness=1.0, surface={
        "index": brushed, "extensions": {"KHR_texture_transform": {"scale": [8.0, 1.0]}}})
    shape = scene.add_mesh("ring", (meshes.torus(0.27, 0.085, 64, 24), copper))
    scene.add_node("ring", mesh=shape, translation=[0.02, 0.335, 0.26], rotation=about((1.0, 0.0, -0.35), 68))


def screen(scene: SceneFile):
    """A folding screen of pierced brass: alpha mask. The key light throws its pattern over the table."""
    def pierced(u, v):
        hole = math.hypot(u - 0.5, v - 0.5) - 0.36
        corner = math.hypot(min(u, 1 - u), min(v, 1 - v)) - 0.16
        return (0.86, 0.66, 0.34, 0.5 + 4.0 * min(hole, corner))
    pattern = scene.add_texture(scene.add_image(pictures.picture(64, 64, pierced, 4), "pierced"))
    brass = scene.add_material("pierced brass", texture=pattern, metallic=0.65, roughness=0.45, alphaMode="MASK",
                               doubleSided=True)
    frame = scene.add_material("brass", (0.80, 0.58, 0.28), metallic=0.8, roughness=0.35)
    leaf = meshes.quad((0, 0.68, 0), (0.70, 0, 0), (0, 1.20, 0))
    leaf.uvs = [(7 * u, 12 * v) for u, v in leaf.uvs]
    bars = meshes.merged(
        *[meshes.moved(meshes.box((0.035, 1.30, 0.035)), (side * 0.3675, 0.66, 0)) for side in (-1, 1)],
        *[meshes.moved(meshes.box((0.70, 0.035, 0.035)), (0, height, 0)) for height in (0.0625, 1.2925)])
    panel = scene.add_mesh("screen leaf", (leaf, brass), (bars, frame))
    scene.add_node("screen, left leaf", mesh=panel, translation=[-1.95, 0, -0.22], rotation=about((0, 1, 0), 62))
    scene.add_node("screen, right leaf", mesh=panel, translation=[-1.52, 0, -0.78], rotation=about((0, 1, 0), 22))


def stained_glass(scene: SceneFile):
    """A window of thin coloured glass with lead between: colour and transmission come from textures."""
    palette = [(0.92, 0.16, 0.12), (0.98, 0.62, 0.10), (0.12, 0.40, 0.92), (0.10, 0.70, 0.42), (0.70, 0.18, 0.72),
               (0.98, 0.86, 0.25)]

    def cell_of(u, v):
        radius, angle = math.hypot(u - 0.5, v - 0.5), math.atan2(v - 0.5, u - 0.5) / (2 * math.pi) + 0.5
        edges = [0.13, 0.29, 0.44]
        shell = sum(radius > edge for edge in edges)
        count = (1, 6, 12, 4)[shell]
        turn = (angle * count + (0.5 if shell == 2 else 0.0)) % count
        sides = abs(turn - round(turn)) * 2 * math.pi * radius / count if count > 1 else 1.0
        lead = min([abs(radius - edge) for edge in edges] + [sides])
        return palette[(int(turn) * 5 + shell * 2 + int(turn) // 3) % len(palette)], lead < 0.012
    size = 160
    color = scene.add_image(pictures.picture(
        size, size, lambda u, v: (0.03, 0.03, 0.03) if cell_of(u, v)[1] else cell_of(u, v)[0]), "window")
    clear = scene.add_image(pictures.picture(
        size, size, lambda u, v: (0.0,) * 3 if cell_of(u, v)[1] else (1.0,) * 3), "glass, not lead")
    wrap = (CLAMP, CLAMP)
    glass = scene.add_material("stained glass", texture=scene.add_texture(color, wrap), roughness=0.0, extensions={
        "KHR_materials_transmission": {
            "transmissionFactor": 0.95, "transmissionTexture": {"index": scene.add_texture(clear, wrap)}}})
    iron = scene.add_material("iron", (0.10, 0.10, 0.11), metallic=0.4, roughness=0.5)
    pane = meshes.quad((0, 0.82, 0), (1.24, 0, 0), (0, 1.24, 0))
    bars = meshes.merged(
        *[meshes.moved(meshes.box((0.06, 1.44, 0.06)), (side * 0.65, 0.78, 0)) for side in (-1, 1)],
        *[meshes.moved(meshes.box((1.24, 0.06, 0.06)), (0, height, 0)) for height in (0.17, 1.47)],
        *[meshes.moved(meshes.box((0.10, 0.06, 0.40)), (side * 0.65, 0.03, 0)) for side in (-1, 1)])
    scene.add_node("window", mesh=scene.add_mesh("window", (pane, glass), (bars, iron)),
                   translation=[1.62, 0, -0.86], rotation=about((0, 1, 0), -24))


def vase(scene: SceneFile):
    """A twisted, fluted vase from coral to indigo: vertex colours on smooth normals."""
    def point_of(u, v):
        around = 2 * math.pi * u
        body = 0.135 + 0.08 * math.cos(2 * math.pi * (v - 0.36))
        away = body * (1 + 0.07 * math.cos(9 * around + 5 * v))
        return (away * math.cos(around), 0.62 * v, -away * math.sin(around))

    def color_of(_, v):
        low, high = (0.08, 0.07, 0.33), (0.90, 0.26, 0.16)
        mix = v * v * (3 - 2 * v)
        return tuple(a + (b - a) * mix for a, b in zip(low, high))
    glaze = scene.add_material("glaze", roughness=0.28, doubleSided=True)
    scene.add_node("vase", mesh=scene.add_mesh("vase", (meshes.sheet(point_of, 72, 16, color_of), glaze)),
                   translation=[1.36, 0.0, 0.42])


def lantern(scene: SceneFile):
    """A small lantern: its four windows glow by an emission texture, and a warm point light stands before it."""
    def windows(u, v):
        inside = all(0.10 < x < 0.44 or 0.56 < x < 0.90 for x in (u, v))
        warmth = 1.0 - 0.5 * abs(v - 0.6)
        return (warmth, 0.62 * warmth, 0.22 * warmth) if inside else (0.0, 0.0, 0.0)
    glow = scene.add_texture(scene.add_image(pictures.picture(48, 48, windows), "lantern windows"), (CLAMP, CLAMP))
    paper = scene.add_material("lantern", (0.05, 0.04, 0.04), roughness=0.6, emissiveFactor=[1, 1, 1],
                               emissiveTexture={"index": glow},
                               extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 1.8}})
    roof = scene.add_material("lantern roof", (0.06, 0.05, 0.05), roughness=0.4)
    top = meshes.lathe([(0.24, 0.30), (0.24, 0.32), (0.0, 0.44)], 4)
    scene.add_node("lantern", mesh=scene.add_mesh(
        "lantern", (meshes.moved(meshes.box((0.28, 0.30, 0.28)), (0, 0.15, 0)), paper), (top, roof)),
        translation=[-1.28, 0.0, 0.42], rotation=about((0, 1, 0), 33))


def disc(scene: SceneFile):
    """A disc of tinted acrylic before the mirror ball's flank: alpha blend."""
    tint = scene.add_material("teal acrylic", (0.03, 0.42, 0.44, 0.45), roughness=0.15, alphaMode="BLEND",
                              doubleSided=True)
    rim = scene.add_material("brass rim", (0.80, 0.58, 0.28), metallic=0.8, roughness=0.3)
    face = Mesh([(0, 0, 0)], [(0, 0, 1)], [], [], [])
    for step in range(64):
        angle = 2 * math.pi * step / 64
        face.positions.append((0.27 * math.cos(angle), 0.27 * math.sin(angle), 0.0))
        face.normals.append((0, 0, 1))
        face.triangles.append((0, step + 1, (step + 1) % 64 + 1))
    edge = meshes.torus(0.275, 0.014, 48, 8)
    edge.positions = [(x, -z, y) for x, y, z in edge.positions]
    edge.normals = [(x, -z, y) for x, y, z in edge.normals]
    edge.uvs = []
    scene.add_node("disc", mesh=scene.add_mesh("disc", (face, tint), (edge, rim)), translation=[-0.86, 0.287, 0.52],
                   rotation=about((0, 1, 0), 24))


def ruler(scene: SceneFile):
    """A vernier scale, unlit as a printed label: ten parts on nine, and the name."""
    ivory, ink, red = (236, 228, 206), (38, 34, 40), (176, 44, 36)
    canvas = pictures.Canvas(640, 96, ivory)
    canvas.write("VERNIER", 22, 20, 5, ink)
    canvas.fill(256, 46, 372, 2, ink)
    for mark in range(31):
        canvas.fill(262 + 12 * mark, 46 - (22 if mark % 10 == 0 else 16 if mark % 5 == 0 else 10), 2, 22, ink)
        canvas.fill(262 + 12 * mark, 48, 2, 30, ivory)
    for mark in range(11):
        canvas.fill(298 + round(10.8 * mark), 48, 2, 18 if mark % 5 == 0 else 11, red)
    for number in range(4):
        canvas.write(str(number), 258 + 120 * number, 5, 2, ink)
    for number in (0, 5):
        canvas.write(str(number), 294 + 54 * (number // 5), 72, 2, red)
    print_ = scene.add_texture(scene.add_image(canvas.to_png(), "scale"), (CLAMP, CLAMP))
    label = scene.add_material("printed scale", texture=print_, extensions={"KHR_materials_unlit": {}})
    wood = scene.add_material("boxwood", (0.55, 0.38, 0.18), roughness=0.5)
    face = meshes.quad((0, 0.032, 0), (1.28, 0, 0), (0, 0, -0.192))
    body = meshes.moved(meshes.box((1.30, 0.03, 0.212)), (0, 0.015, 0))
    scene.add_node("ruler", mesh=scene.add_mesh("ruler", (face, label), (body, wood)), translation=[0.62, 0.0, 1.02],
                   rotation=about((0, 1, 0), 9))


def lights_and_cameras(scene: SceneFile):
    """A warm key through the screen, a cool point on the wall, a fill, a sun through the window, the lantern's glow."""
    scene.add_light("key", "spot", (1.0, 0.87, 0.70), 66.0, at=(-4.3, 3.1, 0.7), towards=(0.1, 0.25, 0.0),
                    spot={"innerConeAngle": 0.22, "outerConeAngle": 0.46})
    scene.add_light("cool", "point", (0.55, 0.74, 1.0), 11.0, at=(-2.2, 2.3, -2.9))
    scene.add_light("fill", "point", (0.80, 0.88, 1.0), 10.0, at=(2.4, 3.4, 4.2))
    scene.add_light("sun", "directional", (1.0, 0.93, 0.82), 3.9, towards=(-0.40, -0.62, 0.67))
    scene.add_light("lantern glow", "point", (1.0, 0.62, 0.28), 0.10, at=(-1.12, 0.17, 0.67), range=1.5)
    scene.add_camera("still life", (0.15, 1.42, 4.7), (0.06, 0.58, -0.1), degrees=31)
    scene.add_camera("elevation", (0.0, 0.75, 5.0), (0.0, 0.75, 0.0), half_height=1.15)


def every_effect() -> bytes:
    """The whole still life as .glb."""
    scene = SceneFile(TITLE)
    for part in (lights_and_cameras, table_and_wall, spheres, pedestal, ring, screen, stained_glass, vase, lantern, disc,
                 ruler):
        part(scene)
    return scene.to_bytes()
