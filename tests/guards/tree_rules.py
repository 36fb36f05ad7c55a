#!/usr/bin/env python3
"""What no file of the project may be: too long, written for one machine or one tracker, a copy of a test asset that is
not ours to ship, named so that anything could end up in it, in another folder's namespace, or commented in riddles.

usage: tree_rules.py SOURCE_DIR ASSET_DIR | --self-test
"""
import hashlib
import re
import sys
import tempfile
from pathlib import Path

MAX_LINES = 300
MAX_TEST_LINES = 400  # One file for a unit, however much is promised of it.
# Files that are longer for a reason: path -> the reason.
LONGER = {
    "tools/cook/cook.cpp": "the list of a cook's passes, which one reads from top to bottom",
    "tests/mutants/mutants.txt": "a list, three lines to a mistake",
    "tools/lab/reference_tree.cpp": "one integrator: its steps, and what contacts, limits and links do within one",
}
BUILT = {"tools/view/built/view.html"}  # Made from sources that are looked at themselves; its words are base64.
CODE = {".h", ".cpp", ".py", ".sh", ".cmake", ".vert", ".frag", ".txt", ".mjs", ".ts"}
COMMENTED = CODE | {".c", ".css", ".glsl", ".html", ".js"}
TEXT = COMMENTED | {".md", ".json", ".in", ""}
BAD_NAMES = {"utils", "util", "common", "misc", "helpers", "helper", "manager"}
BAD_TEXT = [
    (re.compile(r"(?<![\w.])/(?:work|root|home)/\w"), "a path of one machine"),
    (re.compile(r"\b(?:TODO|FIXME|XXX|HACK)\b"), "a note to oneself"),
    (re.compile(r"\b(?:tickets?|issue\s*#?\d+|(?:fixes|closes|see)\s+#\d+)\b", re.IGNORECASE), "a tracker's number"),
    (re.compile(r"\b(?:chatgpt|claude|copilot|as an ai|language model)\b", re.IGNORECASE), "talk about its making"),
]
# What a formatter of C++ makes of other languages.
MANGLED = re.compile(r"^(?:#+[A-Z]|```\w+ \S|#! ?/ )")
# A comment, or one of its lines, that begins with "Of": a genitive that the reader has to find the noun for.
RIDDLE = re.compile(r"(?:^|[\s;,{}()])(?:/{2,}!?|/\*+!?|\*|#+|<!--)<?\s*Of\s")
PLAIN = {"base"}  # Folders of tools whose words are all tools': they are in namespace coif itself.
NAMES = {"import": "importer"}  # Other names of namespaces than folders': that one is a word of C++.
FOLDERS = ("formats", "runtime", "tools", "shaders", "tests", "sample_assets", ".ci")


def project_files(source):
    """Files of the project; build trees and outputs lie elsewhere."""
    yield from (p for p in sorted(source.iterdir()) if p.is_file())
    for folder in FOLDERS:
        yield from (p for p in sorted((source / folder).rglob("*")) if p.is_file() and "__pycache__" not in p.parts)


def text_problems(path, text):
    if path == "tests/guards/tree_rules.py":  # Holds the very words it forbids.
        return
    lines = text.count("\n")
    most = MAX_TEST_LINES if path.startswith("tests/") else MAX_LINES
    if Path(path).suffix in CODE and lines > most and path not in LONGER:
        yield f"{path}: {lines} lines, above {most}; split it, or give the reason in LONGER"
    for number, line in enumerate(text.splitlines(), 1):
        if Path(path).suffix in {".md", ".py", ".sh"} and MANGLED.search(line) and not line.startswith("#!/"):
            yield f"{path}:{number}: formatted as if it were C++: {line.strip()[:80]}"
        for pattern, what in BAD_TEXT:
            if pattern.search(line):
                yield f"{path}:{number}: {what}: {line.strip()[:80]}"
        if Path(path).suffix in COMMENTED and RIDDLE.search(line):
            yield f"{path}:{number}: a comment begins with 'Of'; say what it is: {line.strip()[:80]}"


