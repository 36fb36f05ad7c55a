#!/usr/bin/env python3
"""Fits the table of tools/cook/strands/strand_evidence.h.

    fit_roots.py TRIAL CORPUS [--sets 80] [--styles 42] [--seed 1] [--start WEIGHTS.json] [-o WEIGHTS.json]

TRIAL is the program coif_root_trial, CORPUS a folder with a TRUTH.json as the corpus judge reads it (labels "roots").
Tries the table as it is, each weight alone by a few factors, and random tables around it, on made-up styles whose roots
are known and on the labelled files; prints the best table. For the cross-validation, the best table is chosen again
without each maker (the part of a folder's name before "_"), and judged on that maker's files. Needs only Python.
"""
import argparse, itertools, json, math, os, random, subprocess, sys, tempfile
from concurrent.futures import ThreadPoolExecutor

TABLE = {"distance": 0.78, "height": 0.25, "shell_height": 0.8, "taper": 0.23, "tied": 0.88, "fade": 1.19,
         "neighbour": 1.25, "mirror": 0.87, "island": 1.21, "common": 0.35, "habit": 0.16, "longer": 0.96,
         "lines": 2.01, "ends": 1.05, "common_axis": 0.19, "unwrapped": 0.28, "mirrored_axis": 1.55}
FACTORS = (0.4, 0.7, 1.4, 2.2)
# Tables that go wrong, only to learn by what one sees that.
BROKEN = [{"height": -0.4, "shell_height": -0.8}, {"distance": -1, "height": -0.2, "shell_height": -0.4}, {"neighbour": 0, "mirror": 0},
          {"neighbour": 0, "mirror": 0, "island": 0, "common": 0}, {"lines": -1, "longer": -0.7}, {"neighbour": -0.6},
          {"mirrored_axis": -2, "mirror": -0.6}, {"height": 0, "shell_height": 0, "distance": 0, "fade": 0}]
DOUBTS = ("unsure", "rises", "rises_above", "against_neighbour", "against_mirror", "against_ends")


def designs(start, count, seed):
    """The tables that are tried, the start first."""
    sets = [dict(start)]
    for name in start:
        sets += [dict(start, **{name: start[name] * f}) for f in FACTORS]
    dice = random.Random(seed)
    for _ in range(count):
        sets.append({n: v * math.exp(dice.gauss(0, 0.4)) for n, v in start.items()})
    return sets


def down(rows, box):
    inside = [r for r in rows if all(box[0][k] <= r[1 + k] <= box[1][k] for k in range(3))]
    falls, rises = (sum(r[0] for r in inside if s * r[5] > 0.3) for s in (-1, 1))
    return falls / (falls + rises) if falls + rises > 0.05 * sum(r[0] for r in rows) else None


def mirror(rows):
    low, high = ([f(r[1 + k] for r in rows) for k in range(3)] for f in (min, max))
    cell, middle, grid = 0.012 * max(h - l for l, h in zip(low, high)), (low[0] + high[0]) / 2, {}
    key = lambda p: tuple(round(c / cell) for c in p)
    for r in rows:
        grid.setdefault(key((r[1] - middle, r[2], r[3])), []).append(r)
    both = same = 0.0
    for r in rows:
        at, best = (middle - r[1], r[2], r[3]), None
        for near in itertools.product((-1, 0, 1), repeat=3):
            for o in grid.get(tuple(a + b for a, b in zip(key(at), near)), ()):
                d = (o[1] - middle - at[0]) ** 2 + (o[2] - at[1]) ** 2 + (o[3] - at[2]) ** 2
                if d < cell * cell and (best is None or d < best[0]):
                    best = (d, o)
        if best:
            both += r[0]
            same += r[0] * (-r[4] * best[1][4] + r[5] * best[1][5] + r[6] * best[1][6] >= 0)
    return same / both if both > 0.15 * sum(r[0] for r in rows) else None


def from_top(rows):
    rows = sorted(rows, key=lambda r: r[2])
    fifth = sum(r[0] for r in rows) / 5

    def mean(order):
        area = place = 0.0
        for r in order:
            if area >= fifth:
                break
            area, place = area + r[0], place + r[0] * r[7]
        return place / area
    return mean(rows) - mean(reversed(rows))


def outwards(rows, c):
    return sum(r[0] for r in rows if sum(r[4 + k] * (r[1 + k] - c[k]) for k in range(3)) > 0) / sum(r[0] for r in rows)


def margins(labels, truth, rows, head):
    """How far each label of a file is fulfilled: 0 just so, positive well."""
    center = truth["head"]["center"] if truth.get("head") else head[:3]
    found = {"down_below_center": lambda: down(rows, ([-99] * 3, [99, center[1], 99])), "mirror": lambda: mirror(rows),
             "outwards": lambda: outwards(rows, center)}
    result = []
    for name, value in found.items():
        if name in labels and (v := value()) is not None:
            result.append(v - labels[name])
    if "down_in" in labels and (v := down(rows, labels["down_in"]["box"])) is not None:
        result.append(v - labels["down_in"]["least"])
    if labels.get("from") == "top":
        result.append(from_top(rows) - 0.1)
    return result


def run(trial, weights, styles, files):
    return subprocess.run([trial, weights, str(styles)] + files, capture_output=True, text=True).stdout.splitlines()


