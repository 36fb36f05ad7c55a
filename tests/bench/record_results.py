#!/usr/bin/env python3
"""Adds the medians of one run to this machine's table and prints them, with each peer's ratio to the runtime and what
other benchmarks compare.

usage: record_results.py COMMIT RESULT.json...      what the programs of this folder wrote
       record_results.py --self-test
"""
import csv
import datetime
import io
import json
import re
import sys
from pathlib import Path

COLUMNS = ["date", "commit", "processor", "benchmark", "heads", "chains", "bones", "solver", "instruction_set", "substeps",
           "ns_per_bone", "step_ns_per_bone", "set_head_ns", "us_per_frame", "us_per_call", "bytes_per_head", "file_bytes",
           "spread_pct", "repetitions", "ratio"]
MICROSECONDS = {"ns": 1e-3, "us": 1.0, "ms": 1e3, "s": 1e6}


def processor():
    text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    match = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
    return match.group(1).strip() if match else "unknown processor"


def file_name(processor_name):
    """A file's name that says which processor: 'Intel(R) Xeon(R) Processor' -> intel_xeon_processor.csv."""
    plain = re.sub(r"\((?:r|tm)\)", "", processor_name.lower())
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_") + ".csv"


def number(value):
    """Whole numbers in full, others with four significant digits: a table that people read."""
    if value is None or isinstance(value, str):
        return value or ""
    if value != int(value):
        value = float(f"{value:.4g}")
    return str(int(value)) if value == int(value) else str(value)


def row_of(median, variation):
    """One row of the table from Google Benchmark's median and, where it gave one, its coefficient of variation."""
    solver, _, instruction_set = median.get("label", "").partition(" ")
    row = {column: median.get(column) for column in COLUMNS}
    row.update(benchmark=median["name"].split("/")[0].removesuffix("_median"), solver=solver,
               instruction_set=instruction_set, repetitions=median["repetitions"])
    if "us_per_frame" not in median:
        # The thread's own time: a call has no median frame to keep other programs out.
        row["us_per_call"] = median["cpu_time"] * MICROSECONDS[median["time_unit"]]
    if variation:
        key = "us_per_frame" if "us_per_frame" in variation else "cpu_time"
        row["spread_pct"] = 100 * variation[key]
    return row


def rows_of(report):
    failed = [b["name"] for b in report["benchmarks"] if b.get("error_occurred")]
    if failed:
        sys.exit(f"record_results: {', '.join(failed)}: did not run through")
    variations = {b.get("run_name"): b for b in report["benchmarks"] if b.get("aggregate_name") == "cv"}
    medians = [b for b in report["benchmarks"] if b.get("aggregate_name") == "median"]
    medians.sort(key=lambda b: b.get("family_index", 0))  # as the program lists them, not as they were shuffled
    return [row_of(b, variations.get(b.get("run_name"))) for b in medians]


def step_times(rows):
    """Workload's letter -> the default solver's nanoseconds per bone; the best where there are several."""
    times = {}
    for row in rows:
        match = re.fullmatch(r"simulate_(\w)_coif.*", row["benchmark"])
        if match:
            times[match.group(1)] = min(row["step_ns_per_bone"], times.get(match.group(1), float("inf")))
    return times


def add_peer_ratios(rows):
    ours = step_times(rows)
    for row in rows:
        peer = re.match(r"peer_(\w)_", row["benchmark"])
        if peer and peer.group(1) in ours:
            row["ratio"] = row["step_ns_per_bone"] / ours[peer.group(1)]


def print_table(rows):
    print(f"{'benchmark':24}{'solver':28}{'on':9}{'ns/bone':>9}{'step':>9}{'set ns':>8}{'us':>11}{'B/head':>9}{'+-%':>9}{'ratio':>10}")
    for row in rows:
        time = row["us_per_frame"] if row["us_per_frame"] is not None else row["us_per_call"]
        print(f"{row['benchmark']:24}{row['solver']:28}{row['instruction_set']:9}{number(row['ns_per_bone']):>9}"
              f"{number(row['step_ns_per_bone']):>9}{number(row['set_head_ns']):>8}{number(time):>11}"
              f"{number(row['bytes_per_head']):>9}{number(row['spread_pct']):>9}"
              f"{number(row['ratio']):>10}")


def write_rows(out, rows, with_heading):
    writer = csv.DictWriter(out, COLUMNS, lineterminator="\n")
    if with_heading:
        writer.writeheader()
    for row in rows:
        writer.writerow({column: number(value) for column, value in row.items()})


def record(commit, reports, folder):
    rows = [row for report in reports for row in rows_of(report)]
    if not rows:
        sys.exit("record_results: no medians in these files; run with --benchmark_repetitions")
    name = processor()
    date = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%MZ")
    for row in rows:
        row.update(date=date, commit=commit, processor=name)
    add_peer_ratios(rows)
    print_table(rows)
    path = folder / file_name(name)
    is_new = not path.exists()
    with path.open("a", encoding="utf-8", newline="") as out:
        write_rows(out, rows, is_new)
    print(f"{len(rows)} rows added to {path}")


def self_test():
    common = {"run_name": "simulate_a_coif/manual_time", "repetitions": 3, "label": "coif scalar"}
    report = {"benchmarks": [
        {**common, "name": "simulate_a_coif/manual_time_mean", "aggregate_name": "mean", "us_per_frame": 9.0},
        {**common, "name": "simulate_a_coif/manual_time_median", "aggregate_name": "median", "us_per_frame": 8.0,
         "step_ns_per_bone": 4.0, "heads": 200},
        {**common, "name": "simulate_a_coif/manual_time_cv", "aggregate_name": "cv", "us_per_frame": 0.5},
        {"name": "open_bob_median", "aggregate_name": "median", "repetitions": 3, "cpu_time": 2.0, "time_unit": "ms"}]}
    crowd, opened = rows_of(report)
    peers = [dict(crowd, benchmark="peer_a_slow", step_ns_per_bone=200.0), dict(crowd, benchmark="peer_b_slow")]
    add_peer_ratios([crowd, *peers])
    out = io.StringIO()
    write_rows(out, [crowd], True)
    checks = {
        "the median is taken": crowd["us_per_frame"] == 8.0,
        "names lose their endings": (crowd["benchmark"], opened["benchmark"]) == ("simulate_a_coif", "open_bob"),
        "the label is solver and instruction set": (crowd["solver"], crowd["instruction_set"]) == ("coif", "scalar"),
        "the spread is in percent": crowd["spread_pct"] == 50,
        "calls are in microseconds": opened["us_per_call"] == 2000,
        "a row has every column": out.getvalue().splitlines()[1].count(",") == len(COLUMNS) - 1,
        "numbers are short": (number(435520.0), number(1234567.8), number(0.123456), number(None))
        == ("435520", "1235000", "0.1235", ""),
        "a file's name": file_name("Intel(R) Xeon(R) E5 @ 2.0GHz") == "intel_xeon_e5_2_0ghz.csv",
        "ratios are to the same workload": (peers[0]["ratio"], peers[1]["ratio"], crowd["ratio"]) == (50, None, None),
        "peers stand beside the default solver": step_times([crowd]) == {"a": 4.0}}
    bad = [promise for promise, kept in checks.items() if not kept]
    print("\n".join(f"not so: {promise}" for promise in bad) or f"record_results: {len(checks)} checks")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) < 3:
        sys.exit(__doc__)
    else:
        record(sys.argv[1], [json.loads(Path(p).read_text()) for p in sys.argv[2:]], Path(__file__).parent / "results")
