#!/usr/bin/env python3
"""`coif grow`, and a cook of what it makes, as a build machine calls them.

usage: grow_hair.py CASE PROGRAM FOLDER
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

CARDS = {"triangles": 60, "texels": 8192}


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def write(self, name, data):
        (self.folder / name).write_text(json.dumps(data))

    def coif(self, *words):
        return subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True)

    def done(self, *words):
        done = self.coif(*words)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def refused(self, code, wanted, *words):
        done = self.coif(*words)
        assert done.returncode == code, (words, done.returncode, done.stderr)
        assert wanted in done.stderr, done.stderr


def strands_are_written_and_cooked(bench):
    told = json.loads(bench.done("grow", "--style", "bob", "--strands", "800", "-o", "a.hair", "--format", "json"))
    assert told["strands"] == 800 and told["bytes"] == (bench.folder / "a.hair").stat().st_size, told
    bench.done("grow", "--style", "bob", "--strands", "800", "--threads", "1", "-o", "b.hair")
    assert (bench.folder / "a.hair").read_bytes() == (bench.folder / "b.hair").read_bytes(), "threads change the strands"
    text = bench.done("grow", "--style", "bob", "--strands", "800", "-o", "a.obj")
    assert "800 strands" in text and "coif cook a.obj" in text, text
    bench.write("r.json", {"source": {"metres_per_unit": 1, "up_axis": "y"}, "cards": CARDS})
    bench.done("cook", "a.obj", "--recipe", "r.json", "-o", "a.coif", "--draft")
    bench.done("validate", "a.coif")


def a_recipe_is_a_source_and_names_its_body(bench):
    bench.write("bob.recipe.json", {"cards": CARDS, "grow": {"style": "bob", "strands": 600}})
    told = json.loads(bench.done("cook", "bob.recipe.json", "-o", "bob.coif", "--draft", "--format", "json"))
    assert 20 < told["triangles"] <= 60 and told["chains"] >= 1, told
    bench.done("validate", "bob.coif")
    bench.refused(1, "bob.recipe.json: is a recipe itself; leave --recipe out", "cook", "bob.recipe.json", "--recipe", "bob.recipe.json", "-o", "c.coif")

    # A head of its own: a dependency of the cook, and of what the cache keeps.
    head = bench.folder / "head.obj"
    write_head(head, 0.1)
    bench.write("on_head.recipe.json", {"cards": {**CARDS, "body": "head.obj"}, "grow": {"style": "short", "strands": 500}})
    cook = ("cook", "on_head.recipe.json", "-o", "h.coif", "--draft", "--cache", "cache", "--depfile", "h.d", "--format", "json")
    assert not json.loads(bench.done(*cook))["from_cache"]
    assert json.loads(bench.done(*cook))["from_cache"]
    assert "head.obj" in (bench.folder / "h.d").read_text()
    first = (bench.folder / "h.coif").read_bytes()
    write_head(head, 0.11)
    assert not json.loads(bench.done(*cook))["from_cache"], "the head has changed"
    assert (bench.folder / "h.coif").read_bytes() != first
    write_head(bench.folder / "other.obj", 0.1)
    bench.done(*cook[:4], "--draft", "--body", "other.obj")
    assert (bench.folder / "h.coif").read_bytes() != first, "the recipe is another"
    bench.refused(2, "absent.obj: cannot open", *cook[:4], "--body", "absent.obj")


def write_head(path, radius):
    import math
    rings, around = 16, 24
    text = []
    for r in range(rings + 1):
        polar = math.pi * r / rings
        text += [f"v {radius * math.sin(polar) * math.sin(2 * math.pi * k / around):.6f} {1.6 + 1.1 * radius * math.cos(polar):.6f} "
                 f"{radius * math.sin(polar) * math.cos(2 * math.pi * k / around):.6f}" for k in range(around)]
    for r in range(rings):
        for k in range(around):
            a, b = r * around + k + 1, r * around + (k + 1) % around + 1
            text += [f"f {a} {a + around} {b}", f"f {b} {a + around} {b + around}"]
    path.write_text("o face\n" + "\n".join(text) + "\n")


def what_cannot_grow_is_refused(bench):
    bench.write("r.json", {"grow": {"style": "beehive"}})
    bench.write("flat.json", {"grow": {"hairline_front": 90, "hairline_temples": 90, "hairline_sides": 90, "hairline_nape": 90, "hairline_fade": 0}})
    (bench.folder / "out.hair").write_bytes(b"as it was")
    bench.refused(1, "needs -o OUT.obj or OUT.hair", "grow")
    bench.refused(1, "'beehive' is not one of bob", "grow", "--style", "beehive", "-o", "out.hair")
    bench.refused(1, "out.abc", "grow", "-o", "out.abc")
    bench.refused(3, 'r.json: "grow.style" wants one of none|bob', "grow", "--recipe", "r.json", "-o", "out.hair")
    bench.refused(3, "flat.json: the hairline leaves no room for hair", "grow", "--recipe", "flat.json", "-o", "out.hair")
    bench.refused(2, "absent.glb: cannot open", "grow", "--body", "absent.glb", "-o", "out.hair")
    bench.write("many.json", {"grow": {"strands": 1000000, "style": "curly"}})
    bench.refused(4, "are more than the", "grow", "--recipe", "many.json", "-o", "out.hair")
    assert (bench.folder / "out.hair").read_bytes() == b"as it was"


CASES = {f.__name__: f for f in (strands_are_written_and_cooked, a_recipe_is_a_source_and_names_its_body, what_cannot_grow_is_refused)}


def main(case, program, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    CASES[case](Bench(program, folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
