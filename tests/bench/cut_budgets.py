#!/usr/bin/env python3
"""Prints how near pictures come to exact order, against the triangles that cutting crossings may add.

usage: tests/bench/cut_budgets.py SOURCE [RECIPE [BUILD_FOLDER [PERCENT...]]]     (none: "", build/release, 0 2 5 10 15)

Each row is a cook of the source with another "order.cut_budget"; decibels are what the cook expects of its own pictures, median and
worst of the views at rest and median of those in motion. `gain` is what it expects of the cuts alone, from how often two
triangles change places in a picture.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def recipe_text(path):
    """Without comments, which JSON has none of."""
    text = pathlib.Path(path).read_text() if path else "{}"
    return json.loads(re.sub(r"^\s*//.*$", "", text, flags=re.M))


def cook(coif, source, recipe, folder):
    # Beside the real one, for what it names.
    home = pathlib.Path(recipe["path"]).resolve().parent if recipe["path"] else folder
    values = dict(recipe["values"])
    with tempfile.NamedTemporaryFile("w", suffix=".json", dir=home) as file:
        json.dump(values, file)
        file.flush()
        report = folder / "report.json"
        subprocess.run([coif, "cook", source, "-o", folder / "out.coif", "--recipe", file.name, "--report", report],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads(report.read_text())


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    source = sys.argv[1]
    path = sys.argv[2] if len(sys.argv) > 2 else ""
    build = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else "build/release").resolve()
    percents = [float(p) for p in sys.argv[4:]] or [0, 2, 5, 10, 15]
    values = recipe_text(path)
    print(f"{'budget':>7}{'added':>8}{'':>8}{'cuts':>6}{'crossings':>11}{'dB':>7}{'median':>8}{'worst':>7}{'moving':>8}"
          f"{'gain':>6}{'cook':>9}")
    with tempfile.TemporaryDirectory() as name:
        for percent in percents:
            order = {**values.get("order", {}), "cut_budget": percent / 100}
            report = cook(build / "tools/cli/coif", source, {"path": path, "values": {**values, "order": order}},
                          pathlib.Path(name))
            found = report["draw_order"]
            whole = report["triangles"] - found["triangles_added"]
            seconds = sum(p["ms"] for p in report["passes"]) / 1000
            print(f"{percent:5.0f} %{found['triangles_added']:8}{100 * found['triangles_added'] / whole:6.1f} %"
                  f"{found['cuts']:6}{found['crossings']:11}{found['psnr_db']:7.1f}{found['median_psnr_db']:8.1f}"
                  f"{found['worst_psnr_db']:7.1f}{found['moving_psnr_db']:8.1f}{found['cut_gain_db']:6.2f}{seconds:7.1f} s",
                  flush=True)


if __name__ == "__main__":
    main()