def namespace_problems(path, text):
    """tools/cook is coif::cook, and tests/cook too. Files may declare in other folders' namespaces what they forward."""
    top, folder, *rest = path.split("/")[:3] + [""] * 2
    if top != "tools" or not rest[0] or Path(path).suffix not in {".h", ".cpp"}:
        return
    own = "coif" if folder in PLAIN else f"coif::{NAMES.get(folder, folder)}"
    opened = re.findall(r"^namespace (coif[\w:]*)", text, re.MULTILINE)
    if opened and own not in opened:
        yield f"{path}: opens {opened[0]}; what is in tools/{folder} is in {own}"
    if own != "coif" and "coif" in opened:
        yield f"{path}: opens coif, which is the runtime's; what is in tools/{folder} is in {own}"


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def copied(source, files, assets):
    """Project files whose bytes are those of a test asset."""
    by_size = {}
    for asset in (p for p in assets.rglob("*") if p.is_file() and p.stat().st_size > 0):
        by_size.setdefault(asset.stat().st_size, []).append(asset)
    for file in files:
        if any(digest(file) == digest(asset) for asset in by_size.get(file.stat().st_size, [])):
            yield f"{file.relative_to(source)}: a copy of a test asset, which may not be shipped"


def check(source, assets):
    files = list(project_files(source))
    bad = [] if files else [f"no files under {source}: nothing was checked"]
    for file in files:
        path = file.relative_to(source).as_posix()
        if BAD_NAMES & set(re.split(r"[/._]", path.lower())):
            bad.append(f"{path}: a name for a place where anything may end up")
        if file.suffix in TEXT and path not in BUILT:
            text = file.read_text(encoding="utf-8", errors="replace")
            bad += text_problems(path, text)
            bad += namespace_problems(path, text)
    if not assets.is_dir():
        print(f"no test assets at {assets}: copies of them were not looked for")
    return len(files), bad + list(copied(source, files, assets))


def self_test():
    must_fail = {"tools/cook/long.cpp": "//\n" * 301, "tests/long.cpp": "//\n" * 401, "tools/x.cpp": "// /" + "work/main\n", "formats/a.md": "TO" "DO\n",
                 "tests/b.cpp": "// see #12\n", "tools/string_utils.h": "", "tools/utils/x.h": "",
                 "sample_assets/a/a.glb": "bytes of an artist", "runtime/c.cpp": "// made by Chat" "GPT\n", "tools/cook/a.h": "namespace coif {\n", "tools/cook/b.h": "namespace coif::view {\n",
                 "tools/base/c.h": "namespace coif::base {\n", "tools/cook/of.cpp": "/// Of what the caller asked for.\n",
                 "formats/of.h": "int a = 0;  ///< Of a bone.\n", "runtime/of.c": "int a; /* Of a bone. */\n", "tests/of.py": "a = 1  # Of a bone.\n",
                 "runtime/of.ts": "/** Of every step. */\n", "shaders/of.glsl": "// The share\n// Of it.\n", "tools/of.cmake": "# Of a bone.\n",
                 "tools/of.mjs": "/**\n * Of a bone.\n */\n", "tests/c.md": "##One part,\n", "tests/d.py": "#! / usr / bin\n",
                 "tools/d.md": "```sh sh tools / x.sh\n"}
    must_pass = {"tools/cook/fine.cpp": "//\n" * 300, "tests/fine.cpp": "//\n" * 400, "README.md": "an issue of a file, at https://example.org/home/x\n",
                 "tools/cook/d.h": "namespace coif::view {\nclass Page;\n}\nnamespace coif::cook {\n", "tools/base/e.h": "namespace coif {\n",
                 "tools/cook/offer.h": "/// Offers a bone, one\n/// of many. Of these, one stays.\nint Of = 1;\n", "tests/of.md": "# Of hair\n",
                 "tests/f.md": "# One\n\n```sh\n#!/bin/sh\n```\n", "tests/g.py": "#!/usr/bin/env python3\n# A\n"}
    bad = []
    for path, text in {**must_fail, **must_pass}.items():
        with tempfile.TemporaryDirectory() as tree, tempfile.TemporaryDirectory() as assets:
            Path(assets, "artist.glb").write_text("bytes of an artist")
            Path(tree, path).parent.mkdir(parents=True, exist_ok=True)
            Path(tree, path).write_text(text)
            fired = bool(check(Path(tree), Path(assets))[1])
            if fired != (path in must_fail):
                bad.append(f"{'fired on' if fired else 'did not fire on'}: {path}")
    with tempfile.TemporaryDirectory() as empty:
        if not check(Path(empty), Path(empty))[1]:
            bad.append("an empty tree passed")
    return len(must_fail) + len(must_pass) + 1, bad


if __name__ == "__main__":
    seen, problems = self_test() if sys.argv[1] == "--self-test" else check(Path(sys.argv[1]), Path(sys.argv[2]))
    print("\n".join(problems) or f"tree rules: {seen} files or cases checked")
    sys.exit(1 if problems else 0)
