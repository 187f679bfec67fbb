"""The small scenes about surfaces: alpha, metal and roughness, normal maps, colours, transforms, emission."""

import math

from scene_making import meshes, pictures
from scene_making.gltf import CLAMP, REPEAT, SceneFile, about
from scene_making.meshes import Mesh
from scene_making.studies import WHITE, board, ground


def alpha() -> bytes:
    """Leaves cut out by alpha mask, panes that blend, and the shadows of both."""
    scene = SceneFile("alpha")
    ground(scene, board(scene, (0.78, 0.76, 0.72), (0.55, 0.54, 0.52)), 8, 1)

    def leaf_of(u, v):
        along = 1.0 - v
        blade = 0.34 * math.sin(math.pi * min(1.0, along * 1.12)) ** 0.8 if along < 0.89 else 0.0
        teeth = 1.0 - 0.10 * abs((along * 14) % 1.0 - 0.5)
        distance = max(blade * teeth - abs(u - 0.5), 0.03 - abs(u - 0.5) if along < 0.25 else -1.0)
        vein = abs(u - 0.5) < 0.015 or (abs((along * 7 - 3 * abs(u - 0.5)) % 1.0 - 0.5) < 0.06 and blade > 0.1)
        green = (0.55, 0.68, 0.26) if vein else (0.20, 0.46, 0.14)
        return (*green, 0.5 + 8.0 * distance)
    leaf = scene.add_texture(scene.add_image(pictures.picture(96, 96, leaf_of, 4), "leaf"), (CLAMP, CLAMP))
    foliage = scene.add_material("leaf", texture=leaf, roughness=0.7, alphaMode="MASK", alphaCutoff=0.5,
                                 doubleSided=True)
    card = scene.add_mesh("leaf", (meshes.quad((0, 0.8, 0), (1.6, 0, 0), (0, 1.6, 0)), foliage))
    for number, (x, z, turn, lean) in enumerate(((-1.5, -0.3, 35, -12), (-0.9, 0.2, -20, 8), (-1.9, 0.5, 80, 15))):
        node = scene.add_node(f"stem {number}", translation=[x, 0, z], rotation=about((0, 1, 0), turn))
        scene.add_node(f"leaf {number}", parent=node, mesh=card, rotation=about((1, 0, 0), lean))
    pane = meshes.quad((0, 0.9, 0), (1.0, 0, 0), (0, 1.6, 0))
    for number, (color, x, z) in enumerate((((0.85, 0.10, 0.10, 0.5), 0.7, -0.5), ((0.10, 0.55, 0.20, 0.5), 1.05, 0.0),
                                            ((0.10, 0.20, 0.80, 0.5), 1.4, 0.5))):
        paint = scene.add_material(f"pane {number}", color, roughness=0.3, alphaMode="BLEND", doubleSided=True)
        scene.add_node(f"pane {number}", mesh=scene.add_mesh(f"pane {number}", (pane, paint)), translation=[x, 0, z],
                       rotation=about((0, 1, 0), -25))
    scene.add_light("sun", "directional", (1, 0.97, 0.9), 2.8, towards=(-0.35, -1.0, -0.75))
    scene.add_light("fill", "point", (0.8, 0.9, 1.0), 8.0, at=(3, 3, 4))
    scene.add_camera("view", (0, 2.0, 5.6), (0, 0.75, 0), degrees=38)
    return scene.to_bytes()


def materials() -> bytes:
    """Balls by roughness (left to right 0 to 1) and kind (top to bottom: gold, half metal, plastic, coloured specular)."""
    scene = SceneFile("materials")
    wall = scene.add_material("wall", (0.30, 0.32, 0.36))
    scene.add_node("wall", mesh=scene.add_mesh("wall", (meshes.quad((0, 0, -1.2), (16, 0, 0), (0, 10, 0)), wall)))
    ball = None
    rows = (("gold", (1.0, 0.77, 0.34), 1.0, None), ("half metal", (0.55, 0.65, 0.80), 0.5, None),
            ("plastic", (0.10, 0.35, 0.60), 0.0, None),
            ("coloured specular", (0.05, 0.05, 0.05), 0.0,
             {"KHR_materials_specular": {"specularColorFactor": [1.0, 0.35, 0.2]}, "KHR_materials_ior": {"ior": 2.2}}))
    for row, (name, color, metallic, extensions) in enumerate(rows):
        for column in range(6):
            label = f"{name}, roughness {column / 5:.1f}"
            paint = scene.add_material(label, color, metallic=metallic, roughness=round(column / 5, 1),
                                       extensions=extensions)
            if ball is None:
                ball = scene.add_mesh(label, (meshes.icosphere(3, 0.45), paint))
                mesh = ball
            else:
                mesh = scene.repeat_mesh(ball, label, paint)
            scene.add_node(label, mesh=mesh, translation=[column - 2.5, 1.5 - row, 0])
    scene.add_light("key", "directional", (1, 0.97, 0.93), 1.6, towards=(-0.6, -0.8, -1.0))
    scene.add_light("left", "point", (0.6, 0.8, 1.0), 14.0, at=(-4.5, 1.0, 3.0))
    scene.add_light("right", "point", (1.0, 0.7, 0.45), 14.0, at=(4.5, -1.0, 3.0))
    scene.add_camera("front", (0, 0, 9), (0, 0, 0), degrees=29)
    return scene.to_bytes()


