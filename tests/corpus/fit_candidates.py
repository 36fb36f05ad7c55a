#!/usr/bin/env python3
"""Fits the weights by which `coif cook` tells hair from other parts of a model (tools/cook/select/candidate_verdict.cpp).

usage: fit_candidates.py COIF FOLDER... [--per-part]

Each FOLDER has a TRUTH.json, as vary_models.py writes one, too: points on hair ("points") and near by on what is none
("not"), and the meshes that are hair ("is"). Each part that `coif cook --list candidates` prints is labelled by the
points that are nearest to it. Prints the table, and how well it does on each maker (a folder's name up to the first
'_') that it was not fitted to. Exit code 77 where a FOLDER or numpy is absent.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

RIDGE = 0.02  # Pull of each weight towards 0, per unit of squared weight and file: features are 0..1.
STEPS = 60


def candidates_of(coif, path):
    run = subprocess.run([coif, "cook", str(path), "--list", "candidates", "--format", "json"], capture_output=True)
    return json.loads(run.stdout) if run.returncode == 0 else None


def labels_of(np, truth, parts):
    """1 hair, 0 none, None unsure; one for each part."""
    if not truth["hair"]:
        return [0] * len(parts)
    select = truth.get("select", {})
    if select.get("is") == "all of it":
        return [1] * len(parts)
    votes = [[0, 0] for _ in parts]
    for kind, key in enumerate(("points", "not")):
        for point in select.get(key, []):
            far = [np.square(np.array(p["middles"]) - point).sum(axis=1).min() if p["middles"] else np.inf for p in parts]
            if parts:
                votes[int(np.argmin(far))][kind] += 1
    return [None if hair == other else int(hair > other) for hair, other in votes]


def fit(np, x, y, weight):
    """A logistic regression with a ridge, by Newton's steps; the last column is the bias, which nothing pulls."""
    theta, pull = np.zeros(x.shape[1]), np.full(x.shape[1], RIDGE * weight.sum() / 10)
    pull[-1] = 1e-6
    for _ in range(STEPS):
        p = 1 / (1 + np.exp(-np.clip(x @ theta, -30, 30)))
        slope = x.T @ (weight * (p - y)) + pull * theta
        bend = (x * (weight * np.maximum(p * (1 - p), 1e-6))[:, None]).T @ x + np.diag(pull)
        theta = theta - np.linalg.solve(bend, slope)
    return theta


def gather(np, ask):
    rows, names = [], None
    for folder in map(Path, ask.folder):
        for name, truth in sorted(json.loads((folder / "TRUTH.json").read_text()).items()):
            said = candidates_of(ask.coif, folder / name)
            if not said:
                continue
            parts = said["candidates"]
            labels = labels_of(np, truth, parts)
            count = max(1, sum(label is not None for label in labels))
            for part, label in zip(parts, labels):
                if label is None:
                    continue
                names = names or list(part["features"])
                rows.append({"maker": name.split("/")[0].split("_")[0], "file": name, "sees": said["sees_head"], "y": label,
                             "weight": 1 / count ** 0.5, "x": list(part["features"].values()) + [1.0],
                             "name": f"{part['mesh']}/{part['material']} {part['triangles']}", "now": part["probability"]})
    return rows, names


def report(np, rows, names, title, per_part):
    for row in rows:  # Each maker counts the same.
        row["weight"] *= 10 / sum(r["weight"] for r in rows if r["maker"] == row["maker"])
    x, y = np.array([r["x"] for r in rows]), np.array([r["y"] for r in rows], float)
    weight, makers = np.array([r["weight"] for r in rows]), np.array([r["maker"] for r in rows])
    held = np.zeros(len(rows))
    for maker in sorted(set(makers)):
        theta = fit(np, x[makers != maker], y[makers != maker], weight[makers != maker])
        held[makers == maker] = 1 / (1 + np.exp(-x[makers == maker] @ theta))
    print(f"{title}: {len(rows)} parts of {len(set(r['file'] for r in rows))} files, {int(y.sum())} are hair")
    for maker in sorted(set(makers)):
        of = makers == maker
        wrong = ((held > 0.5) != (y > 0.5)) & of
        print(f"  without {maker:10} {int((held[of] > 0.5).sum()):4} called hair, {int(y[of].sum()):4} are; {int(wrong.sum()):3} wrong, "
              f"{int((wrong & (abs(held - 0.5) > 0.3)).sum())} of them surely")
        for k in np.flatnonzero(wrong):
            print(f"      {held[k]:.2f} {int(y[k])} {rows[k]['file']} {rows[k]['name']}")
    hit = lambda a, b: int(((held > 0.5) == a)[y == b].sum())
    print(f"  held out: hair found {hit(True, 1)}, missed {hit(False, 1)}; other left {hit(False, 0)}, taken {hit(True, 0)}")
    for low in np.arange(0, 1, 0.2):
        of = (held >= low) & (held < low + 0.2)
        if of.any():
            print(f"  said {low:.1f}..{low + 0.2:.1f}: {y[of].mean():.2f} of {int(of.sum())} are hair")
    theta = fit(np, x, y, weight)
    print("  {%.2f, {%s}}" % (theta[-1], ", ".join("%.2f" % w for w in theta[:-1])))
    print("  " + ", ".join(f"{n} {w:.2f}" for n, w in zip(names + ["bias"], theta)))
    if per_part:
        for k, row in enumerate(rows):
            print(f"    {held[k]:.2f} now {row['now']:.2f} {row['y']} {row['file']} {row['name']} " +
                  " ".join(f"{n}={v:.2f}" for n, v in zip(names, row["x"]) if v))


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("coif")
    ask.add_argument("folder", nargs="+")
    ask.add_argument("--per-part", action="store_true")
    ask = ask.parse_args()
    for folder in ask.folder:
        if not (Path(folder) / "TRUTH.json").exists():
            print(f"SKIP: {folder} has no TRUTH.json")
            return 77
    try:
        import numpy as np
    except ImportError:
        print("SKIP: needs numpy (Debian: python3-numpy)")
        return 77
    rows, names = gather(np, ask)
    for sees, title in ((True, "with a head"), (False, "without one")):
        of = [r for r in rows if r["sees"] == sees]
        if len(set(r["y"] for r in of)) == 2:
            report(np, of, names, title, ask.per_part)
    return 0


if __name__ == "__main__":
    sys.exit(main())
