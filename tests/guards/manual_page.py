#!/usr/bin/env python3
"""The manual page has what the program's help has - every command, argument, option and exit code - and man(1) can show it.

usage: manual_page.py PROGRAM | --self-test PROGRAM
"""
import re
import shutil
import subprocess
import sys

SECTIONS = ["NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES"]


def output(*command, **how):
    return subprocess.run(command, check=True, capture_output=True, text=True, **how).stdout


def plain(roff):
    """The page's words, without fonts and escapes."""
    return re.sub(r"\\f[BIR]", "", roff).replace("\\-", "-").replace("\\(aq", "'")


def parts(page, macro):
    """Title of each section or subsection -> its text."""
    pieces = re.split(rf"(?m)^\.{macro} (.*)$", page)
    return dict(zip(pieces[1::2], pieces[2::2]))


def names(help_text):
    """Arguments and options that a help lists, each by its longest name."""
    listed = help_text.partition("Subcommands:")[0]
    return re.findall(r"(?m)^  (?:-\w,)?(--[\w-]+|[A-Z]+)", listed)


def content_faults(page, helps):
    """`helps`: command (empty: the program) -> its help."""
    sections = parts(page, "SH")
    yield from (f"has no section {name}" for name in SECTIONS if not sections.get(name, "").strip())
    if list(sections) != sorted(sections, key=lambda name: (SECTIONS + ["SEE ALSO"]).index(name)):
        yield "has its sections in another order than manual pages do"
    commands = {title.split()[1]: text for title, text in parts(sections.get("COMMANDS", ""), "SS").items()}
    for command, help_text in helps.items():
        text = commands.get(command, "") if command else sections.get("OPTIONS", "")
        for name in names(help_text):
            if not re.search(rf"(?m)^(?:-\w,)?{name}\b", text):
                yield f"does not say what {name} of 'coif {command}' is"
        if command and f"coif {command} " not in sections.get("SYNOPSIS", ""):
            yield f"does not say how 'coif {command}' is written"
    codes = re.findall(r"(?m)^(\d+)$", sections.get("EXIT STATUS", ""))
    if codes != re.findall(r"(\d+) [a-z]", helps[""].partition("Exit codes:")[2]):
        yield f"has other exit codes than the help: {codes}"


def faults(page, helps):
    yield from content_faults(plain(page), helps)
    if shutil.which("groff"):
        shown = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-z"], input=page, capture_output=True, text=True)
        if shown.returncode or shown.stderr:
            yield f"groff: {shown.stderr}"


def read(program):
    helps = {"": output(program, "--help")}
    for command in re.findall(r"(?m)^  (\w+)  ", helps[""].partition("Subcommands:")[2]):
        helps[command] = output(program, command, "--help")
    return output(program, "--man"), helps


def check(program):
    page, helps = read(program)
    seen = sum(len(names(text)) for text in helps.values())
    bad = list(faults(page, helps))
    if len(helps) < 2 or any(not names(text) for text in helps.values()):
        bad.append("a help without names: little was compared")
    return seen, bad


def self_test(program):
    page, helps = read(program)
    harms = {
        "an option is missing": page.replace("\\-\\-print\\-recipe", "\\-\\-recipes"),
        "a command is missing": re.sub(r"(?ms)^\.SS coif info.*?(?=^\.SS)", "", page),
        "an exit code is missing": page.replace("\\fB70\\fR", "\\fB71\\fR"),
        "a section is missing": page.replace(".SH FILES", ".PP"),
        "sections change places": page.replace(".SH FILES", ".SH -").replace(".SH ENVIRONMENT", ".SH FILES").replace(
            ".SH -", ".SH ENVIRONMENT"),
    }
    if shutil.which("groff"):
        harms["a macro is unknown"] = page + ".XYZ\n"
    bad = [f"did not fire where {harm}" for harm, text in harms.items() if text == page or not list(faults(text, helps))]
    return len(harms), bad


if __name__ == "__main__":
    seen, problems = self_test(sys.argv[2]) if sys.argv[1] == "--self-test" else check(sys.argv[1])
    print("\n".join(problems) or f"manual page: {seen} names or cases checked")
    sys.exit(1 if problems else 0)
