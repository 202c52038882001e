# SPDX-License-Identifier: MIT
"""Growth of small waves in MD, read off the fluctuations of layers below the onset, beside the continuum's."""
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, LENGTH, MACH, TEMPERATURE, plt, points, save

NAME = "figure_6_fluctuations"
CAPTION = (
    "What small waves do from cycle to cycle in MD, from the covariance of each wave with itself later: the part that changes sign every cycle and the factor by which it fades, f* = 0.4174. (a) Its mean square and (b) its factor by "
    "wavelength in the strip of 168 x 10 at three peak accelerations below the onset of stripes of 21; crosses: the continuum in that strip at 2.2, from noise. Dotted: 42 and a third of it. "
    "(c) The factor against the acceleration in cells of 42 x 42, waves of 21 and 42, MD, and of the wave of 21 in the continuum on columns 2 wide. Broken: the source's onsets, 1.955 (continuum) and 2.15 (MD). Bars: one standard error."
)
STRIP = "data/scenes/ch5_dispersion.toml"
COLOURS = (LENGTH, DENSITY, MACH)
RESONANT = 42.0      # sigma


def continuum_by_wave():
    """Wavelengths in the strip and factors of the waves that alternate at f* = 0.4174."""
    rows = tables.waves_of_strip(0.4174, "jenkins_richman")
    return np.array([168.0 / row["waves_x"] for row in rows]), np.array([-row["multiplier"] for row in rows])


def continuum_against_gamma(closure):
    rows = [row for row in tables.growth_rows() if tables.setting(row, "continuum.closure") == closure and tables.setting(row, "continuum.pair_correlation") == "goldshtein"
            and tables.setting(row, "continuum.spacing_horizontal") == "2" and not tables.setting(row, "continuum.restitution") and not tables.setting(row, "continuum.scheme")]
    return sorted((row["value"], tables.factor(row)) for row in rows)


def draw(study):
    strip = tables.fluctuations(STRIP)
    figure, (powers, factors, onset) = plt.subplots(3, 1, figsize=(6.4, 9.2), height_ratios=(1, 1, 1.3))
    columns = {name: [] for name in ("of", "Gamma", "wavelength/sigma", "mean square/sigma^2", "error", "factor a cycle", "its error")}

    def kept(label, some):
        for row in some:
            for name, value in zip(columns, (label, row["value"], row["wavelength"], row["alternating"], row["alternating_error"], row["alternating_factor"], row["alternating_factor_error"])):
                columns[name].append(value)

    for gamma, colour in zip(sorted({row["value"] for row in strip}), COLOURS):
        some = [row for row in strip if row["value"] == gamma]
        at = [row["wavelength"] for row in some]
        for axis, key in ((powers, "alternating"), (factors, "alternating_factor")):
            points(axis, at, [row[key] for row in some], y_error=[row[f"{key}_error"] for row in some], marker="o", ms=4, color=colour, linestyle="-", lw=0.8, label=rf"MD, $\Gamma$ = {gamma:g}")
        kept("MD, strip", some)
    wavelength, factor = continuum_by_wave()
    factors.plot(wavelength, factor, "x-", color=TEMPERATURE, ms=5, lw=0.8, label=r"continuum, $\Gamma$ = 2.2")
    powers.set_yscale("log")
    powers.set_ylabel(r"$\langle\psi^2\rangle$ that alternates, $\sigma^2$")
    factors.set_ylabel("factor a cycle")
    factors.set_ylim(0.3, 1.1)
    factors.set_xlabel(r"wavelength, $\sigma$")
    for axis in (powers, factors):
        axis.set_xscale("log")
        axis.set_xticks([10, 14, 21, 28, 42, 84, 168], ["10", "14", "21", "28", "42", "84", "168"])
        axis.minorticks_off()
        for resonance in (RESONANT, RESONANT / 3):
            axis.axvline(resonance, color="0.5", ls=":", lw=0.9)
    powers.legend(fontsize=8)
    factors.legend(fontsize=8, loc="lower left")
    for wave, marker, colour in ((21.0, "^", DENSITY), (42.0, "s", LENGTH)):
        some = tables.small_waves(wave)
        points(onset, [row["value"] for row in some], [row["alternating_factor"] for row in some], y_error=[row["alternating_factor_error"] for row in some],
               marker=marker, ms=5, color=colour, mfc="white", linestyle="-", lw=0.8, label=rf"MD, wave of {wave:g}")
        kept("MD, cell", some)
    for closure, words, ls in (("jenkins_richman", "continuum, wave of 21", "-"), ("jenkins_richman_fluid", "the same, a fluid's transport at packing", "--")):
        chosen = continuum_against_gamma(closure)
        onset.plot(*zip(*chosen), "x", ls=ls, color=TEMPERATURE, lw=0.9, ms=5, label=words)
        for gamma, value in chosen:
            kept(words, [{"value": gamma, "wavelength": 21.0, "alternating": np.nan, "alternating_error": np.nan, "alternating_factor": value, "alternating_factor_error": np.nan}])
    for key, colour in (("continuum_onset", TEMPERATURE), ("onset", DENSITY)):
        onset.axvline(tables.published(6)[key]["value"], color=colour, ls="--", lw=0.8)
    for axis in (factors, onset):
        axis.axhline(1.0, color="0.5", lw=0.8)
    onset.set_xlabel(r"peak acceleration $\Gamma$")
    onset.set_ylabel("factor a cycle")
    onset.set_ylim(0.4, 1.4)
    onset.legend(fontsize=8)
    for axis, letter in zip((powers, factors, onset), "abc"):
        axis.text(0.01, 0.97, f"({letter})", transform=axis.transAxes, va="top", fontsize=9)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
