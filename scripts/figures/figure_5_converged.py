# SPDX-License-Identifier: MIT
"""Growth of the wave of 21 against the width of the columns: what of the continuum's onset is the grid's."""
import sys

import numpy as np

import convergence
import run_folder
from style import plt, save

NAME = "figure_5_converged"
CAPTION = (
    "Growth from cycle to cycle of a wave of 21 diameters and one per cent of the density in the continuum (default closure, e(v) with e0 = 0.7 in the sink, dz = 0.2, upper end at 25, cycles 8 to 15), against "
    "the width of the columns; above 1 the flat layer gives way to stripes. Crosses, on columns 1 wide: rows half as high, steps half as long, the end at 50 and at 100. "
    "At the left, squares with bars: the value on the finest columns with its error, the last difference between columns and what each of the others changes, added up."
)


def draw(study):
    growths = convergence.read()
    figure, axis = plt.subplots(figsize=(6.2, 4.6))
    names = ("Gamma", "dx/sigma", "varied", "value", "growth a cycle", "error")
    columns = {name: [] for name in names}

    def keep(*values):
        for name, value in zip(names, values):
            columns[name].append(value)

    for index, gamma in enumerate(sorted({key[0] for key in growths})):
        colour = f"C{index}"
        widths, on = convergence.ladder(growths, gamma)
        axis.plot(widths, on, marker="o", ms=4, lw=1, color=colour, label=rf"$\Gamma$ = {gamma:g}")
        others = [(dx, key, value, growth) for (at, dx, key, value), growth in growths.items() if at == gamma and key]
        axis.plot([dx for dx, *_ in others], [growth for *_, growth in others], "x", ms=6, color=colour)
        value, error = convergence.limit(growths, gamma)
        axis.errorbar(widths[-1] / 1.25, value, yerr=error, marker="s", ms=3, color=colour, capsize=3)
        for dx, growth in zip(widths, on):
            keep(gamma, dx, "", np.nan, growth, np.nan)
        for dx, key, varied, growth in others:
            keep(gamma, dx, key, varied, growth, np.nan)
        keep(gamma, 0, "limit", np.nan, value, error)
    gamma, error = convergence.onset(growths)
    keep(gamma, 0, "onset", np.nan, 1, error)
    axis.axhline(1.0, color="0.5", lw=0.8)
    axis.set_xscale("log", base=2)
    axis.set_xticks(widths, [f"{width:g}" for width in widths])
    axis.set_xlabel(r"width of the columns $dx/\sigma$")
    axis.set_ylabel("growth of the wave a cycle")
    axis.set_title(rf"neither grows nor fades at $\Gamma$ = {gamma:.2f} $\pm$ {error:.2f}", fontsize=9)
    axis.legend(fontsize=8)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
