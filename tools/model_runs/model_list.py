"""Which models to run, and what each is expected to do."""

import csv
import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Model:
    """A scene file. `expectation` and `note` as in the manifest; `geometry` a reference of what a camera sees, or None."""

    name: str
    path: pathlib.Path
    expectation: str = "SAFE"
    note: str = ""
    geometry: pathlib.Path | None = None


def list_models(folder: pathlib.Path) -> list[Model]:
    """The models of MANIFEST.tsv in `folder`, or without one all .gltf, .glb and .obj files below it."""
    manifest = folder / "MANIFEST.tsv"
    if not manifest.is_file():
        return [Model(str(path.relative_to(folder)), path, "RENDER") for path in sorted(folder.rglob("*"))
                if path.suffix.lower() in (".gltf", ".glb", ".obj")]
    with open(manifest, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    models = []
    for row in rows:
        if pathlib.PurePath(row["path"]).suffix.lower() not in (".gltf", ".glb", ".obj"):
            continue
        reference = row.get("aov") or ""
        geometry = folder / reference if reference.endswith(".npz") else None
        models.append(Model(row["path"], folder / row["path"], row.get("expectation") or "SAFE", row.get("note") or "",
                            geometry))
    return models
