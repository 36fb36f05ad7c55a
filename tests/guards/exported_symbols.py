#!/usr/bin/env python3
"""A shared library shows its public interface and nothing else: what a public header names, functions of the C interface
in libcoif.so and namespace coif in all others. libcoif.so shows all that the headers of the C interface declare. Headers
of other folders add what they mark COIF_API, for libraries of ours that stand on that one.

usage: exported_symbols.py NM INCLUDE_DIR... [--marked DIR...] -- LIBRARY... | --self-test NM COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NAME = re.compile(r"[A-Za-z_]\w*")
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
C_FUNCTION = re.compile(r"\b(coif_\w+)\(")


MARKED = re.compile(r"^(?:.*\bCOIF_API\b.*|(?:class|struct) \w+.*\{)$", re.MULTILINE)


def is_c_header(path):
    return path.name == "coif.h" or path.parent.parts[-2:] == ("coif", "c")


def exported(nm, library):
    """Demangled names as a linker sees them, without arguments."""
    listing = subprocess.run([nm, "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return [line.split(maxsplit=2)[2].split("(")[0] for line in listing.splitlines()]


def fault(symbol, is_c, public):
    if is_c and not re.fullmatch(r"coif_\w+", symbol):
        return "is no function of the C interface"
    if not is_c and not re.fullmatch(r"coif(::~?\w+)+", symbol):
        return "is not in namespace coif"
    if not public.issuperset(NAME.findall(symbol)):
        return "is in no public header"
    return None


def check(nm, roots, libraries, marked=()):
    files = [header for root in roots for header in sorted(Path(root).rglob("*.h"))]
    headers = [header.read_text() for header in files]
    inner = [line for root in marked for header in sorted(Path(root).rglob("*.h")) for line in MARKED.findall(header.read_text())]
    public = set(NAME.findall("\n".join(headers + inner)))
    promised = {name for path, text in zip(files, headers) if is_c_header(path)
                for name in C_FUNCTION.findall(COMMENT.sub("", text))}
    seen, bad = 0, [] if headers else ["no public header found: nothing was compared"]
    for library in libraries:
        is_c = Path(library).name.split(".")[0] == "libcoif"
        symbols = exported(nm, library)
        seen += len(symbols)
        bad += [f"{library}: {symbol} {why}" for symbol in symbols if (why := fault(symbol, is_c, public))]
        bad += [f"{library}: lacks {name}" for name in sorted(promised - set(symbols)) if is_c]
        if not symbols:
            bad.append(f"{library}: shows nothing")
    return seen, bad


def self_test(nm, compiler):
    header = "namespace coif { struct Hair { ~Hair(); void step(); }; int f(Hair); }\nextern \"C\" void coif_step(void);  // coif_inside()\n"
    cases = [  # library, its source, what is said of it
        ("libcoif_sim.so", "coif::Hair::~Hair() {} void coif::Hair::step() {}", False),
        ("libcoif_sim.so", "namespace coif { int f(Hair) { return 1; } }", False),
        ("libcoif_sim.so", "namespace coif { int inside() { return 1; } }", True),
        ("libcoif_sim.so", "namespace coif { int inner() { return 1; } }", False),
        ("libcoif_sim.so", "namespace coif { int unmarked() { return 1; } }", True),
        ("libcoif_sim.so", "namespace hwy { int f() { return 1; } }", True),
        ("libcoif_sim.so", "int f() { return 1; }", True),
        ("libcoif_sim.so", "extern \"C\" void coif_step() {}", True),
        ("libcoif_sim.so", "static int f() { return 1; } extern const int g; const int g = f();", True),
        ("libcoif_sim.so", "", True),
        ("libcoif.so.0.1", "extern \"C\" void coif_step() {}", False),
        ("libcoif.so.0.1", "extern \"C\" void coif_step() {} extern \"C\" void coif_outside() {}", True),
        ("libcoif.so.0.1", "extern \"C\" void coif_inside() {}", True),
        ("libcoif.so.0.1", "", True),
        ("libcoif.so.0.1", "void coif::Hair::step() {}", True),
    ]
    bad = []
    for name, body, must_fail in cases:
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as marked:
            Path(folder, "coif.h").write_text(header)
            Path(marked, "gl.h").write_text("class Pass {\n  COIF_API int inner();\n};\nint unmarked();\n")
            library, source = Path(folder, name), Path(folder, "case.cpp")
            source.write_text('#include "coif.h"\n' + body)
            subprocess.run([compiler, "-shared", "-fPIC", source, "-o", library], check=True)
            if bool(check(nm, [folder], [str(library)], [marked])[1]) != must_fail:
                bad.append(f"{'did not fire on' if must_fail else 'fired on'} {name}: {body!r}")
    with tempfile.TemporaryDirectory() as empty:
        if not check(nm, [empty], [])[1]:
            bad.append("no headers passed")
    return len(cases) + 1, bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        seen, problems = self_test(*sys.argv[2:])
    else:
        split = sys.argv.index("--")
        roots, marked = sys.argv[2:split], []
        if "--marked" in roots:
            roots, marked = roots[:roots.index("--marked")], roots[roots.index("--marked") + 1:]
        seen, problems = check(sys.argv[1], roots, sys.argv[split + 1:], marked)
    print("\n".join(problems) or f"exported symbols: {seen} symbols or cases checked")
    sys.exit(1 if problems else 0)
