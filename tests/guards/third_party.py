#!/usr/bin/env python3
"""Whose works are in coif is said for each library of the group [program] in packages.txt: its licence's text in the notices, and a package that
coif depends on in the SPDX file.

usage: third_party.py PACKAGES_TXT NOTICES SPDX_JSON | --self-test
"""
import json
import re
import sys
from pathlib import Path


def libraries(packages):
    group = re.search(r"^\[program\]$(.*?)^\[", packages, re.MULTILINE | re.DOTALL)
    return re.findall(r"^(?:[a-z]\S*-dev|libjs-\S+)$", group[1] if group else "", re.MULTILINE)


def faults(packages, notices, spdx):
    names = libraries(packages)
    bad = [] if names else ["packages.txt: no library in the group [program]: nothing was looked for"]
    for key in ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo"):
        if key not in spdx:
            bad.append(f"the SPDX file has no \"{key}\"")
    known = {package["SPDXID"]: package for package in spdx.get("packages", [])}
    needed = {r["relatedSpdxElement"] for r in spdx.get("relationships", []) if r["relationshipType"] == "DEPENDS_ON"}
    for name in names:
        text = re.search(rf"\({re.escape(name)} [^)]*\)\n=+\n\n(.*?)(?:\n====|\Z)", notices, re.DOTALL)
        if not text or len(text[1]) < 300:
            bad.append(f"{name}: its licence's text is not in the notices")
        package = known.get(f"SPDXRef-{name}")
        if not package or not package.get("licenseDeclared") or f"SPDXRef-{name}" not in needed:
            bad.append(f"{name}: the SPDX file does not say that coif depends on it, or by which licence")
    return len(names), bad


def self_test():
    packages = "[program]\n#= One | MIT | program\nlibone-dev\n[tests]\nlibtwo-dev\n"
    notices = "coif\n\n====\nOne, MIT (libone-dev 1.0)\n====\n\n" + "may be used " * 40
    spdx = {key: "x" for key in ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo")}
    spdx["packages"] = [{"SPDXID": "SPDXRef-libone-dev", "licenseDeclared": "MIT"}]
    spdx["relationships"] = [{"relationshipType": "DEPENDS_ON", "relatedSpdxElement": "SPDXRef-libone-dev"}]
    assert faults(packages, notices, spdx) == (1, []), faults(packages, notices, spdx)
    assert faults(packages, notices[:60], spdx)[1]
    assert faults(packages, notices, {**spdx, "packages": []})[1]
    assert faults(packages, notices, {**spdx, "relationships": []})[1]
    assert faults("[tests]\n", notices, spdx)[1]
    return 5


def main():
    if sys.argv[1:] == ["--self-test"]:
        print(f"third party: {self_test()} cases checked")
        return 0
    packages, notices, spdx = (Path(name).read_text(encoding="utf-8") for name in sys.argv[1:])
    count, bad = faults(packages, notices, json.loads(spdx))
    print(*bad, f"third party: {count} libraries checked", sep="\n")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
