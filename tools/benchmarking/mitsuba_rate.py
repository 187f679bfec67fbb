"""Camera samples per second of Mitsuba: mitsuba_rate.py SCENE.json WIDTH HEIGHT SPP DEPTH THREADS PICTURE.

SCENE.json is by scene_files.write_mitsuba, beside the meshes that it names. Prints one line of JSON: samples, seconds and CPU
seconds of the rendering alone. Runs under an interpreter that has mitsuba (tools/setup mitsuba).
"""

import json
import sys
import time

import drjit
import mitsuba

mitsuba.set_variant("scalar_rgb")


def scene_of(description: dict, width: int, height: int, depth: int):
    camera = description["camera"]
    look = mitsuba.ScalarTransform4f().look_at(origin=camera["eye"], target=camera["target"], up=[0, 1, 0])
    parts = {"type": "scene",
             "integrator": {"type": "path", "max_depth": depth},
             "sensor": {"type": "perspective", "fov": camera["fov"], "fov_axis": "y", "to_world": look,
                        "film": {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"},
                                 "pixel_format": "rgb"}},
             "light": {"type": "point", "position": description["light"]["position"],
                       "intensity": {"type": "rgb", "value": [description["light"]["candela"]] * 3}}}
    for name, bsdf in description["surfaces"].items():
        parts[name] = {"type": "ply", "filename": f"{name}.ply", "bsdf": bsdf}
    return mitsuba.load_dict(parts)


def main() -> None:
    width, height, spp, depth, threads = (int(word) for word in sys.argv[2:7])
    with open(sys.argv[1], encoding="utf-8") as file:
        description = json.load(file)
    drjit.set_thread_count(threads)
    scene = scene_of(description, width, height, depth)
    clock, cpu = time.perf_counter(), time.process_time()
    picture = mitsuba.render(scene, spp=spp)
    drjit.eval(picture)
    seconds, cpu_s = time.perf_counter() - clock, time.process_time() - cpu
    mitsuba.util.write_bitmap(sys.argv[7], picture)
    print(json.dumps({"samples": width * height * spp, "seconds": seconds, "cpu_s": cpu_s, "version": mitsuba.__version__}))


if __name__ == "__main__":
    main()
