"""Finds places for subtle mistakes in C++ text and writes them there, each behind a condition on its number."""
import re

# Arguments of these may be swapped without a difference.
COMMUTATIVE = {"add", "smaller", "larger", "distance", "squared_distance", "angle_between", "max", "min", "dot", "hypot", "Max", "Min", "Add", "Mul", "fmax", "fmin", "gcd", "lcm", "swap", "And", "Or", "Xor", "Eq", "Ne"}
KEYWORDS = {"if", "for", "while", "switch", "return", "sizeof", "catch", "alignof", "alignas", "decltype", "static_assert", "noexcept",
            "operator", "co_return", "else", "throw", "new", "delete", "requires", "explicit", "assert", "defined", "using"}
OPERATORS = {"<": "Less", "<=": "LessEqual", ">": "Greater", ">=": "GreaterEqual"}


def blank(text):
    """The text with comments, strings and preprocessor lines as spaces, so that places in it are places in the text."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*'
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.MULTILINE | re.DOTALL)


def closing(text, at):
    """Where the bracket that opens there closes; None where it does not."""
    depth = 0
    for i in range(at, len(text)):
        depth += text[i] in "([{"
        depth -= text[i] in ")]}"
        if depth == 0:
            return i
    return None


def arguments(text, start, end):
    """[(from, to)] of what commas separate; None where a template's bracket makes that a guess."""
    if re.search(r"[<>{}]|\bconst\b|&&", text[start:end]):
        return None
    cuts, depth = [start], 0
    for i in range(start, end):
        depth += text[i] in "(["
        depth -= text[i] in ")]"
        if text[i] == "," and depth == 0:
            cuts.append(i + 1)
    cuts.append(end + 1)
    return [(a, b - 1) for a, b in zip(cuts, cuts[1:])]


def constants(code):
    """Numbers, a tenth larger: [(from, to, text)]. Not those that no tenth can change, and not what bits are made of."""
    for m in re.finditer(r"(?<![\w.])(\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+|\d+)([fFuUlL]*)(?![\w.'])", code):
        number, suffix = m.groups()
        is_whole = number.isdigit()
        if float(number) == 0 or (is_whole and (int(number) < 8 or re.search(r"(<<|>>|alignas\(|\[) *$", code[:m.start()]))):
            continue
        other = str(int(number) + max(1, int(number) // 10)) if is_whole else repr(float(f"{float(number) * 1.1:.8g}"))
        yield m.start(), m.end(), f"(coif_mutants::at(NUMBER) ? {other}{suffix} : {m.group()})"


def comparisons(code):
    """Those that let the edge in or out: [(from, to, text)]. The operators stand where the old one stood and bind alike."""
    for m in re.finditer(r"(?<=[\w)\]] )(<=|>=|<|>)(?= [\w(\-!*])", code):
        if re.search(r"\btemplate $", code[:m.start()][-12:]):
            continue
        yield m.start(), m.end(), f"< coif_mutants::{OPERATORS[m.group()]}{{NUMBER}} >"


def dropped_calls(code):
    """Statements that are a call: [(from, to, text)]."""
    for m in re.finditer(r"(?<=[;{}\n)])([ \t]+)((?:[A-Za-z_]\w*(?:::|\.|->|\[\w+\]\.))*([A-Za-z_]\w*))\(", code):
        end = closing(code, m.end() - 1)
        if m.group(3) in KEYWORDS or end is None or not code[end + 1:].startswith(";") or "\n" in code[m.start(2):end]:
            continue
        statement = code[m.start(2):end + 2]
        yield m.start(2), end + 2, f"{{ if (!coif_mutants::at(NUMBER)) {statement} }}"


def swapped_arguments(code):
    """Two arguments that stand beside each other: [(from, to, text)]."""
    for m in re.finditer(r"(?<![\w:.>])((?:[A-Za-z_]\w*(?:::|\.|->))*([A-Za-z_]\w*))\(", code):
        end = closing(code, m.end() - 1)
        if end is None or m.group(2) in KEYWORDS | COMMUTATIVE or "\n" in code[m.start():end]:
            continue
        # "Type name(a, b)" is no call.
        if re.search(r"[\w>&*] $", code[:m.start()][-2:]) and not re.search(r"\b(return|else) $", code[:m.start()][-8:]):
            continue
        given = arguments(code, m.end(), end)
        if given is None or len(given) < 2:
            continue
        for first, second in zip(given, given[1:]):
            a, b = code[slice(*first)].strip(), code[slice(*second)].strip()
            if a == b or not a or not b or (a[0].isdigit() and b[0].isdigit()) or {a, b} & {"d", "d_"}:  # d is a Highway type
                continue
            swapped = code[m.start():first[0]] + b + ", " + a + code[second[1]:end + 1]
            yield m.start(), end + 1, f"(coif_mutants::at(NUMBER) ? {swapped} : {code[m.start():end + 1]})"


KINDS = {"constant": constants, "comparison": comparisons, "dropped call": dropped_calls, "swapped arguments": swapped_arguments}


def find(text):
    """[(kind, from, to, replacement)] for a file's text; the replacement has NUMBER in it and no other number of lines."""
    code = blank(text)
    found = []
    for kind, search in KINDS.items():
        for start, end, other in search(code):
            # What is inside a string was blanked, and must come back.
            if code[start:end] == text[start:end]:
                found.append((kind, start, end, other))
    return found


def plant(text, chosen):
    """Writes [(number, (kind, from, to, replacement))] into the text; no two of them overlap."""
    for number, (_, start, end, other) in sorted(chosen, key=lambda c: -c[1][1]):
        line = text.rfind("\n", 0, start) + 1
        text = text[:start] + other.replace("NUMBER", str(number)) + text[end:]
        # A constant that depends on which mistake is made is not known to the compiler.
        head = re.match(r"[ \t]*(inline |static )?constexpr (?!auto \w+ = \[)", text[line:start])
        if head and "(" not in text[line:start].split("=")[0]:
            text = text[:line] + text[line:start].replace("constexpr ", "const ", 1) + text[start:]
    return text
