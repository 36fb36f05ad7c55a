#!/usr/bin/env python3
"""One name, one thing, in all of a program: two classes of one name, or two inline functions, of which the linker keeps whichever it
meets first, are no error to any compiler. Reads the sources for types and functions outside of anonymous namespaces that two files
define, and the archives for symbols that two objects define.

usage: one_definition.py NM SOURCE_DIR BUILD_DIR | --self-test NM CXX
"""
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

FOLDERS = ("formats", "runtime", "tools", "tests")
# Programs of their own, a file each beside what they share: names of two of them never meet.
PROGRAMS = ("runtime/examples/", "tests/consumer/", "tests/fuzz/")
TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.']*|::|\[\[|\]\]|\"\"|[^\s\w]")
NOISE = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])*'", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.MULTILINE)
TYPES = {"class", "struct", "union", "enum"}
BUILT_IN = {"int", "char", "short", "long", "unsigned", "signed", "float", "double", "bool", "void", "auto", "const"}


def tokens_of(text):
    text = NOISE.sub(lambda match: '""' if match.group()[0] in "\"R" else " ", text)
    return TOKEN.findall(DIRECTIVE.sub("", text))


def skip(tokens, at, opening, closing):
    """Behind the bracket that closes the one at `at`."""
    depth = 0
    while at < len(tokens):
        depth += (tokens[at] == opening) - (tokens[at] == closing)
        at += 1
        if depth == 0:
            break
    return at


def significant(tokens):
    """Without attributes, alignments and the head of a template, of which the number of parameters comes second."""
    out, at, parameters = [], 0, 0
    while at < len(tokens):
        if tokens[at] == "[[":
            at = skip(tokens, at, "[[", "]]")
        elif tokens[at] == "alignas":
            at = skip(tokens, at + 1, "(", ")")
        elif tokens[at] == "template" and tokens[at + 1:at + 2] == ["<"]:
            end = skip(tokens, at + 1, "<", ">")
            parameters += 1 + tokens[at:end].count(",")
            at = end
        else:
            out.append(tokens[at])
            at += 1
    return out, parameters


def type_name(tokens):
    """Of `class API Name final : public Base`; None for what is no type, or has no name."""
    at = next((i for i, token in enumerate(tokens) if token in TYPES), None)
    if at is None or "(" in tokens or "=" in tokens:
        return None
    names = []
    for i in range(at + 1, len(tokens)):
        if tokens[i] in {":", "final"}:
            break
        if tokens[i] == "<":
            names.append("".join(tokens[i:skip(tokens, i, "<", ">")]))
            break
        if tokens[i] not in TYPES:
            names.append(tokens[i])
    if not names:
        return None
    if names[-1].startswith("<"):
        return "".join(names[-2:])
    first = max((i for i in range(1, len(names)) if names[i] != "::" and names[i - 1] != "::"), default=0)
    return "".join(names[first:])


def parameter_types(tokens):
    """Of what stands between a function's brackets: without names and defaults."""
    types, one, depth = [], [], 0
    for token in tokens + [","]:
        depth += (token in "(<[{") - (token in ")>]}")
        if token == "," and depth == 0:
            one = one[:one.index("=")] if "=" in one else one
            named = len(one) > 1 and re.match(r"[A-Za-z_]", one[-1]) and one[-1] not in BUILT_IN and one[-2] != "::"
            types.append(" ".join(one[:-1] if named else one))
            one = []
        else:
            one.append(token)
    return ", ".join(types)


def function_name(tokens, parameters):
    """With the types of its parameters; None for what is none, or is known in its file alone."""
    begin = next((i for i, token in enumerate(tokens) if token == "("), None)
    if begin is None or begin == 0 or tokens[0] in {",", ":", "catch"} or "static" in tokens[:begin]:
        return None
    if "operator" in tokens[:begin]:
        first = tokens.index("operator")
        if tokens[first + 1] == "(":
            begin = first + 3
        name = "".join(tokens[first:begin])
    elif "=" in tokens[:begin] or not re.match(r"[A-Za-z_~]", tokens[begin - 1]):
        return None
    else:
        first = begin - 1
        name = tokens[first]
    while first >= 2 and tokens[first - 1] == "::":
        first -= 2
        name = tokens[first] + "::" + name
    end = skip(tokens, begin, "(", ")")
    constness = " const" if "const" in tokens[end:end + 1] else ""
    template = f"template of {parameters} " if parameters else ""
    return f"{template}{name}({parameter_types(tokens[begin + 1:end - 1])}){constness}"


