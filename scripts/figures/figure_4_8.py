# SPDX-License-Identifier: MIT
"""Figure 4.8: centre of mass and shock location against phase for layers of three depths."""
import sys

import numpy as np

import run_folder
from figure_4_2b import START, in_layer
from style import PLATE, plt, points, save

NAME = "figure_4_8"
DEPTHS = (("4.5", "h4.5", "h4.5_fine", "#1b7837", "^", "--"), ("9", "default", "dz_0.1", "#b2182b", "o", "-"),
          ("13.5", "h13.5", "h13.5_fine", "#2166ac", "s", ":"))
CAPTION = (
    "Figure 4.8. (a) Centre of mass over one cycle and (b) shock location while the shock is in the layer, for H = 4.5, 9 and 13.5: MD "
    "(markers, bars of one standard error) and continuum (lines, bands of the grid error). Thick line: the plate."
)


def draw(study):
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(6.0, 8.4))
    columns = {}
    for depth, name, finer, color, marker, line in DEPTHS:
        run = study.run(name, finer)
        count = len(run.phase)
        first = int(np.ceil((START % 1.0) * count - 1e-9))
        order = (first + np.arange(count)) % count
        phase = run.phase[order] - (order >= first)
        plate = run.plate_height[order]
        some = slice(None, None, max(1, count // 40))
        centre, centre_grid = run.continuum("centre_of_mass")[order], run.grid_error("centre_of_mass")[order]
        upper.plot(phase, centre, color=color, ls=line, label=f"$H = {depth}$, continuum")
        upper.fill_between(phase, centre - centre_grid, centre + centre_grid, color=color, alpha=0.25, lw=0)
        points(upper, phase[some], run.md("centre_of_mass")[order][some], y_error=run.md.error("centre_of_mass")[order][some],
               marker=marker, color=color, mfc="none", label=f"$H = {depth}$, MD")
        shock, grid = in_layer(run.continuum)[order] + plate, run.grid_error("shock/location")[order]
        of_md = in_layer(run.md)[order] + plate
        lower.plot(phase, shock, color=color, ls=line)
        lower.fill_between(phase, shock - grid, shock + grid, color=color, alpha=0.25, lw=0)
        each = slice(None, None, max(1, count // 100))
        points(lower, phase[each], of_md[each], y_error=run.md.error("shock/location")[order][each], marker=marker, color=color, mfc="none")
        part = {"H": np.full(count, float(depth)), "ft": phase, "plate/sigma": plate,
                "centre of mass MD/sigma": run.md("centre_of_mass")[order], "centre of mass MD error/sigma": run.md.error("centre_of_mass")[order],
                "centre of mass continuum/sigma": centre, "centre of mass continuum grid error/sigma": centre_grid,
                "shock MD/sigma": of_md, "shock MD error/sigma": run.md.error("shock/location")[order],
                "shock continuum/sigma": shock, "shock continuum grid error/sigma": grid}
        columns = {key: np.append(columns.get(key, []), values) for key, values in part.items()}
    for axis, letter in ((upper, "a"), (lower, "b")):
        axis.plot(phase, plate, color=PLATE, lw=3)
        axis.text(0.02, 0.96, f"({letter})", transform=axis.transAxes, va="top")
        axis.set_ylim(0, 40)
        axis.set_ylabel(r"height $z/\sigma$")
    upper.set_xlim(phase[0], phase[-1])
    lower.set_xlim(0, 0.5)
    lower.set_xlabel(r"$ft$")
    upper.legend(loc="upper center", fontsize=8, ncols=3)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
