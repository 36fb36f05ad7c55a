#!/usr/bin/env python3
"""`coif report cards`: cards beside the strands that they stand for. In two runs, since making cards takes long.

usage: report_cards.py PROGRAM FOLDER
"""
import json
import shutil
import sys
from pathlib import Path

import jsonschema

from cook_strands import RECIPE, Bench, obj, strands, tfx


def report(bench, *words):
    done = bench.coif("report", "a.coif", "cards", "--format", "json", "--directions", "4", "--size", "64x64", *words)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def figures_are_complete(found):
    """Of a.tfx, with 300 triangles. Returns the asset's."""
    assert found["is_its_source"] and found["strands"] == 200 and found["left_out"] == [], found
    ways = {(row["baseline"], row["triangles"], tuple(row["direction"])) for row in found["rows"]}
    assert len(ways) == len(found["rows"]) == 3 * 4, len(found["rows"])
    assert {way[0] for way in ways} == {"none", "kmeans", "even"}
    for row in found["rows"]:
        assert 0.2 < row["coverage_iou"] <= 1 and row["psnr_db"] > 5 and row["texels"] == 65536, row
    own = next(s for s in found["summary"] if s["baseline"] == "none" and s["triangles"] == 300)
    asset = found["asset_levels"][0]
    assert asset["triangles"] == own["made_triangles"], (asset, own)
    assert abs(asset["mean_coverage_iou"] - own["mean_coverage_iou"]) < 0.05, (asset, own)
    return asset


def keeps_to_its_schema(found):
    schema = json.loads(Path(__file__).parents[2].joinpath("tools/report/reports.schema.json").read_text())
    faults = [error.message for error in jsonschema.Draft202012Validator(schema).iter_errors(found)]
    assert not faults and found["report"] == "cards", faults


def page_has_pictures(page):
    assert page.count('"png":"iVBOR') == 4 and page.count('{"chart":') + page.count('"chart": {') == 4
    for words in ("From the front.", "From the back.", "What did the cook keep?", "RMS error"):
        assert words in page, words


def main(program, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    bench = Bench(program, folder)
    made = strands(200)
    bench.write("a.tfx", tfx(made))
    bench.write("b.obj", obj(made))
    bench.write("a.recipe.json", {**RECIPE, "cards": {"triangles": 300, "texels": 65536}})
    done = bench.coif("cook", "a.tfx", "-o", "a.coif", "--draft")
    assert done.returncode == 0, done.stderr

    found = report(bench, "--source", "a.tfx", "--budgets", "300", "-o", "out.html")
    keeps_to_its_schema(found)
    asset = figures_are_complete(found)
    page_has_pictures((folder / "out.html").read_text())
    # The same strands in another file are the same hair.
    other = report(bench, "--source", "b.obj", "--recipe", "a.recipe.json", "--budgets", "100", "--ablation")
    keeps_to_its_schema(other)
    assert len(other["ablation"]) == 12 and found["ablation"] == [], other["ablation"]
    assert not other["is_its_source"]
    assert abs(other["asset_levels"][0]["mean_coverage_iou"] - asset["mean_coverage_iou"]) < 0.02, other["asset_levels"]


if __name__ == "__main__":
    main(*sys.argv[1:])
