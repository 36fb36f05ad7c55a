#!/usr/bin/env python3
"""Fits how sure a cook is of its decisions to labelled files.

    fit_decisions.py COIF JUDGE FOLDER...

JUDGE is judge.py of the labelled files; each FOLDER has a TRUTH.json. Each file is cooked as a
draft without a recipe; its report has the features of each decision, the judge says whether the decision is right. For
each kind of decision this prints the weights for the table in the source, and, with the files of one maker left out at
a time (a folder's name up to its first '_'), how often what was said to be sure was right. The variants of a file
count together as one.
"""
import collections
import importlib.util
import json
import os
import subprocess
import sys
import tempfile

import numpy

LABEL = {"head": "head", "facing": "faces", "roots": "roots", "hair": "select", "chains": "chains moves rigid"}
STRENGTH = 0.1  # of the prior that weights are near 0
BINS = (0.0, 0.25, 0.5, 0.8, 0.9, 1.0)


def load_judge(path):
    spec = importlib.util.spec_from_file_location("judge", path)
    judge = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(judge)
    return judge


def samples(coif, judge, folder):
    """Of each file that cooks: (maker, file, kind, features, whether it is right)."""
    truths = json.load(open(os.path.join(folder, "TRUTH.json")))
    with tempfile.TemporaryDirectory() as room:
        asset, report = os.path.join(room, "a.coif"), os.path.join(room, "r.json")
        for name, truth in sorted(truths.items()):
            for old in (asset, report):
                if os.path.exists(old):
                    os.remove(old)
            subprocess.run([coif, "cook", os.path.join(folder, name), "-o", asset, "--draft", "--report", report],
                           capture_output=True, check=False)
            if not os.path.exists(asset) or not truth["hair"]:
                continue
            bad = judge.judge(truth, judge.read_asset(asset))
            file = name.split("/")[0].split("~")[0]
            for decision in json.load(open(report)).get("decisions", []):
                labels = LABEL.get(decision["what"], "").split()
                is_judged = any(label in truth for label in labels) and (labels == ["select"] or "select" not in bad)
                if is_judged and decision["features"]:
                    is_right = not any(label in bad for label in labels)
                    yield file.split("_")[0], file, decision["what"], decision["features"], is_right, name


def fit(x, y, w):
    """Logistic regression by Newton's method; the last column of x is 1 and has no prior."""
    weights = numpy.zeros(x.shape[1])
    prior = numpy.full(x.shape[1], STRENGTH)
    prior[-1] = 1e-3
    for _ in range(50):
        p = 1 / (1 + numpy.exp(-x @ weights))
        gradient = x.T @ (w * (p - y)) + prior * weights
        hessian = (x * (w * p * (1 - p))[:, None]).T @ x + numpy.diag(prior)
        weights -= numpy.linalg.solve(hessian, gradient)
    return weights


def show(kind, rows):
    names = list(dict.fromkeys(n for row in rows for n in row[3]))
    x = numpy.array([[row[3].get(n, 0) for n in names] + [1] for row in rows])
    y = numpy.array([float(row[4]) for row in rows])
    share = collections.Counter(row[1] for row in rows)
    w = numpy.array([1 / share[row[1]] for row in rows])
    said = numpy.zeros(len(rows))
    for maker in {row[0] for row in rows}:
        out = numpy.array([row[0] == maker for row in rows])
        if (~out).any():
            said[out] = 1 / (1 + numpy.exp(-x[out] @ fit(x[~out], y[~out], w[~out])))
    weights = fit(x, y, w)
    print(f"\n{kind}: {len(rows)} cooks of {len(share)} files, {int(y.sum())} right")
    print(f"  bias {weights[-1]:.2f}; " + ", ".join('{"%s", %.2f}' % pair for pair in zip(names, weights)))
    print("  said (its maker left out)   files   right")
    for low, high in zip(BINS, BINS[1:]):
        inside = (said >= low) & ((said < high) | (high == 1))
        if inside.any():
            print(f"  {low:4.2f} to {high:4.2f}, mean {numpy.average(said[inside], weights=w[inside]):4.2f}"
                  f"      {w[inside].sum():6.1f}   {numpy.average(y[inside], weights=w[inside]):5.2f}")
    for row, p in sorted(zip(rows, said), key=lambda r: r[1]):
        if row[4] != (p >= 0.8):
            print(f"  {'right' if row[4] else 'WRONG'}, said {p:.2f}: {row[5]}")


def main(coif, judge_path, *folders):
    judge = load_judge(judge_path)
    kinds = collections.defaultdict(list)
    for folder in folders:
        for row in samples(coif, judge, folder):
            kinds[row[2]].append(row)
    for kind, rows in kinds.items():
        show(kind, rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