def variable_name(tokens):
    """Of one that says that it is inline; all others are known in their file alone, or in the archives."""
    found, _ = significant(tokens)
    end = next((i for i, token in enumerate(found) if token in {"=", "{}", "["}), None)
    is_one = end and "inline" in found[:end] and "(" not in found[:end] and re.match(r"[A-Za-z_]", found[end - 1])
    return found[end - 1] if is_one else None


def opened(tokens):
    """What an opening bracket after these tokens begins: kind and name."""
    found, parameters = significant(tokens)
    if "namespace" in found:
        return "namespace", "".join(found[found.index("namespace") + 1:])
    if found == ["extern", '""']:
        return "linkage", ""
    if name := type_name(found):
        return "type", name
    if name := function_name(found, parameters):
        return "function", name
    return "other", ""


def definitions(text):
    """Names, with their namespaces, that are known in other files too: (kind, name)."""
    statement, scopes = [], []
    tokens = tokens_of(text)
    at = 0

    def known(kind, name):
        spaces = [scope for k, scope in scopes if k == "namespace"]
        return [(kind, "::".join(spaces + [name]))] if name and all(spaces) else []

    while at < len(tokens):
        token = tokens[at]
        at += 1
        if token == "{" and statement.count("(") > statement.count(")"):  # a default
            at = skip(tokens, at - 1, "{", "}")
        elif token == "{":
            kind, name = opened(statement)
            if kind in {"namespace", "linkage"}:
                scopes.append((kind, name))
                statement = []
                continue
            yield from known(kind, name)
            at = skip(tokens, at - 1, "{", "}")
            goes_on = kind == "other" and statement and statement[0] != ","  # else a member's beginning, or a body
            statement = statement + ["{}"] if goes_on else [] if kind != "type" else statement
        elif token in "};":
            yield from known("variable", variable_name(statement)) if token == ";" else ()
            if token == "}" and scopes:
                scopes.pop()
            statement = []
        else:
            statement.append(token)


def source_problems(files):
    """`files`: path -> text. A program's own main is its own."""
    homes = defaultdict(set)
    for path, text in files.items():
        program = next((path for program in PROGRAMS if path.startswith(program)), "")
        for kind, name in definitions(text):
            if not name.startswith("main("):
                homes[program, kind, name].add(path)
    for (_, kind, name), paths in sorted(homes.items()):
        if len(paths) > 1:
            yield f"{kind} {name} is defined in {' and in '.join(sorted(paths))}: give each its own name, or an anonymous namespace"
    if not homes:
        yield "no definitions found: nothing was checked"


def archive_problems(nm, archives):
    """Symbols that two objects of all archives define; inline ones, which many do, are not among them."""
    homes = defaultdict(set)
    listing = subprocess.run([nm, "-A", "--defined-only", "--extern-only", *map(str, archives)], capture_output=True, text=True, check=True)
    for line in listing.stdout.splitlines():
        place, _, rest = line.rpartition(":")
        fields = rest.split()
        if len(fields) == 3 and fields[1] in "TDBRGSA":
            homes[fields[2]].add(place)
    for symbol, places in sorted(homes.items()):
        if len(places) > 1:
            yield f"{symbol} is defined by {' and by '.join(sorted(places))}"
    if not homes:
        yield "no symbols found: nothing was checked"


def check(nm, source, build):
    files = {p.relative_to(source).as_posix(): p.read_text(encoding="utf-8")
             for folder in FOLDERS for p in sorted((source / folder).rglob("*")) if p.suffix in {".h", ".cpp", ".c"}}
    archives = [p for folder in FOLDERS for p in sorted((build / folder).rglob("*.a"))]
    bad = list(source_problems(files))
    if archives:
        bad += archive_problems(nm, archives)
    return len(files), len(archives), bad


