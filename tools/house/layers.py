"""Who may include and link whom: one way, from `error` up to `cli`."""

import re

from house.source_tree import Finding, line_of

ROOMS = ["math", "image", "scene", "codecs", "bvh", "effects", "gpu", "reference", "render", "accuracy", "verify",
         "preview", "cli"]

# Rooms that know less than the order alone would allow.
IGNORES = {
    "bvh": {"image", "scene"},
    "gpu": {"image", "scene", "bvh", "effects"},
    "reference": {"gpu", "bvh"},
}


def allowed_rooms(room: str) -> set[str]:
    """The rooms that `room` may include and link, itself among them."""
    return (set(ROOMS[:ROOMS.index(room) + 1]) - IGNORES.get(room, set())) | {room}


def check_layers(texts: dict[str, str]) -> list[Finding]:
    """Includes and CMake links of src/ that go against the order, and folders that are no room."""
    findings = []
    for path, text in texts.items():
        parts = path.split("/")
        if parts[0] != "src" or len(parts) < 3:
            continue
        room = parts[1]
        if room not in ROOMS:
            findings.append(Finding(path, 1, f"src/{room} is not a room; the rooms are {' '.join(ROOMS)}"))
            continue
        pattern = r"\bvernier_(\w+)" if path.endswith("CMakeLists.txt") else r'^\s*#\s*include\s+"(\w+)/'
        for match in re.finditer(pattern, text, flags=re.MULTILINE):
            other = match.group(1)
            if other in ROOMS and other not in allowed_rooms(room):
                findings.append(Finding(path, line_of(text, match.start(1)), f"{room} may not know {other}"))
    return findings
