# SPDX-License-Identifier: MIT
"""Whether MD runs that are averaged are independent: the rule of compare/independence.hpp, for scripts that average by themselves.

Grains that collide are chaotic, so that two runs meet in the bits of z_cm only where they are one trajectory.
"""
import itertools
import pathlib
import sys
import tomllib

import h5py
import numpy as np

CHANCE = 0.1  # of a cycle: samples at one instant may agree, of starts that fill a lattice


class Run:
    """folder/md.h5: how it started, None where from a file, and z_cm of its samples."""

    def __init__(self, folder):
        self.path = pathlib.Path(folder) / "md.h5"
        if not self.path.is_file():
            raise FileNotFoundError(f"{self.path}: no such file; whether runs are independent is told from it")
        with h5py.File(self.path) as file:
            scene = tomllib.loads(file["provenance/scene"][()].decode())
            heights = file["profiles/centre_of_mass"][:]
        seeds = scene.get("md", {}).get("seed", 1), scene.get("initial", {}).get("seed", 1)
        self.start = None if scene.get("initial", {}).get("file") else seeds
        self.phases = heights.shape[1]
        self.samples = {(phase, z) for cycle in heights for phase, z in enumerate(cycle) if not np.isnan(z)}


def in_common(one, other):
    """What makes two runs one, in words; empty where they are independent."""
    if one.path.resolve() == other.path.resolve():
        return "they are one file"
    if one.start is not None and one.start == other.start:
        return f"they start alike, md.seed = {one.start[0]} and initial.seed = {one.start[1]}"
    shared = len(one.samples & other.samples) / one.phases
    return f"they share {shared:.3g} cycles bit for bit" if shared >= CHANCE else ""


def why_dependent(folders):
    """A sentence with both names, of the first two that are not independent; empty where all are. Raises FileNotFoundError where an md.h5 is not there."""
    for one, other in itertools.combinations([Run(folder) for folder in folders], 2):
        if common := in_common(one, other):
            return f"{one.path} and {other.path} are not independent: {common}; an average is over runs of other seeds, or from other states"
    return ""


def exit_code_of(command, folders):
    """0 where they are independent; else 65, or 66 where an md.h5 is not there, and the reason goes to stderr."""
    try:
        dependent, code = why_dependent(folders), 65
    except FileNotFoundError as error:
        dependent, code = str(error), 66
    if dependent:
        print(f"{command}: {dependent}", file=sys.stderr)
    return code if dependent else 0
