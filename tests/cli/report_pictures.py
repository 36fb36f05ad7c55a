#!/usr/bin/env python3
"""`coif report picture` beside pictures that coif itself draws: there is nothing between them, and what is changed is found.

usage: report_pictures.py PROGRAM ASSET FOLDER
"""
import json
import shutil
import sys
from pathlib import Path

import jsonschema

from cook_strands import Bench

AMBIENT = 0.09  # the recipe's default, which the sample has


def drawn(bench, asset, name, *words):
    done = bench.coif("render", asset, "--size", "96x96", "--samples", "16", "--backdrop", "clear", "--format", "json", "-o", name, *words)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def report(bench, asset, *words):
    done = bench.coif("report", asset, "picture", "--truth", ".", *words)
    assert done.returncode == 0, done.stderr
    return done.stdout


def keeps_to_its_schema(found):
    schema = json.loads(Path(__file__).parents[2].joinpath("tools/report/reports.schema.json").read_text())
    faults = [error.message for error in jsonschema.Draft202012Validator(schema).iter_errors(found)]
    assert not faults and found["report"] == "picture", faults


def main(program, asset, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    bench = Bench(program, folder)
    picture = drawn(bench, asset, "a.exr", "--view", "25,10")
    bench.write("camera.json", picture)
    again = drawn(bench, asset, "b.exr", "--camera", "camera.json")
    assert again["camera"] == picture["camera"], "a camera that was printed is taken as it is"
    assert folder.joinpath("a.exr").read_bytes()[:4] == bytes.fromhex("762f3101"), "OpenEXR"
    scene = {"view": "left", "color": "own", "light": "studio", "pictures": ["a.exr", "b.exr"], "camera": picture["camera"],
             "lights": picture["lights"], "sky": [AMBIENT] * 3}
    dim = {**scene, "light": "dim", "sky": [0, 0, 0], "lights": picture["lights"][:1]}
    bench.write("truth.json", {"scenes": [scene, dim]})

    found = json.loads(report(bench, asset, "--format", "json"))
    keeps_to_its_schema(found)
    rows = {row["light"]: row for row in found["rows"] if row["size"] == 96}
    same, dimmer = rows["studio"], rows["dim"]
    assert same["tone"] < 0.03 and abs(same["bias"]) < 0.02, same
    assert all(0.9 < same[f"grain_{pixels}"] < 1.1 for pixels in (1, 2, 4, 8)), same
    assert dimmer["tone"] > 0.1 and dimmer["bias"] < -0.1, dimmer
    assert {row["size"] for row in found["rows"]} == {96, 24}, "at a quarter, too"
    assert "tone is off by" in found["finding"], found["finding"]

    report(bench, asset, "-o", "page.html")
    page = folder.joinpath("page.html").read_text()
    assert page.count('"png":"iVBOR') == 2 and "Truth beside coif" in page

    folder.joinpath("b.exr").write_bytes(folder.joinpath("a.exr").read_bytes()[:99])
    done = bench.coif("report", asset, "picture", "--truth", ".")
    assert done.returncode == 3 and "b.exr" in done.stderr, done.stderr


main(*sys.argv[1:])
