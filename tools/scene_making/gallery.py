"""gallery: a museum hall with six exhibits on plinths, pictures on the walls and a polished floor."""

import math

from scene_making import meshes, pictures
from scene_making.gltf import CLAMP, NEAREST, REPEAT, SceneFile, about
from scene_making.studies import BALL_LEVEL, glass_extensions

HALF_WIDTH, HEIGHT, NEAR, FAR = 3.0, 3.4, 4.0, -9.0
PLINTHS = [(side * 1.55, z) for z in (-0.6, -3.4, -6.2) for side in (-1, 1)]


def hall(scene: SceneFile):
    """Floor of black and white marble, plain walls, a ceiling with two rows of lamps."""
    marble = scene.add_texture(scene.add_image(
        pictures.checker((0.72, 0.70, 0.66), (0.10, 0.10, 0.11), 2, 32), "marble"), (REPEAT, REPEAT), NEAREST)
    floor = scene.add_material("polished marble", texture=marble, roughness=0.06)
    wall = scene.add_material("wall", (0.46, 0.16, 0.14))
    ceiling = scene.add_material("ceiling", (0.78, 0.76, 0.72))
    lamp = scene.add_material("lamps", (0, 0, 0), emissiveFactor=[0.85, 0.79, 0.70],
                              extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 1.15}})
    length, middle = NEAR - FAR, (NEAR + FAR) / 2
    ground = meshes.quad((0, 0, middle), (2 * HALF_WIDTH, 0, 0), (0, 0, -length))
    ground.uvs = [(2 * HALF_WIDTH / 1.5 * u, length / 1.5 * v) for u, v in ground.uvs]
    walls = meshes.merged(
        meshes.quad((-HALF_WIDTH, HEIGHT / 2, middle), (0, 0, -length), (0, HEIGHT, 0)),
        meshes.quad((HALF_WIDTH, HEIGHT / 2, middle), (0, 0, length), (0, HEIGHT, 0)),
        meshes.quad((0, HEIGHT / 2, FAR), (2 * HALF_WIDTH, 0, 0), (0, HEIGHT, 0)))
    cover = meshes.quad((0, HEIGHT, middle), (2 * HALF_WIDTH, 0, 0), (0, 0, length))
    lamps = meshes.merged(*[meshes.quad((side * 1.2, HEIGHT - 0.02, z), (0.5, 0, 0), (0, 0, 1.2))
                            for z in (2.0, -0.8, -3.6, -6.4) for side in (-1, 1)])
    scene.add_node("hall", mesh=scene.add_mesh("hall", (ground, floor), (walls, wall), (cover, ceiling), (lamps, lamp)))


def framed_pictures(scene: SceneFile):
    """Four abstract paintings and one at the far end: base colour textures in gilded frames."""
    gilt = scene.add_material("gilt", (0.83, 0.62, 0.28), metallic=1.0, roughness=0.35)

    def rings(u, v):
        radius = math.hypot(u - 0.4, v - 0.55)
        return tuple(0.5 + 0.45 * math.cos(14 * radius + shift) for shift in (0.0, 0.9, 2.2))

    def waves(u, v):
        height = 0.5 + 0.18 * math.sin(7 * u) + 0.08 * math.sin(17 * u + 2)
        deep = (v - height) * 2
        return (0.12 + 0.1 * deep, 0.30 - 0.15 * deep, 0.45 - 0.2 * deep) if v > height else (0.93, 0.74 - 0.4 * v, 0.45)

    def squares(u, v):
        tone = pictures.noise(int(u * 5) + 3, int(v * 4) + 8)
        return ((0.85, 0.22, 0.14), (0.92, 0.80, 0.56), (0.10, 0.22, 0.42), (0.92, 0.62, 0.12))[int(tone * 4)]
    bars = meshes.merged(*[meshes.moved(meshes.box((0.09, 1.19, 0.08)), (x, 0, 0)) for x in (-0.745, 0.745)],
                         *[meshes.moved(meshes.box((1.4, 0.09, 0.08)), (0, y, 0)) for y in (-0.55, 0.55)])
    frames = []
    for name, paint_of, size in (("rings", rings, 64), ("waves", waves, 64), ("squares", squares, 60)):
        image = scene.add_texture(scene.add_image(pictures.picture(size, size, paint_of), name), (CLAMP, CLAMP))
        paint = scene.add_material(name, texture=image, roughness=0.7)
        frames.append(scene.add_mesh(name, (meshes.quad((0, 0, 0.01), (1.4, 0, 0), (0, 1.01, 0)), paint), (bars, gilt)))
    for number, (side, z) in enumerate(((-1, -2.0), (1, -2.0), (-1, -4.8), (1, -4.8))):
        scene.add_node(f"painting {number}", mesh=frames[(number + side) % 3], translation=[side * (HALF_WIDTH - 0.05), 1.75, z],
                       rotation=about((0, 1, 0), -90 * side))
    scene.add_node("painting at the end", mesh=frames[1], translation=[0, 1.7, FAR + 0.05], scale=[1.6, 1.6, 1.0])


