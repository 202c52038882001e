"""From a run folder's md.h5 to a file of data/expected: python3 scripts/expected.py out/md.h5 "the command that made it".

z_cm(ft) at twenty phases and pair collisions a particle and cycle: means over the cycles averaged, how single cycles
spread about them, and standard errors of the means from ten blocks of cycles."""
import re
import sys

import h5py
import numpy

with h5py.File(sys.argv[1]) as file:
    scene = file["provenance/scene"][()].decode()
    height = file["observables/centre_of_mass/value"][:]
    pairs = file["observables/pair_collisions/value"][:]


def key(name):
    return int(re.search(rf"^{name} = (\d+)", scene, re.MULTILINE).group(1))


phases, settle, particles = key("phases"), key("settle"), key("number")
height = height.reshape(-1, phases)[settle:, :: phases // 20]
pairs = numpy.diff(pairs.reshape(-1, phases)[settle:, 0]) / particles


def error(values):
    blocks = [block.mean(axis=0) for block in numpy.array_split(values, 10)]
    return numpy.std(blocks, axis=0, ddof=1) / numpy.sqrt(10)


def row(values):
    return "[" + ", ".join(f"{v:.4f}" for v in values) + "]"


print(f"# {' '.join(sys.argv[2:])}")
print("# Mean over the cycles after settling, standard deviation of one cycle, standard error of the mean (ten blocks).")
print("# Lengths in sigma, in the laboratory's frame; phases ft = 0, 0.05, ... 0.95.")
print(f"cycles = {len(height)}\nsettle = {settle}")
print(f"\n[centre_of_mass]\nmean = {row(height.mean(axis=0))}")
print(f"spread = {row(height.std(axis=0, ddof=1))}\nerror = {row(error(height))}")
print(f"\n[pair_collisions_per_particle_and_cycle]\nmean = {pairs.mean():.3f}")
print(f"spread = {pairs.std(ddof=1):.3f}\nerror = {error(pairs):.3f}")
