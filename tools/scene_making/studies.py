"""The small scenes: each shows one thing. A white wall facing its light is near 0.8: about 2.9 lux arrive there."""

from scene_making import meshes, pictures
from scene_making.gltf import CLAMP, LINEAR, MIRROR, NEAREST, REPEAT, SceneFile, about

WHITE, GREY = (0.8, 0.8, 0.8), (0.45, 0.45, 0.45)
BALL_LEVEL = 4


def ground(scene: SceneFile, material: int, size: float = 8.0, tiles: float = 1.0):
    """A square in the plane y = 0, its texture `tiles` times along a side."""
    scene.add_node("ground", mesh=scene.add_mesh(
        "ground", (meshes.quad((0, 0, 0), (size, 0, 0), (0, 0, -size), tiles), material)))


def board(scene: SceneFile, first=(0.75, 0.73, 0.68), second=(0.16, 0.18, 0.22)) -> int:
    """A material with a checkerboard of 8 x 8 fields, sharp at its edges."""
    image = scene.add_image(pictures.checker(first, second, 8, 64), "board")
    return scene.add_material("board", texture=scene.add_texture(image, (REPEAT, REPEAT), NEAREST), roughness=0.9)


def glass_extensions(ior: float = 1.5, thickness: float = 1.0, color=None, distance: float = 1.0) -> dict:
    """Solid clear glass; with `color` what is left of white light after `distance` metres in it."""
    volume = {"thicknessFactor": thickness}
    if color:
        volume.update(attenuationColor=list(color), attenuationDistance=distance)
    return {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": ior},
            "KHR_materials_volume": volume}


def first_light() -> bytes:
    """A ball on a plane, one point light."""
    scene = SceneFile("first_light")
    ground(scene, scene.add_material("plane", WHITE))
    clay = scene.add_material("clay", (0.8, 0.35, 0.2), roughness=0.5)
    scene.add_node("ball", mesh=scene.add_mesh("ball", (meshes.icosphere(BALL_LEVEL), clay)), translation=[0, 1, 0])
    scene.add_light("lamp", "point", (1, 1, 1), 45.0, at=(-2.5, 3.5, 2.5))
    scene.add_camera("view", (0, 2.2, 6), (0, 0.8, 0), degrees=40)
    return scene.to_bytes()


def mirror_pair() -> bytes:
    """Two mirrors face each other, a red and a blue ball between: images as deep as --max-bounces allows."""
    scene = SceneFile("mirror_pair")
    ground(scene, board(scene), 8, 1)
    mirror = scene.add_material("mirror", (0.92, 0.94, 0.92), metallic=1.0, roughness=0.0)
    frame = scene.add_material("frame", (0.30, 0.18, 0.08), roughness=0.6)
    glass = meshes.quad((0, 1.3, 0), (3.2, 0, 0), (0, 2.4, 0))
    edge = meshes.merged(*[meshes.moved(meshes.box((0.1, 2.6, 0.1)), (x, 1.3, -0.06)) for x in (-1.65, 1.65)],
                         *[meshes.moved(meshes.box((3.2, 0.1, 0.1)), (0, y, -0.06)) for y in (0.05, 2.55)])
    panel = scene.add_mesh("mirror", (glass, mirror), (edge, frame))
    scene.add_node("mirror, behind", mesh=panel, translation=[0, 0, -1.6])
    scene.add_node("mirror, in front", mesh=panel, translation=[0, 0, 1.6], rotation=about((0, 1, 0), 180))
    red = scene.add_material("red", (0.75, 0.08, 0.06), roughness=0.4)
    blue = scene.add_material("blue", (0.08, 0.16, 0.70), roughness=0.4)
    ball = scene.add_mesh("red ball", (meshes.icosphere(BALL_LEVEL, 0.4), red))
    scene.add_node("red ball", mesh=ball, translation=[-0.55, 0.4, -0.3])
    scene.add_node("blue ball", mesh=scene.repeat_mesh(ball, "blue ball", blue), translation=[0.6, 0.4, 0.35])
    scene.add_light("lamp", "point", (1, 0.97, 0.92), 24.0, at=(0.2, 3.4, 0.3))
    scene.add_light("fill", "point", (0.8, 0.9, 1), 8.0, at=(-2.6, 1.8, 0.2))
    scene.add_camera("between", (1.25, 1.55, 1.35), (-0.35, 0.75, -1.6), degrees=62)
    return scene.to_bytes()


