# SPDX-License-Identifier: MIT
"""Figure 5.1: the layer seen from above, z_cm(x, y) at one phase of two cycles that follow one another, for each engine that kept maps:
    overhead_map.py RUN_FOLDER [FT] [CYCLE]        default: ft = 0.25 and the last two cycles
"""
import sys
from pathlib import Path

import h5py
import numpy as np

from style import plt, save

NAME = "figure_5_1"


def maps_of(path, phase, cycle):
    """Deviations from the mean height and the cycles, for `cycle` and the one after it."""
    with h5py.File(path) as file:
        group = file["height_maps"]
        rows = np.flatnonzero(np.abs(group["phase"][:] - phase) < 1e-9)
        if rows.size < 2:
            sys.exit(f"overhead_map: {path} has no two maps at ft = {phase}")
        cycles = group["cycle"][:][rows]
        at = rows.size - 2 if cycle is None else int(np.searchsorted(cycles, cycle))
        chosen = rows[at:at + 2]
        heights = group["height"][chosen]
        return heights - heights.mean(axis=(1, 2), keepdims=True), group["cycle"][:][chosen], (
            group.attrs["length_x"], group.attrs["length_y"])


def draw(folder, phase, cycle):
    engines = [e for e in ("md", "continuum") if (folder / f"{e}.h5").exists() and "height_maps" in h5py.File(folder / f"{e}.h5")]
    if not engines:
        sys.exit(f"overhead_map: no run in {folder} kept maps; run with --set sample.map_bin=2")
    figure, axes = plt.subplots(len(engines), 2, figsize=(7.2, 3.4 * len(engines)), squeeze=False, layout="constrained")
    columns = {name: [] for name in ("engine", "cycle", "x/sigma", "y/sigma", "psi")}
    for row, engine in zip(axes, engines):
        psi, cycles, (length_x, length_y) = maps_of(folder / f"{engine}.h5", phase, cycle)
        limit = np.abs(psi).max()
        for axis, values, number in zip(row, psi, cycles):
            image = axis.imshow(values, origin="lower", extent=(0, length_x, 0, length_y), cmap="RdBu_r", vmin=-limit, vmax=limit)
            axis.set_title(f"{engine.replace('md', 'MD')}, cycle {number}, $ft$ = {phase:g}", fontsize=9)
            axis.set_xlabel(r"$x/\sigma$")
            axis.set_ylabel(r"$y/\sigma$")
            ny, nx = values.shape
            for iy in range(ny):
                for ix in range(nx):
                    for name, cell in zip(columns, (engine, int(number), (ix + 0.5) * length_x / nx, (iy + 0.5) * length_y / ny,
                                                    float(values[iy, ix]))):
                        columns[name].append(cell)
        figure.colorbar(image, ax=row, label=r"$\psi = z_{cm} - \langle z_{cm}\rangle$", shrink=0.9)
    return save(figure, folder / "figures", NAME, columns)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    print(draw(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.25,
               int(sys.argv[3]) if len(sys.argv) > 3 else None))
