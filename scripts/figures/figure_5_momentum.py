# SPDX-License-Identifier: MIT
"""What becomes of horizontal momentum when a layer lands: grains that lie in planes turn it round, a fluid only loses it."""
import sys

import numpy as np

import horizontal_momentum as momentum
import run_folder
import tables
from style import DENSITY, TEMPERATURE, plt, save

NAME = "figure_5_momentum"
CAPTION = (
    "Horizontal momentum of the flat layer at Gamma = 2.0, f* = 0.4174. (a) Part of a transverse wave v_y(x) of the cell's length, 21.4, that is left of it from ft = 0.25 on: in MD (100 cycles, both directions, "
    "bars of one standard error from ten blocks) and by the viscosity of the continuum's closure in its own column. A fluid can only lose it; the grains turn it round when they land. (b) Grains of MD at ft = 0.25 "
    "against their height above the lowest, and the continuum's volume fraction: planes of spheres. (c) Mean |psi_6| of the lowest plane at ft = 0.25 (1 in a triangular lattice): full, that cell; open, cells of 42 x 42 after a hundred cycles. Broken: the source's onset of order in MD, 2.15."
)
REFERENCE = 0.25     # ft
BLOCKS = 10
PLANE = 0.45         # sigma above the lowest grains: half way to the next plane
BIN = 0.1


def order_of_lowest_plane(position, at, sides, every):
    """Mean |psi_6| of the lowest plane over the states at the reference phase, each `every` of them."""
    chosen = np.flatnonzero(np.abs(at - REFERENCE) < 1e-9)[::every]
    lowest = [np.percentile(position[i, :, 2], 0.1) + PLANE for i in chosen]
    return np.nanmean([momentum.bond_order(position[i, position[i, :, 2] < top, :2], sides) for i, top in zip(chosen, lowest)])


def draw(study):
    position, velocity, at, sides = momentum.states(study.folder / "runs/md_flat/md.h5")
    phases = len(np.unique(at))
    reference = int(np.argmin(np.abs(at[:phases] - REFERENCE)))
    amplitudes = momentum.transverse(position, velocity, sides)
    left = momentum.survival(amplitudes, phases, reference)[:phases + 1]
    cycles = len(at) // phases
    parts = [momentum.survival(amplitudes[b * cycles // BLOCKS * phases:(b + 1) * cycles // BLOCKS * phases], phases, reference)[:phases + 1] for b in range(BLOCKS)]
    error = np.std(parts, axis=0, ddof=1) / np.sqrt(BLOCKS)
    ft = REFERENCE + np.arange(phases + 1) / phases
    continuum_ft, continuum_left = momentum.viscous_survival(study.folder / "runs/continuum_flat/continuum.h5", 2 * np.pi / sides[0], REFERENCE)

    figure = plt.figure(figsize=(7.6, 6.4))
    grid = figure.add_gridspec(2, 2, width_ratios=(1.3, 1))
    upper, lower, beside = figure.add_subplot(grid[0, :]), figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1])
    upper.errorbar(ft, left, yerr=error, fmt="o", ms=4, color=DENSITY, elinewidth=0.8, label="MD")
    upper.plot(continuum_ft, continuum_left, color=TEMPERATURE, label="viscosity of jenkins_richman, goldshtein")
    upper.axhline(0, color="0.5", lw=0.8)
    upper.set_xlabel("$ft$")
    upper.set_ylabel("part of the wave left")
    upper.set_ylim(-1.4, 1.2)
    upper.legend(loc="lower left")
    chosen = np.flatnonzero(np.abs(at - REFERENCE) < 1e-9)
    heights = [position[i, :, 2] - np.percentile(position[i, :, 2], 0.1) for i in chosen]
    order = order_of_lowest_plane(position, at, sides, 10)
    squares = {}
    for run in sorted((study.folder / "runs").glob("md_square_*")):
        there, _, when, wide = momentum.states(run / "md.h5")
        squares[float(run.name.rpartition("_")[2])] = order_of_lowest_plane(there, when, wide, 1)
    edges = np.arange(-0.3, 9, BIN)
    share = np.pi / 6 * np.histogram(np.concatenate(heights), edges)[0] / (len(chosen) * BIN * sides.prod())
    lower.stairs(share, edges, color=DENSITY, fill=True, alpha=0.5, label="MD, centres of grains")
    z, nu = momentum.column_at(study.folder / "runs/continuum_flat/continuum.h5", REFERENCE)
    lower.plot(z, nu, color=TEMPERATURE, label="continuum, from the plate")
    beside.plot([2.0], [order], "o", color=DENSITY)
    beside.plot(list(squares), list(squares.values()), "o-", color=DENSITY, mfc="white", lw=0.8)
    beside.axvline(tables.published(6)["onset"]["value"], color="0.4", ls="--", lw=0.8)
    beside.set_ylim(0.4, 1.02)
    beside.set_xlabel(r"peak acceleration $\Gamma$")
    beside.set_ylabel(r"$|\psi_6|$ of the lowest plane")
    lower.set_xlim(-0.3, 9)
    lower.set_xlabel(r"height, $\sigma$")
    lower.set_ylabel(r"$\pi/6$ times number a volume")
    lower.legend(loc="upper right", fontsize=7)
    for axis, letter in ((upper, "(a)"), (lower, "(b)"), (beside, "(c)")):
        axis.set_title(letter, loc="left", fontsize=9)
    count = phases + 1
    return save(figure, study.figures, NAME, {"ft": ft, "MD": left, "MD error": error, "continuum": np.interp(ft, continuum_ft, continuum_left), "psi_6 of the lowest plane": [order] * count,
                                             **{f"psi_6, 42 x 42, Gamma {gamma}": [value] * count for gamma, value in squares.items()}})


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
