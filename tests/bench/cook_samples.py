#!/usr/bin/env python3
"""Times `coif cook` of the sample assets on one thread and prints what Google Benchmark would: {"benchmarks": [...]}.
The time is the program's own on the processor, so that a busy machine does not lengthen it; cook_speed.py shows how
it grows with the model.

usage: cook_samples.py COIF_PROGRAM REPETITIONS
"""
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "sample_assets"


def cpu_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure(program, name, repetitions, folder):
    out = folder / f"{name}.coif"
    source = SAMPLES / name
    command = [program, "cook", source / f"{name}.glb", "--recipe", source / f"{name}.recipe.json", "-o", out,
               "--threads", "1"]
    seconds = statistics.median(cpu_seconds(command) for _ in range(repetitions))
    return {"name": f"cook_{name}_median", "aggregate_name": "median", "repetitions": repetitions, "cpu_time": seconds,
            "time_unit": "s", "file_bytes": out.stat().st_size}


def main():
    program, repetitions = sys.argv[1], int(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        names = sorted(p.name for p in SAMPLES.iterdir() if (p / f"{p.name}.recipe.json").exists())
        rows = [measure(program, name, repetitions, pathlib.Path(folder)) for name in names]
    print(json.dumps({"benchmarks": rows}, indent=1))


if __name__ == "__main__":
    main()
