#!/usr/bin/env python3
"""Who may include whom. LAYERS, HOMES and STANDARD below are the rules; the rest applies them.

usage: include_rules.py SOURCE_DIR | --self-test
"""
import re
import sys
from pathlib import Path

FORMATS = {"formats/include"}
SIM = FORMATS | {"runtime/include"}
DRAWING = {"runtime/include/coif/debug_lines.h", "runtime/include/coif/drawing.h", "runtime/include/coif/triangle_order.h"}
RENDERER = DRAWING | {"runtime/include/coif/motion_vectors.h", "runtime/include/coif/renderer.h", "runtime/include/coif/shadow.h"}
RESEARCH = RENDERER | {"runtime/include/coif/research.h"}
VERSION = {"runtime/include/coif/version.h"}
C_HEADERS = VERSION | {"runtime/include/coif.h", "runtime/include/coif/c"}  # What is read by C.
HASH = {"formats/payload_hash.h"}  # Private to the format, but tools stamp sources and recipes with the same hash.
VIEW_SETTINGS = {"tools/view/page/view_settings.h"}
# Folder (or file) -> folders it may include from; itself always. The longest match owns a file. Those of the tools follow
# from what tools/CMakeLists.txt links: see tool_layers().
LAYERS = {
    "formats": FORMATS | HASH,
    "formats/include": set(),
    "formats/payload_hash.h": set(),
    "formats/write": FORMATS | HASH,
    "runtime/include": FORMATS,
    "runtime/include/coif.h": VERSION | {"runtime/include/coif/c"},
    "runtime/include/coif/version.h": set(),
    "runtime/include/coif/c": set(),
    "runtime/include/coif/debug_lines.h": SIM | DRAWING,
    "runtime/include/coif/drawing.h": SIM,
    "runtime/include/coif/triangle_order.h": SIM | DRAWING,
    "runtime/include/coif/renderer.h": SIM | DRAWING,
    "runtime/include/coif/motion_vectors.h": SIM | RENDERER,
    "runtime/include/coif/shadow.h": SIM | RENDERER,
    "runtime/include/coif/research.h": SIM | RENDERER,
    "runtime/sim": SIM,
    "runtime/skinning": SIM,
    "runtime/c": SIM | DRAWING | C_HEADERS,
    "runtime/drawing": SIM | DRAWING,
    "runtime/gl": SIM | RENDERER,
    "runtime/research": SIM | RESEARCH | {"runtime/gl"},
    "runtime/examples": SIM | RENDERER | C_HEADERS,
    "tools/cli": None,  # Everything.
    # For browsers, by the build for the web: tools/CMakeLists.txt knows nothing of it. Of the cook it has the formulas of bones, and what
    # these stand on: view/page/CMakeLists.txt names their files.
    "tools/view/page": SIM | RESEARCH | VIEW_SETTINGS | {"tools/view/body"}
    | {"tools/base", "tools/motion", "tools/render", "tools/lab", "tools/cook/recipe", "tools/cook/dynamics"},
    # What that page can set, which sheets speak of.
    **{header: SIM | RESEARCH | {"tools/motion"} for header in VIEW_SETTINGS},
    "tests": None,
}
# What every tool may include, and what linking these brings along.
TOOL_BASE = SIM | HASH | VERSION | {"formats/write"}
LINKED = {"coif::gl": RENDERER, "coif::research": RESEARCH, "coif::drawing": DRAWING, "coif_view_settings": VIEW_SETTINGS}

