#!/usr/bin/env python3
"""shaders/README.md names every shader file and every piece of one, every define, vertex attribute and uniform that the shaders have, and no define
that they do not have.

usage: shader_page.py SHADER_FOLDER | --self-test
"""
import re
import sys
from pathlib import Path

DEFINE = re.compile(r"\bCOIF_\w+")
ATTRIBUTE = re.compile(r"layout\(location = \d+\) in \w+ (\w+);")
UNIFORM = re.compile(r"^uniform (?:highp )?\w+ (\w+);", re.MULTILINE)
BLOCK = re.compile(r"layout\(std140\) uniform (\w+) \{(.*?)\};", re.DOTALL)
PIECE = re.compile(r"^//// ([\w.]+)", re.MULTILINE)
MEMBER = re.compile(r"^\s*\w+ (\w+)(?:\[\w+\])?;", re.MULTILINE)


def names_in(code):
    """What a renderer has to provide for this code. A shadow's own samplers have names that coif/shadow.h gives."""
    names = set(DEFINE.findall(code)) | set(ATTRIBUTE.findall(code))
    names |= {name for name in UNIFORM.findall(code) if not name.startswith("hair_shadow_")}
    for block, members in BLOCK.findall(code):
        names.add(block)
        names |= set(MEMBER.findall(members)) - {"palette"}  # rows, described as such
    return names


def violations(page, shaders):
    """`shaders`: file name -> code. Pieces begin as shaders/embed.cmake has it."""
    wanted = set(shaders).union(*map(PIECE.findall, shaders.values())).union(*map(names_in, shaders.values()))
    for name in sorted(wanted):
        if not re.search(rf"\b{re.escape(name)}\b", page):
            yield f"shaders/README.md does not name {name}; say what it is for"
    defines = set().union(*(DEFINE.findall(code) for code in shaders.values()))
    for name in sorted(set(DEFINE.findall(page)) - defines):
        yield f"shaders/README.md names {name}, which no shader has"


def self_test():
    code = ("#ifdef COIF_A\nlayout(location = 0) in vec3 rest;\nuniform vec3 range;\n#endif\n"
            "layout(std140) uniform Block {\n  vec4 color;  // rgb\n};\n\n//// b.glsl after c.glsl\n")
    page = "a.vert b.glsl COIF_A rest range Block color"
    bad = [f"did not fire without {word}" for word in page.split()
           if not list(violations(page.replace(word, ""), {"a.vert": code}))]
    if not list(violations(page + " COIF_B", {"a.vert": code})):
        bad.append("did not fire on a define that no shader has")
    if found := list(violations(page, {"a.vert": code})):
        bad.append(f"fired on a page that names everything: {found}")
    return len(page.split()) + 2, bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        seen, problems = self_test()
    else:
        folder = Path(sys.argv[1])
        files = {path.name: path.read_text() for path in sorted(folder.iterdir())
                 if path.suffix in {".glsl", ".vert", ".frag"}}
        seen, problems = len(files), list(violations((folder / "README.md").read_text(), files))
        if seen == 0:
            problems.append("no shader found: nothing was checked")
    print("\n".join(problems) or f"shader page: {seen} files or cases checked")
    sys.exit(1 if problems else 0)
