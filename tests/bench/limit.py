#!/usr/bin/env python3
"""How far the simulation is from what the processor can do: what a bone costs in instructions, vector arithmetic,
divisions and bytes, how long each of these alone would take at the machine's measured peak, and which of them is the
floor that the measured time stands on. A time far above its floor waits for results (latency), not for the machine.

usage: limit.py BUILD_FOLDER [SOLVER [INSTRUCTION_SET...]]     (coif, all that there are)
       limit.py --self-test

Needs valgrind and objdump; run it on one core: taskset -c 1 ... Instructions are counted by callgrind inside one function;
a run of few frames is taken from a run of more. Bytes are the cache lines that its model of this processor's first cache
has to fetch.
"""
import collections
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

STEP = "coif::TimedCrowd::step(float)"
FRAMES = (2, 12)
WIDTHS = {"avx2": 8, "avx512": 16}  # floats in a register; 4 in all others
NOT_EMULATED = {"avx512"}  # by valgrind
CASES = [("a", 0), ("b", 0), ("a", 20000)]  # workload, heads
# What shares two ports on today's processors; moves, shuffles and logic have more of them.
ARITHMETIC = re.compile(r"v?(?:add|sub|mul|min|max|cmp\w*|u?comi|cvt\w*|round|rndscale|f(?:n?m)(?:add|sub)\w*|rcp\w*|rsqrt\w*)"
                        r"(?:[ps]s|[ps]d)$")
CACHE_LINE = 64  # bytes
DIVISION = re.compile(r"v?(?:div|sqrt)[ps][sd]$")


def run_json(command):
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def parse_callgrind(lines):
    """Instruction executions by (object file, address), and cache lines fetched, of a profile without compressed names and
    positions."""
    counts, fetched = collections.Counter(), 0
    object_file, events, skip = None, [], False
    for line in lines:
        if line.startswith("events:"):
            events = line.split()[1:]
        elif line.startswith("ob="):
            object_file = line[3:].strip()
        elif line.startswith("calls="):
            skip = True  # the next line is what the callee took, which is counted there
        elif line.startswith("0x"):
            if not skip:
                address, _, *costs = line.split()
                cost = dict(zip(events, map(int, costs)))  # zeros at the end are left out
                counts[object_file, int(address, 16)] += cost.get("Ir", 0)
                fetched += cost.get("D1mr", 0) + cost.get("D1mw", 0)
            skip = False
    return counts, fetched


def profile(command):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "profile")
        subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={STEP}",
                        "--collect-atstart=no", "--cache-sim=yes", "--dump-instr=yes", "--compress-strings=no", "--compress-pos=no", *command],
                       check=True, capture_output=True)
        return parse_callgrind(out.read_text().splitlines())


def mnemonics(object_file):
    """Address -> name of the instruction there."""
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", object_file], capture_output=True, text=True).stdout
    found = re.findall(r"^\s*([0-9a-f]+):\t(?:(?:rep|lock|bnd|notrack|data16) )*(\S+)", listing, re.MULTILINE)
    return {int(address, 16): name for address, name in found}


def mix_of(counts, fetched, names_in):
    """Executed instructions of each kind, and bytes fetched."""
    mix = collections.Counter(bytes=CACHE_LINE * fetched)
    for (object_file, address), count in counts.items():
        name = names_in(object_file).get(address, "")
        mix["instructions"] += count
        mix["arithmetic"] += count * bool(ARITHMETIC.match(name))
        mix["divisions"] += count * bool(DIVISION.match(name))
        mix["unknown"] += count * (name == "")
    return mix


def count_frame(program, workload, solver, instruction_set):
    """The mix of one frame."""
    cache = {}

    def names_in(object_file):
        if object_file not in cache:
            cache[object_file] = mnemonics(object_file)
        return cache[object_file]

    command = [program, "frames", workload, "0", solver, instruction_set]
    few, many = (mix_of(*profile([*command, str(frames)]), names_in) for frames in FRAMES)
    return {kind: (many[kind] - few[kind]) / (FRAMES[1] - FRAMES[0]) for kind in many}


def floors(per_bone, peaks, width, traffic):
    """Nanoseconds per bone that each kind of work takes at least."""
    vector = next(w for w in peaks["widths"] if w["floats"] == width)
    return {"issue": per_bone["instructions"] / peaks["instructions"],
            "arithmetic": per_bone["arithmetic"] / vector["arithmetic"],
            "division": per_bone["divisions"] / vector["divisions"],
            "memory": per_bone["bytes"] / traffic}


def print_peaks(peaks):
    print(f"peaks on one core, per ns: {peaks['instructions']:.1f} instructions; per register width: "
          + "; ".join(f"{w['floats']} floats {w['arithmetic']:.1f} multiplications or additions, {w['divisions']:.2f} divisions"
                      for w in peaks["widths"]))
    print("bytes per ns, two read for one written: "
          + ", ".join(f"{t['bytes_per_ns']:.0f} over {t['bytes'] / 1e6:g} MB" for t in peaks["traffic"]))


