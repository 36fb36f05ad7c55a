#!/usr/bin/env python3
"""Draws how wrong every solver is against what it costs, of one or more builds in one picture, and prints the numbers.

usage: tests/bench/error_against_ns.py OUT.svg FPS NAME=REPORT.json [NAME=REPORT.json...]

A REPORT.json is of `coif report FILE.coif accuracy -o REPORT.json`. Errors are the RMS of all motions' RMS errors, in % of a
chain's length; ns are the mean over the motions, per bone and frame. A line joins the sub-steps of a solver. Solvers whose code is
the same in all builds are drawn as well: where they lie apart, the machine did not keep its pace.
"""
import collections
import json
import math
import pathlib
import sys

WIDTH, HEIGHT, MARGIN = 900, 600, 60
COLOURS = ["#1b6ca8", "#c2501a", "#3f8f3f", "#8a4fa3"]


def points(report, fps):
    """{solver: [(sub-steps, ns, error in %)]}"""
    groups = collections.defaultdict(list)
    for row in report["rows"]:
        if row["fps"] == fps and row["of_motion_pct"] is not None:
            groups[row["solver"], row["substeps"]].append((row["ns_per_bone_frame"], row["rms_error_pct"]))
    solvers = collections.defaultdict(list)
    for (solver, substeps), rows in sorted(groups.items()):
        ns = sum(row[0] for row in rows) / len(rows)
        error = math.sqrt(sum(row[1] ** 2 for row in rows) / len(rows))
        solvers[solver].append((substeps, ns, error))
    return solvers


def scale(values, low, high):
    """Logarithmic, from the values' range to low..high."""
    least, most = math.log10(min(values)), math.log10(max(values))
    return lambda value: low + (math.log10(value) - least) / max(most - least, 1e-9) * (high - low)


def ticks(values):
    decades = range(math.floor(math.log10(min(values))), math.ceil(math.log10(max(values))) + 1)
    return [tick for tick in (factor * 10.0 ** decade for decade in decades for factor in (1, 2, 5))
            if min(values) <= tick <= max(values)]


def picture(builds, fps):
    shown = [point for solvers in builds.values() for line in solvers.values() for point in line if point[2] > 0]
    across = scale([point[1] for point in shown], MARGIN, WIDTH - 2 * MARGIN)
    down = scale([point[2] for point in shown], HEIGHT - MARGIN, MARGIN)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="11">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for tick in ticks([point[1] for point in shown]):
        parts.append(f'<text x="{across(tick):.1f}" y="{HEIGHT - MARGIN + 22}" text-anchor="middle">{tick:g}</text>')
    for tick in ticks([point[2] for point in shown]):
        parts.append(f'<text x="{MARGIN - 12}" y="{down(tick) + 4:.1f}" text-anchor="end">{tick:g}</text>')
        parts.append(f'<path d="M{MARGIN} {down(tick):.1f}H{WIDTH - 2 * MARGIN}" stroke="#ddd"/>')
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 12}" text-anchor="middle">ns per bone and frame</text>')
    parts.append(f'<text x="{MARGIN - 40}" y="{MARGIN - 24}">RMS error, % of the chain, {fps:g} frames per second</text>')
    for (name, solvers), colour in zip(builds.items(), COLOURS):
        for solver, line in solvers.items():
            places = [(across(ns), down(error)) for _, ns, error in line if error > 0]
            parts.append(f'<path d="M{" ".join(f"{x:.1f} {y:.1f}" for x, y in places)}" fill="none" stroke="{colour}"/>')
            parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places]
            parts.append(f'<text x="{places[-1][0] + 6:.1f}" y="{places[-1][1] + 4:.1f}" fill="{colour}">{solver}</text>')
    for i, (name, colour) in enumerate(zip(builds, COLOURS)):
        parts.append(f'<text x="{WIDTH - 2 * MARGIN - 60}" y="{MARGIN - 24 + 14 * i}" fill="{colour}">{name}</text>')
    return "\n".join([*parts, "</svg>", ""])


def main():
    if len(sys.argv) < 4:
        print(__doc__)
        return 2
    fps = float(sys.argv[2])
    builds = {}
    for argument in sys.argv[3:]:
        name, path = argument.split("=", 1)
        builds[name] = points(json.loads(pathlib.Path(path).read_text()), fps)
    if not any(builds.values()):
        sys.exit(f"no report has rows of {fps:g} frames per second")
    pathlib.Path(sys.argv[1]).write_text(picture(builds, fps))
    for name, solvers in builds.items():
        for solver, line in solvers.items():
            for substeps, ns, error in line:
                print(f"{name:12} {solver:18} {substeps:3} {ns:9.1f} ns {error:9.3g} %")
    return 0


if __name__ == "__main__":
    sys.exit(main())
