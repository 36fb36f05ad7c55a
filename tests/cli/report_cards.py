#!/usr/bin/env python3
"""`coif report cards`: cards beside the strands that they stand for.

usage: report_cards.py CASE PROGRAM FOLDER
"""
import json
import shutil
import sys
from pathlib import Path

from cook_strands import RECIPE, Bench, obj, strands, tfx

QUICK = ("--directions", "4", "--size", "64x64")


def cooked(bench, made=None):
    """a.tfx and what is cooked of it, a.coif."""
    bench.write("a.tfx", tfx(made or strands(200)))
    bench.write("a.recipe.json", {**RECIPE, "cards": {"triangles": 300, "texels": 65536}})
    done = bench.coif("cook", "a.tfx", "-o", "a.coif", "--draft")
    assert done.returncode == 0, done.stderr


def report(bench, budgets, source="a.tfx", *words):
    done = bench.coif("report", "a.coif", "cards", "--source", source, "--format", "json", "--budgets", budgets, *QUICK, *words)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def of_hundred_triangles(found):
    """What is the same in every run."""
    for summary in found["summary"]:
        assert summary.pop("seconds") > 0, summary
    return [row for name in ("rows", "summary") for row in found[name] if row["triangles"] == 100]


def figures_are_complete_and_repeat(bench):
    cooked(bench)
    found = report(bench, "100,300")
    assert found["is_its_source"] and found["strands"] == 200 and found["left_out"] == [], found
    ways = {(row["baseline"], row["triangles"], tuple(row["direction"])) for row in found["rows"]}
    assert len(ways) == len(found["rows"]) == 3 * 2 * 4, len(found["rows"])
    assert {way[0] for way in ways} == {"none", "kmeans", "even"}
    for row in found["rows"]:
        assert 0.2 < row["coverage_iou"] <= 1 and row["psnr_db"] > 5 and row["texels"] == 65536, row
    own = next(s for s in found["summary"] if s["baseline"] == "none" and s["triangles"] == 300)
    asset = found["asset_levels"][0]
    assert asset["triangles"] == own["made_triangles"], (asset, own)
    assert abs(asset["mean_coverage_iou"] - own["mean_coverage_iou"]) < 0.05, (asset, own)
    again = report(bench, "100")
    assert of_hundred_triangles(found) == of_hundred_triangles(again) and len(again["rows"]) == 3 * 4
    # The same strands as another file are the same hair.
    bench.write("b.obj", obj(strands(200)))
    other = report(bench, "100", "b.obj", "--recipe", "a.recipe.json")
    assert not other["is_its_source"]
    assert abs(other["asset_levels"][0]["mean_coverage_iou"] - asset["mean_coverage_iou"]) < 0.02, other["asset_levels"]


def a_page_has_contact_sheets(bench):
    cooked(bench)
    done = bench.coif("report", "a.coif", "cards", "--source", "a.tfx", "-o", "out.html", "--budgets", "300", *QUICK)
    assert done.returncode == 0, done.stderr
    assert "\n  kmeans " in done.stdout and "With 300 triangles coif's cards have coverage IoU 0." in done.stdout, done.stdout
    page = (bench.folder / "out.html").read_text()
    assert page.count("data:image/png;base64,") == 4 and page.count("<svg") == 4
    for words in ("From the front.", "From the back.", "What did the cook keep?", "RMS error"):
        assert words in page, words


def what_cannot_be_compared_is_refused(bench):
    cooked(bench)
    bench.write("strips.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    bench.write("far.tfx", tfx([[(x + 3, y, z) for x, y, z in strand] for strand in strands(50)]))
    bench.write("notes.txt", b"no strands")
    source = ("a.coif", "cards", "--source")
    for words, code, wanted in (
            (("a.coif", "cards"), 1, "name those that the asset was cooked from: --source GROOM"),
            ((*source, "notes.txt"), 1, "--source: notes.txt is no file of strands; name one that is: .hair, .tfx, .obj"),
            ((*source, "absent.tfx"), 2, "absent.tfx: "),
            ((*source, "strips.obj"), 3, "strips.obj: cannot be read as lines of a Wavefront OBJ: "),
            ((*source, "far.tfx", "--recipe", "a.recipe.json"), 3, "a.coif: was cooked from other strands than those of far.tfx: its hair is "),
            ((*source, "a.tfx", "--size", "64x48"), 1, "--size: pictures of cards are as wide as high"),
            ((*source, "a.tfx", "--size", "2000x2000"), 1, "pictures of 16 to 1024 pixels"),
            ((*source, "a.tfx", "--budgets", "1"), 1, "--budgets"),
            (("a.coif", "cost", "--source", "a.tfx"), 1, "--source is for 'coif report FILE.coif cards' only; leave it out")):
        done = bench.coif("report", *words, *(() if "--size" in words or "cost" in words else ("--directions", "2")))
        assert done.returncode == code and wanted in done.stderr, (words, done.returncode, done.stderr)


CASES = {f.__name__: f for f in (figures_are_complete_and_repeat, a_page_has_contact_sheets, what_cannot_be_compared_is_refused)}


def main(case, program, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    CASES[case](Bench(program, folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
