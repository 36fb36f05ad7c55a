#!/usr/bin/env python3
"""What equal results everywhere cost: times the simulation with multiplications and additions fused, as compilers like
to do and the project does not allow, and prints what Google Benchmark would: {"benchmarks": [...]}. `ratio` is the fused
step's time over that of the step as it ships. The two programs run in turns, so that a slow minute hits both.

usage: fused_arithmetic.py BUILD_FOLDER REPETITIONS
       fused_arithmetic.py --self-test

Needs objdump, to see that one is fused and the other is not.
"""
import json
import re
import statistics
import subprocess
import sys
from pathlib import Path

WIDE = "^simulate_._(coif|thesis)/(avx2|avx512|neon)"  # instruction sets that can fuse
FUSED = re.compile(r"\s(?:vfn?m(?:add|sub)\w*|fn?m(?:add|sub|la|ls))\s")
TIMES = ["ns_per_bone", "step_ns_per_bone", "set_head_ns", "us_per_frame"]


def fused_instructions(program):
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, capture_output=True, text=True)
    return len(FUSED.findall(listing.stdout))


def run(program):
    """Name -> Google Benchmark's row."""
    out = subprocess.run([program, f"--benchmark_filter={WIDE}", "--benchmark_min_time=0.05", "--benchmark_format=json"],
                         check=True, capture_output=True, text=True).stdout
    return {row["name"]: row for row in json.loads(out)["benchmarks"]}


def row_of(name, plain, fused):
    """One row from the rows of all repetitions."""
    row = dict(fused[0], name=name.replace("simulate_", "fused_", 1) + "_median", aggregate_name="median",
               repetitions=len(fused))
    row.update({time: statistics.median(f[time] for f in fused) for time in TIMES})
    row["ratio"] = statistics.median(f["step_ns_per_bone"] / p["step_ns_per_bone"] for p, f in zip(plain, fused))
    return row


def measure(folder, repetitions):
    programs = [folder / "coif_bench", folder / "coif_bench_fused"]
    plain_count, fused_count = map(fused_instructions, programs)
    if plain_count > 0 or fused_count == 0:
        sys.exit(f"fused_arithmetic: {plain_count} fused instructions in {programs[0]}, {fused_count} in {programs[1]}; "
                 "there should be none and some")
    turns = [[run(program) for program in programs] for _ in range(repetitions)]
    return [row_of(name, [plain[name] for plain, _ in turns], [fused[name] for _, fused in turns]) for name in turns[0][0]]


def self_test():
    def row(nanoseconds):
        return dict.fromkeys(TIMES, nanoseconds) | {"name": "simulate_a_coif/avx2", "label": "coif avx2"}

    made = row_of("simulate_a_coif/avx2", [row(10), row(20), row(40)], [row(9), row(16), row(36)])
    checks = {
        "the ratio is that of each pair": made["ratio"] == 0.9,
        "times are medians": made["step_ns_per_bone"] == 16,
        "the row has a name of its own": (made["name"], made["label"]) == ("fused_a_coif/avx2_median", "coif avx2"),
        "fused instructions are found": len(FUSED.findall("\tvfmadd231ps %ymm0\n\tvfnmsub132ss %x\n\tfmla v0.4s\n")) == 3,
        "others are not": not FUSED.search("\tvmulps %ymm0\n\tvaddps %ymm1\n\tfmul v0.4s\n")}
    bad = [promise for promise, kept in checks.items() if not kept]
    print("\n".join(f"not so: {promise}" for promise in bad) or f"fused_arithmetic: {len(checks)} checks")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) != 3:
        sys.exit(__doc__)
    else:
        print(json.dumps({"benchmarks": measure(Path(sys.argv[1]).resolve() / "tests/bench", int(sys.argv[2]))}, indent=1))
