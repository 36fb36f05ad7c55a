#!/usr/bin/env python3
"""Holds what `coif report --format json` prints to reports.schema.json, and what pages show of it to page_layout.schema.json.

usage: schema_test.py check|can_fail TOOLS COIF ASSET
check runs each report on ASSET, briefly; can_fail breaks answers and layouts in ways the schemas must see.
"""
import copy
import json
import subprocess
import sys
from pathlib import Path

try:
    import jsonschema
except ImportError:
    sys.exit("no python3-jsonschema here (Debian: python3-jsonschema)")

NO_DEVICE = 5  # The exit code where nothing can be drawn.
BRIEFLY = {
    "accuracy": ["--motion", "nod", "--fps", "30,60", "--substeps", "1", "--seconds", "0.5", "--solver", "coif,thesis"],
    "stability": ["--solver", "thesis"],
    "cost": ["--heads", "1,10", "--time", "0.3", "--size", "32x24"],
    "order": ["--size", "32x32", "--views", "2", "--orbit", "2", "--no-modes"],
    "shadows": ["--map-size", "64", "--spacing", "0.02"],
}


def answer(coif, asset, subject):
    done = subprocess.run([coif, "report", asset, subject, *BRIEFLY[subject], "--format", "json"], capture_output=True, text=True,
                          check=False)
    if done.returncode == NO_DEVICE:
        print(f"{subject}: not measured: {done.stderr.strip()}")
        return None
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def faults(schema, value):
    return [f"{list(error.absolute_path)}: {error.message[:200]}" for error in jsonschema.Draft202012Validator(schema).iter_errors(value)]


def schema_of(schema, value):
    """The part that is meant, where that only refers to it."""
    name = value.get("$ref", "").rpartition("/")[2]
    return schema["$defs"][name] if name else value


def not_in_schema(schema, report):
    """Keys of the report and of its lists' records that the schema does not name: it would hold nothing of them."""
    named = {**schema["properties"], **schema["$defs"][report["report"]]["properties"]}
    bad = [key for key in report if key not in named]
    for key, value in report.items():
        if isinstance(value, list) and value and key in named:
            known = schema_of(schema, named[key]["items"])["properties"]
            bad += [f"{key}.{inner}" for inner in value[0] if inner not in known]
    return bad


def columns_without_key(report):
    """Columns of keys that the records have not."""
    return [f"{name}: {column['key']}" for name, columns in report["columns"].items() if report[name]
            for column in columns if column["key"] not in report[name][0]]


def layouts(tools):
    found = sorted(Path(tools).rglob("*_page.json"))
    assert len(found) == 9, found
    return {path.name: json.loads(path.read_text()) for path in found}


def read(tools, name):
    schema = json.loads(Path(tools, "report", name).read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema


def check(tools, coif, asset):
    schema, layout_schema = read(tools, "reports.schema.json"), read(tools, "page/page_layout.schema.json")
    bad = [f"{name}: {fault}" for name, layout in layouts(tools).items() for fault in faults(layout_schema, layout)]
    for subject in BRIEFLY:
        report = answer(coif, asset, subject)
        if report is None:
            continue
        bad += [f"{subject}: {fault}" for fault in faults(schema, report)]
        bad += [f"{subject}: not in the schema: {key}" for key in not_in_schema(schema, report)]
        bad += [f"{subject}: no such key: {column}" for column in columns_without_key(report)]
        if report["report"] != subject:
            bad.append(f"{subject}: calls itself {report['report']}")
    return bad


def can_fail(tools, coif, asset):
    schema, layout_schema = read(tools, "reports.schema.json"), read(tools, "page/page_layout.schema.json")
    good, layout = answer(coif, asset, "stability"), layouts(tools)["accuracy_page.json"]
    chart = next(i for i, part in enumerate(layout) if "chart" in part)
    breaks = [(schema, good, change) for change in (
        lambda v: v.pop("cases"), lambda v: v.update(report="speed"), lambda v: v["cases"][0].update(outcome="fine"),
        lambda v: v["cases"][0].pop("stretch_max_pct"), lambda v: v["cases"][0].update(max_speed="fast"),
        lambda v: v["totals"][0].update(ok=-1), lambda v: v["columns"]["cases"][0].update(kind="numbers"),
        lambda v: v["columns"]["cases"][2]["looks"][0].update(look="green"))]
    breaks += [(layout_schema, layout, change) for change in (
        lambda v: v[chart]["chart"].pop("x"), lambda v: v[chart]["chart"]["series"][0].pop("by"), lambda v: v[chart].update(text="two"),
        lambda v: v[chart]["chart"]["y"].update(logarithmic=True), lambda v: v.append({"picture": "worst"}))]
    bad = []
    for number, (against, value, change) in enumerate(breaks):
        broken = copy.deepcopy(value)
        change(broken)
        if not faults(against, broken):
            bad.append(f"break {number} was not seen")
    extra = copy.deepcopy(good)
    extra["cases"][0]["new"] = 1
    extra["columns"]["cases"][0]["key"] = "nowhere"
    if not_in_schema(schema, extra) != ["cases.new"] or columns_without_key(extra) != ["cases: nowhere"]:
        bad.append("keys that nobody knows were not seen")
    return bad


def main():
    test, tools, coif, asset = sys.argv[1:]
    problems = {"check": check, "can_fail": can_fail}[test](tools, coif, asset)
    print("\n".join(problems) or "fits")
    return 1 if problems else 0


sys.exit(main())
