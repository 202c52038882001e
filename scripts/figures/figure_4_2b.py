# SPDX-License-Identifier: MIT
"""Figure 4.2(b): shock and centre of mass over one period of the layer, over the continuum's volume fraction."""
import sys

import numpy as np

import run_folder
from style import PLATE, plt, points, save

NAME = "figure_4_2b"
START = -0.33  # where the source begins its cycle: the layer near the top of its flight
CAPTION = (
    "Figure 4.2(b). Shock location and centre of mass over one period in the lab frame: continuum (lines) and MD (markers). "
    "Shading: volume fraction of the continuum, dark is dense. Crosses: upper (+) and lower (x) edge of the layer in MD, "
    "where the volume fraction falls below 4 % of random close packing. Thick line: the plate."
)
SHOCK, CENTRE = "#d95f02", "#1f78b4"


def draw(run):
    figure, axis = plt.subplots(figsize=(6.5, 4.6))
    shade, columns = draw_cycle(axis, run)
    figure.colorbar(shade, ax=axis, label=r"volume fraction $\nu$ (continuum)", pad=0.02)
    axis.set_xlabel(r"$ft$")
    axis.legend(loc="lower center", bbox_to_anchor=(0.5, 1.01), ncols=2, fontsize=8)
    return save(figure, run.figures, NAME, columns)


def draw_cycle(axis, run):
    """One period from START: what shades it, and the columns of its CSV."""
    count, cycles = len(run.phase), run.cycles
    first = int(np.ceil((START % cycles) * count / cycles - 1e-9))
    order = (first + np.arange(count)) % count
    phase = run.phase[order] - cycles * (order >= first)
    plate = run.plate_height[order]
    density = run.continuum.volume_fraction[order]
    edges = np.append(phase, phase[-1] + cycles / count) - 0.5 * cycles / count
    mesh_plate = np.interp(edges, phase, plate, period=cycles)
    z = mesh_plate[:, None] + run.bin_edges()[None, :]
    shade = axis.pcolormesh(np.broadcast_to(edges[:, None], z.shape), z, density, cmap="Greys", vmin=0, vmax=0.65, rasterized=True)
    axis.plot(phase, plate, color=PLATE, lw=3, label="plate")
    axis.plot(phase, run.continuum("centre_of_mass")[order], color=CENTRE, ls="--", label="centre of mass, continuum")
    every = max(1, count // 50)
    some = slice(None, None, every)
    axis.plot(phase[some], run.md("centre_of_mass")[order][some], "o", ms=4, mfc="none", color=CENTRE, label="centre of mass, MD")
    axis.plot(phase, in_layer(run.continuum)[order] + plate, color=SHOCK, label="shock, continuum")
    points(axis, phase[some], (in_layer(run.md)[order] + plate)[some], y_error=run.md.error("shock/location")[order][some], marker="^",
           ms=4.5, color=SHOCK, label="shock, MD")
    for edge, marker in (("upper", "+"), ("lower", "x")):
        axis.plot(phase[some], (run.md(f"layer/{edge}")[order] + plate)[some], marker, ms=4, color="0.25", mew=0.8,
                  label=f"{edge} edge of the layer, MD")
    axis.set_xlim(edges[0], edges[-1])
    upper = np.nanmax(run.md("layer/upper")[order] + plate)
    axis.set_ylim(0, 10.0 * np.ceil((upper + 1) / 10.0))
    axis.set_ylabel(r"height $z/\sigma$")
    return shade, {
        "ft": phase, "plate/sigma": plate,
        "centre of mass MD/sigma": run.md("centre_of_mass")[order],
        "centre of mass MD error/sigma": run.md.error("centre_of_mass")[order],
        "centre of mass continuum/sigma": run.continuum("centre_of_mass")[order],
        "shock MD/sigma": in_layer(run.md)[order] + plate,
        "shock MD error/sigma": run.md.error("shock/location")[order],
        "shock continuum/sigma": in_layer(run.continuum)[order] + plate,
        "upper edge MD/sigma": run.md("layer/upper")[order] + plate,
        "lower edge MD/sigma": run.md("layer/lower")[order] + plate,
    }


def in_layer(engine):
    """Shock location above the plate between formation and leaving; NaN elsewhere."""
    followed = engine("shock/followed") > 0
    return np.where(followed, engine("shock/location"), np.nan)


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))
