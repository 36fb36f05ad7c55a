#!/usr/bin/env python3
"""Cooks damaged copies of models and watches that nothing crashes, hangs or leaves half an output.

usage: tests/fuzz/mutate_sources.py PROGRAM COUNT SEED MODEL... [--max-seconds N] [--recipe R.json] [--jobs N]

COUNT copies of each model are damaged, each in one of several ways that its number and SEED choose: bytes changed, a part
cut off, repeated or moved, a number of a text replaced by an extreme one. Every copy is cooked in a folder of its own, the
model's neighbours beside it. A cook may succeed or refuse (exit codes 0, 3, 4, 5); whatever else it does is a finding: its
copy is kept in the current folder. So is a cook that takes more than twice --max-seconds, which bounds the importer and then the
cook, and five seconds; and one that finds only at its end that no asset can be made. Prints what was tried and the longest time
for each model, and ends with 1 where there was a finding.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

ALLOWED = {0: "cooked", 3: "refused", 4: "over budget", 5: "unsupported"}
EXTREMES = [b"0", b"-1", b"1e38", b"-1e38", b"1e400", b"nan", b"2147483648", b"4294967295", b"-2147483648", b"65536", b"0.5"]
NUMBER = re.compile(rb"(?<![\w.])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
RECIPE = '{"order": {"method": "head"}, "textures": {"max_size": 64}}'


def change_bytes(data, rng):
    for _ in range(rng.choice([1, 4, 64])):
        data[rng.randrange(len(data))] = rng.choice([0, 1, 0x7F, 0x80, 0xFF, rng.randrange(256)])
    return data


def cut_off(data, rng):
    return data[: rng.randrange(len(data))]


def repeat_part(data, rng):
    begin = rng.randrange(len(data))
    part = data[begin : begin + rng.choice([1, 16, 4096])]
    return data[:begin] + part * rng.choice([2, 8, 64]) + data[begin + len(part) :]


def move_part(data, rng):
    begin, length, target = rng.randrange(len(data)), rng.choice([4, 64, 1024]), rng.randrange(len(data))
    part = data[begin : begin + length]
    rest = data[:begin] + data[begin + length :]
    return rest[:target] + part + rest[target:]


def replace_number(data, rng):
    """In texts, and in the JSON that a GLB begins with."""
    window = rng.randrange(max(1, min(len(data), 1 << 20) - 4096))
    numbers = list(NUMBER.finditer(bytes(data[window : window + 4096])))
    if not numbers:
        return change_bytes(data, rng)
    number = rng.choice(numbers)
    return data[: window + number.start()] + rng.choice(EXTREMES) + data[window + number.end() :]


WAYS = [change_bytes, cut_off, repeat_part, move_part, replace_number, replace_number]


def damaged(original, seed):
    rng = random.Random(seed)
    data = bytearray(original)
    for _ in range(rng.choice([1, 1, 2, 4])):
        if data:
            data = rng.choice(WAYS)(data, rng)
    return bytes(data)


def neighbours(model, folder):
    """What the model may read: files beside it and their folders, as links, but not the model."""
    for entry in model.parent.iterdir():
        if entry != model:
            (folder / entry.name).symlink_to(entry)


def judge(given, model, original, seed):
    """What became of one copy: a word, and a sentence where it is a finding."""
    with tempfile.TemporaryDirectory(prefix="coif_fuzz_") as name:
        folder = pathlib.Path(name) / "in"
        folder.mkdir()
        neighbours(model, folder)
        copy, recipe, output = folder / model.name, pathlib.Path(name) / "r.json", pathlib.Path(name) / "out"
        copy.unlink(missing_ok=True)
        copy.write_bytes(damaged(original, seed))
        recipe.write_text(given.recipe.read_text() if given.recipe else RECIPE)
        output.mkdir()
        command = [given.program, "cook", copy, "-o", output / "out.coif", "--recipe", recipe, "--threads", "1",
                   "--max-seconds", str(given.max_seconds), "--root", model.parent]
        most, begin = 2 * given.max_seconds + 5, time.monotonic()
        try:
            done = subprocess.run(command, timeout=most, stdin=subprocess.DEVNULL, capture_output=True, check=False)
        except subprocess.TimeoutExpired:
            return "hung", keep(copy, seed, f"did not end in {most} s"), most
        seconds = time.monotonic() - begin
        return *judge_end(given, copy, output, done, seed), seconds


def judge_end(given, copy, output, done, seed):
    """The same, without the seconds, of one that ended."""
    if b"internal error" in done.stderr or b"the cooked asset is not valid" in done.stderr:
        return "late", keep(copy, seed, f"exit code {done.returncode}: {done.stderr[-300:]!r}")
    left = sorted(path.name for path in output.iterdir())
    if done.returncode not in ALLOWED:
        return "crashed", keep(copy, seed, f"exit code {done.returncode}: {done.stderr[-300:]!r}")
    if left != (["out.coif"] if done.returncode == 0 else []):
        return "left files", keep(copy, seed, f"exit code {done.returncode}, but left {left}")
    if done.returncode != 0 and b"error" not in done.stderr:
        return "silent", keep(copy, seed, f"exit code {done.returncode} without an error message")
    if done.returncode == 0 and subprocess.run([given.program, "validate", output / "out.coif"], capture_output=True).returncode:
        return "invalid", keep(copy, seed, "cooked an asset that does not validate")
    return ALLOWED[done.returncode], None


def keep(copy, seed, sentence):
    kept = f"finding_{seed}_{copy.name}"
    shutil.copy(copy, kept)
    return f"{kept}: {sentence}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("count", type=int)
    parser.add_argument("seed", type=int)
    parser.add_argument("models", nargs="+", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--max-seconds", type=int, default=60)
    parser.add_argument("--recipe", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    given = parser.parse_args()
    begin, findings, total = time.time(), 0, 0
    for model in given.models:
        original = model.read_bytes()
        with ThreadPoolExecutor(given.jobs) as pool:
            results = list(pool.map(lambda i: judge(given, model, original, given.seed * 1_000_003 + i), range(given.count)))
        words = collections.Counter(word for word, _, _ in results)
        longest = max(seconds for _, _, seconds in results)
        print(f"{model.name}: " + ", ".join(f"{n} {word}" for word, n in sorted(words.items())) + f"; {longest:.1f} s at most", flush=True)
        for sentence in [s for _, s, _ in results if s]:
            print(f"  {sentence}", flush=True)
            findings += 1
        total += given.count
    print(f"{total} files, {time.time() - begin:.0f} s, {findings} findings")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
