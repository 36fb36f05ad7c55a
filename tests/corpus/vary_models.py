#!/usr/bin/env python3
"""Makes variants of labelled .glb, .vrm and .obj files that lack evidence, or have another attitude or shape.

usage: vary_models.py FOLDER OUT

FOLDER has a TRUTH.json (judge.py explains it); OUT gets one, too, of the variants FOLDER~KIND/FILE. Kinds: unnamed
(meshes, materials and images have neutral names), nobones (bones have), nonames (both), alone (hair without a body),
alone_nonames, alone_loose (without skins as well), turned (by 180 degrees), mirrored, stretched (wider, lower, less
deep heads), scaled (100 or 10 times as large), nouv. Exit code 77 where FOLDER is absent.
"""
import copy
import json
import struct
import sys
from pathlib import Path

JSON_CHUNK = 0x4E4F534A
STRETCH = (1.12, 0.94, 0.9)


def read(path):
    data = path.read_bytes()
    length, kind = struct.unpack_from("<II", data, 12)
    if data[:4] != b"glTF" or kind != JSON_CHUNK:
        raise ValueError("no GLB")
    return json.loads(data[20:20 + length]), data[20 + length:]


def write(path, document, rest):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), JSON_CHUNK) + text + rest)


def rename_looks(document):
    for key, word in (("materials", "Material.%03d"), ("meshes", "Object_%d"), ("images", "image_%d"), ("textures", "tex_%d")):
        for number, entry in enumerate(document.get(key, [])):
            entry["name"] = word % number
    for number, node in enumerate(document["nodes"]):
        if "mesh" in node:
            node["name"] = "Object_%d" % number


def rename_bones(document):
    for number, node in enumerate(document["nodes"]):
        if "mesh" not in node:
            node["name"] = "Bone.%03d" % number
    for name in ("VRM", "VRMC_vrm", "VRMC_springBone"):  # these name the head and its springs
        document.get("extensions", {}).pop(name, None)
        document["extensionsUsed"] = [used for used in document.get("extensionsUsed", []) if used != name]
    if not document["extensionsUsed"]:
        del document["extensionsUsed"]


def drop_skins(document):
    document.pop("skins", None)
    document.pop("animations", None)
    for node in document["nodes"]:
        node.pop("skin", None)
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            for key in [key for key in primitive["attributes"] if key.startswith(("JOINTS", "WEIGHTS"))]:
                del primitive["attributes"][key]


def put_below(document, **transform):
    scene = document["scenes"][document.get("scene", 0)]
    document["nodes"].append({"name": "Root", "children": scene["nodes"], **transform})
    scene["nodes"] = [len(document["nodes"]) - 1]


def parts_of(document):
    """(node, primitive, names): names as TRUTH.json has them, mesh/material, of the node and of the mesh."""
    for node in document["nodes"]:
        for primitive in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            material = document["materials"][primitive["material"]].get("name", "") if "material" in primitive else ""
            names = (node.get("name", ""), document["meshes"][node["mesh"]].get("name", ""))
            yield node, primitive, {f"{name}/{material}" for name in names}


def keep_hair(document, hair):
    kept = {}
    for node, primitive, names in parts_of(document):
        if names & hair:
            kept.setdefault(id(node), []).append(primitive)
    for node in document["nodes"]:
        if "mesh" not in node:
            continue
        if id(node) in kept:
            document["meshes"].append({**document["meshes"][node["mesh"]], "primitives": kept[id(node)]})
            node["mesh"] = len(document["meshes"]) - 1
        else:
            del node["mesh"]
            node.pop("skin", None)


def changed(truth, scale):
    """The truth of a model whose axes are multiplied by `scale`; negative numbers turn or mirror it."""
    truth = copy.deepcopy(truth)
    at = lambda point: [c * s for c, s in zip(point, scale)]

    def box(corners):
        corners = [at(corner) for corner in corners]
        return [[min(c) for c in zip(*corners)], [max(c) for c in zip(*corners)]]

    for key in ("points", "not"):
        if key in truth.get("select", {}):
            truth["select"][key] = [at(point) for point in truth["select"][key]]
    if "head" in truth:
        truth["head"]["center"] = at(truth["head"]["center"])
        if isinstance(truth["head"].get("radii"), list):
            truth["head"]["radii"] = [abs(r) for r in at(truth["head"]["radii"])]
    for region in truth.get("moves", []) + truth.get("rigid", []):
        region["box"] = box(region["box"])
    if "down_in" in truth.get("roots", {}):
        truth["roots"]["down_in"]["box"] = box(truth["roots"]["down_in"]["box"])
    if "size_m" in truth:
        truth["size_m"] = [length * abs(scale[1]) for length in truth["size_m"]]
    if "any_size" in truth:  # the distance of the head from the ground, nearly
        truth["any_size"] *= abs(scale[1])
    if "faces" in truth and scale[2] < 0:
        truth["faces"] = "-Z" if truth["faces"] == "+Z" else "+Z"
    return truth


