# SPDX-License-Identifier: MIT
"""Figure 5.3: the particles from the side, along the stripes, at eight phases of two cycles."""
import sys

import numpy as np
from matplotlib.collections import EllipseCollection

import run_folder
from slices import Stripes
from style import PLATE, plt, save

NAME = "figure_5_3"
CAPTION = (
    "Figure 5.3. The MD's particles seen along the stripes at eight phases of two cycles, Gamma = 2.2, f* = 0.4174: those within 10 "
    "diameters along the line of sight, as circles of their size. Peaks and valleys change places from cycle to cycle. Thick line: the plate."
)
PHASES, DEEP, TOP = (0.0, 0.25, 0.5, 0.75), 10.0, 21.0


def draw(study):
    stripes = Stripes(study.folder / "runs" / "md_stripes", "md")
    figure, axes = plt.subplots(len(PHASES), 2, figsize=(8.0, 8.4), sharex=True, sharey=True)
    columns = {name: [] for name in ("ft", "x/sigma", "z/sigma")}
    for row, ft in zip(axes, PHASES):
        for axis, time in zip(row, (ft, ft + 1)):
            x, along, z, *_ = stripes.particles(time, last=True)
            near = along % (stripes.width) < DEEP
            x, z = x[near], z[near]
            axis.add_collection(EllipseCollection(np.ones_like(x), np.ones_like(x), np.zeros_like(x), units="xy", offsets=np.column_stack([x, z]),
                                                  offset_transform=axis.transData, facecolor="none", edgecolor="#2166ac", lw=0.35))
            axis.axhline(stripes.plate(time), color=PLATE, lw=2.2)
            axis.set_xlim(0, stripes.width)
            axis.set_ylim(-0.5, TOP)
            axis.set_aspect("equal")
            axis.text(0.02, 0.95, f"$ft$ = {time:g}", transform=axis.transAxes, va="top", fontsize=8)
            for name, values in zip(columns, (np.full(len(x), time), np.round(x, 3), np.round(z, 3))):
                columns[name].extend(values)
    for axis in axes[-1]:
        axis.set_xlabel(r"$x/\sigma$")
    for axis in axes[:, 0]:
        axis.set_ylabel(r"$z/\sigma$")
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
