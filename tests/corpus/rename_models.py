#!/usr/bin/env python3
"""Makes stress variants of .glb and .vrm files: what if nobody named anything, or there are no bones?

usage: rename_models.py FOLDER OUT

FOLDER has a TRUTH.json. For each file OUT gets NAME.names.glb, where meshes, materials, images and the nodes of meshes
have neutral names; NAME.bare.glb, where bones have, too; and NAME.skinless.glb, where skins and springs are dropped as
well. Shapes stay, so that the truth holds. Exit code 77 where FOLDER is absent.
"""
import json
import struct
import sys
from pathlib import Path

JSON_CHUNK = 0x4E4F534A


def read(path):
    data = path.read_bytes()
    length, kind = struct.unpack_from("<II", data, 12)
    if data[:4] != b"glTF" or kind != JSON_CHUNK:
        raise ValueError("no GLB")
    return json.loads(data[20:20 + length]), data[20 + length:]


def write(path, document, rest):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), JSON_CHUNK) + text + rest)


def neutral(document, bones_too):
    for key, word in (("meshes", "Mesh_"), ("materials", "Material."), ("images", "Image_"), ("textures", "Texture_")):
        for number, entry in enumerate(document.get(key, [])):
            entry["name"] = f"{word}{number:03}"
    for number, node in enumerate(document.get("nodes", [])):
        if "mesh" in node or bones_too:
            node["name"] = f"Node_{number:03}"
    for skin in document.get("skins", []):
        skin.pop("name", None)
    if bones_too:  # VRM names the head and its springs in an extension.
        drop_extensions(document)


def drop_extensions(document):
    for name in ("VRM", "VRMC_vrm", "VRMC_springBone"):
        document.get("extensions", {}).pop(name, None)
        document["extensionsUsed"] = [used for used in document.get("extensionsUsed", []) if used != name]
    if not document["extensionsUsed"]:
        del document["extensionsUsed"]


def skinless(document):
    document.pop("skins", None)
    document.pop("animations", None)
    for node in document.get("nodes", []):
        node.pop("skin", None)
    for mesh in document.get("meshes", []):
        for primitive in mesh["primitives"]:
            for key in ("JOINTS_0", "WEIGHTS_0", "JOINTS_1", "WEIGHTS_1"):
                primitive["attributes"].pop(key, None)


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    folder, out = map(Path, sys.argv[1:])
    if not (folder / "TRUTH.json").exists():
        print(f"SKIP: {folder} has no TRUTH.json")
        return 77
    for name in sorted(json.loads((folder / "TRUTH.json").read_text())):
        if not name.endswith((".glb", ".vrm")):
            continue
        for kind in ("names", "bare", "skinless"):
            document, rest = read(folder / name)
            neutral(document, kind != "names")
            if kind == "skinless":
                skinless(document)
            write(out / f"{name}.{kind}.glb", document, rest)
    return 0


if __name__ == "__main__":
    sys.exit(main())
