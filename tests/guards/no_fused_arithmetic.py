#!/usr/bin/env python3
"""No instruction of the shipped archives multiplies and adds, or subtracts, in one go, which rounds once where other
machines round twice. Whatever flags made them: what matters is what is in the machine code, of x86 and of ARM.

usage: no_fused_arithmetic.py OBJDUMP ARCHIVE... | --self-test OBJDUMP COMPILER
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# FMA3 and AVX-512 (vfmadd213ps, vfnmsub..., vfmaddsub..., of AVX-512 FP16 also vfmaddcph and vfcmulcph), FMA4 (vfmaddps),
# and ARM's fmadd, fnmsub, fmla, vfma and vmla, the last of which fuses nothing but belongs to code that was not asked for.
FUSED = re.compile(r"^(vfn?m(add|sub)|vfc?m(add|ul)c|fn?m(add|sub)\b|fml[as]|vfn?m[as]\b|vfn?m[as][.]|vmla[.]f|vmls[.]f)")
FUNCTION = re.compile(r"^[0-9a-f]+ <(.+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\s+([a-z][a-z0-9.]*)")  # GNU's and LLVM's


def check(objdump, archives):
    """(instructions read, sentences about fused ones and about archives of which nothing could be read)"""
    read, bad = 0, []
    for archive in archives:
        listing = subprocess.run([objdump, "-d", "-C", "--no-show-raw-insn", archive], check=True, capture_output=True, text=True).stdout
        function, here = "", 0
        for line in listing.splitlines():
            if name := FUNCTION.match(line):
                function = name[1]
            elif found := INSTRUCTION.match(line):
                here += 1
                if FUSED.match(found[1]):
                    bad.append(f"{archive}: {found[1]} in {function}")
        if here == 0:
            bad.append(f"{archive}: no instruction seen: nothing was checked")
        read += here
    return read, bad


def self_test(objdump, compiler):
    machine = subprocess.run([compiler, "-dumpmachine"], check=True, capture_output=True, text=True).stdout
    flags = ["-mfma", "-mfpmath=sse"] if re.match("x86_64|i.86", machine) else []
    fused = "float f(float a, float b, float c) { return __builtin_fmaf(a, b, c); }"
    plain = "float f(float a, float b, float c) { return a * b + c; }"
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        for number, (body, must_fail) in enumerate([(fused, True), (plain, False), ("int nothing;", True)]):
            source, object_file = Path(folder, "case.cpp"), Path(folder, f"case{number}.o")
            source.write_text(body)
            subprocess.run([compiler, "-O2", "-ffp-contract=off", *flags, "-c", source, "-o", object_file], check=True)
            if bool(check(objdump, [str(object_file)])[1]) != must_fail:
                bad.append(f"{'did not fire' if must_fail else 'fired'}: {body}")
    return bad


def main():
    if sys.argv[1] == "--self-test":
        bad = self_test(*sys.argv[2:])
    else:
        read, bad = check(sys.argv[1], sys.argv[2:])
        print(f"{read} instructions of {len(sys.argv) - 2} archives")
    for line in bad[:20]:
        print(line)
    if len(bad) > 20:
        print(f"... and {len(bad) - 20} more")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