def glass_ball() -> bytes:
    """A ball of glass on a checkered floor, a tinted one beside it: refraction, Fresnel reflection, absorption."""
    scene = SceneFile("glass_ball")
    ground(scene, board(scene), 10, 2)
    clear = scene.add_material("clear glass", roughness=0.0, extensions=glass_extensions())
    amber = scene.add_material("amber glass", roughness=0.0,
                               extensions=glass_extensions(1.5, 1.0, (0.85, 0.42, 0.10), 0.6))
    ball = scene.add_mesh("clear ball", (meshes.icosphere(BALL_LEVEL), clear))
    scene.add_node("clear ball", mesh=ball, translation=[-0.5, 1, 0])
    scene.add_node("amber ball", mesh=scene.repeat_mesh(ball, "amber ball", amber), translation=[1.15, 0.55, 0.75],
                   scale=[0.55] * 3)
    wall = scene.add_material("wall", (0.25, 0.42, 0.50))
    scene.add_node("wall", mesh=scene.add_mesh("wall", (meshes.quad((0, 2.5, -4), (14, 0, 0), (0, 5, 0)), wall)))
    scene.add_light("sun", "directional", (1, 0.96, 0.9), 3.0, towards=(-0.5, -1.0, -0.6))
    scene.add_light("lamp", "point", (1, 1, 1), 12.0, at=(-2, 3, 3))
    scene.add_camera("view", (0, 2.0, 5.6), (0.1, 0.85, 0), degrees=38)
    return scene.to_bytes()


def nested_glass() -> bytes:
    """Glass around a bubble of air around a core of denser glass: every wall has a front and a back."""
    scene = SceneFile("nested_glass")
    ground(scene, board(scene, (0.80, 0.76, 0.66), (0.30, 0.10, 0.10)), 10, 2)
    shell = scene.add_material("shell", roughness=0.0, extensions=glass_extensions(1.5, 1.0, (0.80, 0.95, 0.98), 1.0))
    core = scene.add_material("core", roughness=0.0, extensions=glass_extensions(1.8, 0.5, (0.95, 0.55, 0.75), 0.5))
    outer = meshes.icosphere(BALL_LEVEL)
    # The bubble is the shell's inner wall: its fronts look inwards, into the air.
    bubble = meshes.icosphere(3, 0.75)
    bubble.triangles = [(a, c, b) for a, b, c in bubble.triangles]
    bubble.normals = [meshes.scale(normal, -1.0) for normal in bubble.normals]
    scene.add_node("shell", mesh=scene.add_mesh("shell", (outer, shell), (bubble, shell)), translation=[0, 1, 0])
    scene.add_node("core", mesh=scene.add_mesh("core", (meshes.icosphere(3, 0.42), core)), translation=[0, 1, 0])
    wall = scene.add_material("wall", (0.48, 0.44, 0.34))
    scene.add_node("wall", mesh=scene.add_mesh("wall", (meshes.quad((0, 2.5, -4), (14, 0, 0), (0, 5, 0)), wall)))
    scene.add_light("sun", "directional", (1, 0.96, 0.9), 2.6, towards=(0.5, -1.0, -0.4))
    scene.add_light("lamp", "point", (1, 1, 1), 14.0, at=(-2, 3, 3))
    scene.add_camera("view", (0.3, 1.9, 4.6), (0, 0.9, 0), degrees=36)
    return scene.to_bytes()


