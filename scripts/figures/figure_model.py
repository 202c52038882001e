# SPDX-License-Identifier: MIT
"""Work and precision (c): error of the model, continuum against MD for each closure, above the bands of what the grid and the statistics leave uncertain."""
import sys

import numpy as np

from style import DENSITY, TEMPERATURE, plt, save
from work_precision_chart import columns_of, main, select, sign

NAME = "figure_model"
SHORT = {"jenkins_richman/goldshtein": "JR\nG", "jenkins_richman/carnahan_starling": "JR\nCS", "garzo_dufty/goldshtein": "GD\nG", "garzo_dufty/carnahan_starling": "GD\nCS",
         "jenkins_richman_dense/goldshtein": "dense\nG", "jenkins_richman_fluid/goldshtein": "fluid\nG", "jenkins_richman_bocquet/goldshtein": "Bocq.\nG"}
PANELS = (("z_cm", r"$z_{cm}(ft)$"), ("density", "$n$ over the layer"), ("velocity", "$u$ over the layer"), ("temperature", "$T$ over the layer"), ("shock_location", "height of the shock"))
MARKS = (("o", DENSITY), ("s", TEMPERATURE))  # by height of the upper end, the lowest first
FLOORS = {"": "at the plate", "_half_diameter": "half a diameter up"}
CAPTION = (
    "Error of the model on ch4_shock, per cent: the continuum at its default grid against the mean of the long MD runs, for each closure (JR: jenkins_richman, dense, fluid and Bocq.: its variants of these names, GD: garzo_dufty; "
    "G: goldshtein, CS: carnahan_starling). Bands: error of the default grid (blue) and statistical error of the default MD run (red); whatever lies above them no finer grid and no "
    "longer run will remove."
)


def of_default(rows, study, quantity, knob):
    found = [r["error_percent"] for r in select(rows, study=study, quantity=quantity, knob=knob) if r["default"] == 1]
    return found[0] if found else np.nan


def ends(rows):
    """Heights of the upper end that the rows have, with their marks; ValueError for more of them than there are marks."""
    return list(zip(sorted({r["value"] for r in select(rows, study="model")}), MARKS, strict=True))


def handles(rows):
    return [plt.Line2D([], [], marker=marker, mfc="white" if suffix else colour, mec=colour, ls="none", label=f"end at {end:g}, floor {words}")
            for end, (marker, colour) in ends(rows) for suffix, words in FLOORS.items()]


def panel(axis, rows, quantity):
    shown = select(rows, study="model")
    grid, statistics = of_default(rows, "ch4_shock", quantity, "dz"), of_default(rows, "md", quantity, "cycles")
    for aside, (end, (marker, colour)) in zip((-0.12, 0.12), ends(rows)):
        for suffix in FLOORS:
            for i, closure in enumerate(SHORT):
                for r in select(shown, scheme=closure, value=end, quantity=quantity + suffix):
                    axis.errorbar(i + aside, r["error_percent"], yerr=r["error_of_error"], marker=marker, color=colour, mfc="white" if suffix else colour, ms=6)
                    if r["default"] and not suffix:
                        axis.plot(i + aside, r["error_percent"], "o", ms=13, mfc="none", mec="black", mew=1.3)
    axis.set_yscale("log")
    axis.set_ylim(3e-3, 100)
    for percent, words, colour in ((statistics, "statistics, 150 cycles ", TEMPERATURE), (grid, r"grid, $\Delta z$ = 0.2 ", DENSITY)):
        if np.isfinite(percent):
            axis.axhspan(axis.get_ylim()[0], percent, color=colour, alpha=0.15, lw=0)
            axis.text(len(SHORT) - 0.55, percent, words, ha="right", va="bottom", fontsize=6.5, color=colour)
    axis.set_xlim(-0.5, len(SHORT) - 0.5)
    axis.set_xticks(range(len(SHORT)), SHORT.values(), fontsize=7)
    axis.tick_params(axis="x", which="both", length=0)


def draw(rows, folder, signature):
    figure, axes = plt.subplots(1, len(PANELS), figsize=(14.0, 4.8), sharey=True)
    for axis, (quantity, title) in zip(axes, PANELS):
        panel(axis, rows, quantity)
        axis.set_title(title)
    axes[0].set_ylabel("error, %")
    default = plt.Line2D([], [], color="black", marker="o", mfc="none", ls="none", ms=10, label="default")
    figure.legend(handles=[*handles(rows), default], ncols=5, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    sign(figure, signature)
    return save(figure, folder, NAME, columns_of(select(rows, study="model")))


if __name__ == "__main__":
    sys.exit(main(draw))
