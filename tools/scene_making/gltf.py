"""Puts a scene together and writes it as one binary glTF 2.0 file (Khronos, glTF 2.0 Specification)."""

import json
import math
import struct

from scene_making.meshes import Mesh, cross, subtract, unit

FLOAT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5123, 5125
REPEAT, CLAMP, MIRROR = 10497, 33071, 33648
NEAREST, LINEAR = 9728, 9729


def rounded(values, digits=6):
    """`values` without digits that the last place of another machine's sine could change; -0 becomes 0."""
    return [round(value, digits) + 0.0 for value in values]


def rotation_between(columns) -> list:
    """The unit quaternion (x, y, z, w) of the rotation matrix with these three columns."""
    (a, d, g), (b, e, h), (c, f, i) = columns
    trace = a + e + i
    if trace > 0:
        w = math.sqrt(1 + trace) / 2
        found = [(h - f) / (4 * w), (c - g) / (4 * w), (d - b) / (4 * w), w]
    elif a >= e and a >= i:
        x = math.sqrt(1 + a - e - i) / 2
        found = [x, (b + d) / (4 * x), (c + g) / (4 * x), (h - f) / (4 * x)]
    elif e >= i:
        y = math.sqrt(1 - a + e - i) / 2
        found = [(b + d) / (4 * y), y, (f + h) / (4 * y), (c - g) / (4 * y)]
    else:
        z = math.sqrt(1 - a - e + i) / 2
        found = [(c + g) / (4 * z), (f + h) / (4 * z), z, (d - b) / (4 * z)]
    return rounded(found, 9)


def facing(direction, up=(0.0, 1.0, 0.0)) -> list:
    """The rotation that turns -Z to `direction` and keeps +Y near `up`: for cameras, spots and directional lights."""
    back = unit(tuple(-x for x in direction))
    if abs(sum(x * y for x, y in zip(back, unit(up)))) > 0.999:
        up = (0.0, 0.0, -1.0)
    right = unit(cross(up, back))
    return rotation_between((right, cross(back, right), back))


def about(axis, degrees: float) -> list:
    """The rotation by `degrees` about `axis`."""
    half = math.radians(degrees) / 2
    return rounded([x * math.sin(half) for x in unit(axis)] + [math.cos(half)], 9)


