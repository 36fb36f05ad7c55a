#!/usr/bin/env python3
"""Compares `coif validate --warnings-as-errors` and `coif cook --warnings-as-errors`: they end with the same exit code, and their JSON has
the same codes.

  verbs_agree.py drawn|all COIF FOLDER SAMPLES SHARED...

drawn: the smallest sample and small files of SHARED, within 20 s; all: every sample, model and strand file, which takes an hour. A folder of
SHARED may be absent: then there is less to compare. FOLDER is for the assets that are cooked.
"""

import concurrent.futures
import json
import os
import random
import subprocess
import sys
import time
from pathlib import Path

SUFFIXES = {".fbx", ".obj", ".dae", ".glb", ".gltf", ".vrm", ".hair", ".tfx"}
DRAWN_BYTES = 60_000
DRAWN_SECONDS = 6
SECONDS = {"drawn": 10, "all": 600}  # for each file and verb; what takes longer is not compared


def run(*arguments):
    done = subprocess.run(list(map(str, arguments)), capture_output=True)
    text = done.stdout.decode(errors="replace")
    try:
        return done.returncode, json.loads(text), done.stderr.decode(errors="replace")
    except json.JSONDecodeError:
        return done.returncode, {}, done.stderr.decode(errors="replace")


def counted_codes(result):
    """Codes of errors and warnings, without notes: a cook has those as sentences."""
    issues = result.get("issues", []) + result.get("folded", [])
    return {issue["code"] for issue in issues if issue["severity"] != "info"}


def compare(coif, path, folder, seconds):
    """None where the two agree, else what differs; "late" where there is nothing to compare."""
    options = ["--warnings-as-errors", "--format", "json", "--max-seconds", seconds]
    asset = folder / f"{abs(hash(str(path)))}.coif"
    validated, verdict, told = run(coif, "validate", path, *options)
    cooked, result, cook_told = run(coif, "cook", path, "-o", asset, "-q", "--threads", 1, *options)
    is_written = asset.exists()
    asset.unlink(missing_ok=True)
    if any(f"exceeded {seconds} s" in text for text in (told, cook_told)):
        return "late"
    if not verdict or not result:
        return f"no JSON: exit codes {validated} and {cooked}\n{told}\n{cook_told}"
    of_validate, of_cook = counted_codes(verdict["files"][0]), counted_codes(result)
    if validated != cooked or of_validate != of_cook:
        return f"validate {validated} {sorted(of_validate)}, cook {cooked} {sorted(of_cook)}"
    if is_written != (cooked == 0):
        return f"the cook ends with {cooked}, and {'an' if is_written else 'no'} asset is there"
    return None


def drawn(files):
    """Small files of all folders, in an order that is the same each time."""
    small = [path for path in files if path.stat().st_size < DRAWN_BYTES]
    random.Random(1).shuffle(small)
    return small


def main():
    part, coif, folder, samples, *shared = sys.argv[1:]
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    own = [path for path in sorted(Path(samples).rglob("*")) if path.suffix.lower() in SUFFIXES]
    files = []
    for place in map(Path, shared):
        if not place.is_dir():
            print(f"{place} does not exist: its files are not compared")
        files += sorted(path for path in place.rglob("*") if path.suffix.lower() in SUFFIXES)
    if part == "drawn":
        own = [min(own, key=lambda path: path.stat().st_size)]
        files = drawn(files)
    end = time.monotonic() + DRAWN_SECONDS

    def judge(path):
        if part == "drawn" and time.monotonic() > end:
            return path, "not reached"
        return path, compare(coif, path, folder, SECONDS[part])

    counts = {"agree": 0, "late": 0, "not reached": 0}
    faults = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, found in pool.map(judge, own + files):
            if found is None or found in counts:
                counts[found or "agree"] += 1
                if found == "late" and part == "all":
                    print(f"{path}: takes more than {SECONDS[part]} s, not compared")
            else:
                faults += 1
                print(f"{path}: {found}")
    print(f"{len(own + files)} files: {counts['agree']} agree, {faults} do not, {counts['late']} take too long, "
          f"{counts['not reached']} not tried")
    return 1 if faults > 0 or counts["agree"] == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