def texture_wrap() -> bytes:
    """Nine quads by wrap mode (repeat, clamp, mirror in u and v), the left half nearest, the right half linear."""
    scene = SceneFile("texture_wrap")
    canvas = pictures.Canvas(16, 16, (226, 220, 205))
    canvas.fill(0, 0, 8, 8, (196, 60, 44))
    canvas.fill(8, 8, 8, 8, (40, 84, 160))
    canvas.write("F", 9, 1, 1, (30, 30, 34))
    image = scene.add_image(canvas.to_png(), "letter F")
    modes = [("repeat", REPEAT), ("clamp", CLAMP), ("mirror", MIRROR)]
    for row, (name_v, wrap_v) in enumerate(modes):
        for column, (name_u, wrap_u) in enumerate(modes):
            for half, (filter_name, filtering) in enumerate((("nearest", NEAREST), ("linear", LINEAR))):
                label = f"{name_u} u, {name_v} v, {filter_name}"
                paint = scene.add_material(label, texture=scene.add_texture(image, (wrap_u, wrap_v), filtering))
                # uv from -1 to 2: the picture in the middle, one width of what lies outside all around it.
                tile = meshes.quad((0, 0, 0), (0.9, 0, 0), (0, 0.9, 0), 3.0, -1.0)
                scene.add_node(label, mesh=scene.add_mesh(label, (tile, paint)),
                               translation=[(column - 1) * 2.0 + (half - 0.5) * 0.95, (1 - row) * 1.0, 0])
    scene.add_light("lamp", "directional", (1, 1, 1), 3.0, towards=(0, 0, -1))
    scene.add_camera("front", (0, 0, 5), (0, 0, 0), half_height=1.75)
    return scene.to_bytes()


def light_types() -> bytes:
    """Four bays with a ball each: point, spot with a soft edge, directional, and a point light that ends at its range."""
    scene = SceneFile("light_types")
    paint, clay = scene.add_material("bay", WHITE), scene.add_material("ball", GREY, roughness=0.4)
    bay = scene.add_mesh("bay", (meshes.merged(
        meshes.quad((0, 0, 0), (1.9, 0, 0), (0, 0, -2)), meshes.quad((0, 1, -1), (1.9, 0, 0), (0, 2, 0)),
        meshes.quad((-0.95, 1, 0), (0, 0, -2), (0, 2, 0)), meshes.quad((0.95, 1, 0), (0, 0, 2), (0, 2, 0)),
        meshes.quad((0, 2, 0), (1.9, 0, 0), (0, 0, 2))), paint))
    ball = scene.add_mesh("ball", (meshes.icosphere(3, 0.35), clay))
    for index, name in enumerate(("point", "spot", "directional", "range")):
        x = 2.0 * index - 3.0
        scene.add_node(f"bay, {name}", mesh=bay, translation=[x, 0, 0])
        scene.add_node(f"ball, {name}", mesh=ball, translation=[x, 0.35, -0.2])
    scene.add_light("point", "point", (1, 0.9, 0.8), 2.2, at=(-3.0, 1.2, 0.45))
    scene.add_light("spot", "spot", (1, 1, 1), 9.0, at=(-1.0, 1.8, 0.6), towards=(-1.0, 0.2, -0.3),
                    spot={"innerConeAngle": 0.25, "outerConeAngle": 0.5})
    # From the front and below the ceilings: it reaches every bay, which is what sunlight does.
    scene.add_light("directional", "directional", (0.7, 0.85, 1.0), 0.7, towards=(0.25, -0.35, -1.0))
    scene.add_light("range", "point", (0.9, 1, 0.8), 2.6, at=(3.0, 1.1, 0.4), range=1.4)
    scene.add_camera("view", (0, 1.2, 8.5), (0, 0.95, 0), degrees=32)
    return scene.to_bytes()