def exhibits(scene: SceneFile):
    """Glass, mirror, gold ring, a gem, a twisted column and nested rings, each on its plinth."""
    stone = scene.add_material("plinth", (0.80, 0.79, 0.76), roughness=0.8)
    plinth = scene.add_mesh("plinth", (meshes.moved(meshes.box((0.7, 1.0, 0.7)), (0, 0.5, 0)), stone))
    for number, (x, z) in enumerate(PLINTHS):
        scene.add_node(f"plinth {number}", mesh=plinth, translation=[x, 0, z])
    places = iter([(x, 1.0, z) for x, z in PLINTHS])
    glass = scene.add_material("glass", roughness=0.0, extensions=glass_extensions(1.52, 1.0, (0.75, 0.90, 0.97), 0.8))
    chrome = scene.add_material("chrome", (0.90, 0.91, 0.93), metallic=1.0, roughness=0.0)
    gold = scene.add_material("gold", (1.0, 0.76, 0.33), metallic=1.0, roughness=0.22)
    ruby = scene.add_material("ruby", (0.70, 0.04, 0.10), roughness=0.05)
    jade = scene.add_material("jade", (0.14, 0.42, 0.26), roughness=0.25)
    ball = scene.add_mesh("glass ball", (meshes.icosphere(BALL_LEVEL, 0.36), glass))
    ring = scene.add_mesh("gold ring", (meshes.torus(0.25, 0.09, 48, 20), gold))
    gem = meshes.icosphere(1, 0.36)
    gem.normals = []

    def column(u, v):
        away = 0.17 * (1 + 0.22 * math.cos(6 * math.pi * u + 4 * v)) * (1.15 - 0.5 * v)
        return (away * math.cos(2 * math.pi * u), 0.8 * v, -away * math.sin(2 * math.pi * u))

    def put(name, mesh, lift, **fields):
        x, y, z = next(places)
        scene.add_node(name, mesh=mesh, translation=[x, y + lift, z], **fields)
    put("glass ball", ball, 0.36)
    put("gold ring", ring, 0.34, rotation=about((1, 0.25, 0), 80))
    put("jade column", scene.add_mesh("jade column", (meshes.sheet(column, 60, 12), jade)), 0.0)
    put("chrome ball", scene.repeat_mesh(ball, "chrome ball", chrome), 0.36)
    put("ruby", scene.add_mesh("ruby", (gem, ruby)), 0.36, rotation=about((1, 1, 0), 25))
    put("jade ring", scene.repeat_mesh(ring, "jade ring", jade), 0.34, rotation=about((0.2, 0, 1), 90))


def lights(scene: SceneFile):
    """A spot above each plinth and two soft points in the middle."""
    for number, (x, z) in enumerate(PLINTHS):
        scene.add_light(f"spot {number}", "spot", (1.0, 0.92, 0.80), 13.0, at=(x * 0.55, HEIGHT - 0.15, z + 0.9),
                        towards=(x, 1.2, z), spot={"innerConeAngle": 0.25, "outerConeAngle": 0.5})
    for number, z in enumerate((1.6, -2.2, -6.0)):
        scene.add_light(f"room {number}", "point", (1.0, 0.95, 0.88), 4.2, at=(0, HEIGHT - 1.2, z))


def gallery() -> bytes:
    """The hall as .glb."""
    scene = SceneFile("gallery")
    for part in (hall, framed_pictures, exhibits, lights):
        part(scene)
    scene.add_camera("entrance", (0.55, 1.62, 3.7), (-0.12, 1.28, -3.0), degrees=46)
    return scene.to_bytes()