# Third-party header -> the folders that may include it.
HOMES = {
    "assimp/": ["tools/import"],
    "pugixml.hpp": ["tools/import"],
    "httplib.h": ["tools/view/server", "tests/view"],
    "hwy/": ["runtime/sim"],
    "xmmintrin.h": ["runtime/sim/float_environment.h"],
    "CLI/": ["tools/cli"],
    "meshoptimizer.h": ["tools/cook/lods", "tools/cook/pack", "tools/gltf", "tools/view/body", "tests/import"],
    "draco/": ["tools/gltf", "tests/import"],
    "nlohmann/": ["tools/", "tests/"],
    "Eigen/": ["tools/", "tests/"],
    "fmt/": ["tools/", "tests/"],
    "tl/": ["tools/", "tests/"],
    "stb/stb_easy_font.h": ["tools/render"],
    "webp/decode.h": ["tools/cook/texture/image_kinds.cpp"],
    "webp/encode.h": ["tools/view/body"],
    "stb/stb_image.h": ["tools/cook/texture", "tests/"],
    "stb/stb_image_resize.h": ["tools/cook/texture"],
    "stb/stb_image_write.h": ["tools/base", "tests/cook"],
    "EGL/": ["tools/render", "tests/gl", "runtime/examples"],
    "GLES2/": ["tools/render", "tests/gl", "tests/render"],
    "GLES3/": ["runtime/gl", "runtime/research", "tools/render", "tools/report/shadow", "tests/gl", "tests/render", "runtime/examples", "tools/view/page"],
    "emscripten/": ["tools/view/page"],
    "KHR/": ["tools/render"],
    "linux/": ["tools/platform", "tests/platform", "tests/import"],
    "gtest/": ["tests/"],
    "benchmark/": ["tests/"],
    "BulletSoftBody/": ["tests/bench/peers"],
}

# Headers of POSIX, and of C's signals, which other systems lack or have otherwise. Of the tools one folder includes them.
POSIX = re.compile(r"sys/.*|arpa/.*|net/.*|netinet/.*|(c?signal|dirent|dlfcn|fcntl|fnmatch|ftw|glob|grp|netdb|poll|pthread|pwd|sched|"
                   r"semaphore|spawn|strings|syslog|termios|time|ucontext|unistd|utime|wait|wordexp)(\.h)?")
POSIX_HOME = "tools/platform"
POSIX_INSIDE = {"tools/platform/descriptor.h", "tools/platform/spawn.h"}  # Which have types of POSIX, for that folder alone.

# What shipped code may use of the standard library: nothing that allocates, throws or drags in a container.
STANDARD = {"algorithm", "bit", "cfloat", "climits", "cmath", "concepts", "cstddef", "cstdint", "cstdio", "cstring",
            "limits", "new", "numeric", "span", "type_traits", "utility"}
C_STANDARD = {"stddef.h", "stdint.h"}
SHIPPED = ("formats", "formats/include", "formats/payload_hash.h", "runtime/include", "runtime/include/coif/motion_vectors.h",
           "runtime/include/coif/renderer.h", "runtime/include/coif/research.h", "runtime/include/coif/shadow.h", "runtime/include/coif/debug_lines.h", "runtime/include/coif/drawing.h", "runtime/include/coif/triangle_order.h", "runtime/sim", "runtime/skinning",
           "runtime/drawing", "runtime/gl", "runtime/research", "runtime/c", *C_HEADERS)

# Headers that the build writes, by the layers that include them.
GENERATED = {"runtime/gl": {"hair_shaders.h"}, "runtime/research": {"hair_shaders.h"}}

ROOTS = ["", "formats/include", "runtime/include", "formats", "runtime", "tools", "tests"]
SUFFIXES = {".h", ".cpp", ".hpp", ".c", ".inl"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)


def tool_layers(cmake):
    """LAYERS of the tools from the text of tools/CMakeLists.txt, and a sentence for each library that links what comes after
    it: a folder may include what it links, and what that links publicly."""
    layers, public, problems = {}, {}, []
    folder_of = {"coif_" + f.replace("/", "_"): f for f in re.findall(r"^coif_tool_library\(([^\s)]+)", cmake, re.MULTILINE)}
    for folder, rest in re.findall(r"^coif_tool_library\(([^\s)]+)([^)]*)\)", cmake, re.MULTILINE):
        layer = f"tools/{folder}"
        own, private = ([name for name in part.split() if name != "PUBLIC"] for part in (rest + " PRIVATE ").split("PRIVATE")[:2])
        problems += [f"tools/CMakeLists.txt: {folder} links {name}, which does not stand above it"
                     for name in own + private if name in folder_of and f"tools/{folder_of[name]}" not in layers]
        reached = lambda names: set().union(*({f"tools/{folder_of[n]}"} | public.get(folder_of[n], set()) if n in folder_of
                                              else LINKED.get(n, set()) for n in names))
        public[folder] = reached(own)
        layers[layer] = TOOL_BASE | public[folder] | reached(private)
    return layers, problems


