# SPDX-License-Identifier: MIT
"""The three charts of work and precision side by side, small enough for docs/: errors of z_cm(ft) on ch4_shock."""
import sys

import figure_discretisation
import figure_model
import figure_statistics
from style import plt, save
from work_precision_chart import columns_of, main, select, sign

NAME = "figure_overview"
DOTS_PER_INCH = 100
CAPTION = (
    "Error of z_cm(ft) on ch4_shock, per cent. Left: of the discretisation (blue: muscl, green: weno5, red: ftcs; full: dz, dotted: CFL number). Middle: of the MD's statistics. "
    "Right: of the model, above both as bands. Rings: the scene's settings."
)


def draw(rows, folder, signature):
    figure, axes = plt.subplots(1, 3, figsize=(13.0, 4.4))
    figure_discretisation.panel(axes[0], rows, "ch4_shock", "z_cm", "cpu_seconds", True)
    figure_statistics.panel(axes[1], select(rows, study="md"), "z_cm", "cpu_seconds", True)
    figure_model.panel(axes[2], rows, "z_cm")
    for axis, title in zip(axes, ("discretisation: muscl (blue), weno5 (green), ftcs (red)", "statistics of the MD", "model: continuum against MD")):
        axis.set_title(title, fontsize=10)
    axes[0].set_ylabel(r"error of $z_{cm}(ft)$, %")
    axes[0].set_xlabel("CPU seconds of a run")
    axes[1].set_xlabel("CPU seconds, settling included")
    handles = [plt.Line2D([], [], color=colour, marker=marker, ls=line, label=words) for marker, line, colour, words in figure_statistics.KNOBS.values()]
    axes[1].legend(handles=handles, fontsize=7, loc="upper right")
    axes[2].legend(handles=figure_model.handles(rows), fontsize=7, loc="upper left")
    sign(figure, signature)
    with plt.rc_context({"savefig.dpi": DOTS_PER_INCH}):
        return save(figure, folder, NAME, columns_of([r for r in rows if r["quantity"].startswith("z_cm") and r["study"] in ("ch4_shock", "md", "model")]))


if __name__ == "__main__":
    sys.exit(main(draw))
