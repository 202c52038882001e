# SPDX-License-Identifier: MIT
"""The open question: growth of a small wave of 21 diameters in the continuum for each choice and grid, above the MD's pattern."""
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "figure_5_growth"
CAPTION = (
    "Growth from cycle to cycle of a wave of 21 diameters and one per cent of the density in the continuum, cycles 8 to 15, for each choice of closure, pair correlation, scheme and restitution in "
    "the sink, on columns 2 wide (full markers) and, of some choices, 1 wide (open); above 1 the flat layer gives way to stripes; nothing is drawn where another wave or nothing of it is left (Bocquet's viscosity: everywhere). Columns 2 wide add 0.01 to 0.05 to the growth of the default choice, and put its onset 0.4 too low (figure 5.converged). Triangles: the same wave in MD, from its fluctuations (figure 6.fluctuations). Below: the MD's order and the amplitude of its alternating wave. "
    "Broken: the source's onset in its continuum, 1.955, and in MD, 2.15."
)
# (closure, pair correlation, scheme): words, colour.
CHOICES = {
    ("jenkins_richman", "goldshtein", "muscl"): ("default", "#000000"),
    ("jenkins_richman", "carnahan_starling", "muscl"): ("carnahan_starling", "#2166ac"),
    ("garzo_dufty", "goldshtein", "muscl"): ("garzo_dufty", "#b2182b"),
    ("jenkins_richman_dense", "goldshtein", "muscl"): ("no 1/G terms", "#1b7837"),
    ("jenkins_richman_fluid", "goldshtein", "muscl"): ("fluid's transport", "#35978f"),
    ("jenkins_richman_bocquet", "goldshtein", "muscl"): ("Bocquet's viscosity", "#8c510a"),
    ("jenkins_richman_dense", "goldshtein", "ftcs"): ("ftcs, no 1/G terms", "#7a3b9a"),
}
DISSIPATION = "0.1"   # default C_AD of ftcs
WAVELENGTH = 21.0


def family(row):
    """What a row's run was of: choice, C_AD, e of the sink, width of the columns."""
    return (tables.setting(row, "continuum.closure", "jenkins_richman"), tables.setting(row, "continuum.pair_correlation", "goldshtein"),
            tables.setting(row, "continuum.scheme", "muscl"), tables.setting(row, "continuum.artificial_dissipation", DISSIPATION),
            tables.setting(row, "continuum.restitution", "e(v)"), float(tables.setting(row, "continuum.spacing_horizontal", "1")))


def draw(study):
    rows = tables.growth_rows()
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(6.6, 7.4), sharex=True, height_ratios=(1.6, 1))
    names = ("closure", "pair correlation", "scheme", "C_AD", "e of the sink", "dx/sigma", "Gamma", "factor a cycle")
    columns = {name: [] for name in names}
    shown = {}
    for kind in sorted({family(row) for row in rows}):
        closure, pair, scheme, dissipation, law, wide = kind
        words, colour = CHOICES.get(kind[:3], ("other", "0.5"))
        words += f", $C_{{AD}}$ = {dissipation}" if scheme == "ftcs" else ""
        chosen = sorted((row["value"], tables.factor(row)) for row in rows if family(row) == kind)
        shown[words] = colour, "o" if dissipation == DISSIPATION else "s"
        upper.plot(*zip(*chosen), color=colour, ls="-" if law == "e(v)" else ":", marker="o" if dissipation == DISSIPATION else "s", ms=3.5, lw=0.9,
                   mfc=colour if wide == 2 else "white")
        for gamma, factor in chosen:
            for name, value in zip(names, (*kind, gamma, factor)):
                columns[name].append(value)
    grains = tables.small_waves(WAVELENGTH)
    points(upper, *([row[key] for row in grains] for key in ("value", "alternating_factor")), y_error=[row["alternating_factor_error"] for row in grains], marker="^", ms=7, color=DENSITY)
    for row in grains:
        for name, value in zip(names, ("MD", "", "", "", "e(v)", "", row["value"], row["alternating_factor"])):
            columns[name].append(value)
    upper.axhline(1.0, color="0.5", lw=0.8)
    upper.set_ylabel("growth of the wave a cycle")
    upper.set_ylim(0.4, 1.4)
    handles = [plt.Line2D([], [], color=DENSITY, marker="^", ms=7, lw=0, label="MD, from its fluctuations")] + [plt.Line2D([], [], color=colour, marker=marker, ms=3.5, lw=0.9, label=words) for words, (colour, marker) in shown.items()]
    upper.legend(handles=handles, loc="lower right", fontsize=7, title="lines: sink of e(v), $e_0$ = 0.7; dotted: constant 0.7\nfull: $dx$ = 2, open: $dx$ = 1", title_fontsize=7)
    onset = tables.rows("ch6_onset_md.csv")
    value, order, order_error, wave, wave_error = (np.array([row[key] for row in onset]) for key in ("value", "order", "order_error", "coherent", "coherent_error"))
    points(lower, value, order, y_error=order_error, marker="^", color=DENSITY, mfc="none", label=r"$P_{\max}$, MD")
    points(lower, value, 2 * wave, y_error=2 * wave_error, marker="o", color=TEMPERATURE, mfc="none", label=r"amplitude of the alternating wave, $\sigma$, MD")
    published = tables.published(6)
    for axis in (upper, lower):
        axis.axvline(published["continuum_onset"]["value"], color="0.3", ls="--", lw=0.8)
        axis.axvline(published["onset"]["value"], color=DENSITY, ls="--", lw=0.8)
    lower.set_ylim(0, 1.25)
    lower.set_xlabel(r"peak acceleration $\Gamma$")
    lower.legend(loc="center right")
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
