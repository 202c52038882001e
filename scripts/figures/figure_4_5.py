# SPDX-License-Identifier: MIT
"""Figure 4.5: greatest Mach number in the layer, and shock width over mean free path, while the shock lives."""
import sys

import numpy as np

import run_folder
from style import LENGTH, MACH, plt, points, save

NAME = "figure_4_5"
RANGE = (0.10, 0.38)
CAPTION = (
    "Figure 4.5. Greatest Mach number in the layer (dashed line: continuum, triangles: MD) and shock width over the mean free "
    "path at the shock's location (solid line: continuum, circles: MD) against phase; pale: width by the steepest slope over "
    "the mean free path at the shock's foot. Bars are one standard error. Dotted: one, and the source's formation (ft = 0.12) "
    "and leaving (ft = 0.35)."
)
PUBLISHED_LIFE = (0.12, 0.35)


def draw(run):
    limits = RANGE if run.cycles == 1 else (0.0, float(run.cycles))
    shown = (run.phase >= limits[0] - 1e-9) & (run.phase <= limits[1] + 1e-9)
    phase = run.phase[shown]
    figure, axis = plt.subplots(figsize=(5.6, 4.2))
    ratio, slope = {}, {}
    for engine in (run.continuum, run.md):
        followed = engine("shock/followed") > 0
        ratio[engine] = np.where(followed, engine("shock/width_over_mean_free_path"), np.nan)[shown]
        slope[engine] = np.where(followed, engine("shock/slope_width_over_mean_free_path_foot"), np.nan)[shown]
    some = slice(None, None, max(1, len(run.phase) // 100))
    axis.plot(phase, run.continuum("max_mach")[shown], "--", color=MACH, label=r"largest $\mathrm{Ma}$, continuum")
    points(axis, phase[some], run.md("max_mach")[shown][some], y_error=run.md.error("max_mach")[shown][some], marker="^",
           color=MACH, mfc="none", label=r"largest $\mathrm{Ma}$, MD")
    axis.plot(phase, ratio[run.continuum], color=LENGTH, label=r"$d/\lambda$, continuum")
    points(axis, phase[some], ratio[run.md][some],
           y_error=run.md.error("shock/width_over_mean_free_path")[shown][some], marker="o", color=LENGTH, mfc="none",
           label=r"$d/\lambda$, MD")
    axis.plot(phase, slope[run.continuum], color=LENGTH, alpha=0.45, lw=1.2, label="by the steepest slope, continuum")
    points(axis, phase[some], slope[run.md][some],
           y_error=run.md.error("shock/slope_width_over_mean_free_path_foot")[shown][some], marker="s", ms=3, color=LENGTH,
           alpha=0.45, label="by the steepest slope, MD")
    for name, color, values in (("max_mach", MACH, run.continuum("max_mach")[shown]),
                                ("shock/width_over_mean_free_path", LENGTH, ratio[run.continuum])):
        error = run.grid_error(name)[shown]
        axis.fill_between(phase, values - error, values + error, color=color, alpha=0.25, lw=0)
    for ft in PUBLISHED_LIFE:
        axis.axvline(ft, color="0.6", lw=0.8, ls=":")
    axis.axhline(1.0, color="0.6", lw=0.8, ls=":")
    axis.set_xlim(*limits)
    axis.set_ylim(bottom=0)
    axis.set_xlabel(r"$ft$")
    axis.set_ylabel(r"$\mathrm{Ma}$,  $d/\lambda$")
    axis.legend(loc="upper right")
    return save(figure, run.figures, NAME, {
        "ft": phase,
        "largest Ma MD": run.md("max_mach")[shown], "largest Ma MD error": run.md.error("max_mach")[shown],
        "largest Ma continuum": run.continuum("max_mach")[shown],
        "d/lambda MD": ratio[run.md], "d/lambda MD error": run.md.error("shock/width_over_mean_free_path")[shown],
        "d/lambda continuum": ratio[run.continuum],
        "slope d/lambda_foot MD": slope[run.md],
        "slope d/lambda_foot MD error": run.md.error("shock/slope_width_over_mean_free_path_foot")[shown],
        "slope d/lambda_foot continuum": slope[run.continuum],
    })


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))
