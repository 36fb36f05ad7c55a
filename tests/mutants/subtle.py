#!/usr/bin/env python3
"""Puts subtle mistakes into a copy of the project, one at a time, and lists those that no test notices.

  tests/mutants/subtle.py WORK [--count 300] [--seed 1] [--only NUMBER,...] [--folders formats,runtime/sim,tools/cook]
                          [--tests REGEX] [--without REGEX] [--shortest SECONDS] [--longest SECONDS] [-D... for CMake]

A mistake is a constant a tenth larger, `<` for `<=`, a call left out or two arguments swapped. Where they are made is drawn by
lot from all such places of the folders, as many of each kind. Left out are only those that do not compile, and of numbers
those that are 0 and whole ones below 8. All are compiled in at once, each behind a condition that is true where COIF_MUTANT
holds its number. Tests are taken suite by suite. First each suite runs without a mistake and says which mistakes' places it
comes through; then, for each mistake, those suites run that come through it, the quickest first, until one fails. Prints a line
for each mistake, and a sum by folder and by kind; ends with 1 where more than a tenth survived, and with 2 where a suite fails
without a mistake. Some survivors change nothing that anybody can see: `<` for `<=` in a minimum, a limit that a second one
repeats. harmless.txt tells them with the reason; they are listed and not counted, and one of them that a test notices, or whose
line is gone, is an error (1). WORK keeps what was built and learned; --only goes on with those that an earlier run left.
"""
import argparse
import collections
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys

import subtle_mistakes
import suites as test_suites

HEADER = """#pragma once
#ifdef __cplusplus
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace coif_mutants {
// A file in memory, so that what crashes and what a child does is known as well.
inline unsigned char* shared() {
  static unsigned char own[4096];
  const char* const name = std::getenv("COIF_MUTANTS_SEEN");
  const int file = name ? ::open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0666) : -1;
  if (file < 0 || ::ftruncate(file, sizeof own) != 0) return own;
  void* const all = ::mmap(nullptr, sizeof own, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return all == MAP_FAILED ? own : static_cast<unsigned char*>(all);
}
inline unsigned char* const seen = shared();
inline const int chosen = std::getenv("COIF_MUTANT") ? std::atoi(std::getenv("COIF_MUTANT")) : 0;
inline bool at(int number) { seen[number] = 1; return number == chosen; }
struct Less { int number; };
struct LessEqual { int number; };
struct Greater { int number; };
struct GreaterEqual { int number; };
template <class L, class Kind> struct Left { const L& left; int number; };
template <class L> Left<L, Less> operator<(const L& left, Less kind) { return {left, kind.number}; }
template <class L> Left<L, LessEqual> operator<(const L& left, LessEqual kind) { return {left, kind.number}; }
template <class L> Left<L, Greater> operator<(const L& left, Greater kind) { return {left, kind.number}; }
template <class L> Left<L, GreaterEqual> operator<(const L& left, GreaterEqual kind) { return {left, kind.number}; }
template <class L, class R> bool operator>(Left<L, Less> l, const R& r) { return at(l.number) ? l.left <= r : l.left < r; }
template <class L, class R> bool operator>(Left<L, LessEqual> l, const R& r) { return at(l.number) ? l.left < r : l.left <= r; }
template <class L, class R> bool operator>(Left<L, Greater> l, const R& r) { return at(l.number) ? l.left >= r : l.left > r; }
template <class L, class R> bool operator>(Left<L, GreaterEqual> l, const R& r) { return at(l.number) ? l.left > r : l.left >= r; }
}
#endif
"""
# Places beyond those asked for, since some do not compile: mostly arguments of two types.
SPARE = {"swapped arguments": 6}
USUAL_SPARE = 1.5


class Mistake:
    """`path` in the project; `lot` tells it from all others; `text` is its line as it was."""

    def __init__(self, number, lot, path, line, place, text):
        self.number, self.lot, self.path, self.line, self.place, self.text = number, lot, path, line, place, text
        self.kind = place[0]


