#!/usr/bin/env python3
"""`coif cook` of strands: files of its own making, as a build machine hands them in.

usage: cook_strands.py CASE PROGRAM FOLDER
"""
import json
import math
import random
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path


def strands(count=400):
    """Hair of 0.35 m that lies on a head of 0.1 m about (0, 1.6, 0) down to its middle, and hangs from there."""
    numbers = random.Random(4)
    return [strand(numbers.uniform(0.2, 1.4), numbers.uniform(0, 2 * math.pi), numbers.uniform(0.103, 0.115)) for _ in range(count)]


def strand(polar, around, radius):
    """From an angle off the vertical, at a distance from the head's middle."""
    out = []
    for k in range(16):
        along = 0.35 * k / 15
        angle = min(polar + along / radius, math.pi / 2)
        falls = max(along - (math.pi / 2 - polar) * radius, 0)
        side = radius * math.sin(angle)
        out.append((side * math.cos(around), 1.6 + radius * math.cos(angle) - falls, side * math.sin(around)))
    return out


def hair(hair_strands):
    points = [p for strand in hair_strands for p in strand]
    head = struct.pack("<4sIIIIfffff", b"HAIR", len(hair_strands), len(points), 2, len(hair_strands[0]) - 1, 0.0005, 0.0, 0.4, 0.3, 0.2)
    # The format's files have Z up.
    return head.ljust(128, b"\0") + b"".join(struct.pack("<3f", x, -z, y) for x, y, z in points)


def tfx(hair_strands):
    points = [p for strand in hair_strands for p in strand]
    head = struct.pack("<fIII", 4.0, len(hair_strands), len(hair_strands[0]), 160)
    return head.ljust(160, b"\0") + b"".join(struct.pack("<4f", *p, 1) for p in points)


def obj(hair_strands):
    text, first = ["o hair"], 1
    for strand in hair_strands:
        text += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in strand]
        text += [f"l {first + k} {first + k + 1}" for k in range(len(strand) - 1)]  # as Blender writes curves
        first += len(strand)
    return "\n".join(text).encode() + b"\n"


RECIPE = {"source": {"metres_per_unit": 1, "up_axis": "y"}, "cards": {"triangles": 600, "texels": 65536}}


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def write(self, name, data):
        (self.folder / name).write_bytes(data if isinstance(data, bytes) else json.dumps(data).encode())

    def coif(self, *words):
        return subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True)

    def cook(self, source, *words):
        """Its report."""
        done = self.coif("cook", source, "-o", "out.coif", "--draft", "--format", "json", *words)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)


def every_format_gives_the_same_hair(bench):
    made = strands()
    bench.write("a.hair", hair(made))
    bench.write("a.tfx", tfx(made))
    bench.write("a.obj", obj(made))
    bench.write("r.json", RECIPE)
    bench.write("z.json", {**RECIPE, "source": {"metres_per_unit": 1, "up_axis": "z"}})
    reports = [bench.cook(name, "--recipe", recipe) for name, recipe in (("a.hair", "z.json"), ("a.tfx", "r.json"), ("a.obj", "r.json"))]
    for report in reports:
        assert 300 <= report["triangles"] <= 600, report
        assert abs(report["triangles"] - reports[0]["triangles"]) <= 60, reports
        assert report["chains"] >= 1, report
    checked = bench.coif("validate", "out.coif")
    assert checked.returncode == 0, checked.stdout + checked.stderr


def the_budget_is_kept_and_cooks_repeat(bench):
    bench.write("a.tfx", tfx(strands()))
    assets = []
    for triangles, threads in ((300, 1), (300, 2), (1200, 2)):
        bench.write("r.json", {**RECIPE, "cards": {"triangles": triangles, "texels": 65536}})
        report = bench.cook("a.tfx", "--recipe", "r.json", "--threads", str(threads))
        assert triangles / 2 < report["triangles"] <= triangles, report
        assets.append((bench.folder / "out.coif").read_bytes())
    assert assets[0] == assets[1], "the number of threads changes the asset"
    assert assets[0] != assets[2]


def bad_files_are_refused_and_leave_what_was_there(bench):
    whole = tfx(strands(30))
    (bench.folder / "out.coif").write_bytes(b"as it was")
    for name, data, code, wanted in (
            ("cut.tfx", whole[:-100], 3, "cut.tfx: cannot be read as TressFX: cut off in the points: 7580 of 7680 bytes from byte 160 on"),
            ("old.tfx", struct.pack("<f", 2.0) + whole[4:], 3, "old.tfx: cannot be read as TressFX: is of version 2; 3 and 4 can be read"),
            ("text.hair", b"this is a text " * 20, 3, "text.hair: cannot be read as HAIR: does not begin with 'HAIR'"),
            ("none.obj", b"v 0 0 0\nv 0 1 0\n", 3, "none.obj: ")):
        bench.write(name, data)
        done = bench.coif("cook", name, "-o", "out.coif")
        assert done.returncode == code, (name, done.returncode, done.stderr)
        assert wanted in done.stderr, done.stderr
        assert (bench.folder / "out.coif").read_bytes() == b"as it was"
    bench.write("a.tfx", tfx(strands(300)))
    bench.write("r.json", {**RECIPE, "cards": {"triangles": 6000, "texels": 4096}})
    done = bench.coif("cook", "a.tfx", "-o", "out.coif", "--recipe", "r.json")
    assert done.returncode == 4 and "do not fit into 4096 texels; allow more texels, or fewer triangles" in done.stderr, done.stderr


def maps_of_strands_are_as_wide_as_colours(bench):
    bench.write("a.tfx", tfx(strands()))
    bench.write("r.json", RECIPE)
    done = bench.coif("cook", "a.tfx", "-o", "out.coif", "--recipe", "r.json")
    assert done.returncode == 0, done.stderr
    sizes = dict(re.findall(r"(base_color|shift_mask|strand_axis) +(\d+x\d+)", bench.coif("info", "out.coif").stdout))
    width, height = map(int, sizes["base_color"].split("x"))
    # Strands run down the rows: a quarter of these says as much.
    assert sizes["shift_mask"] == sizes["strand_axis"] == f"{width}x{height // 4}", sizes


CASES = {f.__name__: f for f in (every_format_gives_the_same_hair, maps_of_strands_are_as_wide_as_colours, the_budget_is_kept_and_cooks_repeat, bad_files_are_refused_and_leave_what_was_there)}


def main(case, program, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    CASES[case](Bench(program, folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
