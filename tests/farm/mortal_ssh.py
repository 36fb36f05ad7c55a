#!/usr/bin/env python3
"""Stands in for ssh: runs a command on this machine. The host "mortal" dies as soon as an asset lies in the folder that the
variable FARM_OUTPUT names, with all that runs there, and cannot be reached any more: exit code 255, as ssh's.

usage: mortal_ssh.py [OPTIONS] HOST [--] COMMAND...
"""
import os
import pathlib
import subprocess
import sys
import time

from dying_machine import kill_all


def main():
    words = sys.argv[1:]
    while words[0].startswith("-"):
        words.pop(0)
    host = words.pop(0)
    command = " ".join(words[1:] if words[0] == "--" else words)
    login = {"SHELL": "/bin/sh", **os.environ}  # which sshd sets, and parallel relies on
    if host != "mortal":
        return subprocess.run(["sh", "-c", command], env=login).returncode
    output = pathlib.Path(os.environ["FARM_OUTPUT"])
    grave = output / "mortal_is_dead"
    if not grave.exists():
        mark = {"ON_HOST": f"mortal of {output}"}
        work = subprocess.Popen(["sh", "-c", command], env={**login, **mark})
        while work.poll() is None and not any(output.rglob("*.coif")):
            time.sleep(0.01)
        kill_all([f"{name}={value}" for name, value in mark.items()])
        work.wait()
        grave.touch()
    return 255


if __name__ == "__main__":
    sys.exit(main())