MUST_FAIL = {
    "two classes": ("namespace coif { class Views { int a; }; }", "namespace coif { struct Views final { double a[9]; }; }"),
    "beside what is anonymous": ("namespace coif { namespace { struct Own {}; } class A {}; }", "namespace coif::x { } namespace coif { class A : B { }; }"),
    "an enumeration": ("namespace coif { enum class Kind : int { kA }; }", "namespace coif { enum Kind { kB }; }"),
    "of an interface": ("namespace coif { class COIF_API Hair {}; }", "namespace coif { class Hair {}; }"),
    "inline functions": ("namespace coif { inline int f(int a) { return a; } }", "namespace coif { [[nodiscard]] inline int f(int b = 2) { return -b; } }"),
    "templates": ("template <class T> void g(const T& t) { t(); }", "template <typename T> void g(const T& other) { other(2); }"),
    "operators": ("namespace c { bool operator==(A a, A b) { return 1; } }", "namespace c { bool operator==(A x, A y) { return 0; } }"),
    "inline variables": ("namespace c { inline constexpr float kArm = 0.1f; }", "namespace c { inline constexpr double kArm{2}; }"),
    "methods": ("namespace c { int A::get() const { return 1; } }", "namespace c { int A::get() const { return 2; } }"),
    "behind other things": ("const X k{1, 2}; A::A() : a_{1}, b_(2) { } struct S { int f() { return 1; } };", "#define S {\nstruct S { };"),
}
MUST_PASS = {
    "namespaces": ("namespace a { struct S {}; }", "namespace b { struct S {}; }"),
    "anonymous ones": ("namespace a { namespace { struct S {}; int f() { return 1; } } }", "namespace a { namespace { struct S {}; int f() { return 2; } } }"),
    "declarations": ("struct S; int f(int); enum class E : int;", "struct S {}; int f(int a) { return a; } enum class E : int { k };"),
    "overloads": ("int f(int a) { return a; }", "int f(float a) { return 1; }"),
    "what is nested": ("struct A { struct S { }; };", "struct B { struct S { }; };"),
    "defaults": ("int f(const A& a = {}); struct O {};", "int f(const A& a) { return 1; }"),
    "constants of a file": ("constexpr int kA = 1; const X k{1};", "constexpr int kA = 2; const X k{2};"),
    "comments and strings": ('// struct S {};\nconst char* a = "struct S { }";', "struct S {}; /* struct S { */"),
    "static functions": ("static int f() { return 1; }", "static int f() { return 2; }"),
    "specializations": ("template <> struct H<int> { };", "template <> struct H<char> { };"),
}


def self_test(nm, cxx):
    bad = [f"passed: {what}" for what, (a, b) in MUST_FAIL.items() if not list(source_problems({"a.h": a, "b.h": b}))]
    for what, (a, b) in MUST_PASS.items():
        bad += [f"refused: {what}: {problem}" for problem in source_problems({"a.h": a, "b.h": b, "c.h": "struct Other {};"})]
    if not list(source_problems({"a.h": "// nothing"})):
        bad.append("passed: no source")
    with tempfile.TemporaryDirectory() as folder:
        objects = []
        for name, text in (("a", "int f() { return 1; } inline int g() { return 3; } int (*p)() = g;"), ("b", "int f() { return 2; }"),
                           ("c", "inline int g() { return 3; } int (*q)() = g;")):
            source = Path(folder) / f"{name}.cpp"
            source.write_text(text)
            objects.append(Path(folder) / f"{name}.o")
            subprocess.run([cxx, "-c", source, "-o", objects[-1]], check=True)
        found = list(archive_problems(nm, objects))
        if len(found) != 1 or "a.o" not in found[0] or "b.o" not in found[0]:
            bad.append(f"objects: {found}")
    return bad


def main(arguments):
    if arguments[:1] == ["--self-test"]:
        bad = self_test(*arguments[1:])
        print(f"{len(MUST_FAIL)} cases that must fail, {len(MUST_PASS)} that must not")
    else:
        files, archives, bad = check(arguments[0], Path(arguments[1]), Path(arguments[2]))
        print(f"{files} files, {archives} archives")
    for problem in bad:
        print(problem, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