def vary_glb(path, truth, put):
    document, rest = read(path)

    def variant(kind, label, *edits):
        edited = copy.deepcopy(document)
        for edit in edits:
            edit(edited)
        put(kind, "glb", label, lambda out: write(out, edited, rest))

    variant("unnamed", truth, rename_looks)
    variant("nobones", truth, rename_bones)
    variant("nonames", truth, rename_looks, rename_bones)
    variant("mirrored", changed(truth, (-1, 1, 1)), lambda d: put_below(d, scale=[-1, 1, 1]))
    variant("stretched", changed(truth, STRETCH), lambda d: put_below(d, scale=list(STRETCH)))
    if path.suffix == ".glb":  # a VRM says which way it looks
        variant("turned", changed(truth, (-1, 1, -1)), lambda d: put_below(d, rotation=[0, 1, 0, 0]))
    if "any_size" not in truth:
        variant("scaled", truth, lambda d: put_below(d, scale=[100] * 3))
    hair = truth.get("select", {}).get("is")
    hair = set(hair) if isinstance(hair, list) else set()
    if any(names & hair for _, _, names in parts_of(document)):
        alone = lambda d: keep_hair(d, hair)
        variant("alone", truth, alone)
        variant("alone_nonames", truth, alone, rename_looks, rename_bones)
        if not document.get("skins"):  # else positions are those of the bind pose
            variant("alone_loose", truth, alone, drop_skins, rename_looks, rename_bones)


def vary_obj(path, truth, put):
    lines = path.read_text(errors="replace").splitlines()

    def scaled_by(scale):
        result = []
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                line = " ".join(["v"] + [repr(float(w) * s) for w, s in zip(words[1:4], scale)])
            elif words[:1] == ["vn"]:
                line = " ".join(["vn"] + [repr(float(w) / s) for w, s in zip(words[1:4], scale)])
            elif words[:1] == ["f"] and scale[0] * scale[1] * scale[2] < 0:
                line = " ".join(["f"] + words[:0:-1])
            result.append(line)
        return result

    def variant(kind, label, text):
        put(kind, "obj", label, lambda out: out.write_text("\n".join(text) + "\n"))

    variant("turned", changed(truth, (-1, 1, -1)), scaled_by((-1, 1, -1)))
    variant("mirrored", changed(truth, (-1, 1, 1)), scaled_by((-1, 1, 1)))
    variant("stretched", changed(truth, STRETCH), scaled_by(STRETCH))
    variant("scaled", truth, scaled_by((10,) * 3))
    plain = [" ".join(w.split("/")[0] for w in line.split()) if line.startswith("f ") else line for line in lines
             if not line.startswith(("vt ", "vn ", "g ", "o ", "usemtl", "mtllib"))]
    variant("nouv", truth, plain)


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    folder, out = map(Path, sys.argv[1:])
    if not (folder / "TRUTH.json").exists():
        print(f"SKIP: {folder} has no TRUTH.json")
        return 77
    made = {}
    for name, truth in sorted(json.loads((folder / "TRUTH.json").read_text()).items()):
        path = folder / name

        def put(kind, suffix, label, save):
            target = out / f"{path.parent.name}~{kind}" / f"{path.stem if 'name' not in kind else 'model'}.{suffix}"
            target.parent.mkdir(parents=True, exist_ok=True)
            save(target)
            for image in path.parent.glob("*.png"):
                (target.parent / image.name).write_bytes(image.read_bytes())
            made[f"{target.parent.name}/{target.name}"] = label

        if truth["hair"] and path.suffix in (".glb", ".vrm"):
            vary_glb(path, truth, put)
        elif truth["hair"] and path.suffix == ".obj":
            vary_obj(path, truth, put)
    (out / "TRUTH.json").write_text(json.dumps(made))
    print(f"{len(made)} variants in {out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
