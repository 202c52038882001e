# SPDX-License-Identifier: MIT
"""Figure 4.2: one cycle from one state at ft = -0.33, for three restitution coefficients."""
import sys

import numpy as np

import run_folder
from figure_4_2b import draw_cycle
from style import plt, save

NAME = "figure_4_2"
PANELS = (("a", 0.99), ("b", 0.90), ("c", 0.85))
CAPTION = (
    "Figure 4.2. Shock location and centre of mass in the lab frame over one cycle from one state at ft = -0.33 (of the shaken layer "
    "with e = 0.9), when e becomes 0.99, 0.90 and 0.85: continuum (lines) and MD (markers, the mean over 16 states; bars of one standard "
    "error). Shading: volume fraction of the continuum. + and x: upper and lower edge of the layer in MD. Thick line: the plate."
)


def draw(study):
    figure, axes = plt.subplots(len(PANELS), 1, figsize=(6.5, 10.5), sharex=True, sharey=True)
    columns = {}
    for axis, (letter, e) in zip(axes, PANELS):
        shade, part = draw_cycle(axis, study.run(f"e{e:.2f}"))
        axis.text(0.02, 0.95, f"({letter}) $e = {e:.2f}$", transform=axis.transAxes, va="top")
        part = {"e": np.full(len(part["ft"]), e)} | part
        columns = {name: np.append(columns.get(name, []), values) for name, values in part.items()}
    axes[0].set_ylim(0, 60)
    axes[-1].set_xlabel(r"$ft$")
    axes[0].legend(loc="lower center", bbox_to_anchor=(0.5, 1.01), ncols=2, fontsize=8)
    figure.colorbar(shade, ax=axes, label=r"volume fraction $\nu$ (continuum)", pad=0.02, aspect=50)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
