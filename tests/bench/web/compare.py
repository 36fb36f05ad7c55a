#!/usr/bin/env python3
"""WebAssembly beside native code and three-vrm-springbone: one core, one run, in turns, medians over the rounds.

usage: compare.py BENCH_BUILD WEB_BUILD [ROUNDS] | --self-test
BENCH_BUILD: a release build tree with COIF_BENCH=ON (targets coif_bench and coif_write_workloads);
WEB_BUILD: one of the preset web. Exit code 1 where WebAssembly takes more than MOST times native SSE4's time, or three-vrm less than
LEAST times that of WebAssembly.
"""
import json
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

MOST = 2.5
LEAST = 12
HERE = Path(__file__).resolve().parent


def steps(text):
    """Nanoseconds per bone by workload, of what a benchmark prints: names are KIND_WORKLOAD_..."""
    rows = json.loads(text)["benchmarks"]
    return {row["name"].split("_")[1]: row["step_ns_per_bone"] for row in rows if row.get("aggregate_name") == "median"}


def on_one_core(*command):
    core = str(max(os.sched_getaffinity(0)))
    return steps(subprocess.run(["taskset", "-c", core, *map(str, command)], check=True, capture_output=True, text=True).stdout)


def fetch_peer(folder):
    """three-vrm-springbone from npm, in `folder`; its program there."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json", "spring_bones.mjs"):
        shutil.copy(HERE.parent / "peers" / name, folder)
    if not (folder / "node_modules").is_dir():
        subprocess.run(["npm", "ci", "--prefix", folder, "--ignore-scripts"], check=True, capture_output=True)
    return folder / "spring_bones.mjs"


def measure(bench, web, rounds):
    """The rounds' figures by program and workload."""
    work = bench / "tests/bench/web"
    work.mkdir(exist_ok=True)
    subprocess.run([bench / "tests/bench/coif_write_workloads", work], check=True)
    peer = fetch_peer(bench / "tests/bench/peers")
    programs = {
        "native sse4": (bench / "tests/bench/coif_bench", "--benchmark_filter=simulate_._coif/sse4", "--benchmark_repetitions=3",
                        "--benchmark_min_time=0.1", "--benchmark_report_aggregates_only=true", "--benchmark_format=json"),
        "wasm": ("node", HERE / "wasm_crowds.mjs", web / "npm", work, 3, 120),
        "three-vrm": ("node", peer, 3, 60),
    }
    found = {name: {"a": [], "b": []} for name in programs}
    for _ in range(rounds):
        for name, command in programs.items():
            for workload, value in on_one_core(*command).items():
                found[name][workload].append(value)
    return {name: {workload: statistics.median(values) for workload, values in each.items()} for name, each in found.items()}


def verdicts(medians):
    """Lines to print, and whether the targets are met."""
    lines, met = [], True
    for workload in ("a", "b"):
        native, wasm, peer = (medians[name][workload] for name in ("native sse4", "wasm", "three-vrm"))
        lines.append(f"({workload}) ns per bone and step: native sse4 {native:.1f}, wasm {wasm:.1f} ({wasm / native:.2f} times native), "
                     f"three-vrm {peer:.0f} ({peer / wasm:.0f} times wasm)")
        met = met and wasm <= MOST * native and peer >= LEAST * wasm
    return lines, met


def self_test():
    good = {"native sse4": {"a": 20, "b": 20}, "wasm": {"a": 40, "b": 30}, "three-vrm": {"a": 600, "b": 600}}
    slow = {**good, "wasm": {"a": 40, "b": 51}}
    matched = {**good, "three-vrm": {"a": 470, "b": 600}}
    printed = json.dumps({"benchmarks": [{"name": "peer_b_wasm/x", "aggregate_name": "median", "step_ns_per_bone": 3},
                                         {"name": "peer_b_wasm/y", "aggregate_name": "mean", "step_ns_per_bone": 4}]})
    return verdicts(good)[1] and not verdicts(slow)[1] and not verdicts(matched)[1] and steps(printed) == {"b": 3}


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(0 if self_test() else 1)
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    lines, met = verdicts(measure(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), int((sys.argv[3:] or [3])[0])))
    print("\n".join(lines))
    sys.exit(0 if met else 1)
