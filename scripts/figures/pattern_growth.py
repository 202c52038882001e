# SPDX-License-Identifier: MIT
"""Growth of a small wave from cycle to cycle in the continuum, for each closure, above the order and size of the MD's pattern:
    pattern_growth.py data/expected/ch5_growth.csv data/expected/ch6_onset_md.csv FOLDER
"""
import csv
import re
import sys

import numpy as np

from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "pattern_growth"
LOOKS = {
    ("jenkins_richman", "goldshtein"): ("o", "#000000"),
    ("jenkins_richman", "carnahan_starling"): ("s", "#2166ac"),
    ("garzo_dufty", "goldshtein"): ("^", "#b2182b"),
    ("garzo_dufty", "carnahan_starling"): ("v", "#7a3b9a"),
    ("jenkins_richman_dense", "goldshtein"): ("D", "#1b7837"),
}
# Waves smaller than this after eight cycles have nothing left of the one that was put in.
SMALLEST = 1e-5


def rows_of(path):
    with open(path, newline="") as table:
        return list(csv.DictReader(table))


def setting(row, key, default):
    found = re.search(re.escape(key) + r"=(\S+)", row["command"])
    return found[1] if found else default


def draw(growth, onset, folder):
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(6.2, 7.0), sharex=True, height_ratios=(1.3, 1))
    columns = {name: [] for name in ("Gamma", "closure", "pair correlation", "e of the sink", "factor a cycle")}
    for (closure, pair), (marker, colour) in LOOKS.items():
        for law, line, fill in (("law", "-", colour), ("0.7", ":", "none")):
            chosen = [r for r in growth if setting(r, "closure", "jenkins_richman") == closure
                      and setting(r, "pair_correlation", "goldshtein") == pair
                      and setting(r, "continuum.restitution", "law") == law and float(r["coherent"]) > SMALLEST]
            if not chosen:
                continue
            gamma = [float(r["value"]) for r in chosen]
            factor = [abs(float(r["multiplier"])) for r in chosen]
            label = f"{closure}, {pair}" if law == "law" else None
            upper.plot(gamma, factor, line, marker=marker, color=colour, mfc=fill, ms=4, lw=1, label=label)
            for g, f in zip(gamma, factor):
                for name, value in zip(columns, (g, closure, pair, law, f)):
                    columns[name].append(value)
    upper.axhline(1.0, color="0.5", lw=0.8)
    upper.set_ylabel("growth of a wave of 21 diameters a cycle")
    upper.legend(loc="lower right", fontsize=7, title="full: sink of e(v), $e_0$ = 0.7; dotted: constant 0.7", title_fontsize=7)

    value, order, square = (np.array([float(r[k]) for r in onset]) for k in ("value", "order", "mean_square"))
    points(lower, value, order, y_error=[float(r["order_error"]) for r in onset], marker="^", color=DENSITY, mfc="none",
           label=r"$P_{\max}$, MD")
    points(lower, value, square, y_error=[float(r["mean_square_error"]) for r in onset], marker="o", color=TEMPERATURE,
           mfc="none", label=r"$\langle\psi^2\rangle$, MD")
    lower.set_ylim(0, 1)
    lower.set_xlabel(r"peak acceleration $\Gamma$")
    lower.legend(loc="center right")
    return save(figure, folder, NAME, columns)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    print(draw(rows_of(sys.argv[1]), rows_of(sys.argv[2]), sys.argv[3]))
