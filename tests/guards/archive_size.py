#!/usr/bin/env python3
"""How many bytes of code and constants a program takes of a shipped archive: .text, .rodata and .data, after strip, of the
members that the linker's map says it took. What several of these have, as templates, the linker takes once. The archives that it needs beside are measured too, without a limit, and each as
a whole.

usage: archive_size.py LIMIT MAP AR STRIP OBJDUMP ARCHIVE [NEEDED...] | --self-test AR STRIP OBJDUMP COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# With -ffunction-sections each function has a section of its own: .text._ZN4coif...
COUNTED = re.compile(r"\.(text|rodata|data)(\.|$)")
# In the map: /where/libcoif_sim.a(hair.cpp.o), and who asked for it.
MEMBER = re.compile(r"^(?:\S*/)?([^/\s]+\.a)\(([^)\s]+)\)", re.MULTILINE)
SECTION = re.compile(r"^\s*\d+\s+(\S+)\s+([0-9a-f]+)\s")
# In a table of symbols: one that is weak, and its section.
WEAK = re.compile(r"^[0-9a-f]+  ?w\s+\S*\s+(\.\S+)\s", re.MULTILINE)


def output(*command, folder=None):
    return subprocess.run(command, check=True, capture_output=True, text=True, cwd=folder).stdout


def code_bytes(ar, strip, objdump, archive):
    """The counted sections of each member: (name, whether others may have the same, bytes)."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        output(ar, "x", str(Path(archive).resolve()), folder=folder)
        for member in sorted(Path(folder).iterdir()):
            output(strip, "--strip-unneeded", member)
            weak = set(WEAK.findall(output(objdump, "-t", member)))
            sections = filter(None, map(SECTION.match, output(objdump, "-h", "-w", member).splitlines()))
            found[member.name] = [(name, name in weak, int(size, 16))
                                  for name, size in (section.groups() for section in sections) if COUNTED.match(name)]
    return found


def size_of(members):
    """Bytes of their sections, those that several may have counted once."""
    shared = {name: size for sections in members for name, is_shared, size in sections if is_shared}
    return sum(shared.values()) + sum(size for sections in members for _, is_shared, size in sections if not is_shared)


def check(limit, link_map, ar, strip, objdump, archives):
    """A line for each archive, and the complaints. The limit is the first archive's."""
    taken = set(MEMBER.findall(Path(link_map).read_text()))
    lines, bad = [], []
    for archive in archives:
        name = Path(archive).name
        members = code_bytes(ar, strip, objdump, archive)
        linked = size_of([sections for member, sections in members.items() if (name, member) in taken])
        lines.append(f"{name}: {linked} bytes linked, {size_of(members.values())} in all")
        if linked == 0:
            bad.append(f"{name}: nothing of it is linked: nothing was measured")
        if archive == archives[0]:
            lines[0] += f"; {limit} linked allowed"
            if linked > limit:
                bad.append(f"{name}: {linked - limit} bytes more than allowed; leave something out, or out of line")
    return lines, bad


def self_test(ar, strip, objdump, compiler):
    """Of an archive a program takes the members it names; only those count, and what two of them have counts once."""
    both = "inline __attribute__((noinline)) int both(int x) { asm(\".skip 3000\"); return x; }\n"
    sources = {
        "one": both + "int one(int x) { return both(x); }\n",
        "two": both + "int two(int x) { return both(x); }\n",
        "twins": "int one(int); int two(int); int main() { return one(0) + two(0); }\n",
        "named": "extern const char table[3000]; const char table[3000] = {1}; int f(int x) { return x * table[x]; }\n",
        "unnamed": "extern const char other[9000]; const char other[9000] = {1};\n",
        "main": "int f(int); int main() { return f(0); }\n",
        "alone": "int main() {}\n"}
    cases = [("main", 3300, False), ("main", 2999, True), ("alone", 3300, True), ("twins", 3300, False),
             ("twins", 2999, True)]
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sources.items():
            Path(folder, f"{name}.cpp").write_text(text)
            output(compiler, "-Os", "-g", "-ffunction-sections", "-fdata-sections", "-c", f"{name}.cpp", folder=folder)
        output(ar, "cr", "case.a", "named.o", "unnamed.o", "one.o", "two.o", folder=folder)
        for program, limit, must_fail in cases:
            output(compiler, f"{program}.o", "case.a", f"-Wl,-Map={program}.map", "-o", program, folder=folder)
            found = check(limit, Path(folder, f"{program}.map"), ar, strip, objdump, [Path(folder, "case.a")])[1]
            if bool(found) != must_fail:
                bad.append(f"{program}, limit {limit}: {found or 'did not fire'}")
    return [f"archive size: {len(cases)} cases checked"], bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        report, problems = self_test(*sys.argv[2:])
    else:
        report, problems = check(int(sys.argv[1]), *sys.argv[2:6], sys.argv[6:])
    print("\n".join(report + problems))
    sys.exit(1 if problems else 0)