def layer_of(path):
    """The longest entry of LAYERS that `path` lies in, or None."""
    fitting = [name for name in LAYERS if path == name or path.startswith(name + "/")]
    return max(fitting, key=len, default=None)


def resolve(name, folder, exists):
    """Path of an included project file, or None: beside the includer first, then under ROOTS."""
    for root in [folder, *ROOTS]:
        candidate = f"{root}/{name}" if root else name
        if exists(candidate):
            return candidate
    return None


def foreign_violation(layer, path, name):
    home = next((HOMES[prefix] for prefix in HOMES if name.startswith(prefix)), None)
    if home is not None:
        return None if any(path.startswith(h) for h in home) else f"<{name}> belongs in {' or '.join(home)} only"
    if layer in SHIPPED and name not in (C_STANDARD if layer in C_HEADERS else STANDARD):
        return f"<{name}> is not among the headers that shipped code may use"
    if path.startswith("tools/") and not path.startswith(POSIX_HOME + "/") and POSIX.fullmatch(name):
        return f"<{name}> is of POSIX, which {POSIX_HOME} alone includes"
    if "/" in name and not POSIX.fullmatch(name):
        return f"<{name}> has no home; give it one in HOMES, with a reason in the commit"
    return None


def violations(path, text, exists):
    """One sentence for each #include of `text` that breaks a rule."""
    layer = layer_of(path)
    if layer is None:
        yield f"{path}: belongs to no layer; see LAYERS"
        return
    for match in INCLUDE.finditer(text):
        name = match.group(1) or match.group(2)
        target = resolve(name, path.rpartition("/")[0], exists)
        if target is None:
            generated = name in GENERATED.get(layer, ())
            problem = None if generated else foreign_violation(layer, path, name)
        else:
            owner, allowed = layer_of(target), LAYERS[layer]
            problem = None
            if owner != layer and allowed is not None and owner not in allowed:
                problem = f'"{name}" is in {owner}, which {layer} may not include'
            elif target in POSIX_INSIDE and layer != POSIX_HOME:
                problem = f'"{name}" has types of POSIX, for {POSIX_HOME} alone'
        if problem:
            yield f"{path}: {problem}"


def check(source):
    files = [p for top in ("formats", "runtime", "tools", "tests") for p in sorted((source / top).rglob("*"))
             if p.suffix in SUFFIXES]
    bad = [] if files else [f"no source files under {source}: the rules checked nothing"]
    table = source / "tools/CMakeLists.txt"
    layers, problems = tool_layers(table.read_text(encoding="utf-8") if table.is_file() else "")
    LAYERS.update(layers)
    bad += problems
    for file in files:
        path = file.relative_to(source).as_posix()
        bad += violations(path, file.read_text(encoding="utf-8"), lambda p: (source / p).is_file())
    return len(files), bad


