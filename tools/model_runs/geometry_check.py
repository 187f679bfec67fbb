"""Compares what Vernier's camera sees with the reference of an independent ray caster."""

import json
import math
import pathlib

from model_runs.limited_run import run_limited
from picture_files.exr import read_exr
from picture_files.npz import read_npz

# The gates of the reference data: shares of pixels.
HIT_MASK_LIMIT = 0.003
DEPTH_TOLERANCE, DEPTH_SHARE = 1e-3, 0.995
NORMAL_COSINE, NORMAL_SHARE = 0.99, 0.99
SHADOW_LIMIT = 0.02


def triple(values) -> str:
    return ",".join(repr(float(value)) for value in values)


# The reference's surfaces are opaque and its light is only seen or not: no glass, no interpolated normals.
PLAIN = "auto,-refraction,-tinted_shadows,-smooth_normals,-normal_texture,-unlit"


def render_command(program: str, model_path, reference: dict, light: str, effects: str, output,
                   aovs: str | None) -> list[str]:
    """One sample at the pixel centres through the reference's camera, lit by nothing but `light`."""
    target = [eye + step for eye, step in zip(reference["eye"], reference["look_dir"])]
    command = [program, "render", str(model_path), "-o", str(output), "--quiet", "--spp", "1", "--max-bounces", "0",
               f"--size={reference['width']}x{reference['height']}", f"--eye={triple(reference['eye'])}",
               f"--target={triple(target)}", f"--up={triple(reference['up'])}", f"--fov={reference['yfov_deg']!r}",
               f"--light=point:{triple(reference['light'])}:{light}", "--ambient=0,0,0", "--background=0,0,0",
               f"--effects={effects}"]
    return command + (["--aov", aovs] if aovs else [])


def differs(one: dict, other: dict, index: int) -> bool:
    """Whether two pictures have another colour there."""
    return any(one[channel][index] != other[channel][index] for channel in "RGB")


def compare(reference_arrays: dict, lit: dict, dark: dict, shadowless: dict) -> dict[str, float]:
    """Shares of pixels: hit mask differs, depth agrees, normal agrees, shadow differs, shadow is told at all."""
    depth, hit = lit["depth.Z"], reference_arrays["hit"][1]
    t, normal, visible = (reference_arrays[name][1] for name in ("t", "ng", "shadow_lit"))
    total = len(hit)
    shared = [index for index in range(total) if hit[index] and math.isfinite(depth[index])]
    mask_differs = sum(bool(hit[index]) != math.isfinite(depth[index]) for index in range(total))
    depth_agrees = sum(abs(depth[index] - t[index]) <= DEPTH_TOLERANCE * t[index] for index in shared)
    channels = [lit[f"normal.{axis}"] for axis in "XYZ"]
    normal_agrees = sum(abs(sum(channels[axis][index] * normal[3 * index + axis] for axis in range(3))) > NORMAL_COSINE
                        for index in shared)
    # Lit is what the light changes: emission, which the reference does not know, cancels out. Where not even a light
    # without shadows changes anything (black, unlit or turned away), the picture says nothing about them.
    told = [index for index in shared if differs(shadowless, dark, index)]
    shadow_differs = sum(bool(visible[index]) != differs(lit, dark, index) for index in told)
    count = max(1, len(shared))
    return {"mask": mask_differs / total, "depth": depth_agrees / count, "normal": normal_agrees / count,
            "shadow": shadow_differs / max(1, len(told)), "told": len(told) / count}


def geometry_faults(shares: dict[str, float]) -> list[str]:
    """The gates that `shares` miss."""
    faults = []
    if shares["mask"] > HIT_MASK_LIMIT:
        faults.append(f"hit mask differs on {shares['mask']:.2%}")
    if shares["depth"] < DEPTH_SHARE:
        faults.append(f"depth agrees on {shares['depth']:.2%} only")
    if shares["normal"] < NORMAL_SHARE:
        faults.append(f"normal agrees on {shares['normal']:.2%} only")
    if shares["shadow"] > SHADOW_LIMIT:
        faults.append(f"shadow differs on {shares['shadow']:.2%}")
    return faults


def check_geometry(program: str, model, folder: pathlib.Path, limit_s: float, limit_mib: float):
    """(shares or None, faults) of one model that has a reference; the renders stay in `folder`."""
    reference = json.loads(model.geometry.with_suffix(".json").read_text(encoding="utf-8"))
    images = []
    for name, light, effects, aovs in (("lit", "1e6,1e6,1e6", PLAIN, "depth,normal"), ("dark", "0,0,0", PLAIN, None),
                                       ("shadowless", "1e6,1e6,1e6", f"{PLAIN},-shadows", None)):
        output = folder / f"{name}.exr"
        command = render_command(program, model.path, reference, light, effects, output, aovs)
        outcome = run_limited(command, limit_s, limit_mib)
        if outcome.ending != "exit 0":
            return None, [f"geometry render: {outcome.ending}: {outcome.stderr.strip()[:200]}"]
        width, height, channels = read_exr(output)
        if (width, height) != (reference["width"], reference["height"]):
            return None, [f"geometry render has {width}x{height} pixels"]
        images.append(channels)
    shares = compare(read_npz(model.geometry), *images)
    return shares, geometry_faults(shares)
