# SPDX-License-Identifier: MIT
"""Horizontal waves of momentum in MD's layer from one cycle to the next: a sheet that is elastic when it lands turns transverse ones round, which a fluid can only lose."""
import sys

import numpy as np

import horizontal_momentum as momentum
import run_folder
from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "figure_5_elastic"
CAPTION = (
    "Part of a wave of horizontal momentum that is left after one cycle, against its wavelength, at ft = 0.25 in a strip of 168 x 10.5, f* = 0.4174, MD: v_x (longitudinal) and v_y (transverse) along x. A fluid can only lose a transverse wave (0 to 1). "
    "(a) The flat layer at Gamma = 2.0: transverse waves too are turned round each cycle, if shorter than the upright line. In a triangular lattice of central forces the longitudinal sound is faster by sqrt(3). (b) Gamma = 2.6, "
    "with stripes. Grey: a transverse wave under the viscosity of the continuum's closure in its flat layer at 2.0. Bars: one standard error from five blocks of cycles."
)
REFERENCE, COUNT, BLOCKS = 0.25, 16, 5
KINDS = (("longitudinal, $v_x$", "s", DENSITY), ("transverse, $v_y$", "o", TEMPERATURE))


def draw(study):
    figure, axes = plt.subplots(2, 1, figsize=(6.2, 7.0), sharex=True, sharey=True)
    columns = {name: [] for name in ("Gamma", "wave", "wavelength/sigma", "factor a cycle", "error", "turned below/sigma", "its error")}
    for axis, gamma, letter in zip(axes, ("2.0", "2.6"), "ab"):
        wavelengths, amplitudes = momentum.along_strip(study.folder / f"runs/md_strip_{gamma}/md.h5", REFERENCE, COUNT)
        pairs = momentum.pairs(amplitudes)
        factors, errors = momentum.without_blocks(pairs, BLOCKS, momentum.factor_a_cycle)
        for kind, (label, marker, colour) in enumerate(KINDS):
            below, below_error = np.nan, np.nan
            if gamma == "2.0":
                below, below_error = momentum.without_blocks(pairs[:, :, kind], BLOCKS, lambda some: momentum.turned_below(wavelengths, momentum.factor_a_cycle(some)))
                axis.axvline(below, color=colour, lw=0.9, ls="--")
                label += rf", turned below {below:.0f} $\pm$ {below_error:.0f}"
            points(axis, wavelengths, factors[kind], y_error=errors[kind], marker=marker, ms=5, color=colour, mfc="white", linestyle="-", lw=0.8, label=label)
            for name, values in zip(columns, ([gamma] * COUNT, [KINDS[kind][0].split(",")[0]] * COUNT, wavelengths, factors[kind], errors[kind], [below] * COUNT, [below_error] * COUNT)):
                columns[name].extend(values)
        axis.plot(wavelengths, viscous(study, wavelengths), color="0.6", lw=1.0, label="transverse, a fluid's viscosity")
        axis.axhline(0, color="0.5", lw=0.8)
        axis.set_title(rf"({letter}) $\Gamma$ = {gamma}", loc="left", fontsize=9)
        axis.set_ylabel("left of the wave after a cycle")
        axis.legend(fontsize=8, loc="upper left")
    axes[1].set_xscale("log")
    axes[1].set_xticks([10, 14, 21, 28, 42, 84, 168], ["10", "14", "21", "28", "42", "84", "168"])
    axes[1].minorticks_off()
    axes[1].set_xlabel(r"wavelength, $\sigma$")
    return save(figure, study.figures, NAME, columns)


def viscous(study, wavelengths):
    column = study.folder / "runs/continuum_flat/continuum.h5"
    return [momentum.viscous_survival(column, 2 * np.pi / wavelength, REFERENCE)[1][-1] for wavelength in wavelengths]


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
