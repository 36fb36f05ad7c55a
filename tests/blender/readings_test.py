"""The cook's reading of FBX, OBJ and COLLADA beside Blender's own: the same triangles, corner by corner.

    readings_test.py BLENDER PRINT_MODEL made      small files that Blender exports and text FBX files, made for this
    readings_test.py BLENDER PRINT_MODEL FOLDER    what lies there
    readings_test.py BLENDER PRINT_MODEL can_fail  that a difference of each kind is noticed
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import compare_readings

HERE = pathlib.Path(__file__).parent
SUFFIXES = {".fbx", ".obj", ".dae"}

# Distances as a part of the model's size, of a unit normal, of a UV, of a colour, of a whole weight. Blender keeps places, matrices and
# weights as floats; what a bone holds goes through the bone's head, tail and roll (5.8e-6 in the worst file); assimp's bind matrices are floats too,
# some with a scale of 0.01 (normals 9.5e-4). Normals of OBJ and COLLADA are two short angles in Blender (3.5e-4), colours of COLLADA bytes.
TOLERANCE = {"position": 1e-6, "held position": 1e-5, "normal": 1e-6, "held normal": 2e-3, "uv": 1e-6, "color": 1e-6, "weights": 1e-6}
OF_FORMAT = {".obj": {"normal": 2e-3}, ".dae": {"normal": 2e-3, "held normal": 2e-3, "color": 0.5 / 255}}

# What differs for a reason. A file whose reason does not hold any more fails.
REASONS = [
    (r"(71_geometric_parent|text_geometric_above)", "Blender hands a geometric transform on to children, against its own comment"),
    (r"text_post_rotation", "Blender turns by PostRotation, where FBX means its inverse"),
    (r"(75_lodgroup|b09_lods)", "coarser levels of detail are left out"),
    (r"b02_mapping_node\.fbx", "Blender reads the other way round what it wrote of a mapping node"),
    (r"b03_second_uv\.dae", "Blender does not follow <bind_vertex_input>, and takes the first UV map"),
    (r"b05_posed\.fbx", "bones turn normals here; the file's, which are compared, are not turned in Blender"),
    (r"cubes_with_outofrange_float", "assimp misreads numbers of 78 digits"),
    (r"box_orphant_embedded_texture", "Blender refuses an embedded image that is text"),
    (r"box_nested_animation_4286", "refused here: an accessor reads beyond its array"),
    (r"assimp/malformed\.obj", "refused here: a face of corners that are not there, which Blender leaves out"),
    (r"dae_segv", "assimp crashes, in its own process"),
    (r"fbx_old/UnityChan", "refused here: FBX 6.1, which assimp does not read to the end"),
]


class Rules:
    """What a format and Blender make of names and colours."""

    def __init__(self, suffix):
        self.suffix = suffix

    def color(self, values):
        # Blender's importer of FBX takes the file's numbers for linear ones where it is asked for floats.
        return [compare_readings.linear(x) for x in values[:3]] + [values[3]] if self.suffix == ".fbx" else values

    def bone(self, name, _theirs):
        return name


def read_by_blender(blender, paths):
    with tempfile.TemporaryDirectory() as folder:
        outs = [pathlib.Path(folder) / f"{i}.json" for i in range(len(paths))]

        def run(indices):
            files = [str(file) for i in indices for file in (paths[i], outs[i])]
            command = [blender, "-b", "--factory-startup", "--python-exit-code", "3", "--python", str(HERE / "read_in_blender.py"), "--", *files]
            return subprocess.run(command, capture_output=True, text=True, errors="replace")

        run(range(len(paths)))
        for i, out in enumerate(outs):
            if not out.exists():  # Blender ended before it.
                done = run([i])
                if not out.exists():
                    out.write_text(json.dumps({"error": f"Blender ended with {done.returncode}: {(done.stdout + done.stderr)[-300:]}"}))
        return [json.loads(out.read_text()) for out in outs]


def read_by_cook(print_model, path):
    return json.loads(subprocess.run([print_model, str(path)], capture_output=True, text=True, check=True).stdout)


def difference(ours, theirs, suffix):
    """What differs, or None; and the figures."""
    if "error" in ours and ("error" in theirs or not theirs["meshes"]):
        return None, "neither reads triangles of it"
    if "error" in ours:
        return f"refused here: {ours['error']}", "read by Blender alone"
    if "error" in theirs:
        return f"refused by Blender: {theirs['error']}", "read here alone"
    reading = compare_readings.compare(ours, theirs, Rules(suffix))
    limits = {**TOLERANCE, **OF_FORMAT.get(suffix, {})}
    faults = [f"{what} differs by {far:.2g} at {reading.where[what]}" for what, far in reading.far.items() if not far <= limits[what]]
    left_out = "".join(f", {n} {what}" for n, what in ((reading.twice, "that Blender has once"), (reading.degenerate, "without area")) if n)
    figures = f"{reading.triangles} triangles{left_out}; " + ", ".join(f"{what} {far:.1e}" for what, far in reading.far.items())
    return "; ".join(faults + reading.faults) or None, figures


def compare_all(blender, print_model, folder):
    paths = sorted(path for path in folder.rglob("*") if path.suffix.lower() in SUFFIXES and path.is_file())
    if not paths:
        raise SystemExit(f"no files to compare in {folder}")
    faults = []
    for path, theirs in zip(paths, read_by_blender(blender, paths)):
        name = path.relative_to(folder)
        text, figures = difference(read_by_cook(print_model, path), theirs, path.suffix.lower())
        reason = next((why for pattern, why in REASONS if re.search(pattern, str(path))), None)
        print(f"{name}: {figures}" + (f" ({reason})" if reason else ""), flush=True)
        if reason and not text:
            faults.append(f"{name}: '{reason}' is no reason any more")
        if text and not reason:
            faults.append(f"{name}: {text}")
    print(f"{len(paths)} files")
    return faults


def make_files(blender, folder):
    make = [blender, "-b", "--factory-startup", "--python-exit-code", "3", "--python", str(HERE / "make_files.py"), "--", folder]
    subprocess.run(make, check=True, stdout=subprocess.DEVNULL)


def unnoticed(blender, print_model, path):
    """Which differences from what Blender reads of a skinned file go unnoticed."""
    theirs = read_by_blender(blender, [path])[0]
    read = lambda: read_by_cook(print_model, path)["meshes"][0]

    def damaged(what, i, number):
        mesh = read()
        mesh[what][i] = number
        return mesh

    other_bone, without, turned = read(), read(), read()
    other_bone["influences"][4][0][0] = "no bone"
    without["triangles"] = without["triangles"][3:]
    turned["triangles"][:3] = turned["triangles"][2::-1]
    wrongs = {what: damaged(what, 7, read()[what][7] + 1e-3) for what in ("positions", "uvs", "colors")}
    wrongs |= {"normals": damaged("normals", 7, read()["normals"][7] + 0.01), "bones": other_bone, "triangles": without, "winding": turned}
    wrongs["wraps"] = {**read(), "material": {"name": "Hair", "texture": True, "wrap": ["repeat", "repeat"]}}
    if difference({"meshes": [read()]}, theirs, ".fbx")[0]:
        return ["the whole file"]
    return [f"unnoticed: {what}" for what, wrong in wrongs.items() if difference({"meshes": [wrong]}, theirs, ".fbx")[0] is None]


def main():
    blender, print_model, source = sys.argv[1:]
    if source in ("made", "can_fail"):
        with tempfile.TemporaryDirectory() as folder:
            make_files(blender, folder)
            if source == "made":
                faults = compare_all(blender, print_model, pathlib.Path(folder))
            else:
                faults = unnoticed(blender, print_model, pathlib.Path(folder) / "skinned_default.fbx")
    elif not pathlib.Path(source).is_dir():
        print(f"no corpus of artists' files: {source}")
        return
    else:
        faults = compare_all(blender, print_model, pathlib.Path(source))
    if faults:
        raise SystemExit("\n".join(faults))


main()
