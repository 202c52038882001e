# SPDX-License-Identifier: MIT
"""The layer seen from above, z_cm(x, y) at one phase. Of one run, in two cycles that follow one another:
    overhead_map.py RUN_FOLDER [FT] [CYCLE]        default: ft = 0.25 and the last two cycles
"""
import sys
import tomllib
from pathlib import Path

import h5py
import numpy as np

from run_folder import RunError
from style import plt, save

NAME = "overhead_map"
PHASE = 0.25
SHOWN = 98           # per cent of the bins within the colours' ends: single grains that fly high would hide the waves
LABEL = r"$\psi = z_{cm} - \langle z_{cm}\rangle$, $\sigma$"


def maps_of(path, phase=PHASE, cycle=None):
    """Deviations from the mean height of two cycles that follow one another, `cycle` or the last two, those cycles, sides, and Gamma."""
    if not path.is_file():
        raise RunError(f"{path}: not there")
    with h5py.File(path) as file:
        if "height_maps" not in file:
            raise RunError(f"{path} has no maps; run with --set sample.map_bin=2")
        group = file["height_maps"]
        rows = np.flatnonzero(np.abs(group["phase"][:] - phase) < 1e-9)
        if rows.size < 2:
            raise RunError(f"{path} has no two maps at ft = {phase}")
        cycles = group["cycle"][:][rows]
        at = rows.size - 2 if cycle is None else int(np.searchsorted(cycles, cycle))
        chosen = rows[at:at + 2]
        heights = group["height"][chosen]
        gamma = tomllib.loads(file["provenance/scene"][()].decode())["plate"]["acceleration"]
        return heights - heights.mean(axis=(1, 2), keepdims=True), group["cycle"][:][chosen], (
            group.attrs["length_x"], group.attrs["length_y"]), gamma


def panel(axis, values, sides, limit, title):
    image = axis.imshow(values, origin="lower", extent=(0, sides[0], 0, sides[1]), cmap="RdBu_r", vmin=-limit, vmax=limit)
    axis.set_title(title, fontsize=9)
    axis.set_xlabel(r"$x/\sigma$")
    axis.set_ylabel(r"$y/\sigma$")
    return image


def add(columns, label, gamma, cycle, values, sides):
    ny, nx = values.shape
    x, y = np.meshgrid((np.arange(nx) + 0.5) * sides[0] / nx, (np.arange(ny) + 0.5) * sides[1] / ny)
    for name, cells in zip(columns, ([label] * values.size, [gamma] * values.size, [int(cycle)] * values.size, x.ravel(), y.ravel(),
                                     np.round(values.ravel(), 6))):
        columns[name].extend(cells)


def new_columns():
    return {name: [] for name in ("engine", "Gamma", "cycle", "x/sigma", "y/sigma", "psi/sigma")}


def panels(study, name, runs, columns_of_panels):
    """The last cycle of several runs of a study, [(label, run, engine)], on one scale."""
    found = [(label, *maps_of(study.folder / "runs" / run / f"{engine}.h5")) for label, run, engine in runs]
    limit = max(np.percentile(np.abs(psi[-1]), SHOWN) for _, psi, *_ in found)
    rows = -(-len(runs) // columns_of_panels)
    figure, axes = plt.subplots(rows, columns_of_panels, figsize=(3.5 * columns_of_panels, 3.4 * rows), squeeze=False)
    columns = new_columns()
    for axis, (label, psi, cycles, sides, gamma) in zip(axes.ravel(), found):
        image = panel(axis, psi[-1], sides, limit, rf"{label}, $\Gamma$ = {gamma:g}")
        add(columns, label, gamma, cycles[-1], psi[-1], sides)
    figure.colorbar(image, ax=axes, label=LABEL, shrink=0.8, extend="both")
    return save(figure, study.figures, name, columns)


def draw(folder, phase, cycle):
    engines = [e for e in ("md", "continuum") if (folder / f"{e}.h5").exists() and "height_maps" in h5py.File(folder / f"{e}.h5")]
    if not engines:
        raise RunError(f"no run in {folder} kept maps; run with --set sample.map_bin=2")
    figure, axes = plt.subplots(len(engines), 2, figsize=(7.2, 3.4 * len(engines)), squeeze=False)
    columns = new_columns()
    for row, engine in zip(axes, engines):
        psi, cycles, sides, gamma = maps_of(folder / f"{engine}.h5", phase, cycle)
        for axis, values, number in zip(row, psi, cycles):
            image = panel(axis, values, sides, np.abs(psi).max(), f"{engine.replace('md', 'MD')}, cycle {number}, $ft$ = {phase:g}")
            add(columns, engine, gamma, number, values, sides)
        figure.colorbar(image, ax=row, label=LABEL, shrink=0.9)
    return save(figure, folder / "figures", NAME, columns)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    try:
        print(draw(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else PHASE, int(sys.argv[3]) if len(sys.argv) > 3 else None))
    except RunError as error:
        sys.exit(f"overhead_map: {error}")
