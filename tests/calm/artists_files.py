#!/usr/bin/env python3
"""Cooks the artists' files as drafts and this project's samples whole, and looks whether hair of heads that are held comes to rest.

  artists_files.py drawn|all COIF COIF_HOLD_HEADS HAIR SAMPLES

drawn: two ways to run each asset; all: every way, which takes ten minutes. HAIR may be absent: then the samples are all there is.
"""

import pathlib
import subprocess
import sys
import tempfile

SUFFIXES = {".vrm", ".glb", ".gltf", ".fbx", ".obj", ".dae"}
REFUSED = (3, 5)  # exit codes of a cook that finds no hair, or nothing that it can use


def sources(hair, samples):
    found = [samples / "bob/bob.glb", samples / "long/long.glb"]
    if hair.is_dir():
        found += sorted(path for path in hair.rglob("*") if path.suffix.lower() in SUFFIXES)
    else:
        print(f"skipped: {hair} does not exist")
    return found


def cook(coif, source, samples, folder):
    asset = pathlib.Path(folder) / f"{source.stem}.coif"
    # A draft of `long` keeps the numbers that have no one motion, which a whole cook mends.
    draft = [] if samples in source.parents else ["--draft"]
    done = subprocess.run([coif, "cook", source, "-o", asset, "-q"] + draft, capture_output=True, text=True)
    if done.returncode in REFUSED:
        print(f"{source.name}: refused")
        return None
    if done.returncode != 0:
        sys.exit(f"{source}: exit code {done.returncode}\n{done.stderr}")
    return asset


def main():
    ways, coif, hold_heads, hair, samples = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        samples = pathlib.Path(samples)
        assets = [cook(coif, source, samples, folder) for source in sources(pathlib.Path(hair), samples)]
        assets = [asset for asset in assets if asset]
        held = subprocess.run([hold_heads] + (["--drawn"] if ways == "drawn" else []) + assets)
    print(f"{len(assets)} assets")
    return held.returncode


if __name__ == "__main__":
    sys.exit(main())