def draw_mistakes(project, folders, count, seed):
    """Mistakes in the order in which they are drawn, as many of each kind, no two of a line. A place's lot depends on its own line,
    so that a change elsewhere in the tree leaves the others as they were."""
    places, twins = [], collections.Counter()
    for folder in folders:
        for path in sorted((project / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            text = path.read_text()
            lines = text.splitlines()
            for place in subtle_mistakes.find(text):
                line = text.count("\n", 0, place[1]) + 1
                what = f"{seed} {path.relative_to(project)} {lines[line - 1]} {place[0]} {place[3]}"
                twins[what] += 1
                lot = hashlib.sha256(f"{what} {twins[what]}".encode()).hexdigest()
                places.append((lot, path.relative_to(project), line, place, lines[line - 1].strip()))
    print(f"{len(places)} places: " + ", ".join(f"{n} {kind}" for kind, n in
                                                collections.Counter(place[3][0] for place in places).items()), flush=True)
    drawn, taken, left = [], set(), {}
    share = count / len(subtle_mistakes.KINDS)
    for lot, path, line, place, text in sorted(places, key=lambda p: p[0]):
        left.setdefault(place[0], int(share * SPARE.get(place[0], USUAL_SPARE)))
        if (path, line) not in taken and left[place[0]] > 0:
            left[place[0]] -= 1
            taken.add((path, line))
            drawn.append(Mistake(len(drawn) + 1, lot, path, line, place, text))
    return drawn


def write_source(project, source, drawn):
    """The project with the mistakes; files that would not change keep their times, so that little is built anew."""
    wanted = set()
    for path in project.rglob("*"):
        name = path.relative_to(project)
        if name.parts[0] in ("build", ".git", "out") or not path.is_file():
            continue
        wanted.add(name)
        content = path.read_bytes()
        here = [(m.number, m.place) for m in drawn if m.path == name]
        if here:
            content = subtle_mistakes.plant(content.decode(), here).encode()
        target = source / name
        if not target.exists() or target.read_bytes() != content:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
            shutil.copymode(path, target)
    for path in list(source.rglob("*")):
        if path.is_file() and path.relative_to(source) not in wanted:
            path.unlink()


def at_fault(source, drawn, log):
    """Mistakes that the compiler's errors point to."""
    faults = set()
    for m in re.finditer(r"^(/[^:\n]+):(\d+):\d+: (?:fatal )?error: (.*(?:\n(?!/[^:\n]+:\d+:\d+: error).*)*)", log, re.MULTILINE):
        path, line, rest = pathlib.Path(m.group(1)), int(m.group(2)), m.group(3)
        if not path.is_relative_to(source):
            continue
        here = {d for d in drawn if source / d.path == path and d.line == line}
        notes = {(pathlib.Path(p), int(n)) for p, n in re.findall(r"(/[^:\s]+):(\d+):\d+: ", rest)}
        here = here or {d for d in drawn if (source / d.path, d.line) in notes}
        # A constant that the compiler has to know, where it is used.
        used = set(re.findall(r"\bk[A-Z]\w*", path.read_text().splitlines()[line - 1]))
        here = here or {d for d in drawn if d.kind == "constant" and used & set(re.findall(r"\bk[A-Z]\w*", d.text))}
        faults |= here or {d for d in drawn if source / d.path == path}
    if not faults:  # a template of somebody else's, which a line of ours asked for
        asked = {(pathlib.Path(p), int(n)) for p, n in re.findall(r"^(/[^:\n]+):(\d+):\d+:   required from", log, re.MULTILINE)}
        faults = {d for d in drawn if (source / d.path, d.line) in asked}
    return faults


def build(project, work, drawn, arguments):
    """Builds with all mistakes that compile; the others are taken out of the list, and known by their lots next time. True where
    all was built already."""
    source, header, known = work / "source", work / "subtle.h", work / "not_compiling.txt"
    if not header.exists() or header.read_text() != HEADER:
        header.write_text(HEADER)
    useless = set(known.read_text().split()) if known.exists() else set()
    drawn[:] = [m for m in drawn if m.lot not in useless]
    configure = ["cmake", "-S", source, "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                 f"-DCMAKE_CXX_FLAGS=-include {header} -w", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -D_GLIBCXX_ASSERTIONS",
                 "-DCOIF_INSTALL=OFF", *arguments]
    while True:
        write_source(project, source, drawn)
        subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
        done = subprocess.run(["cmake", "--build", work / "build", "--", "-k", "0"], capture_output=True, text=True)
        (work / "build.log").write_text(done.stdout + done.stderr)
        if done.returncode == 0:
            return "no work to do" in done.stdout
        faults = at_fault(source, drawn, done.stdout + done.stderr)
        if not faults:
            sys.exit(f"{work}/build.log: does not build, and not for a mistake's sake")
        drawn[:] = [m for m in drawn if m not in faults]
        known.write_text("\n".join(sorted(useless := useless | {m.lot for m in faults})))
        print(f"{len(faults)} do not compile, {len(drawn)} are left", flush=True)


def choose(drawn, count):
    """As many of each kind, and the first of them, one of each kind after the other."""
    of_kind = [[m for m in drawn if m.kind == kind] for kind in subtle_mistakes.KINDS]
    return [m for round_ in zip(*of_kind) for m in round_][:count]


def read_harmless(project):
    """{(path, line, kind): reason}, of lines that are there; ends the program where one is not."""
    known, text = {}, (project / "tests/mutants/harmless.txt").read_text()
    for entry in re.split(r"\n\n+", re.sub(r"^#.*\n", "", text, flags=re.MULTILINE).strip()):
        place, line, told = (part.strip() for part in entry.split("\n", 2))
        kind, reason = told.split(": ", 1)
        if line not in [other.strip() for other in (project / place).read_text().splitlines()]:
            sys.exit(f"tests/mutants/harmless.txt: {place} has no such line: {line}")
        known[pathlib.Path(place), line, kind] = " ".join(reason.split())
    return known


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=lambda text: [int(number) for number in text.split(",")], help="numbers of mistakes")
    parser.add_argument("--folders", type=lambda text: text.split(","), default=["formats", "runtime/sim", "tools/cook"])
    parser.add_argument("--tests", default="", help="names of the tests and suites that may notice, by default all")
    parser.add_argument("--longest", type=float, default=20, help="seconds that a suite may take to be asked")
    parser.add_argument("--shortest", type=float, default=0, help="seconds that a suite must take; to go on where a run has ended")
    parser.add_argument("--without", default=r"^(consumer|guard|farm|bench|fuzz|example|other_builds)\b|^cli\.(report|galler)",
                        help="names of tests and of suites (program:suite) that are not asked")
    return parser.parse_known_args()


def main():
    given, cmake_arguments = read_arguments()
    project = pathlib.Path(__file__).resolve().parents[2]
    given.work.mkdir(parents=True, exist_ok=True)
    harmless = read_harmless(project)
    drawn = draw_mistakes(project, given.folders, given.count, given.seed)
    is_as_before = build(project, given.work, drawn, cmake_arguments)
    suites = test_suites.list_suites(given.work, given.tests, given.without)
    if failed := test_suites.learn_reach(suites, given.work, is_as_before, given.longest):
        print("fails without a mistake: " + " ".join(failed))
        return 2
    left_out = [suite for suite in suites if not given.shortest <= suite.seconds <= given.longest]
    suites = [suite for suite in suites if suite not in left_out]
    print(f"{len(left_out)} suites left out that take less than {given.shortest} s or more than {given.longest} s")
    print(f"{len(suites)} suites, {sum(suite.seconds for suite in suites):.0f} s", flush=True)
    sample, untouched = given.work / "build/sample", given.work / "sample"
    shutil.rmtree(untouched, ignore_errors=True)
    if sample.exists():  # not without the tools
        shutil.copytree(sample, untouched)
    survivors, tried, noticed = [], [], []
    chosen = choose(drawn, given.count) if not given.only else [m for m in drawn if m.number in given.only]
    for m in chosen:
        caught = test_suites.find_test(suites, m.number)
        if any(suite.is_fixture and m.number in suite.reached for suite in suites):
            shutil.copytree(untouched, sample, dirs_exist_ok=True)
        reach = sum(m.number in suite.reached for suite in suites)
        verdict = f"caught by {caught}" if caught else f"SURVIVED {reach} suites"
        reason = harmless.get((m.path, m.text, m.kind))
        if reason and caught:
            noticed.append(m)
        elif reason:
            verdict = f"harmless, {reason}"
        if not reason or caught:
            tried.append(m)
            survivors += [] if caught else [m]
        print(f"{m.number:4} {m.kind}: {verdict}: {m.path}:{m.line}: {m.text}  =>  {m.place[3]}", flush=True)
    for what in ("folder", "kind"):
        name = (lambda m: m.kind) if what == "kind" else (lambda m: next(f for f in given.folders if m.path.is_relative_to(f)))
        every, left = collections.Counter(map(name, tried)), collections.Counter(map(name, survivors))
        print(f"by {what}: " + ", ".join(f"{key} {left[key]} of {every[key]} survived" for key in sorted(every)))
    share = len(survivors) / max(1, len(tried))
    print(f"{len(tried)} mistakes, {len(tried) - len(survivors)} caught, {len(survivors)} survived ({100 * share:.1f} %)")
    print(f"not counted: {len([m for m in chosen if m not in tried])} that tests/mutants/harmless.txt says to change nothing")
    for m in noticed:
        print(f"tests/mutants/harmless.txt is wrong: {m.path}:{m.line} is noticed")
    return 1 if share > 0.1 or noticed else 0


if __name__ == "__main__":
    sys.exit(main())