def per_bone_of(program, workload, heads, solver, instruction_set):
    """What a bone costs in a frame, its nanoseconds and the bytes of the whole crowd."""
    def frames(crowd, count):
        return run_json([program, "frames", workload, str(crowd), solver, instruction_set, str(count)])

    timed = frames(heads, 20 if heads else 400)
    # Every head runs the same code: thousands of them need no counting of their own.
    mix = count_frame(program, workload, solver, instruction_set)
    bones = timed["bones"] if heads == 0 else frames(0, 1)["bones"]
    per_bone = {kind: count / bones for kind, count in mix.items()}
    return per_bone, timed["ns_per_bone"], int(timed["bones"] * timed["bytes_per_bone"])


def print_row(name, instruction_set, per_bone, nanoseconds, least):
    highest = max(least, key=least.get)
    print(f"{name:18}{instruction_set:9}{nanoseconds:9.2f}{per_bone['instructions']:8.1f}{per_bone['arithmetic']:8.1f}"
          f"{per_bone['divisions']:7.2f}{per_bone['bytes']:8.0f}   " + "".join(f"{value:7.2f}" for value in least.values())
          + f"  {highest}, {100 * least[highest] / nanoseconds:.0f} %", flush=True)
    if per_bone["unknown"] > 0.01 * per_bone["instructions"]:
        print(f"  {per_bone['unknown']:.1f} instructions per bone lie in no object file")


def report(program, solver, instruction_sets):
    peaks = run_json([program, "peaks", "24000", "1000000", "300000000"])
    print_peaks(peaks)
    print(f"\n{'':18}{'':9}{'measured':>9}{'a bone needs':>31}   {'ns per bone at least, for':>28}\n"
          f"{'workload':18}{'on':9}{'ns/bone':>9}{'instr':>8}{'arith':>8}{'div':>7}{'bytes':>8}   "
          f"{'issue':>7}{'arith':>7}{'div':>7}{'memory':>7}  floor, share of the time")
    for instruction_set in instruction_sets or run_json([program, "sets"]):
        if instruction_set in NOT_EMULATED:
            print(f"{instruction_set}: valgrind does not know it; not counted")
            continue
        for workload, heads in CASES:
            per_bone, nanoseconds, footprint = per_bone_of(program, workload, heads, solver, instruction_set)
            traffic = run_json([program, "peaks", str(footprint)])["traffic"][0]["bytes_per_ns"]
            least = floors(per_bone, peaks, WIDTHS.get(instruction_set, 4), traffic)
            print_row(workload + (f" x {heads} heads" if heads else ""), instruction_set, per_bone, nanoseconds, least)


def self_test():
    text = ["events: Ir D1mr D1mw", "ob=/lib/x", "fn=f", "0x10 0 7 2", "calls=1 0x40 0", "0x14 0 900 9 9", "0x18 0 5 0 1",
            "ob=/lib/y", "0x10 0 2"]
    counts, fetched = parse_callgrind(text)
    names = {"/lib/x": {0x10: "vmulps", 0x18: "vdivps"}, "/lib/y": {}}
    mix = mix_of(counts, fetched, names.get)
    peaks = {"instructions": 10.0, "widths": [{"floats": 8, "arithmetic": 5.0, "divisions": 1.0}]}
    least = floors({"instructions": 20, "arithmetic": 20, "divisions": 3, "bytes": 8}, peaks, 8, 4.0)
    checks = {
        "calls are not counted twice": sum(counts.values()) == 14,
        "objects are kept apart": counts["/lib/y", 0x10] == 2,
        "lines are counted where they are fetched": (fetched, mix["bytes"]) == (3, 3 * CACHE_LINE),
        "kinds are told apart": (mix["arithmetic"], mix["divisions"], mix["unknown"]) == (7, 5, 2),
        "fused and compared is arithmetic": all(map(ARITHMETIC.match, ("vfnmadd231ps", "vcmpltps", "vmaxss", "cvtsi2ss"))),
        "moves, logic and divisions are not": not any(map(ARITHMETIC.match, ("vmovaps", "vandps", "vdivps", "vblendvps"))),
        "floors": least == {"issue": 2.0, "arithmetic": 4.0, "division": 3.0, "memory": 2.0}}
    bad = [promise for promise, kept in checks.items() if not kept]
    print("\n".join(f"not so: {promise}" for promise in bad) or f"limit: {len(checks)} checks")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) < 2:
        sys.exit(__doc__)
    else:
        report(Path(sys.argv[1]).resolve() / "tests/bench/coif_limit", (sys.argv[2:3] or ["coif"])[0], sys.argv[3:])
