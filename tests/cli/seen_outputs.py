#!/usr/bin/env python3
"""What users see of the program, as one line per output: SHA-256 and name.

  tests/cli/seen_outputs.py COIF WRITE_GOLDEN [ASSETS [PROJECT]] > before.txt

COIF is the program, WRITE_GOLDEN tests/golden's writer beside it, ASSETS a folder with artists' files in hair/ and
same_hair/ (left out where absent), PROJECT the checkout whose samples are cooked, by default this one. Two builds whose
lists are equal cook the same bytes, simulate and draw the same, print the same help and messages, and give the same keys
in every report. Numbers of reports are not compared: times are among them.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

MODELS = {".fbx", ".glb", ".gltf", ".vrm", ".obj", ".dae"}
VERBS = "cook validate info simulate render gallery compare report strip cache".split()
MOTIONS = "nod turn charge run jump tumble teleport".split()
SHORT = {
    "accuracy": "--motion nod --fps 30,60 --substeps 1 --seconds 0.5".split(),
    "stability": "--solver coif,thesis".split(),
    "cost": "--heads 1,10 --time 0.3 --size 32x24 --table1".split(),
    "order": "--size 48x48 --views 4 --orbit 3".split(),
    "shadows": "--map-size 128 --spacing 0.01".split(),
}


def say(name, data):
    print(hashlib.sha256(data).hexdigest(), name, flush=True)


def run(*arguments, folder=None):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, cwd=folder, check=False)
    return done.returncode, done.stdout, done.stderr


def key_paths(value, path=""):
    """Every key of a document, lists' elements taken together."""
    if isinstance(value, dict):
        return {p for key, inner in value.items() for p in {f"{path}.{key}"} | key_paths(inner, f"{path}.{key}")}
    if isinstance(value, list):
        return {p for inner in value for p in key_paths(inner, path + "[]")}
    return set()


def without_times(text):
    return re.sub(rb"\d+(\.\d+)? (ms|s)\b|\"ms\": [\d.e+-]+", b"T", text)


def main():
    coif, golden = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    assets = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    project = pathlib.Path(__file__).resolve().parents[2]
    if len(sys.argv) > 4:
        project = pathlib.Path(sys.argv[4]).resolve()
    samples = [project / "sample_assets" / name / f"{name}.glb" for name in ("bob", "long")]
    sources = list(samples)
    bad = []
    if assets:
        for folder in ("hair", "same_hair"):
            sources += sorted(p for p in (assets / folder).rglob("*") if p.suffix.lower() in MODELS)
        bad = sorted(p for p in (assets / "bad").rglob("*") if p.suffix.lower() in MODELS)
    root = assets or project

    for verb in [""] + VERBS:
        say(f"help/{verb or 'coif'}", run(coif, *([verb] if verb else []), "--help")[1])
    say("recipe", run(coif, "cook", "--print-recipe")[1])
    say("codes", run(coif, "validate", "--list-codes")[1])

    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)

        def hide(text):
            for folder in (place, root, project):
                text = text.replace(str(folder).encode(), b"")
            return without_times(text)

        cooked = []
        for source in sources:
            name = str(source.relative_to(root) if source.is_relative_to(root) else source.name)
            out = place / (name.replace("/", "_") + ".coif")
            report = place / "report.json"
            code, text, errors = run(coif, "cook", source, "-o", out, "--report", report)
            say(f"cook/{name} exit {code}", out.read_bytes() if out.exists() else b"")
            say(f"cook/{name} text", hide(text))
            say(f"cook/{name} messages", hide(errors))
            if report.exists():
                what = json.loads(report.read_text())
                what["passes"] = None
                say(f"cook/{name} report", hide(json.dumps(what, sort_keys=True).encode()))
                report.unlink()
            if out.exists():
                cooked.append((name, out))
        for name, out in cooked:
            say(f"info/{name}", run(coif, "info", out.name, folder=place)[1])
            say(f"validate/{name}", run(coif, "validate", out.name, "--format", "json", folder=place)[1])
            for motion in MOTIONS if len(cooked) < 4 or name.startswith(("bob", "hair/seedsan", "hair/god")) else ["turn"]:
                run(coif, "simulate", out, "--motion", motion, "-o", place / "m.csv")
                say(f"simulate/{name} {motion}", (place / "m.csv").read_bytes())
        run(coif, "simulate", cooked[0][1], "--motion", "turn", "-o", place / "m.glb")
        say("simulate/bob glb", (place / "m.glb").read_bytes())
        run(coif, "simulate", cooked[0][1], "--motion", "turn", "--solver", "thesis", "-o", place / "m.csv")
        say("simulate/bob thesis", (place / "m.csv").read_bytes())
        for source in bad:
            code, text, errors = run(coif, "cook", source, "-o", place / "bad.coif")
            say(f"bad/{source.relative_to(root)} exit {code}", hide(text) + hide(errors))

        pictures = place / "golden"
        pictures.mkdir()
        run(golden, cooked[0][1], pictures)
        for picture in sorted(pictures.iterdir()):
            say(f"golden/{picture.name}", picture.read_bytes())
        for subject, options in SHORT.items():
            code, text, errors = run(coif, "report", cooked[0][1], subject, *options, "--format", "json")
            paths = sorted(key_paths(json.loads(text))) if code == 0 else [errors.decode()]
            say(f"report/{subject} {len(paths)} keys", "\n".join(paths).encode())


main()
