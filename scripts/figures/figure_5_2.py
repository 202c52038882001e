# SPDX-License-Identifier: MIT
"""Figure 5.2: wavelength of the stripes against the plate's frequency, and how fast the continuum's waves grow or fade."""
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, MACH, TEMPERATURE, plt, save

NAME = "figure_5_2"
CAPTION = (
    "Figure 5.2. (a) Wavelength over depth of the strongest wave of a strip of 168 x 10, Gamma = 2.2: MD after 40 cycles (circles; open where less than "
    "a fifth of the power alternates from cycle to cycle, that is without a pattern), and the strongest of the waves that alternate in the "
    "continuum 8 to 15 cycles after a start from noise (triangles; downward: with a fluid's transport at packing, jenkins_richman_fluid; open where it fades; at 0.15 and 0.2 it is nearly full-grown by then). Bars: the wavelengths that the strip allows, half a wave more or less. Line: fit to experiments with "
    "its error. (b) Growth of that wave from cycle to cycle over these cycles. One grid: its columns, 2 wide, add some 0.04 to the growth of a wave of 21 (figure 5.converged)."
)
LENGTH, DEPTH = 168.0, 5.4
ALTERNATES = 0.2        # share of the power, less what noise leaves there, that alternates from cycle to cycle in a pattern


# Words, closure, marker, colour, shift along f* so that bars do not hide each other.
CONTINUA = (("continuum", "jenkins_richman", "^", TEMPERATURE, 0.004), ("a fluid's transport", "jenkins_richman_fluid", "v", MACH, 0.008))


def strongest(rows):
    """The wave of the greatest power, as the source takes it; None of no wave."""
    return max(rows, key=lambda row: row["root_mean_square"], default=None)


def bars(waves):
    """Wavelength over depth, and the bars below and above it that half a wave makes."""
    middle = LENGTH / waves / DEPTH
    return middle, middle - LENGTH / (waves + 0.5) / DEPTH, LENGTH / (waves - 0.5) / DEPTH - middle


def draw(study):
    md = sorted(tables.rows("ch5_dispersion_md.csv"), key=lambda row: row["value"])
    fit = tables.references(5)["dispersion"]
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(5.8, 6.8), sharex=True, height_ratios=(2.2, 1))
    f = np.linspace(0.13, 0.52, 200)
    upper.plot(f, fit["offset"] + fit["factor"] * f ** fit["exponent"], color="black", lw=1.0, label=r"experiments: $1.0 + 1.1 f^{*-1.32 \pm 0.03}$")
    upper.fill_between(f, *(fit["offset"] + fit["factor"] * f ** (fit["exponent"] + s * fit["exponent_error"]) for s in (-1, 1)), color="0.85", lw=0)
    columns = {name: [] for name in ("engine", "f*", "waves in 168", "wavelength/H", "bar below", "bar above", "alternating share or factor a cycle")}

    def point(engine, frequency, count, measure, marker, colour, full, shift):
        middle, below, above = bars(count)
        upper.errorbar(frequency + shift, middle, yerr=[[below], [above]], marker=marker, ms=6, color=colour, mfc=colour if full else "white", lw=0.8, ls="none")
        for name, value in zip(columns, (engine, frequency, count, middle, below, above, measure)):
            columns[name].append(value)

    for row in md:
        if tables.is_known(row["waves_x"]):
            point("MD", row["value"], row["waves_x"], row["coherent_share"], "o", DENSITY, row["coherent_share"] > ALTERNATES, 0)
    for label, closure, marker, colour, shift in CONTINUA:
        factors = []
        for frequency in sorted({row["value"] for row in tables.rows("ch5_dispersion_continuum.csv")}):
            best = strongest(tables.waves_of_strip(frequency, closure))
            if best:
                point(label, frequency, best["waves_x"], -best["multiplier"], marker, colour, best["multiplier"] < -1, shift)
                factors.append((frequency, -best["multiplier"]))
        if factors:
            lower.plot(*zip(*factors), marker + "-", color=colour, lw=0.8, mfc="white")
        upper.plot([], [], marker, color=colour, mfc="white", label=f"{label} (open: it fades)")
    upper.plot([], [], "o", color=DENSITY, label="MD")
    upper.axvline(fit["highest"], color="0.6", lw=0.8, ls=":")
    upper.set_ylabel(r"$\lambda/H$")
    upper.set_ylim(0, 22)
    upper.legend(loc="upper right")
    lower.axhline(1.0, color="0.5", lw=0.8)
    lower.set_xlabel(r"$f^* = f\sqrt{H/g}$")
    lower.set_ylabel("growth a cycle")
    lower.set_xlim(0.12, 0.53)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
