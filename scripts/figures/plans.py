# SPDX-License-Identifier: MIT
"""What `shaken plan` foretold against what was found: plans.py data/expected/plans.csv FOLDER

Left CPU seconds with the band of a factor 1.5, right errors of z_cm(ft) with the band of a factor 2; a point outside its band is named."""
import csv
import sys

import numpy as np

from style import DENSITY, TEMPERATURE, plt, points, save

PANELS = {"seconds": (1.5, "CPU seconds"), "error_percent": (2.0, r"error of $z_{\mathrm{cm}}(ft)$, %")}
LOOKS = {"continuum": ("o", DENSITY), "md": ("^", TEMPERATURE)}
NAMES = {"continuum": "continuum", "md": "MD"}


def numbers(rows, column):
    return np.array([float(row[column] or "nan") for row in rows])


def draw_panel(axis, rows, quantity):
    factor, words = PANELS[quantity]
    rows = [row for row in rows if row["quantity"] == quantity]
    values = np.concatenate([numbers(rows, "foretold"), numbers(rows, "found")])
    ends = np.array([values.min() / 2, values.max() * 2])
    axis.fill_between(ends, ends / factor, ends * factor, color="0.88", lw=0, label=f"within a factor {factor:g}")
    axis.plot(ends, ends, color="0.5", lw=0.8)
    for engine, (marker, colour) in LOOKS.items():
        chosen = [row for row in rows if row["engine"] == engine]
        points(axis, numbers(chosen, "foretold"), numbers(chosen, "found"), x_error=numbers(chosen, "foretold_uncertainty"),
               y_error=numbers(chosen, "found_uncertainty"), marker=marker, color=colour, mfc="white", ms=6, label=NAMES[engine])
    for row in rows:
        if row["within"] == "0":
            axis.annotate(row["scene"].replace("_", " "), (float(row["foretold"]), float(row["found"])), xytext=(6, -3),
                          textcoords="offset points", fontsize=7)
    axis.set(xscale="log", yscale="log", xlim=ends, ylim=ends, xlabel=f"foretold {words}", ylabel=f"found {words}", aspect="equal")
    axis.legend(loc="upper left")


def main():
    with open(sys.argv[1], newline="") as table:
        rows = list(csv.DictReader(table))
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 4.8))
    for axis, quantity in zip(axes, PANELS):
        draw_panel(axis, rows, quantity)
    names = {row["scene"] for row in rows}
    kept = sum(all(row["within"] == "1" for row in rows if row["scene"] == name) for name in names)
    figure.suptitle(f"{len(names)} scenes planned by their error or time; {kept} keep every promise", fontsize=11)
    columns = {name: [row[name] for row in rows] for name in rows[0]}
    print(save(figure, sys.argv[2], "plans", columns))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main()
