#!/usr/bin/env python3
"""Where a frame goes: the share of each function in the instructions of TimedCrowd::set_heads() and step(), for both
workloads. What the compiler has put into its caller counts there.

usage: hot_functions.py BUILD_FOLDER [SOLVER [INSTRUCTION_SET]]     (coif avx2)
       hot_functions.py --self-test

Needs valgrind, which knows instruction sets up to avx2. Instructions are not time: divisions and square roots, and what
waits for memory, take longer than their share.
"""
import collections
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FRAME = ("coif::TimedCrowd::set_heads()", "coif::TimedCrowd::step(float)")
FRAMES = (2, 12)  # what the second has more than the first is what frames cost
LEAST = 0.002     # of all instructions; what is below is summed up


def parse(lines):
    """Function -> instructions of its own, of a profile without compressed names."""
    counts, function, skip = collections.Counter(), None, False
    for line in lines:
        if line.startswith("fn="):
            function = line[3:].strip()
        elif line.startswith("calls="):
            skip = True  # the next line is what the callee took, which is counted there
        elif re.match(r"[+\-*\d]", line):
            if not skip:
                counts[function] += int(line.split()[1])
            skip = False
    return counts


def short(name):
    """Without arguments, template parameters and what every name has."""
    name = re.sub(r"\(anonymous namespace\)::|\[clone [^]]*\]|\bcoif::|'\d+$", "", name)
    while (plain := re.sub(r"<[^<>]*>|\([^()]*\)( const)?", "", name)) != name:
        name = plain
    return name.split()[-1] if name.split() else "?"


def profile(command):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "profile")
        toggles = [f"--toggle-collect={function}" for function in FRAME]
        subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--collect-atstart=no",
                        "--compress-strings=no", "--compress-pos=no", *toggles, *command], check=True, capture_output=True)
        return parse(out.read_text().splitlines())


def of_one_frame(few, many):
    frames = FRAMES[1] - FRAMES[0]
    costs = collections.Counter()
    for name, count in many.items():
        costs[short(name)] += (count - few[name]) / frames
    return costs


def print_shares(costs, bones):
    total = sum(costs.values())
    rest = total
    for name, cost in costs.most_common():
        if cost < LEAST * total:
            break
        rest -= cost
        print(f"  {100 * cost / total:5.1f} %{cost / bones:9.1f}  {name}")
    print(f"  {100 * rest / total:5.1f} %{rest / bones:9.1f}  all others")


def report(program, solver="coif", instruction_set="avx2"):
    for workload, bones in (("a", 200 * 3 * 3), ("b", 100 * 16)):
        command = [program, "frames", workload, "0", solver, instruction_set]
        costs = of_one_frame(*(profile([*command, str(frames)]) for frames in FRAMES))
        print(f"({workload}) {solver} {instruction_set}: {sum(costs.values()) / bones:.1f} instructions per bone\n"
              "    share per bone  function", flush=True)
        print_shares(costs, bones)


def self_test():
    text = ["events: Ir", "ob=/lib/x", "fl=x.cpp", "fn=one", "16 7", "calls=1 16", "17 900", "18 5", "fn=(other)", "+3 4",
            "totals: 16"]
    names = {"void coif::N_AVX2::(anonymous namespace)::step_row<hwy::Simd<float, 8ul, 0> >(coif::RowStep const&)":
             "N_AVX2::step_row", "coif::Hair::set_head(unsigned int, coif::HeadPose const&)'2": "Hair::set_head"}
    frame = of_one_frame(collections.Counter({"f(int)": 5}), collections.Counter({"f(int)": 25, "f(float)": 10}))
    checks = {"calls are not counted twice": parse(text) == {"one": 12, "(other)": 4},
              "names are short": all(short(full) == name for full, name in names.items()),
              "only frames count": frame == {"f": 3}}
    bad = [promise for promise, kept in checks.items() if not kept]
    print("\n".join(f"not so: {promise}" for promise in bad) or f"hot_functions: {len(checks)} checks")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) < 2:
        sys.exit(__doc__)
    else:
        report(Path(sys.argv[1]).resolve() / "tests/bench/coif_limit", *sys.argv[2:4])
