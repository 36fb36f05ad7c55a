#!/usr/bin/env python3
"""Holds what `coif validate --format json` prints to verdicts.schema.json.

usage: schema_test.py check|can_fail SCHEMA COIF MODEL
check runs the program on good, bad, absent and much-faulted files; can_fail breaks its answer in ways the schema must see.
"""
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import jsonschema
except ImportError:
    sys.exit("no python3-jsonschema here (Debian: python3-jsonschema)")


def rags():
    """An OBJ of ten meshes without texture coordinates: more equal issues than are shown."""
    text = ""
    for i in range(10):
        text += f"o hair_{i}\nv 0 0 {i}\nv 0.1 0.2 {i}\nv 0.2 0 {i}\nf {3 * i + 1} {3 * i + 2} {3 * i + 3}\n"
    return text


def answer(coif, model, *options):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "rags.obj").write_text(rags())
        Path(folder, "notes.coif").write_text("this text is long enough for a header")
        done = subprocess.run([coif, "validate", "--format", "json", *options, model, "notes.coif", "rags.obj", "nope.coif"],
                              cwd=folder, capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout)


def faults(schema, value):
    return [error.message for error in jsonschema.Draft202012Validator(schema).iter_errors(value)]


def check(schema, coif, model):
    jsonschema.Draft202012Validator.check_schema(schema)
    bad = []
    for options in ([], ["--severity", "error"], ["--warnings-as-errors", "--ignore", "S204"], ["--max-issues", "100"]):
        code, value = answer(coif, model, *options)
        bad += [f"{options}: {fault}" for fault in faults(schema, value)]
        bad += [] if code == 2 else [f"{options}: exit code {code}, not 2"]
        bad += [] if len(value["files"]) == 4 else [f"{options}: {len(value['files'])} files, not 4"]
    folded = answer(coif, model)[1]["files"][2]["folded"]
    if folded != [{"code": "S203", "severity": "info", "count": 5}]:
        bad.append(f"ten equal issues of which five are shown fold to {folded}")
    return bad


def can_fail(schema, coif, model):
    good = answer(coif, model)[1]
    breaks = [lambda v: v.pop("files"),
              lambda v: v["files"][0].pop("valid"),
              lambda v: v["files"][1]["issues"][0].update(severity="fatal"),
              lambda v: v["files"][1]["issues"][0].update(code=103),
              lambda v: v["files"][1]["issues"][0].pop("cure"),
              lambda v: v["files"][1]["issues"][0].update(code="X103"),
              lambda v: v["files"][2]["folded"][0].update(count=0),
              lambda v: v["files"][3].update(errors=-1)]
    bad = []
    for number, change in enumerate(breaks):
        value = copy.deepcopy(good)
        change(value)
        if not faults(schema, value):
            bad.append(f"break {number} was not seen")
    return bad


def main():
    test, schema, coif, model = sys.argv[1:]
    problems = {"check": check, "can_fail": can_fail}[test](json.loads(Path(schema).read_text()), coif, model)
    print("\n".join(problems) or "fits")
    return 1 if problems else 0


sys.exit(main())