class SceneFile:
    """A glTF document and its binary chunk while they grow. Every `add_` returns an index."""

    def __init__(self, title: str):
        self.binary = bytearray()
        self.lists = {"nodes": [], "meshes": [], "materials": [], "accessors": [], "bufferViews": [], "images": [],
                      "samplers": [], "textures": [], "cameras": []}
        self.lights = []
        self.extensions = set()
        self.scene = {"name": title, "nodes": []}

    def _append(self, kind: str, entry) -> int:
        self.lists[kind].append(entry)
        return len(self.lists[kind]) - 1

    def _add_view(self, content: bytes, target=None) -> int:
        self.binary += bytes(-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(content)}
        if target:
            view["target"] = target
        self.binary += content
        return self._append("bufferViews", view)

    def _add_accessor(self, rows, kind: str, component=FLOAT, with_bounds=False) -> int:
        flat = [value for row in rows for value in row] if kind != "SCALAR" else list(rows)
        if component == FLOAT:
            flat = rounded(flat)
        code = {FLOAT: "f", UNSIGNED_SHORT: "H", UNSIGNED_INT: "I"}[component]
        view = self._add_view(struct.pack(f"<{len(flat)}{code}", *flat), 34963 if kind == "SCALAR" else 34962)
        entry = {"bufferView": view, "componentType": component, "count": len(rows), "type": kind}
        if with_bounds:
            columns = list(zip(*[struct.unpack("<3f", struct.pack("<3f", *rounded(row))) for row in rows]))
            entry["min"], entry["max"] = [min(column) for column in columns], [max(column) for column in columns]
        return self._append("accessors", entry)

    def add_image(self, png: bytes, name: str) -> int:
        """An image, stored in the binary chunk."""
        return self._append("images", {"name": name, "mimeType": "image/png", "bufferView": self._add_view(png)})

    def add_texture(self, image: int, wrap=(REPEAT, REPEAT), filtering=LINEAR) -> int:
        """`image` as looked up with one wrap mode for each direction and one filter."""
        sampler = {"wrapS": wrap[0], "wrapT": wrap[1], "magFilter": filtering, "minFilter": filtering}
        if sampler not in self.lists["samplers"]:
            self._append("samplers", sampler)
        return self._append("textures", {"source": image, "sampler": self.lists["samplers"].index(sampler)})

    def add_material(self, name: str, color=(1, 1, 1, 1), metallic=0.0, roughness=1.0, texture=None, surface=None,
                     extensions=None, **others) -> int:
        """A metallic-roughness material; `texture` and `surface` are indices or texture infos, `others` go in as they are."""
        def as_use(use):
            return use if isinstance(use, dict) else {"index": use}
        model = {"baseColorFactor": list(color) + [1] * (4 - len(color)), "metallicFactor": metallic,
                 "roughnessFactor": roughness}
        if texture is not None:
            model["baseColorTexture"] = as_use(texture)
        if surface is not None:
            model["metallicRoughnessTexture"] = as_use(surface)
        material = {"name": name, "pbrMetallicRoughness": model, **others}
        if extensions:
            material["extensions"] = extensions
            self.extensions |= set(extensions)
        if "KHR_texture_transform" in json.dumps(material):
            self.extensions.add("KHR_texture_transform")
        return self._append("materials", material)

    def add_mesh(self, name: str, *parts) -> int:
        """A mesh of (Mesh, material index) pairs."""
        return self._append("meshes", {"name": name, "primitives": [self._primitive(*part) for part in parts]})

    def _primitive(self, mesh: Mesh, material: int) -> dict:
        attributes = {"POSITION": self._add_accessor(mesh.positions, "VEC3", with_bounds=True)}
        if mesh.normals:
            attributes["NORMAL"] = self._add_accessor(mesh.normals, "VEC3")
        if mesh.uvs:
            attributes["TEXCOORD_0"] = self._add_accessor(mesh.uvs, "VEC2")
        if mesh.colors:
            attributes["COLOR_0"] = self._add_accessor(mesh.colors, f"VEC{len(mesh.colors[0])}")
        corners = [corner for triangle in mesh.triangles for corner in triangle]
        width = UNSIGNED_SHORT if len(mesh.positions) < 65535 else UNSIGNED_INT
        return {"attributes": attributes, "indices": self._add_accessor(corners, "SCALAR", width), "material": material}

    def repeat_mesh(self, mesh: int, name: str, material: int) -> int:
        """The geometry of a mesh once more, with another material and without new bytes."""
        parts = [{**part, "material": material} for part in self.lists["meshes"][mesh]["primitives"]]
        return self._append("meshes", {"name": name, "primitives": parts})

    def add_node(self, name: str, parent=None, **fields) -> int:
        """A node with glTF's own fields (mesh, translation, rotation, scale, matrix); a root without `parent`."""
        for key in ("translation", "scale"):
            if key in fields:
                fields[key] = rounded(fields[key], 9)
        node = self._append("nodes", {"name": name, **fields})
        if parent is None:
            self.scene["nodes"].append(node)
        else:
            self.lists["nodes"][parent].setdefault("children", []).append(node)
        return node

    def add_light(self, name: str, kind: str, color, intensity: float, at=None, towards=None, **fields) -> int:
        """A light of KHR_lights_punctual: candela for "point" and "spot", lux for "directional"."""
        self.extensions.add("KHR_lights_punctual")
        self.lights.append({"name": name, "type": kind, "color": list(color), "intensity": intensity, **fields})
        node = {"extensions": {"KHR_lights_punctual": {"light": len(self.lights) - 1}}}
        if at is not None:
            node["translation"] = list(at)
        if towards is not None:
            node["rotation"] = facing(subtract(towards, at or (0.0, 0.0, 0.0)))
        return self.add_node(name, **node)

    def add_camera(self, name: str, eye, target, degrees=None, half_height=None) -> int:
        """A perspective camera of `degrees` vertical field of view, or an orthographic one of `half_height` metres."""
        if degrees:
            camera = {"type": "perspective", "perspective": {"yfov": round(math.radians(degrees), 9), "znear": 0.01}}
        else:
            camera = {"type": "orthographic", "orthographic": {
                "xmag": half_height, "ymag": half_height, "znear": 0.0, "zfar": 100.0}}
        index = self._append("cameras", {"name": name, **camera})
        return self.add_node(name, camera=index, translation=list(eye), rotation=facing(subtract(target, eye)))

    def to_bytes(self) -> bytes:
        """The finished .glb."""
        document = {"asset": {"version": "2.0", "generator": "tools/make_scenes", "copyright": "CC0-1.0"},
                    "scene": 0, "scenes": [self.scene]}
        document.update({kind: entries for kind, entries in self.lists.items() if entries})
        document["buffers"] = [{"byteLength": len(self.binary)}]
        if self.extensions:
            document["extensionsUsed"] = sorted(self.extensions)
        if self.lights:
            document["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        binary = bytes(self.binary) + bytes(-len(self.binary) % 4)
        return (struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)) +
                struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary)
