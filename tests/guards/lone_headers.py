#!/usr/bin/env python3
"""Every public header compiles alone, twice in one file, with the flags a game is likely to have.

usage: lone_headers.py COMPILER INCLUDE_DIR... | --self-test COMPILER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

FLAGS = ["-std=c++20", "-fsyntax-only", "-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
         "-Wshadow", "-Wold-style-cast", "-Werror"]


def compile_errors(compiler, roots, header):
    """The compiler's complaints about a file that holds nothing but this header, twice."""
    text = f"#include <{header}>\n#include <{header}>\n"
    result = subprocess.run([compiler, *FLAGS, *(f"-I{root}" for root in roots), "-x", "c++", "-"], input=text,
                            capture_output=True, text=True)
    return result.stderr if result.returncode else ""


def check(compiler, roots):
    headers = [p.relative_to(root).as_posix() for root in roots for p in sorted(Path(root).rglob("*.h"))]
    bad = [] if headers else ["no public header found: nothing was compiled"]
    for header in headers:
        errors = compile_errors(compiler, roots, header)
        if errors:
            bad.append(f"{header} does not compile alone:\n{errors}")
    return len(headers), bad


def self_test(compiler):
    must_fail = ["#pragma once\nstd::uint32_t f();", "struct TwiceDefined {};", "#pragma once\ninline void f() { throw 1; }",
                 "#pragma once\n#include <typeinfo>\ninline auto& f(int& i) { return typeid(i); }"]
    must_pass = ["#pragma once\n#include <cstdint>\nstd::uint32_t f();"]
    bad = []
    for text in must_fail + must_pass:
        with tempfile.TemporaryDirectory() as root:
            Path(root, "case.h").write_text(text)
            fired = bool(check(compiler, [root])[1])
            if fired != (text in must_fail):
                bad.append(f"{'fired on' if fired else 'did not fire on'}: {text!r}")
    with tempfile.TemporaryDirectory() as root:
        if not check(compiler, [root])[1]:
            bad.append("an empty folder passed")
    return len(must_fail) + len(must_pass) + 1, bad


if __name__ == "__main__":
    seen, problems = self_test(sys.argv[2]) if sys.argv[1] == "--self-test" else check(sys.argv[1], sys.argv[2:])
    print("\n".join(problems) or f"lone headers: {seen} checked")
    sys.exit(1 if problems else 0)
