# SPDX-License-Identifier: MIT
"""Figures 5.4 to 5.10 share this: panels of fields over x and z for MD and continuum, the plate drawn, one scale a field."""
import numpy as np
from matplotlib.colors import LogNorm, Normalize

from slices import Stripes
from style import PLATE, plt, save

TOP = 21.0
EMPTY_SHADE = "#e8e8e8"
# Label, colour map, lowest, highest; what has a sign diverges about zero, a lowest above zero asks for a logarithm.
LOOKS = {
    "nu": (r"volume fraction $\nu$", "Blues", 0.0, 0.65),
    "u_x": (r"$u_x/\sqrt{g\sigma}$", "RdBu_r", -0.8, 0.8),
    "u_z": (r"$u_z/\sqrt{g\sigma}$", "RdBu_r", -6.0, 6.0),
    "T": (r"$T/(g\sigma)$", "inferno", 0.0, 1.5),
    "P": (r"$P/(m g/\sigma^2)$", "viridis", 0.03, 100.0),
    "dP/dx": (r"$\partial_x P/(m g/\sigma^3)$", "RdBu_r", -1.5, 1.5),
}
RUNS = (("MD", "md_stripes", "md"), ("continuum", "continuum_stripes", "continuum"))


def both(study, runs=RUNS):
    return [(label, Stripes(study.folder / "runs" / run, engine)) for label, run, engine in runs]


def panel(axis, piece, field):
    """One field of one slice, with the plate; what the colour bar needs."""
    _, colours, low, high = LOOKS[field]
    scale = LogNorm(low, high) if low > 0 else Normalize(low, high)
    axis.set_facecolor(EMPTY_SHADE)
    image = axis.pcolormesh(piece.x, piece.z, piece.fields[field], cmap=colours, norm=scale, rasterized=True)
    axis.axhline(piece.plate, color=PLATE, lw=2.2)
    axis.axhspan(-1, piece.plate, color="white", zorder=0)
    axis.set_ylim(-0.5, TOP)
    axis.set_xlim(piece.x[0], piece.x[-1])
    axis.set_aspect("equal")
    return image


def title(label, stripes):
    return rf"{label}, $\Gamma$ = {stripes.gamma:g}"


def tell(axis, words):
    axis.text(0.02, 0.95, words, transform=axis.transAxes, va="top", fontsize=7, color="black",
              bbox={"facecolor": "white", "alpha": 0.7, "lw": 0, "pad": 1.5})


def columns_of(parts):
    """CSV columns of [(engine, ft, slice, fields)]."""
    columns = {name: [] for name in ("engine", "ft", "x/sigma", "z/sigma", *dict.fromkeys(f for *_, fields in parts for f in fields))}
    for engine, ft, piece, fields in parts:
        x, z = ((edges[1:] + edges[:-1]) / 2 for edges in (piece.x, piece.z))
        grid_z, grid_x = np.meshgrid(z, x, indexing="ij")
        some = np.isfinite(piece.fields[fields[0]])
        count = int(some.sum())
        for name in columns:
            columns[name].extend({"engine": [engine] * count, "ft": [ft] * count, "x/sigma": np.round(grid_x[some], 3), "z/sigma": np.round(grid_z[some], 3)}[name]
                                 if name in ("engine", "ft", "x/sigma", "z/sigma") else np.round(piece.fields[name][some], 5))
    return columns


def one_field(study, name, field, phases=(0.0, 0.25, 0.5, 0.75)):
    """Four phases of two cycles that follow one another, of each engine: its left and its right column."""
    figure, axes = plt.subplots(len(phases), 4, figsize=(10.6, 6.0), sharex=True, sharey=True)
    parts = []
    for side, (label, stripes) in enumerate(both(study)):
        for column, later in enumerate((0, 1)):
            for row, ft in enumerate(phases):
                axis, piece = axes[row, 2 * side + column], stripes.at(ft + later)
                image = panel(axis, piece, field)
                tell(axis, f"$ft$ = {ft + later:g}")
                parts.append((label, ft + later, piece, [field]))
        axes[0, 2 * side].set_title(title(label, stripes), loc="left")
    return finish(study, figure, axes, name, parts, [(image, axes, LOOKS[field][0])])


def two_fields(study, name, fields, phases=(0.875, 1.0, 1.125, 1.25), runs=RUNS):
    """One collision with the plate: two fields, each of MD and continuum side by side."""
    figure, axes = plt.subplots(len(phases), 4, figsize=(10.6, 6.6), sharex=True, sharey=True)
    parts, bars = [], []
    engines = both(study, runs)
    for pair, field in enumerate(fields):
        for side, (label, stripes) in enumerate(engines):
            for row, ft in enumerate(phases):
                axis, piece = axes[row, 2 * pair + side], stripes.at(ft)
                image = panel(axis, piece, field)
                tell(axis, f"$ft$ = {ft:g}")
                if pair == 0:
                    parts.append((label, ft, piece, list(fields)))
            axes[0, 2 * pair + side].set_title(title(label, stripes), loc="left")
        bars.append((image, axes[:, 2 * pair:2 * pair + 2], LOOKS[field][0]))
    return finish(study, figure, axes, name, parts, bars, below=True)


def finish(study, figure, axes, name, parts, bars, below=False):
    for image, some, label in bars:
        where = {"location": "bottom", "shrink": 0.6, "aspect": 40} if below else {"shrink": 0.6, "aspect": 40}
        figure.colorbar(image, ax=some, label=label, extend="neither" if "nu" in label else "both", **where)
    for axis in axes[-1]:
        axis.set_xlabel(r"$x/\sigma$")
    for axis in axes[:, 0]:
        axis.set_ylabel(r"$z/\sigma$")
    return save(figure, study.figures, name, columns_of(parts))
