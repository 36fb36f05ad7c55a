#!/usr/bin/env python3
"""Cooks a manifest on two emulated Slurm nodes, kills one of them in the midst of a batch, and counts what was lost.

usage: tests/farm/killed_node.py COIF COIF_FARM FOLDER BATCHES [MANIFEST]

FOLDER is made anew; the assets come to FOLDER/out. Without MANIFEST a few of the sample are cooked. Prints the figures, and
ends with 1 where an asset was lost, where the last cook had to do what the farm was asked for, or where what the dead node had
done was done again; with 77 where Slurm does not run.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import time

import emulated_slurm
from farm_case import Faults, outputs_of, write_manifest


def running_on(cluster, node):
    """The batches that the node works at."""
    return [int(line) for line in cluster.ask("squeue", "-h", "-t", "R", "-w", node, "-o", "%K").split()]


def kill_in_the_midst(cluster, node, batches, outputs, farm):
    """Returns the batch that the node worked at, and how much it had done of it."""
    while farm.poll() is None:
        for batch in running_on(cluster, node):
            mine = outputs[batch - 1 :: batches]
            if 0 < sum(output.exists() for output in mine) < len(mine):
                cluster.kill(node)
                return batch, sum(output.exists() for output in mine)
        time.sleep(0.02)
    sys.exit(f"{node} was never in the midst of a batch; give it larger ones")


def hurry(cluster, farm):
    """Slurm lets a requeued job wait for two minutes."""
    while farm.poll() is None:
        for job in cluster.ask("squeue", "-h", "-t", "PD", "-o", "%i %r").splitlines():
            if job.endswith("BeginTime"):
                cluster.ask("scontrol", "update", f"JobId={job.split()[0]}", "StartTime=now")
        time.sleep(0.5)
    return farm.wait()


def run_farm(coif, script, manifest, folder, batches):
    """Returns the batch in which a node died, what that had done of it, and the farm's exit code."""
    command = [script, "slurm", manifest, "-o", folder / "out", "--cache", folder / "cache", "--coif", coif]
    command += ["--batches", str(batches), "--jobs", "1", "--report", folder / "report.json"]
    with emulated_slurm.Cluster(folder / "cluster", ["n1", "n2"]) as cluster, open(folder / "farm.log", "wb") as log:
        farm = subprocess.Popen(command, env=cluster.environment, stdout=log, stderr=log)
        batch, done = kill_in_the_midst(cluster, "n1", batches, outputs_of(manifest, folder / "out"), farm)
        return batch, done, hurry(cluster, farm)


def main():
    coif, script, folder, batches, *manifest = sys.argv[1:]
    if not emulated_slurm.is_installed():
        print("Slurm is not installed (Debian: slurm-wlm)")
        return 1
    folder, batches = pathlib.Path(folder).resolve(), int(batches)
    shutil.rmtree(folder, ignore_errors=True)
    manifest = pathlib.Path(manifest[0]) if manifest else write_manifest(folder / "in", 12)
    folder.mkdir(exist_ok=True)
    begin = time.monotonic()
    try:
        batch, done, code = run_farm(coif, script, manifest, folder, batches)
    except emulated_slurm.CannotRun as fault:
        print(f"skipped: Slurm does not run here: {fault}")
        return 77
    seconds = time.monotonic() - begin
    report = json.loads((folder / "report.json").read_text())
    found_again = (folder / f"out/farm/batch-{batch}.log").read_text().count(" yes\n")
    here = report["cooked"] - report["from_cache"]
    outputs = outputs_of(manifest, folder / "out")
    lost = sum(not output.exists() for output in outputs) - report["failed"]
    print((folder / "farm.log").read_text())
    print(f"n1 died in batch {batch}, {done} of its {len(outputs[batch - 1 :: batches])} assets done; {seconds:.0f} s in all")
    print(f"{report['asked']} asked, {report['cooked']} cooked, {report['failed']} failed, {lost} lost; the last cook made {here}")
    print(f"the requeued batch found {found_again} in the cache")

    faults = Faults()
    faults.unless(lost == 0, "assets were lost")
    faults.unless(here == 0, "the farm did not deliver all")
    faults.unless(found_again >= done, "the requeued batch cooked again what had been cooked")
    faults.unless(code == max(file["exit_code"] for file in report["files"]), f"exit code {code}")
    return 1 if faults.count else 0


if __name__ == "__main__":
    sys.exit(main())