def normal_map() -> bytes:
    """One normal map on a quad, a ball and a mirrored quad; the light comes from the upper left: bumps rise, never sink."""
    scene = SceneFile("normal_map")

    def relief(u, v):
        radius = math.hypot(u - 0.5, v - 0.5)
        return 0.06 * max(0.0, 1 - (radius / 0.36) ** 2) ** 0.5 if radius < 0.36 else 0.0
    bumps = scene.add_texture(scene.add_image(pictures.normal_map(64, relief, 1.0), "bumps"), (REPEAT, REPEAT))
    paint = scene.add_material("bumps", (0.62, 0.60, 0.56), roughness=0.5, normalTexture={"index": bumps})
    steep = scene.add_material("bumps, scale 2", (0.36, 0.52, 0.62), roughness=0.35,
                               normalTexture={"index": bumps, "scale": 2.0})
    tile = meshes.quad((0, 0, 0), (1.8, 0, 0), (0, 1.8, 0), 4.0)
    scene.add_node("quad", mesh=scene.add_mesh("quad", (tile, paint)), translation=[-2.1, 0, 0])
    ball = meshes.uv_sphere(0.95, 48, 24)
    ball.uvs = [(12 * u, 6 * v) for u, v in ball.uvs]
    scene.add_node("ball", mesh=scene.add_mesh("ball", (ball, steep)))
    # u runs backwards: the tangent frame is left-handed, and the relief must not turn inside out.
    mirrored = meshes.quad((0, 0, 0), (1.8, 0, 0), (0, 1.8, 0), 4.0)
    mirrored.uvs = [(-u, v) for u, v in mirrored.uvs]
    scene.add_node("mirrored quad", mesh=scene.add_mesh("mirrored quad", (mirrored, paint)), translation=[2.1, 0, 0])
    scene.add_light("lamp", "directional", (1, 0.97, 0.92), 2.8, towards=(0.8, -0.9, -0.9))
    scene.add_camera("front", (0, 0, 6.5), (0, 0, 0), degrees=32)
    return scene.to_bytes()


def vertex_colors() -> bytes:
    """A smooth colour wheel, a faceted gem without normals and a half transparent veil: COLOR_0 with three and four parts."""
    scene = SceneFile("vertex_colors")
    white = scene.add_material("white", roughness=0.6, doubleSided=True)

    def hue(turn):
        return tuple(0.5 + 0.5 * math.cos(2 * math.pi * (turn - shift / 3)) for shift in range(3))
    wheel = Mesh([(0, 0, 0)], [(0, 0, 1)], [], [(1, 1, 1)], [])
    for step in range(48):
        angle = 2 * math.pi * step / 48
        wheel.positions.append((math.cos(angle), math.sin(angle), 0.0))
        wheel.normals.append((0, 0, 1))
        wheel.colors.append(hue(step / 48))
        wheel.triangles.append((0, step + 1, (step + 1) % 48 + 1))
    scene.add_node("wheel", mesh=scene.add_mesh("wheel", (wheel, white)), translation=[-2.3, 0, 0])
    gem = meshes.icosphere(1)
    gem.colors, gem.normals = [tuple(0.5 + 0.45 * x for x in point) for point in gem.positions], []
    scene.add_node("gem", mesh=scene.add_mesh("gem", (gem, white)), rotation=about((1, 0.3, 0), 20))
    veil = meshes.sheet(lambda u, v: (1.8 * (u - 0.5), 1.8 * (v - 0.5), 0.12 * math.sin(9 * u)), 24, 8,
                        lambda u, v: (0.9, 0.25 + 0.5 * v, 0.15, 1.0 - u))
    veil.uvs = []
    thin = scene.add_material("veil", alphaMode="BLEND", doubleSided=True)
    scene.add_node("veil", mesh=scene.add_mesh("veil", (veil, thin)), translation=[2.3, 0, 0.3])
    wall = scene.add_material("wall", (0.34, 0.36, 0.40))
    scene.add_node("wall", mesh=scene.add_mesh("wall", (meshes.quad((0, 0, -1.3), (12, 0, 0), (0, 6, 0)), wall)))
    scene.add_light("lamp", "directional", (1, 1, 1), 2.8, towards=(0.3, -0.5, -1.0))
    scene.add_camera("front", (0, 0, 7), (0, 0, 0), degrees=32)
    return scene.to_bytes()


