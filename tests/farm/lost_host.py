#!/usr/bin/env python3
"""Cooks a manifest on two hosts of GNU parallel, one of which dies in the midst of its first batch.

usage: tests/farm/lost_host.py COIF COIF_FARM FOLDER

The hosts are this machine, by a stand-in for ssh. FOLDER is made anew. Ends with 1 where anything was lost.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

from farm_case import Faults, outputs_of, write_manifest

def main():
    coif, script, folder = sys.argv[1:]
    if not shutil.which("parallel"):
        print("GNU parallel is not installed (Debian: parallel)")
        return 1
    folder = pathlib.Path(folder).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    manifest = write_manifest(folder / "in", 8)
    ssh = pathlib.Path(__file__).resolve().parent / "mortal_ssh.py"
    command = [script, "parallel", manifest, "-o", folder / "out", "--cache", folder / "cache", "--coif", coif]
    command += ["--batches", "4", "--jobs", "1", "--report", folder / "report.json"]
    command += ["--", "--sshlogin", f"1/{ssh} mortal", "--sshlogin", f"1/{ssh} steady"]
    environment = dict(os.environ, FARM_OUTPUT=str(folder / "out"))
    farm = subprocess.run(command, capture_output=True, text=True, env=environment)
    print(farm.stdout, farm.stderr)
    report = json.loads((folder / "report.json").read_text())
    here = report["cooked"] - report["from_cache"]
    print(f"{report['asked']} asked, {report['cooked']} cooked, {here} of them by the last cook")

    faults = Faults()
    faults.unless((folder / "out/mortal_is_dead").exists(), "no host died")
    faults.unless(farm.returncode == 0, f"exit code {farm.returncode}")
    faults.unless("4 of 4 batches done" in farm.stderr, "not all batches were done")
    faults.unless(report["cooked"] == 8 and here == 0, "the farm did not deliver all")
    faults.unless(all(output.exists() for output in outputs_of(manifest, folder / "out")), "assets were lost")
    return 1 if faults.count else 0


if __name__ == "__main__":
    sys.exit(main())
