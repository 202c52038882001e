# SPDX-License-Identifier: MIT
"""Figure 4.1: the particles, coloured by temperature, beside T and nu against height, at four phases of the cycle."""
import sys

import numpy as np
from matplotlib.collections import EllipseCollection

import run_folder
from run_folder import LAYER_VOLUME_FRACTION
from style import DENSITY, PLATE, SHOCK_SHADE, TEMPERATURE, bands, plt, points, save

NAME = "figure_4_1"
PHASES = (0.0, 0.15, 0.22, 0.40)
CAPTION = (
    "Figure 4.1. Granular temperature (red, upper axis) and volume fraction (blue, lower axis) against height at four "
    "phases: MD (markers, bars of one standard error) and continuum (lines, bands of the grid error). Left: the particles of one cycle, seen from the "
    "side, coloured by the temperature at their height. Grey: shock region of the continuum; black: the plate. Within two diameters "
    "of the plate spheres stand in planes: the first of them lies beyond the axis."
)
# Bins thinner than this share of the layer's threshold hold too few particles for a temperature.
THINNEST = 0.2


def draw(run):
    indices = [run.nearest(p) for p in PHASES]
    top = upper_limit(run, indices)
    hottest = temperature_limit(run, indices, top)
    figure, axes = plt.subplots(len(PHASES), 2, figsize=(7.0, 10.5), sharey=True, width_ratios=(0.5, 1))
    columns = {name: [] for name in ("ft", "z/sigma", "nu MD", "nu MD error", "T MD/(g sigma)", "T MD error/(g sigma)",
                                     "nu continuum", "T continuum/(g sigma)")}
    colours = None
    for row, index in enumerate(indices):
        colours = draw_particles(axes[row, 0], run, index, hottest) or colours
        draw_profiles(axes[row, 1], run, index, hottest, row == 0, row == len(PHASES) - 1)
        axes[row, 0].set_ylim(0, top)
        axes[row, 0].set_ylabel(r"$z/\sigma$")
        collect(columns, run, index)
    axes[-1, 0].set_xlabel(r"$x/\sigma$")
    if colours is not None:
        bar = figure.colorbar(colours, ax=axes[:, 0], location="bottom", aspect=28, pad=0.01)
        bar.set_label(r"$T/(g\sigma)$ at the particle's height")
    return save(figure, run.figures, NAME, columns)


def upper_limit(run, indices):
    """A little above the layer at the last phase shown, in multiples of ten: where the shock has been by then."""
    last = indices[-1]
    upper = np.nanmax([engine("layer/upper")[last] for engine in (run.md, run.continuum)]) + run.plate_height[last]
    return 10.0 * np.ceil((upper + 3.0) / 10.0)


def temperature_limit(run, indices, top):
    """The hottest place of the figure's height range, in multiples of five."""
    hottest = 5.0
    for engine in (run.md, run.continuum):
        for i in indices:
            shown = (run.height + run.plate_height[i] < top) & (engine.volume_fraction[i] > THINNEST * LAYER_VOLUME_FRACTION)
            hottest = np.nanmax([hottest, *engine("temperature")[i][shown]])
    return 5.0 * np.ceil(hottest / 5.0)


def draw_particles(axis, run, index, hottest):
    axis.set_aspect("equal", adjustable="box", anchor="C")
    frame = run.frame(run.phase[index])
    if frame is None:
        axis.text(0.5, 0.5, "no particle frames in md.h5", ha="center", va="center", transform=axis.transAxes)
        return None
    phase, position = frame
    at = run.nearest(phase)
    plate = run.plate_height[at]
    position = position[np.argsort(-position[:, 1])]  # the front covers the back
    told = np.isfinite(run.md("temperature")[at])
    temperature = np.interp(position[:, 2] - plate, run.height[told], run.md("temperature")[at][told])
    grains = EllipseCollection(1.0, 1.0, 0.0, units="xy", offsets=position[:, [0, 2]], transOffset=axis.transData,
                               array=temperature, cmap="coolwarm", linewidths=0.15, edgecolors="black", rasterized=True)
    grains.set_clim(0, hottest)
    axis.add_collection(grains)
    width = run.box_width()
    axis.set_xlim(0, width)
    axis.axhspan(0, plate, color="0.6", lw=0)
    axis.axhline(plate, color=PLATE, lw=1.5)
    axis.set_title(f"MD, $ft = {phase:.2f}$", fontsize=10)
    return grains


def draw_profiles(axis, run, index, hottest, is_first, is_last):
    plate = run.plate_height[index]
    z = run.height + plate
    warm = axis.twiny()
    shock_top, shock_foot = (run.continuum(f"shock/{edge}")[index] for edge in ("top", "foot"))
    location, upper = run.continuum("shock/location")[index], run.continuum("layer/upper")[index]
    if np.isfinite(shock_top) and location <= upper:
        axis.axhspan(plate + shock_top, plate + shock_foot, color=SHOCK_SHADE, lw=0, zorder=0)
    axis.axhline(plate, color=PLATE, lw=1.5)

    axis.plot(run.continuum.volume_fraction[index], z, color=DENSITY)
    bands(axis, z, run.continuum.volume_fraction[index], run.grid_error("density", np.pi / 6)[index], DENSITY)
    points(axis, run.md.volume_fraction[index], z, run.md.volume_fraction_error[index], marker="o", ms=2.6, mfc="none",
           color=DENSITY)
    for engine, is_md in ((run.continuum, False), (run.md, True)):
        enough = engine.volume_fraction[index] > THINNEST * LAYER_VOLUME_FRACTION
        temperature = np.where(enough, engine("temperature")[index], np.nan)
        if is_md:
            points(warm, temperature, z, engine.error("temperature")[index], marker="o", ms=2.6, color=TEMPERATURE)
        else:
            warm.plot(temperature, z, color=TEMPERATURE)
            bands(warm, z, temperature, run.grid_error("temperature")[index], TEMPERATURE)
    axis.set_xlim(0, 0.7)
    warm.set_xlim(0, hottest)
    warm.tick_params(axis="x", colors=TEMPERATURE, labeltop=is_first)
    axis.tick_params(axis="x", top=False, which="both", colors=DENSITY, labelbottom=is_last)
    axis.text(0.97, 0.6, f"$ft = {run.phase[index]:.2f}$", transform=axis.transAxes, ha="right", va="center")
    if is_first:
        warm.set_xlabel(r"$T/(g\sigma)$", color=TEMPERATURE)
    if is_last:
        axis.set_xlabel(r"volume fraction $\nu$", color=DENSITY)


def collect(columns, run, index):
    rows = (
        np.full(run.height.shape, run.phase[index]), run.height + run.plate_height[index],
        run.md.volume_fraction[index], run.md.volume_fraction_error[index],
        run.md("temperature")[index], run.md.error("temperature")[index],
        run.continuum.volume_fraction[index], run.continuum("temperature")[index],
    )
    for values, row in zip(columns.values(), rows, strict=True):
        values.extend(row)


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))