def measure(ask, sets, truths):
    """{maker: [loss of each set]}, and {file: [is right, for each set]}."""
    losses, right, doubts = {}, {}, {}
    with tempfile.TemporaryDirectory() as room, ThreadPoolExecutor(2) as pool:
        path = os.path.join(room, "sets.json")
        json.dump(sets, open(path, "w"))
        jobs = [pool.submit(run, ask.trial, path, 0, [os.path.join(ask.corpus, f)]) for f in truths]
        jobs.append(pool.submit(run, ask.trial, path, ask.styles, []))
        tallies = {}
        for line in (json.loads(l) for job in jobs for l in job.result()):
            if "style" in line:
                of = tallies.setdefault(line["style"], [[0] * len(sets), 0])
                of[0], of[1] = [a + b for a, b in zip(of[0], line["right"])], of[1] + line["all"]
                continue
            name = os.path.relpath(line["file"], ask.corpus)
            # Without a unit the labels' metres are not the file's: only boxes, of files that have one, need them.
            all_margins = [margins(truths[name]["roots"], truths[name] if name.endswith((".glb", ".vrm")) else {}, rows,
                                   line["head"]) for rows in line["rows"]]
            doubts[name] = line["doubts"]
            right[name] = [min(m, default=1) >= 0 for m in all_margins]
            loss = [sum(max(-0.3, min(1, -v / 0.15)) for v in m) for m in all_margins]
            maker = name.split("_")[0]
            losses[maker] = [a + b for a, b in zip(losses.get(maker, [0] * len(sets)), loss)]
    for family, (good, count) in tallies.items():
        losses["made-up " + family] = [10 * (1 - g / count) for g in good]
    return losses, right, tallies, doubts


def best_of(losses, sets, start, without=None):
    def total(k):
        far = sum(math.log(sets[k][n] / start[n]) ** 2 for n in start)
        return sum(l[k] for m, l in losses.items() if m != without) + 0.05 * far
    return min(range(len(sets)), key=total)


def logistic(rows):
    """Base and weights, none negative, of probability = 1 / (1 + exp(-(base - sum of weight * doubt)))."""
    base, w = 3.0, [3.0] * len(DOUBTS)
    for step in range(1500):
        slope, slopes = 0.0, [0.0005 * v for v in w]
        for x, good, weight in rows:
            p = 1 / (1 + math.exp(-max(-30, min(30, base - sum(a * b for a, b in zip(w, x))))))
            slope += weight * (p - good)
            slopes = [g - weight * (p - good) * b for g, b in zip(slopes, x)]
        rate = 20.0 / (1 + step / 300)
        base = max(1.5, min(4.5, base - rate * slope))
        w = [max(0.0, min(12.0, v - rate * g)) for v, g in zip(w, slopes)]
    return base, w


def calibrate(right, doubts):
    """Prints the weights of RootDoubts::probability(), and how often they warn of right and of wrong roots, by makers
    that were left out."""
    def rows(names):
        # Each file counts the same, right and wrong outcomes of it as much as they are many.
        return [(x, float(good), 1 / len(right) / len(right[n])) for n in names for x, good in zip(doubts[n], right[n])]
    base, w = logistic(rows(right))
    print("probability: base %.2f, " % base + ", ".join("%s %.2f" % d for d in zip(DOUBTS, w)))
    counts = {True: [0, 0], False: [0, 0]}
    for maker in sorted({n.split("_")[0] for n in right}):
        b, v = logistic(rows([n for n in right if n.split("_")[0] != maker]))
        for n in (n for n in right if n.split("_")[0] == maker):
            for x, good in zip(doubts[n], right[n]):
                counts[good][0] += b - sum(a * c for a, c in zip(v, x)) < math.log(0.8 / 0.2)
                counts[good][1] += 1
    print("cross-validation: warns of %d of %d right roots, and of %d of %d wrong ones" % tuple(counts[True] + counts[False]))


def main():
    ask = argparse.ArgumentParser()
    ask.add_argument("trial")
    ask.add_argument("corpus")
    for name, usual in (("--sets", 80), ("--styles", 42), ("--seed", 1)):
        ask.add_argument(name, type=int, default=usual)
    ask.add_argument("--start")
    ask.add_argument("-o")
    ask = ask.parse_args()
    truths = {n: t for n, t in json.load(open(os.path.join(ask.corpus, "TRUTH.json"))).items() if t.get("roots")}
    start = dict(TABLE, **(json.load(open(ask.start)) if ask.start else {}))
    sets = designs(start, ask.sets, ask.seed)
    losses, right, tallies, doubts = measure(ask, sets + [dict(start, **b) for b in BROKEN], truths)
    best = best_of(losses, sets, start)
    for k, said in ((0, "start"), (best, "best")):
        good, count = sum(t[0][k] for t in tallies.values()), sum(t[1] for t in tallies.values())
        print("%-5s %d of %d files right, %.2f %% of %d made-up strips; wrong: %s" % (
            said, sum(r[k] for r in right.values()), len(right), 100 * good / max(1, count), count,
            ", ".join(n for n, r in right.items() if not r[k]) or "none"))
    print("weights: " + json.dumps({n: round(v, 3) for n, v in sets[best].items()}))
    held = 0
    for maker in sorted({n.split("_")[0] for n in right}):
        k = best_of(losses, sets, start, maker)
        files = [n for n in right if n.split("_")[0] == maker]
        held += sum(right[n][k] for n in files)
        print("without %-12s %d of %d right (start: %d)" % (maker, sum(right[n][k] for n in files), len(files), sum(right[n][0] for n in files)))
    print("cross-validation: %d of %d files right" % (held, len(right)))
    calibrate(right, doubts)
    if ask.o:
        json.dump({n: round(v, 3) for n, v in sets[best].items()}, open(ask.o, "w"), indent=1)


if __name__ == "__main__":
    sys.exit(main())
