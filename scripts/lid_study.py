#!/usr/bin/python3
"""The upper end in chapter 4: runs the continuum under both ends, from 60 to 200 high, and holds z_cm against that of MD runs of data/scenes/ch4_shock.toml.

    scripts/lid_study.py MD_RUN_FOLDER ... [--shaken build/release/shaken]        e.g. out/ch4/runs/md_s1 and the others of scripts/reproduce ch4

Prints, for each end and height: its mean force over the layer's weight, the rms difference of z_cm from MD over 20 phases, the same with the floor
half a diameter up, and from the highest stress-free end, all in per cent.
"""
import argparse
import itertools
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

sys.dont_write_bytecode = True
import independent_runs

ROOT = pathlib.Path(__file__).resolve().parents[1]
ENDS, HEIGHTS = ("stress_free", "lid"), (200, 120, 100, 80, 60)
SETTLE, AVERAGE, PHASES = 20, 5, 20


def of_end(shaken, end, top, folder):
    """Mean z_cm at 20 phases, and the mean force on the end over the layer's weight."""
    settings = [f"continuum.upper={end}", f"continuum.lid={top}", f"sample.settle={SETTLE}", f"sample.average={AVERAGE}", f"sample.phases={10 * PHASES}", "sample.frames=0"]
    words = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([shaken, "continuum", ROOT / "data/scenes/ch4_shock.toml", *words, "--quiet", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL)
    with h5py.File(folder / "continuum.h5") as file:
        height = file["observables/centre_of_mass/value"][:].reshape(-1, 10 * PHASES)[SETTLE:, ::10].mean(axis=0)
        impulse, time = (file[f"observables/lid_impulse/{name}"][:][SETTLE * 10 * PHASES:] for name in ("value", "time"))
        mass = file["observables/mass/value"][-1]
    return height, abs(impulse[-1] - impulse[0]) / (time[-1] - time[0]) / mass


def of_grains(folder):
    """Mean z_cm of an MD run at 20 phases, over the cycles after settling."""
    with h5py.File(folder / "md.h5") as file:
        heights = file["profiles/centre_of_mass"][:]
    return heights[:, :: heights.shape[1] // PHASES].mean(axis=0)


def rms(values, reference):
    return 100.0 * float(np.sqrt(np.mean((values / reference - 1.0) ** 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=pathlib.Path, metavar="MD_RUN_FOLDER")
    parser.add_argument("--shaken", default="build/release/shaken")
    options = parser.parse_args()
    if code := independent_runs.exit_code_of("lid_study", options.runs):
        return code
    grains = np.mean([of_grains(run) for run in options.runs], axis=0)
    highest = None
    print("end          height   force %   z_cm %   half a diameter up   against the highest")
    with tempfile.TemporaryDirectory() as folder:
        for end, top in itertools.product(ENDS, HEIGHTS):
            height, force = of_end(options.shaken, end, top, pathlib.Path(folder) / f"{end}_{top}")
            highest = height if highest is None else highest
            print(f"{end:11}  {top:6}   {100 * force:7.3f}   {rms(height, grains):6.2f}   {rms(height + 0.5, grains):18.2f}   {rms(height, highest):19.4f}",
                  flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