def self_test():
    table = """coif_tool_library(platform PUBLIC coif::sim)
coif_tool_library(base PUBLIC coif_platform)
coif_tool_library(import PUBLIC coif_base PRIVATE assimp::assimp)
coif_tool_library(cook/order PUBLIC coif_import)
coif_tool_library(cook PUBLIC coif_cook_order
  PRIVATE coif_base)
coif_tool_library(render PUBLIC coif_base coif::gl)
"""
    layers, problems = tool_layers(table)
    LAYERS.update(layers)
    bad = problems + ([] if tool_layers("coif_tool_library(a PUBLIC coif_b)\ncoif_tool_library(b)\n")[1] else ["upward links pass"])
    tree = {"tools/base/text.h", "tools/cook/order/sort.h", "tools/import/import.h",
            "tools/cook/cook.h", "tools/render/picture.h", "formats/write/asset_writer.h", "formats/include/coif/asset.h",
            "runtime/include/coif/drawing.h", "runtime/include/coif/renderer.h", "runtime/include/coif/research.h", "runtime/include/coif/hair.h",
            "runtime/include/coif/c/types.h",
            "tests/sim/rig.h", "tools/platform/spawn.h", "tools/platform/job.h"}
    must_fail = [("runtime/sim/a.cpp", "#include <vector>"), ("runtime/sim/a.cpp", '#include "cook/cook.h"'),
                 ("runtime/sim/a.cpp", "#include <coif/renderer.h>"), ("runtime/sim/a.cpp", "#include <GLES3/gl3.h>"),
                 ("runtime/sim/a.cpp", "#include <coif/drawing.h>"), ("runtime/drawing/a.cpp", "#include <GLES3/gl3.h>"),
                 ("runtime/drawing/a.cpp", "#include <coif/renderer.h>"),
                 ("runtime/gl/a.cpp", "#include <coif/research.h>"), ("tools/render/a.cpp", "#include <coif/research.h>"),
                 ("runtime/gl/a.cpp", "#include <nlohmann/json.hpp>"), ("runtime/gl/a.cpp", "#  include <EGL/egl.h>"),
                 ("formats/a.cpp", "#include <coif/hair.h>"), ("formats/a.cpp", '#include "write/asset_writer.h"'),
                 ("runtime/include/coif/a.h", "#include <string>"), ("tools/cook/a.cpp", "#include <assimp/scene.h>"),
                 ("tools/cook/a.cpp", '#include "render/picture.h"'), ("tools/cook/order/a.cpp", '#include "cook/cook.h"'),
                 ("tools/cook/a.cpp", "#include <coif/renderer.h>"), ("tools/elsewhere/a.cpp", ""), ("tools/import/a.cpp", '#include "cook/cook.h"'),
                 ("tools/cook/a.cpp", "#include <CLI/CLI.hpp>"), ("tools/cook/a.cpp", "#include <newlib/new.h>"),
                 ("runtime/include/coif/hair.h", "#include <hwy/highway.h>"),
                 ("runtime/gl/a.cpp", '#include "sim/rig.h"'), ("elsewhere/a.cpp", ""),
                 ("runtime/include/coif.h", "#include <cstdint>"), ("runtime/include/coif.h", "#include <coif/hair.h>"),
                 ("runtime/include/coif/c/a.h", "#include <cstdint>"), ("runtime/include/coif/c/a.h", "#include <coif/hair.h>"),
                 ("runtime/sim/a.cpp", "#include <stdint.h>"), ("tools/base/a.cpp", '#include "platform/spawn.h"'),
                 *((f"tools/{folder}/a.cpp", f"#include <{name}>") for folder in ("base", "cli", "cook/order")
                   for name in ("unistd.h", "sys/stat.h", "csignal", "netinet/in.h", "spawn.h", "time.h"))]
    must_pass = [("runtime/include/coif.h", "#include <stdint.h>\n#include <coif/c/types.h>"),
                 ("runtime/include/coif/c/a.h", "#include <stdint.h>"),
                 ("runtime/sim/a.cpp", "#include <span>\n#include <coif/hair.h>"),
                 ("runtime/sim/lanes/a.cpp", "#include <hwy/highway.h>"),
                 ("runtime/drawing/a.cpp", "#include <coif/drawing.h>"),
                 ("runtime/gl/a.cpp", "#include <GLES3/gl3.h>"), ("tools/import/a.cpp", "#include <assimp/scene.h>"),
                 ("runtime/research/a.cpp", "#include <coif/research.h>\n#include <hair_shaders.h>"),
                 ("tools/cook/order/a.cpp", '#include "import/import.h"\n#include "base/text.h"'),
                 ("tools/cook/a.cpp", '#include "cook/order/sort.h"'), ("tools/render/a.cpp", "#include <coif/renderer.h>"),
                 ("tools/cook/a.cpp", '#include "write/asset_writer.h"\n#include <vector>\n#include <ctime>'),
                 ("tools/platform/a.cpp", '#include <unistd.h>\n#include <sys/stat.h>\n#include "platform/spawn.h"'),
                 ("tools/base/a.cpp", '#include "platform/job.h"'), ("tests/base/a.cpp", "#include <unistd.h>")]
    bad += [f"rule did not fire: {c}" for c in must_fail if not list(violations(*c, tree.__contains__))]
    bad += [f"rule fired on: {c}" for c in must_pass if list(violations(*c, tree.__contains__))]
    if not check(Path("/nonexistent"))[1]:
        bad.append("an empty tree passed")
    return len(must_fail) + len(must_pass), bad


if __name__ == "__main__":
    seen, problems = self_test() if sys.argv[1] == "--self-test" else check(Path(sys.argv[1]))
    print("\n".join(problems) or f"include rules: {seen} checked")
    sys.exit(1 if problems else 0)
