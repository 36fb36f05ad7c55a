#!/usr/bin/env python3
"""How the code lies in folders: files and lines of each, and how long files are.

  tests/guards/structure.py [PROJECT]

Counts files of code (C++, C, shaders, Python, shell, CMake) that Git knows, or all where there is no Git. The product is
formats, runtime, shaders and tools; tests are apart.
"""
import pathlib
import statistics
import subprocess
import sys

CODE = {".h", ".cpp", ".c", ".glsl", ".vert", ".frag", ".py", ".sh", ".cmake", ".txt", ".mjs", ".ts"}
PRODUCT = ("formats", "runtime", "shaders", "tools")
SHORT = 40


def code_files(project):
    listed = subprocess.run(["git", "-C", project, "ls-files"], capture_output=True, text=True, check=False).stdout.split("\n")
    paths = [project / name for name in listed if name] or sorted(project.rglob("*"))
    for path in paths:
        name = path.relative_to(project)
        if name.parts[0] in PRODUCT + ("tests",) and path.suffix in CODE and path.is_file() and "corpus" not in name.parts:
            yield name, path.read_bytes().count(b"\n")


def line(label, lengths):
    tenth = sorted(lengths)[len(lengths) // 10]
    short = sum(length < SHORT for length in lengths)
    return (f"{label:28} {len(lengths):5} files {sum(lengths):6} lines   median {statistics.median(lengths):5.0f}  tenth percentile "
            f"{tenth:4}  longest {max(lengths):4}  under {SHORT}: {short:4} ({100 * short / len(lengths):4.1f} %)")


def main():
    project = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if len(sys.argv) < 2:
        project = project.parents[2]
    folders = {}
    for name, length in code_files(project):
        folders.setdefault(name.parent.as_posix(), []).append(length)
    for folder in sorted(folders):
        print(line(folder, folders[folder]))
    print()
    for label, wanted in [*((top, (top,)) for top in PRODUCT + ("tests",)), ("product", PRODUCT), ("all", PRODUCT + ("tests",))]:
        lengths = [length for folder, own in folders.items() if folder.split("/")[0] in wanted for length in own]
        print(line(label, lengths))


main()
