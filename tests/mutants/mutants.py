#!/usr/bin/env python3
"""Puts mistakes into a copy of the project, one at a time, and counts those that the tests notice.

  tests/mutants/mutants.py WORK [PROJECT [CMAKE_ARGUMENT...]]

WORK is a folder for the copy and its build, PROJECT the tree to copy, by default this one. All mistakes (mutants.txt) are
compiled in at once, each behind a condition that is true where the environment variable COIF_MUTANT holds its number, so
that one build serves for all of them. First the tests must pass without any; then each mistake must make one of its tests
fail. Prints a line for each and a sum; ends with 1 where one survived, and with 2 where something could not be tried.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

HEADER = """#pragma once
#ifdef __cplusplus
#include <cstdlib>
namespace coif_mutants {
inline const int chosen = std::getenv("COIF_MUTANT") ? std::atoi(std::getenv("COIF_MUTANT")) : 0;
}
#endif
"""


def read_mutants(file):
    """[(code, mistake, tests)], numbered from 1 by whoever enumerates them."""
    lines = [line for line in file.read_text().splitlines() if line and not line.startswith("#")]
    if len(lines) % 3:
        sys.exit(f"{file}: three lines to a mutant, but there are {len(lines)}")
    return list(zip(lines[0::3], lines[1::3], lines[2::3]))


def plant(source, mutants):
    """Changes the files; returns the numbers that found no place, with how many places there were."""
    texts = {}
    for folder in ("formats", "runtime", "tools"):
        for path in (source / folder).rglob("*"):
            if path.suffix in (".h", ".cpp"):
                texts[path] = path.read_text()
    lost = {}
    for number, (code, mistake, _) in enumerate(mutants, 1):
        holders = [path for path, text in texts.items() if code in text]
        places = sum(texts[path].count(code) for path in holders)
        if places != 1:
            lost[number] = places
            continue
        texts[holders[0]] = texts[holders[0]].replace(code, mistake.replace("MUTANT", f"(coif_mutants::chosen == {number})"))
    for path, text in texts.items():
        path.write_text(text)
    return lost


def copy(project, work):
    source = work / "source"
    shutil.rmtree(source, ignore_errors=True)
    ignored = shutil.ignore_patterns("build", ".git", "out")
    shutil.copytree(project, source, ignore=ignored)
    return source


def build(source, work, arguments):
    header = work / "mutants.h"
    header.write_text(HEADER)
    configure = ["cmake", "-S", source, "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                 f"-DCMAKE_CXX_FLAGS=-include {header}", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DCOIF_INSTALL=OFF", *arguments]
    log = open(work / "build.log", "wb")
    subprocess.run(configure, check=True, stdout=log, stderr=log)
    subprocess.run(["cmake", "--build", work / "build"], check=True, stdout=log, stderr=log)


def failed_tests(work, tests, number):
    """Names of the tests that fail with that mistake; None where no test fits."""
    command = ["ctest", "--test-dir", work / "build", "-R", tests, "-j", str(os.cpu_count()), "--timeout", "300"]
    if number:
        command.append("--stop-on-failure")
    environment = {**os.environ, "COIF_MUTANT": str(number)}
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    if "No tests were found" in done.stdout + done.stderr:
        return None
    return re.findall(r"Test +#\d+: (\S+) .*\*\*\*(?:Failed|Exception|Timeout)", done.stdout)


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    work = pathlib.Path(sys.argv[1]).resolve()
    here = pathlib.Path(__file__).resolve()
    project = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else here.parents[2]
    mutants = read_mutants(here.with_name("mutants.txt"))
    work.mkdir(parents=True, exist_ok=True)
    source = copy(project, work)
    lost = plant(source, mutants)
    build(source, work, sys.argv[3:])
    every = "|".join(dict.fromkeys(tests for _, _, tests in mutants))
    if before := failed_tests(work, every, 0):
        print("fails without a mistake: " + " ".join(before))
        return 2
    survived = 0
    for number, (code, _, tests) in enumerate(mutants, 1):
        if number in lost:
            print(f"{number:3} {lost[number]} places: {code}")
            continue
        failed = failed_tests(work, tests, number)
        survived += not failed
        print(f"{number:3} {'caught by ' + failed[0] if failed else 'SURVIVED'}: {code}", flush=True)
    print(f"{len(mutants)} mistakes, {len(mutants) - survived - len(lost)} caught, {survived} survived, {len(lost)} without a place")
    return 1 if survived else 2 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
