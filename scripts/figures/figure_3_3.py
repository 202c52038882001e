# SPDX-License-Identifier: MIT
"""Figure 3.3: error of z_cm(x, y) with the grid spacing along x, along y and along z, after ten cycles of a layer with a wave.
    figure_3_3.py FOLDER [--scheme muscl] [--against muscl] [--gamma 2.2] [--wide 1,2,3,7] [--high 0.2,0.25,0.4,0.5]
                  [--shaken build/release/shaken]

Runs the strip of data/scenes/ch5_growth.toml (along y: the same, turned) with a wave of 0.3 of the density; a run that is there is not made again.
Runs that are held against each other have one closure, jenkins_richman_dense where one of them is by ftcs, which can run no other.
Error as in the source: rms over the strip, against the finest grid of the scheme --against, in per cent of the mean height, mean of 8 phases of the eleventh cycle.
Maps of coarser cells are compared with the means of the finest over the same cells.
"""
import argparse
import subprocess
from pathlib import Path

import h5py
import numpy as np

from style import DENSITY, LENGTH, TEMPERATURE, plt, save

NAME = "figure_3_3"
LENGTH_OF_STRIP = 42.0
FINEST_WIDE, FINEST_HIGH = 0.5, 0.1   # of the references
CYCLES = 10


def numbers(text):
    return tuple(float(word) for word in text.split(","))


def settings(options, scheme, axis, wide, high):
    box = {"box.x": LENGTH_OF_STRIP, "box.y": 4.0, "initial.wave_x": 2, "initial.wave_y": 0}
    if axis == "y":
        box = {"box.x": 4.0, "box.y": LENGTH_OF_STRIP, "initial.wave_x": 0, "initial.wave_y": 2}
    return box | {
        "plate.acceleration": options.gamma, "initial.wave": 0.3, "sample.phases": 40, "sample.maps": 8,
        "sample.settle": CYCLES, "sample.average": 1, "sample.map_bin": 0.5, "continuum.spacing_horizontal": wide,
        "continuum.spacing": high, "continuum.scheme": scheme, "continuum.closure": closure(options)}


def closure(options):
    """One for both schemes: that of the scene, or the one that ftcs can run."""
    return "jenkins_richman_dense" if "ftcs" in (options.scheme, options.against) else "jenkins_richman"


def maps_of(options, scheme, axis, wide, high):
    """z_cm of the eleventh cycle at 8 phases, bins of 0.5 along the strip: (8, 84)."""
    folder = options.folder / f"{scheme}_{closure(options)}_{options.gamma:g}_{axis}_{wide:g}_{high:g}"
    if not (folder / "continuum.h5").exists():
        words = [w for key, value in settings(options, scheme, axis, wide, high).items() for w in ("--set", f"{key}={value}")]
        command = [options.shaken, "continuum", "data/scenes/ch5_growth.toml", *words, "--out", folder, "--overwrite", "--quiet"]
        if subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode != 0:
            return None
    with h5py.File(folder / "continuum.h5") as file:
        rows = file["height_maps/cycle"][:] == CYCLES
        return file["height_maps/height"][rows].mean(axis=1 if axis == "x" else 2)


def error(heights, reference, width):
    """Per cent; both averaged over cells `width` wide."""
    bins = int(round(width / 0.5))
    coarse, fine = (h.reshape(len(h), -1, bins).mean(axis=2) for h in (heights, reference))
    return float(np.mean(100.0 * np.sqrt(np.mean((coarse - fine) ** 2, axis=1)) / np.mean(fine, axis=1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scheme", default="muscl")
    parser.add_argument("--against", default="muscl", help="scheme of the reference")
    parser.add_argument("--gamma", type=float, default=2.2)
    parser.add_argument("--wide", type=numbers, default=(1.0, 2.0, 3.0, 7.0), help="spacings across columns, divisors of 42")
    parser.add_argument("--high", type=numbers, default=(0.2, 0.25, 0.4, 0.5), help="spacings along them")
    parser.add_argument("--shaken", default="build/release/shaken")
    options = parser.parse_args()
    columns = {"axis": [], "spacing/sigma": [], "error of z_cm/percent": []}
    figure, axis_of_plot = plt.subplots(figsize=(5.0, 4.0))
    for axis, colour, marker in (("x", DENSITY, "o"), ("y", TEMPERATURE, "x"), ("z", LENGTH, "s")):
        along = axis == "z"
        finest = ("x", 2.0, FINEST_HIGH) if along else (axis, FINEST_WIDE, 0.2)
        reference = maps_of(options, options.against, *finest)
        shown = []
        for spacing in options.high if along else options.wide:
            heights = maps_of(options, options.scheme, *(("x", 2.0, spacing) if along else (axis, spacing, 0.2)))
            if heights is None or reference is None:
                print(f"{options.scheme} d{axis} = {spacing:g}: failed", flush=True)
                continue
            shown.append((spacing, error(heights, reference, 2.0 if along else spacing)))
            print(f"{options.scheme} d{axis} = {spacing:g}: {shown[-1][1]:.3g} %", flush=True)
            for name, cell in zip(columns, (axis, *shown[-1])):
                columns[name].append(cell)
        if shown:
            axis_of_plot.loglog(*zip(*shown), marker=marker, color=colour, label=f"along {axis}")
    axis_of_plot.axhline(2.5, color="0.6", lw=0.8, ls=":")
    axis_of_plot.set_xlabel(r"spacing, $\sigma$")
    axis_of_plot.set_ylabel(r"error of $z_{cm}$, %")
    axis_of_plot.legend()
    print(save(figure, options.folder, NAME, columns))


if __name__ == "__main__":
    main()