def transforms() -> bytes:
    """One arrow mesh many times: mirrored, stretched, sheared through a parent, by matrix, turned; all lit from above."""
    scene = SceneFile("transforms")
    ground(scene, scene.add_material("plane", WHITE), 12)
    paint = scene.add_material("arrow", (0.85, 0.45, 0.12), roughness=0.5)
    body = meshes.lathe([(0.0, 0.0), (0.12, 0.0), (0.12, 0.6), (0.28, 0.6), (0.0, 1.1)], 24)
    flag = meshes.moved(meshes.box((0.4, 0.14, 0.06)), (0.3, 0.25, 0))
    arrow = scene.add_mesh("arrow", (meshes.merged(body, flag), paint))
    placed = [("as it is", {}), ("mirrored in x", {"scale": [-1, 1, 1]}), ("stretched", {"scale": [0.6, 1.5, 1.8]}),
              ("turned", {"rotation": about((0, 0, 1), -60)}), ("point mirrored", {"scale": [-1, -1, -1]}),
              ("matrix", {"matrix": [0.8, 0, -0.6, 0, 0.3, 1.1, 0.2, 0, 0.6, 0, 0.8, 0, 0, 0, 0, 1]})]
    for number, (name, fields) in enumerate(placed):
        lift = 1.1 if name == "point mirrored" else 0.35 if name == "turned" else 0.0
        stand = scene.add_node(f"stand, {name}", translation=[(number % 3 - 1) * 1.9 - 0.2, lift, 1.0 - 2.0 * (number // 3)])
        scene.add_node(name, parent=stand, mesh=arrow, **fields)
    # Unequal scale above a rotation shears what stands below; three of them make a small chain.
    parent = scene.add_node("shear", translation=[2.7, 0, 0.2], scale=[1.0, 0.7, 0.5])
    for turn in (0, 35, 70):
        scene.add_node(f"sheared, {turn} degrees", parent=parent, mesh=arrow, rotation=about((1, 0, 1), -turn))
    scene.add_light("sun", "directional", (1, 0.98, 0.94), 2.4, towards=(-0.4, -1.0, -0.5))
    scene.add_light("fill", "point", (0.7, 0.85, 1.0), 14.0, at=(-3, 3, 5))
    scene.add_camera("view", (0.2, 3.2, 7.6), (0.2, 0.5, 0), degrees=30)
    return scene.to_bytes()


def unlit_emissive() -> bytes:
    """An unlit card, an emissive ball, a strong one, a picture that glows and a mirror floor, in next to no light."""
    scene = SceneFile("unlit_emissive")
    ground(scene, scene.add_material("dark mirror", (0.35, 0.36, 0.40), metallic=1.0, roughness=0.08), 10)
    canvas = pictures.Canvas(96, 32, (32, 70, 92))
    canvas.write("UNLIT", 18, 9, 2, (240, 226, 190))
    card = scene.add_texture(scene.add_image(canvas.to_png(), "card"), (CLAMP, CLAMP))
    plain = scene.add_material("unlit card", texture=card, extensions={"KHR_materials_unlit": {}})
    scene.add_node("card", mesh=scene.add_mesh("card", (meshes.quad((0, 0.5, 0), (1.5, 0, 0), (0, 0.5, 0)), plain)),
                   translation=[-1.6, 0.2, 0.4], rotation=about((0, 1, 0), 12))
    ember = scene.add_material("ember", (0, 0, 0), emissiveFactor=[0.9, 0.25, 0.05])
    strong = scene.add_material("lamp", (0, 0, 0), emissiveFactor=[0.7, 0.85, 1.0],
                                extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}})
    ball = scene.add_mesh("ember", (meshes.icosphere(3, 0.45), ember))
    scene.add_node("ember", mesh=ball, translation=[-0.1, 0.5, -0.5])
    scene.add_node("lamp", mesh=scene.repeat_mesh(ball, "lamp", strong), translation=[0.8, 0.35, 0.4], scale=[0.6] * 3)

    def panes(u, v):
        inside = 0.08 < (u * 4) % 1.0 < 0.92 and 0.12 < (v * 3) % 1.0 < 0.88
        lit = pictures.noise(int(u * 4), int(v * 3)) > 0.3
        return (1.0, 0.75, 0.35) if inside and lit else (0.03, 0.04, 0.08)
    glow = scene.add_texture(scene.add_image(pictures.picture(64, 48, panes), "windows"), (CLAMP, CLAMP))
    house = scene.add_material("windows", (0, 0, 0), emissiveFactor=[1, 1, 1], emissiveTexture={"index": glow})
    scene.add_node("house", mesh=scene.add_mesh("house", (meshes.box((1.1, 1.2, 1.1)), house)),
                   translation=[2.0, 0.6, -0.6], rotation=about((0, 1, 0), -30))
    # A file without any light would be shown in the default lighting.
    scene.add_light("moon", "directional", (0.6, 0.75, 1.0), 0.05, towards=(-0.4, -1.0, -0.6))
    scene.add_camera("view", (0.1, 1.5, 5.2), (0.15, 0.5, 0), degrees=36)
    return scene.to_bytes()
