"""One run of each program on the study scene, and what it counted and timed."""

import dataclasses
import json
import pathlib
import re
import resource
import subprocess

VERNIER, POVRAY, EMBREE, MITSUBA = "Vernier", "POV-Ray", "Embree", "Mitsuba"


@dataclasses.dataclass(frozen=True)
class Job:
    """What all programs are given: the folder with the scene's files and the picture to draw."""

    folder: pathlib.Path
    width: int
    height: int
    samples_per_side: int  # spp is its square; POV-Ray and Embree take a picture that many times as wide and high
    bounces: int
    cutoff: float
    threads: int
    program: str
    view: list
    embree_view: list
    mitsuba: list = dataclasses.field(default_factory=list)  # interpreter and script; empty: Mitsuba does not run


@dataclasses.dataclass(frozen=True)
class Measurement:
    """`rays` by kind, the seconds that tracing took, rays per second, and the CPU seconds of the work named in main. Mitsuba counts
    no rays but those of the camera."""

    rays: dict
    seconds: float
    rays_per_s: float
    cpu_s: float
    statistics: dict = dataclasses.field(default_factory=dict)


class RunFailed(Exception):
    """One line: which program, and the end of what it said."""


def run_program(name: str, arguments: list, folder: pathlib.Path) -> tuple:
    """Its output and the CPU seconds it took on all threads."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run([str(argument) for argument in arguments], cwd=folder, capture_output=True, text=True,
                              errors="replace", check=False)
    except OSError as error:
        raise RunFailed(f"{name} cannot be started: {error}; tools/setup benchmark installs what is missing") from error
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise RunFailed(f"{name} ended with exit code {done.returncode}: {last[-300:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout + done.stderr, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def render_vernier(job: Job, width: int, height: int, samples: int, name: str) -> tuple:
    """(statistics of render --json, CPU seconds of the whole program)."""
    _, cpu_s = run_program(VERNIER, [
        job.program, "render", "scene.obj", *job.view, "--size", f"{width}x{height}", "--spp", samples, "--max-bounces",
        job.bounces, "--cutoff", job.cutoff, "-o", f"{name}.png", "--json", f"{name}.json", "--quiet"], job.folder)
    return json.loads((job.folder / f"{name}.json").read_text()), cpu_s


def run_vernier(job: Job) -> Measurement:
    """Rays of all kinds by the device's time. CPU seconds are without those of a picture of one tile and one sample:
    what remains is tracing; the start, the scene, the BVH and the compilation of the kernel cost both runs the same."""
    first, start_cpu_s = render_vernier(job, 8, 8, 1, "first_dispatch")
    statistics, cpu_s = render_vernier(job, job.width, job.height, job.samples_per_side**2, "vernier")
    seconds = statistics["trace_device_ms"] / 1000.0
    statistics["first_dispatch_ms"] = first["trace_device_ms"]
    count = sum(statistics["rays"].values())
    return Measurement(statistics["rays"], seconds, count / seconds, max(cpu_s - start_cpu_s, 1e-9), statistics)


def read_povray_statistics(text: str) -> Measurement:
    """`Rays` are all but shadow rays: primary, reflected and refracted."""
    def number(pattern: str) -> float:
        found = re.search(pattern, text)
        if found is None:
            raise RunFailed(f"{POVRAY} printed no statistics that match {pattern!r}")
        return float(found.group(1))

    rays = {"primary": int(number(r"Pixels:\s+(\d+)")), "shadow": int(number(r"Shadow Ray Tests:\s+(\d+)"))}
    rays["reflection and refraction"] = int(number(r"\nRays:\s+(\d+)")) - rays["primary"]
    seconds = number(r"Trace Time:.*?\(([\d.]+) seconds\)")
    cpu_s = number(r"Trace Time:.*\n\s+using \d+ thread\(s\) with ([\d.]+) CPU-seconds")
    return Measurement(rays, seconds, sum(rays.values()) / seconds, cpu_s)


def run_povray(job: Job) -> Measurement:
    side = job.samples_per_side
    text, _ = run_program(POVRAY, ["povray", "+Iscene.pov", "+Opovray.png", f"+W{job.width * side}",
                                   f"+H{job.height * side}", "-D", "-A", "-V", f"+WT{job.threads}"], job.folder)
    return read_povray_statistics(text)


def run_embree(job: Job) -> Measurement:
    side, seconds = job.samples_per_side, 0.5
    text, _ = run_program(EMBREE, ["./embree_rate", "mesh.bin", job.width * side, job.height * side, seconds,
                                   job.threads, *job.embree_view], job.folder)
    found = json.loads(text)
    rays = {"primary": found["primary"], "shadow": found["shadow"]}
    return Measurement(rays, sum(rays.values()) / found["rays_per_s"], found["rays_per_s"], found["cpu_s"], found)


def run_mitsuba(job: Job) -> Measurement:
    text, _ = run_program(MITSUBA, [*job.mitsuba, job.width, job.height, job.samples_per_side**2, job.bounces + 1, job.threads,
                                    "mitsuba.png"], job.folder)
    found = json.loads(text.strip().splitlines()[-1])
    return Measurement({"camera": found["samples"]}, found["seconds"], found["samples"] / found["seconds"], found["cpu_s"], found)


def compile_embree_rate(source: pathlib.Path, folder: pathlib.Path) -> None:
    # Debian 12 has Embree 3, Debian 13 has 4 (embree.h).
    major = 4 if pathlib.Path("/usr/include/embree4").is_dir() else 3
    run_program("g++", ["g++", "-std=c++20", "-O3", "-march=native", source, "-o", folder / "embree_rate", f"-lembree{major}",
                        "-lpthread"], folder)
