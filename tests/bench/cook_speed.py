#!/usr/bin/env python3
"""Prints how long `coif cook` takes from a thousand to a million triangles, and where the time goes.

usage: tests/bench/cook_speed.py [BUILD_FOLDER [RUNS]]     (build/release, 3)

The models are the sample with more quads per strip ("fine"), and with more strips ("many"). Times are medians in
milliseconds, import included; the exponent is that of growth from the row before.
"""
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

SIZES = [("fine", quads, 1) for quads in ("0.65", "1.92", "5.9", "18.7")] + [("many", "1", copies) for copies in (4, 35, 350)]


def cook(build, model, threads, folder):
    report = folder / "report.json"
    command = [build / "tools/cli/coif", "cook", model, "-o", folder / "out.coif", "--report", report,
               "--threads", str(threads)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads(report.read_text())


def median_run(build, model, threads, folder, runs):
    """The run with the median total, and that total."""
    reports = [cook(build, model, threads, folder) for _ in range(runs)]
    reports.sort(key=lambda r: sum(p["ms"] for p in r["passes"]))
    middle = reports[(runs - 1) // 2]
    return middle, sum(p["ms"] for p in middle["passes"])


def main():
    build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/release").resolve()
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    print(f"{'model':6}{'triangles':>10}{'patches':>9}{'1 thread':>10}{'2 threads':>11}{'exponent':>10}  slowest passes")
    before = None
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for kind, quads, copies in SIZES:
            model = folder / f"{kind}.glb"
            subprocess.run([build / "tools/coif_make_sample", model, quads, str(copies)], check=True,
                           stdout=subprocess.DEVNULL)
            report, one = median_run(build, model, 1, folder, runs)
            _, two = median_run(build, model, 2, folder, runs)
            triangles = report["triangles"]
            grown = before and before[0] == kind
            exponent = f"{math.log(one / before[2]) / math.log(triangles / before[1]):.2f}" if grown else ""
            slowest = sorted(report["passes"], key=lambda p: -p["ms"])[:4]
            print(f"{kind:6}{triangles:10}{report['patches']:9}{one:10.0f}{two:11.0f}{exponent:>10}  "
                  + ", ".join(f"{p['name']} {p['ms']:.0f}" for p in slowest), flush=True)
            before = (kind, triangles, one)


if __name__ == "__main__":
    main()
