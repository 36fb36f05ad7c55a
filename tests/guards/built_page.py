#!/usr/bin/env python3
"""The page of `coif view` in the source tree, tools/view/built/view.html, is the one that its sources give: every source has the
digest that was recorded when the page was built. With BUILT, a page that was built from the sources just now: it has the same
bytes.

usage: built_page.py SOURCE_DIR [BUILT] | --self-test
"""
import hashlib
import sys
import tempfile
from pathlib import Path

PAGE = "tools/view/built/view.html"
RECORD = "tools/view/built/sources.sha256"
CURE = "run 'sh tools/view/renew_page.sh' and commit tools/view/built"


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def recorded(source):
    """Path -> digest, of the record's lines as sha256sum prints them."""
    lines = (source / RECORD).read_text().splitlines()
    return {path: known for known, path in (line.split("  ", 1) for line in lines)}


def check(source, built=None):
    """The number of files that were compared, and what is wrong."""
    if not (source / PAGE).is_file() or not (source / RECORD).is_file():
        return 0, [f"no {PAGE} with its {RECORD}; {CURE}"]
    known = recorded(source)
    changed = [path for path, was in known.items() if not (source / path).is_file() or digest(source / path) != was]
    bad = [] if known else [f"{RECORD} names no source; {CURE}"]
    if changed:
        more = f" and {len(changed) - 3} more" if len(changed) > 3 else ""
        bad.append(f"{PAGE} is older than its sources: {', '.join(changed[:3])}{more} changed; {CURE}")
    if built is not None and digest(source / PAGE) != digest(built):
        bad.append(f"{PAGE} ({digest(source / PAGE)[:12]}) is not what the sources give: {built} ({digest(built)[:12]}); {CURE}")
    return len(known), bad


def self_test():
    """Pages of one source each: what was changed after the record was made, and whether the guard must fail."""
    cases = {"nothing": False, "source": True, "page": True, "absent source": True, "absent page": True, "empty record": True}
    bad = []
    for case, must_fail in cases.items():
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder)
            source, built, page, record = tree / "hair.frag", tree / "built.html", tree / PAGE, tree / RECORD
            page.parent.mkdir(parents=True)
            source.write_text("void main() {}\n")
            page.write_text("page")
            built.write_text("another page" if case == "page" else "page")
            record.write_text("" if case == "empty record" else f"{digest(source)}  hair.frag\n")
            if case == "source":
                source.write_text("void main() { discard; }\n")
            if case.startswith("absent"):
                (source if case == "absent source" else page).unlink()
            if bool(check(tree, built)[1]) != must_fail:
                bad.append(f"{'did not fire' if must_fail else 'fired'} where it was changed: {case}")
    return len(cases), bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        seen, problems = self_test()
    else:
        seen, problems = check(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else None)
    print("\n".join(problems) or f"built page: {seen} files or cases checked")
    sys.exit(1 if problems else 0)
