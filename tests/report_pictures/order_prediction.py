#!/usr/bin/env python3
"""How well the cook's expected PSNR of draw orders and thresholds ranks them as drawn pictures do.

  order_prediction.py COIF SOURCE... [--thresholds 0.5,0.7,0.85,0.95] [--views 24] [--size 160] [--least RHO]

Cooks each source once with each opaque threshold and once with the one that the cook chooses, takes what the cook expects by
distance from the head, in the best single order, and in the orders found, and measures the same with `coif report order`.
Prints a table and Spearman's rank correlation, over all and for each file, at rest and in motion; with --least it fails where
either over all is less. In motion the cook expects a median over its own moments; beside it stands the mean of the medians that
are measured during a turn and a charge.
A recipe that lies beside a source counts. Hair without blended texels is left out.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

QUALITY = r"([\d.]+) dB \(median ([\d.]+), worst ([\d.]+), moving ([\d.]+)\)"
NOTE = re.compile(r"draw order: .*?expected against exact order " + QUALITY + r".*?by distance from the head " +
                  QUALITY + r".*?the best single order of patches " + QUALITY)
CHOSEN = re.compile(r"opaque threshold ([\d.]+)")
TIME = re.compile(r"([\d.]+) ms  draw order")


def ranks(values):
    order = sorted(range(len(values)), key=lambda i: values[i])
    rank = [0.0] * len(values)
    first = 0
    while first < len(order):
        last = first
        while last + 1 < len(order) and values[order[last + 1]] == values[order[first]]:
            last += 1
        for i in range(first, last + 1):
            rank[order[i]] = 0.5 * (first + last)
        first = last + 1
    return rank


def spearman(pairs):
    a, b = ranks([p[0] for p in pairs]), ranks([p[1] for p in pairs])
    middle = (len(pairs) - 1) / 2
    above = sum((x - middle) * (y - middle) for x, y in zip(a, b))
    below = (sum((x - middle) ** 2 for x in a) * sum((y - middle) ** 2 for y in b)) ** 0.5
    return above / below if below > 0 else float("nan")


def recipe_for(source, threshold, folder):
    """The recipe beside the source, with this threshold; null: the cook's own."""
    beside = source.with_name(source.stem + ".recipe.json")
    text = re.sub(r"^\s*//.*$", "", beside.read_text(), flags=re.M) if beside.exists() else "{}"
    recipe = json.loads(text)
    if threshold is not None:
        recipe.setdefault("material", {})["opaque_threshold"] = threshold
    path = folder / "recipe.json"
    path.write_text(json.dumps(recipe))
    return path


def measured(coif, asset, args):
    command = [coif, "report", asset, "order", "--views", str(args.views), "--orbit", "0", "--no-modes",
               "--size", f"{args.size}x{args.size}", "--format", "json"]
    report = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    rows = {(row["order"], row["pose"]): row for row in report.get("rows", report.get("orders"))}
    found = "view" if ("view", "rest") in rows else "best"
    drawn = {}
    for name, order in (("found", found), ("head", "head"), ("single", "best")):
        moving = [row["median_psnr_db"] for (of, pose), row in rows.items() if of == order and pose != "rest"]
        drawn[name] = dict(rows[(order, "rest")], moving_db=sum(moving) / len(moving))
    return drawn


def compare(coif, source, threshold, folder, args):
    """Rows (file, threshold, order, expected dB, expected median, measured dB, measured median, cook's ms, whether the cook chose
    the threshold, expected dB in motion, measured dB in motion)."""
    asset = folder / "hair.coif"
    recipe = recipe_for(source, threshold, folder)
    cooked = subprocess.run([coif, "cook", "-v", source, "--recipe", recipe, "-o", asset], capture_output=True, text=True)
    told = cooked.stdout + cooked.stderr
    note = NOTE.search(told)
    if cooked.returncode != 0 or note is None:
        return []
    used = threshold if threshold is not None else float(CHOSEN.findall(told)[-1])
    figures = [float(x) for x in note.groups()]
    drawn = measured(coif, asset, args)
    rows = []
    for i, name in enumerate(("found", "head", "single")):
        rows.append((source.stem, used, name, figures[4 * i], figures[4 * i + 1], drawn[name]["psnr_db"],
                     drawn[name]["median_psnr_db"], float(TIME.search(told).group(1)), threshold is None,
                     figures[4 * i + 3], drawn[name]["moving_db"]))
    return rows


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("coif")
    parser.add_argument("sources", nargs="+", type=pathlib.Path)
    parser.add_argument("--thresholds", default="0.5,0.7,0.85,0.95")
    parser.add_argument("--views", type=int, default=24)
    parser.add_argument("--size", type=int, default=160)
    parser.add_argument("--least", type=float)
    args = parser.parse_args()
    all_rows = []
    for source in args.sources:
        with tempfile.TemporaryDirectory() as folder:
            of_file = []
            for threshold in [None] + [float(t) for t in args.thresholds.split(",") if t]:
                rows = compare(args.coif, source, threshold, pathlib.Path(folder), args)
                if not rows:
                    break
                for file, used, name, psnr, median, drawn, drawn_median, ms, chosen, moving, drawn_moving in rows:
                    print(f"{file:12} {used:.2f}{'*' if chosen else ' '} {name:7} expected {psnr:5.1f} median {median:5.1f}"
                          f"  drawn {drawn:5.1f} median {drawn_median:5.1f}  moving {moving:5.1f} drawn {drawn_moving:5.1f}"
                          f"  {ms / 1000:5.1f} s", flush=True)
                of_file += rows
        if of_file:
            print(f"{source.stem:12} Spearman {spearman([(r[3], r[5]) for r in of_file]):.3f}, in motion "
                  f"{spearman([(r[9], r[10]) for r in of_file]):.3f}", flush=True)
        else:
            print(f"{source.stem:12} left out: nothing is blended, or no cook", flush=True)
        all_rows += of_file
    if not all_rows:
        sys.exit("no file has blended hair: nothing was compared")
    rho = [spearman([(row[e], row[d]) for row in all_rows]) for e, d in ((3, 5), (9, 10))]
    print(f"all          Spearman {rho[0]:.3f}, in motion {rho[1]:.3f}, of {len(all_rows)}")
    if args.least is not None and min(rho) < args.least:
        sys.exit(f"the cook ranks what it expects by {min(rho):.3f}, less than {args.least}")


if __name__ == "__main__":
    main()
