#!/usr/bin/env python3
"""Makes true pictures of grown hair and says how far coif's are from them.

    make_truth.py COIF FOLDER [--style NAME]... [--color NAME]... [--view NAME]... [--pixels N] [--samples N] [--blender BLENDER] [--keep]
                  [--most-tone SHARE] [--least-outline SHARE]

For each style of styles.json: FOLDER/STYLE.hair (white strands on the portrait), STYLE.coif, and FOLDER/STYLE/ with the path-traced pictures
and truth.json; then `coif report STYLE.coif picture --truth FOLDER/STYLE`, whose page is FOLDER/STYLE.html. --keep: pictures that are there
are not made again. The last two say what of a style's total fails. 1,024 pixels with 32 samples take about ten minutes a picture on two cores, 256 with 16 twenty seconds.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PORTRAIT = HERE.parent.parent / "sample_assets" / "portrait" / "portrait.glb"
COLORS = {"blond": [0.60, 0.42, 0.23], "brown": [0.18, 0.085, 0.04], "red": [0.36, 0.10, 0.03], "black": [0.02, 0.016, 0.014]}
VIEWS = {"front": "0,2", "left": "30,4", "right": "-50,0", "side": "90,6", "back": "160,10", "above": "20,45"}
STUDIO_SKY = 0.065  # as in trace_strands.py
STRANDS, WIDTH = 30000, 0.0002
HEAD = {"shape": "ellipsoid", "center": [0.0, 1.63, -0.012], "radii": [0.0745, 0.09, 0.096]}


def run(*command):
    # Blender's Python takes the modules that lie beside the first python3 of PATH, and wants the system's.
    path = {**os.environ, "PATH": "/usr/bin:/bin:" + os.environ.get("PATH", "")}
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=path)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in command)}\n{done.stdout[-2000:]}{done.stderr[-4000:]}")
    return done.stdout


def recipe_of(style):
    grow = {**style["grow"], "strands": STRANDS, "width": WIDTH, "root_color": [1, 1, 1], "tip_color": [1, 1, 1], "color_random": 0}
    return {"grow": grow, "cards": {"body": str(PORTRAIT), "triangles": 20000}, "head": HEAD, "order": {"method": "head"},
            "lods": {"levels": 1}, "material": {"shading": "volume"}}


def camera_of(coif, asset, view, pixels, folder):
    """The camera and the lights, as coif itself would have them."""
    printed = run(coif, "render", asset, "--view", view, "--size", f"{pixels}x{pixels}", "--samples", 1, "--format", "json", "-o",
                  folder / "camera.png")
    (folder / "camera.png").unlink()
    picture = json.loads(printed)
    return picture["camera"], picture["lights"]


def scenes_of(picture, color, view):
    """What truth.json says of one path-traced picture: each light alone, an even sky alone, and all together."""
    by_name = {light["name"]: light for light in picture["lights"]}
    lights = {"key": ([by_name["key"]], 0), "rim": ([by_name["rim"]], 0), "sky": ([], 1), "studio": (picture["lights"], STUDIO_SKY)}
    return [{"view": view, "color": color, "light": light, "pictures": [f"{picture['name']}.{light}.{seed}.exr" for seed in (1, 2)],
             "camera": picture["camera"], "lights": own, "sky": [sky] * 3, "base_color": picture["base_color"]}
            for light, (own, sky) in lights.items()]


def is_traced(folder, picture):
    return all((folder / f"{picture['name']}.studio.{seed}.exr").exists() for seed in (1, 2))


def make(options, name, style):
    folder = options.folder / name
    folder.mkdir(parents=True, exist_ok=True)
    recipe, hair, asset = options.folder / f"{name}.recipe.json", options.folder / f"{name}.hair", options.folder / f"{name}.coif"
    recipe.write_text(json.dumps(recipe_of(style), indent=2))
    if not (options.keep and hair.exists()):
        run(options.coif, "grow", "--recipe", recipe, "-o", hair)
    run(options.coif, "cook", hair, "--recipe", recipe, "-o", asset)
    pictures, scenes = [], []
    for view in options.view or VIEWS:
        camera, lights = camera_of(options.coif, asset, VIEWS[view], options.pixels, folder)
        for color in options.color or COLORS:
            picture = {"name": f"{view}_{color}", "size": [options.pixels] * 2, "base_color": COLORS[color], "camera": camera,
                       "lights": lights}
            pictures.append(picture)
            scenes += scenes_of(picture, color, view)
    missing = [picture for picture in pictures if not (options.keep and is_traced(folder, picture))]
    if missing:
        job = {"strands": str(hair), "body": str(PORTRAIT), "folder": str(folder), "samples": options.samples, "pictures": missing}
        (folder / "job.json").write_text(json.dumps(job))
        run(options.blender, "-b", "--factory-startup", "--python-exit-code", 3, "--python", HERE / "trace_strands.py", "--",
            folder / "job.json")
    (folder / "truth.json").write_text(json.dumps({"scenes": scenes}, indent=1))
    report = ["report", asset, "picture", "--truth", folder, "--body", PORTRAIT, "-o", options.folder / f"{name}.html"]
    if options.most_tone is None and options.least_outline is None:
        print(run(options.coif, *report))
        return []
    found = json.loads(run(options.coif, *report, "--format", "json"))
    print(found["finding"])
    total = found["totals"][0]
    faults = []
    if options.most_tone is not None and not total["tone"] <= options.most_tone:
        faults.append(f"{name}: tone is {total['tone']:.3f}, above {options.most_tone}")
    if options.least_outline is not None and not total["outline"] >= options.least_outline:
        faults.append(f"{name}: outline is {total['outline']:.3f}, below {options.least_outline}")
    return faults


def main():
    styles = json.loads((HERE / "styles.json").read_text())
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coif", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--style", action="append", choices=styles)
    parser.add_argument("--color", action="append", choices=COLORS)
    parser.add_argument("--view", action="append", choices=VIEWS)
    parser.add_argument("--pixels", type=int, default=1024)
    parser.add_argument("--samples", type=int, default=32)
    parser.add_argument("--blender", default="blender")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--most-tone", type=float)
    parser.add_argument("--least-outline", type=float)
    options = parser.parse_args()
    options.folder = options.folder.resolve()
    faults = [fault for name in options.style or styles for fault in make(options, name, styles[name])]
    if faults:
        sys.exit("\n".join(faults))


main()
