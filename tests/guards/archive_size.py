#!/usr/bin/env python3
"""How many bytes of code and constants a shipped archive holds: .text, .rodata and .data of every member, after strip.
A program takes at most that, as it links only the members that it refers to. The archives that it needs beside are
measured too, without a limit.

usage: archive_size.py LIMIT AR STRIP OBJDUMP ARCHIVE [NEEDED...] | --self-test AR STRIP OBJDUMP COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# With -ffunction-sections each function has a section of its own: .text._ZN4coif...
COUNTED = re.compile(r"\.(text|rodata|data)(\.|$)")
SECTION = re.compile(r"^\s*\d+\s+(\S+)\s+([0-9a-f]+)\s")


def output(*command, folder=None):
    return subprocess.run(command, check=True, capture_output=True, text=True, cwd=folder).stdout


def code_bytes(ar, strip, objdump, archive):
    """Bytes of the counted sections of all members."""
    total = 0
    with tempfile.TemporaryDirectory() as folder:
        output(ar, "x", str(Path(archive).resolve()), folder=folder)
        for member in sorted(Path(folder).iterdir()):
            output(strip, "--strip-unneeded", member)
            for match in map(SECTION.match, output(objdump, "-h", "-w", member).splitlines()):
                if match and COUNTED.match(match[1]):
                    total += int(match[2], 16)
    return total


def check(limit, ar, strip, objdump, archives):
    """A line for each archive and one for all, and the complaints. The limit is the first archive's."""
    sizes = {Path(archive).name: code_bytes(ar, strip, objdump, archive) for archive in archives}
    lines = [f"{name}: {size} bytes of code" for name, size in sizes.items()]
    lines[0] += f", {limit} allowed"
    lines.append(f"together: {sum(sizes.values())}")
    bad = [f"{name}: nothing in it: nothing was measured" for name, size in sizes.items() if size == 0]
    name, size = next(iter(sizes.items()))
    if size > limit:
        bad.append(f"{name}: {size - limit} bytes more than allowed; leave something out, or out of line")
    return lines, bad


def self_test(ar, strip, objdump, compiler):
    data = "extern const char table[3000]; const char table[3000] = {1}; int code(int x) { return x * table[x]; }\n"
    must_fail = [(data, 2999), ("", 1 << 20)]
    must_pass = [(data, 3200)]
    bad = []
    for number, (body, limit) in enumerate(must_fail + must_pass):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "case.cpp").write_text(body)
            output(compiler, "-Os", "-g", "-ffunction-sections", "-fdata-sections", "-c", "case.cpp", folder=folder)
            output(ar, "cr", "case.a", "case.o", folder=folder)
            fired = bool(check(limit, ar, strip, objdump, [Path(folder, "case.a")])[1])
            if fired != (number < len(must_fail)):
                bad.append(f"{'fired on' if fired else 'did not fire on'} case {number}, limit {limit}")
    return [f"archive size: {len(must_fail) + len(must_pass)} cases checked"], bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        report, problems = self_test(*sys.argv[2:])
    else:
        report, problems = check(int(sys.argv[1]), *sys.argv[2:5], sys.argv[5:])
    print("\n".join(report + problems))
    sys.exit(1 if problems else 0)
