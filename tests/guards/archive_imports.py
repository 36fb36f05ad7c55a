#!/usr/bin/env python3
"""What the shipped archives ask of the outside: a few functions of libc and libm, and each other. A container, a
hidden allocation, an exception or a directly linked OpenGL call would show up here as an undefined symbol. With --highway
they may also ask for what is in Highway's namespace.

usage: archive_imports.py [--highway] NM ARCHIVE... | --self-test NM COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ALLOWED = {
    "memcmp", "memcpy", "memmove", "memset", "strlen", "strcmp", "strncmp", "snprintf",
    "sqrt", "sqrtf", "exp", "expf", "exp2f", "fabs", "fmodf", "pow", "powf", "sin", "sinf", "cos", "cosf", "sincosf",
    "atan2f", "acosf", "expm1", "sincos", "atan2", "ceilf",
    # Put in by the compiler, at the distribution's hardening level.
    "__udivmoddi4", "__umoddi3", "__udivdi3", "__divdi3", "__moddi3",  # libgcc's division of 64 bits on 32
    "_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail", "__memcpy_chk", "__memset_chk", "__snprintf_chk",
}

# Functions and variables of namespace hwy, of its own or inside of it: _ZN3hwy..., const members _ZNK3hwy...
HIGHWAY = re.compile(r"_ZNK?3hwy")


def undefined_symbols(nm, archives):
    """Symbols that no archive of the list defines, and how many symbols were seen in all."""
    wanted, defined = set(), set()
    for archive in archives:
        listing = subprocess.run([nm, "--format=posix", archive], check=True, capture_output=True, text=True).stdout
        for fields in (line.split() for line in listing.splitlines()):
            if len(fields) >= 2 and not fields[0].endswith(":"):
                (wanted if fields[1] in "Uw" else defined).add(fields[0])
    return wanted - defined, len(wanted | defined)


def check(nm, archives, highway=False):
    missing, seen = undefined_symbols(nm, archives)
    bad = [f"imports {symbol}, which is not on the list" for symbol in sorted(missing - ALLOWED)
           if not (highway and HIGHWAY.match(symbol))]
    for archive in archives:
        if undefined_symbols(nm, [archive])[1] == 0:
            bad.append(f"{archive}: no symbol seen: nothing was checked")
    return seen, bad


def self_test(nm, compiler):
    header = "#include <vector>\n#include <cstring>\nextern \"C\" void glClear(unsigned);\n"
    vectors = "namespace hwy { struct Targets { long get() const; }; long f(); } long g(hwy::Targets& t) { return t.get() + hwy::f(); }"
    must_fail = [vectors, "int* f() { return new int; }", "void f() { throw 1; }", "void f(std::vector<int>& v) { v.push_back(1); }",
                 "void f() { glClear(1); }", "struct B { virtual void g(); virtual ~B(); }; void B::g() {} B::~B() {}", ""]
    must_pass = ["void g(); void f(char* a, char* b, int n) { std::memcpy(a, b, n); g(); } void g() {}"]
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        for number, body in enumerate(must_fail + must_pass):
            source, object_file = Path(folder, "case.cpp"), Path(folder, f"case{number}.o")
            source.write_text((header if body else "") + body)
            subprocess.run([compiler, "-std=c++20", "-O0", "-fPIC", "-c", source, "-o", object_file], check=True)
            fired = bool(check(nm, [str(object_file)])[1])
            if fired != (body in must_fail):
                bad.append(f"{'fired on' if fired else 'did not fire on'}: {body!r}")
            with_highway = bool(check(nm, [str(object_file)], highway=True)[1])
            if with_highway != (body in must_fail and body != vectors):
                bad.append(f"--highway changes more or less than Highway's own: {body!r}")
    return len(must_fail) + len(must_pass), bad


if __name__ == "__main__":
    arguments = [argument for argument in sys.argv[1:] if argument != "--highway"]
    if arguments[0] == "--self-test":
        seen, problems = self_test(*arguments[1:])
    else:
        seen, problems = check(arguments[0], arguments[1:], highway=len(arguments) < len(sys.argv) - 1)
    print("\n".join(problems) or f"archive imports: {seen} symbols or cases checked")
    sys.exit(1 if problems else 0)
