#!/usr/bin/python3
"""Where the continuum leaves the grains: one layer by both engines for each line of a list, their mean temperatures beside the numbers of validity.

    scripts/validity_study.py [--shaken build/release/shaken] [--only WORDS]        some ten minutes

Prints for each layer: restitution, particles an area, frequency, peak acceleration; of the continuum Kn and omega tau (mean over the layer and the cycle,
weighted by mass, and largest) and the mean share of mass above nu = 0.6 (per cent); T of either engine, weighted by mass, over the cycle; their ratio; the ratio of the heights
of the centre of mass above the plate.
"""
import argparse
import pathlib
import subprocess
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
PHASES = 20
# name, e, N per area, f, Gamma, height of the end (the lid, and the ceiling over the plate's highest), spacing, particles, settle, average.
LAYERS = (
    ("acceleration", 0.99, 0.5, 3.18, 3, 100, 0.5, 200, 1000, 600),
    ("acceleration", 0.99, 0.5, 3.18, 6, 200, 1, 200, 1500, 800),
    ("acceleration", 0.99, 0.5, 3.18, 10, 400, 1, 200, 1500, 800),
    ("acceleration", 0.99, 0.5, 3.18, 20, 1200, 2, 200, 4000, 800),
    ("depth", 0.99, 1.0, 3.18, 20, 600, 1, 200, 1000, 600),
    ("depth", 0.99, 2.0, 3.18, 20, 200, 0.5, 200, 1000, 400),
    ("depth", 0.99, 4.0, 3.18, 20, 100, 0.4, 400, 600, 200),
    ("depth", 0.99, 8.0, 3.18, 20, 60, 0.4, 800, 400, 100),
    ("frequency", 0.99, 2.0, 0.5, 3, 200, 0.5, 200, 200, 200),
    ("frequency", 0.99, 2.0, 1.0, 6, 200, 0.5, 200, 400, 300),
    ("frequency", 0.99, 2.0, 2.0, 12, 200, 0.5, 200, 800, 300),
    ("frequency", 0.99, 2.0, 4.0, 24, 200, 0.5, 200, 1200, 400),
    ("slow", 0.99, 4.0, 0.25, 3, 200, 0.4, 400, 100, 100),
    ("slow", 0.99, 4.0, 0.5, 3, 100, 0.4, 400, 200, 100),
    ("slow", 0.9, 4.0, 0.25, 3, 100, 0.4, 400, 60, 100),
    ("slow", 0.9, 2.0, 0.25, 3, 100, 0.4, 200, 60, 200),
    ("slow", 0.9, 1.0, 0.25, 3, 100, 0.4, 200, 60, 300),
    ("slow", 0.9, 0.5, 0.25, 3, 300, 0.5, 200, 60, 400),
    ("slow", 0.9, 8.0, 0.25, 3, 100, 0.4, 800, 60, 60),
    ("slow", 0.9, 8.0, 0.1, 3, 200, 0.4, 800, 40, 40),
    ("dissipation", 0.8, 2.0, 0.25, 3, 100, 0.4, 200, 60, 200),
    ("dissipation", 0.8, 4.0, 0.25, 3, 100, 0.4, 400, 60, 100),
    ("dissipation", 0.7, 2.0, 0.25, 3, 100, 0.4, 200, 60, 200),
    ("dissipation", 0.7, 1.0, 0.25, 3, 100, 0.4, 200, 60, 300),
    ("dissipation", 0.8, 1.0, 0.25, 3, 100, 0.4, 200, 60, 300),
    ("dissipation", 0.8, 8.0, 0.1, 3, 200, 0.4, 800, 40, 40),
    ("dissipation", 0.95, 8.0, 0.1, 3, 200, 0.4, 800, 40, 40),
    ("dissipation", 0.95, 4.0, 0.25, 3, 100, 0.4, 400, 60, 100),
    ("dissipation", 0.9, 2.0, 1.0, 6, 100, 0.4, 200, 200, 300),
    ("dissipation", 0.9, 2.0, 3.18, 20, 100, 0.4, 200, 400, 400),
)


def run(shaken, engine, layer, folder):
    _, e, per_area, frequency, acceleration, height, spacing, number, settle, average = layer
    side = (number / per_area) ** 0.5
    amplitude = acceleration / (2 * np.pi * frequency) ** 2
    settings = [f"particles.restitution={e}", f"particles.number={number}", f"box.x={side!r}", f"box.y={side!r}", f"plate.frequency={frequency}",
                f"plate.acceleration={acceleration}", f"box.ceiling={height + 2 * amplitude!r}", f"continuum.lid={height}", f"continuum.spacing={spacing}",
                "continuum.dimension=1", f"sample.settle={settle}", f"sample.average={average}", f"sample.phases={PHASES}", f"sample.bin={max(0.5, spacing)}", "sample.frames=0"]
    words = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([shaken, engine, ROOT / "data/scenes/ch4_shock.toml", *words, "--quiet", "--overwrite", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL)
    return h5py.File(folder / f"{engine}.h5")


def temperature(file):
    """Mean T, weighted by mass, over height and phase; of even and of odd cycles apart, for a layer of period two has two flows."""
    sums, odd = file["profiles/sums"][:].sum(axis=0), file["profiles/odd_sums"][:].sum(axis=0)
    heat = 0.0
    for flow in (odd, sums - odd):
        mass, momentum, squares = flow[..., 0], flow[..., 1:4], flow[..., 4:7]
        filled = mass > 1e-9 * mass.max()  # what is less is round-off of the difference
        heat += squares[filled].sum() - (momentum[filled] ** 2 / mass[filled][:, None]).sum()
    return heat / (3 * sums[..., 0].sum())


def height(file, amplitude):
    """Mean height of the centre of mass above the plate's mean height."""
    return np.mean(file["profiles/centre_of_mass"][:]) - amplitude


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shaken", default="build/release/shaken")
    parser.add_argument("--only", default="", metavar="WORD")
    options = parser.parse_args()
    print("layer           e    N/area      f  Gamma       Kn (largest)   omega tau (largest)  packed %      T: continuum, MD    ratio    z ratio", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for layer in LAYERS:
            if options.only not in layer[0]:
                continue
            name, e, per_area, frequency, acceleration = layer[:5]
            amplitude = acceleration / (2 * np.pi * frequency) ** 2
            continuum, grains = (run(options.shaken, engine, layer, pathlib.Path(folder)) for engine in ("continuum", "md"))
            v = {key: item[()] for key, item in continuum["validity"].items()}
            ours, theirs = temperature(continuum), temperature(grains)
            lifted = height(continuum, amplitude) / height(grains, amplitude)
            print(f"{name:14} {e:5} {per_area:7} {frequency:6} {acceleration:6} {v['knudsen']:8.2g} ({v['knudsen_largest']:.2g})"
                  f" {v['omega_tau']:11.3g} ({v['omega_tau_largest']:.3g}) {100 * v['packed_share']:9.2g} {ours:12.4g} {theirs:8.4g} {ours / theirs:8.2f} {lifted:8.2f}", flush=True)


if __name__ == "__main__":
    main()
