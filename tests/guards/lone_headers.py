#!/usr/bin/env python3
"""Every public header compiles alone, twice in one file, with the flags a game is likely to have; those of the C interface
also in C.

usage: lone_headers.py C_COMPILER COMPILER INCLUDE_DIR... | --self-test C_COMPILER COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FLAGS = ["-std=c++20", "-fsyntax-only", "-fno-exceptions", "-fno-rtti", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
         "-Wshadow", "-Wold-style-cast", "-Werror", "-x", "c++"]
C_FLAGS = ["-std=c99", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wstrict-prototypes", "-Wc++-compat",
           "-Werror", "-x", "c"]
C_HEADER = re.compile(r"coif\.h|coif/version\.h|coif/c/\w+\.h")


def compile_errors(compiler, flags, roots, header):
    """The compiler's complaints about a file that holds nothing but this header, twice."""
    text = f"#include <{header}>\n#include <{header}>\nextern int nothing;\n"  # no C file is empty
    result = subprocess.run([compiler, *flags, *(f"-I{root}" for root in roots), "-"], input=text, capture_output=True,
                            text=True)
    return result.stderr if result.returncode else ""


def check(c_compiler, compiler, roots):
    headers = [p.relative_to(root).as_posix() for root in roots for p in sorted(Path(root).rglob("*.h"))]
    bad = [] if headers else ["no public header found: nothing was compiled"]
    for header in headers:
        errors = compile_errors(compiler, FLAGS, roots, header)
        if C_HEADER.fullmatch(header):
            errors += compile_errors(c_compiler, C_FLAGS, roots, header)
        if errors:
            bad.append(f"{header} does not compile alone:\n{errors}")
    return len(headers), bad


def self_test(c_compiler, compiler):
    must_fail = ["#pragma once\nstd::uint32_t f();", "struct TwiceDefined {};", "#pragma once\ninline void f() { throw 1; }",
                 "#pragma once\n#include <typeinfo>\ninline auto& f(int& i) { return typeid(i); }"]
    must_pass = ["#pragma once\n#include <cstdint>\nstd::uint32_t f();"]
    cases = [("case.h", text, text in must_fail) for text in must_fail + must_pass]
    for header in ("coif.h", "coif/c/case.h"):
        cases += [(header, "#pragma once\nnamespace coif {}", True), (header, "#pragma once\nint f();", True),
                  (header, "#pragma once\nvoid f(bool);", True), (header, "#pragma once\nint f(void);", False)]
    bad = []
    for header, text, must_fire in cases:
        with tempfile.TemporaryDirectory() as root:
            Path(root, header).parent.mkdir(parents=True, exist_ok=True)
            Path(root, header).write_text(text)
            if bool(check(c_compiler, compiler, [root])[1]) != must_fire:
                bad.append(f"{'did not fire on' if must_fire else 'fired on'} {header}: {text!r}")
    with tempfile.TemporaryDirectory() as root:
        if not check(c_compiler, compiler, [root])[1]:
            bad.append("an empty folder passed")
    return len(cases) + 1, bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        seen, problems = self_test(*sys.argv[2:])
    else:
        seen, problems = check(sys.argv[1], sys.argv[2], sys.argv[3:])
    print("\n".join(problems) or f"lone headers: {seen} checked")
    sys.exit(1 if problems else 0)
