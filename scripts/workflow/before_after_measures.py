# SPDX-License-Identifier: MIT
"""What scripts/before_after takes from runs: a measure gets what one run or two left and gives a number or a few words."""
import csv
import dataclasses
import json
import pathlib
import re
import subprocess

import h5py
import numpy as np


@dataclasses.dataclass(frozen=True)
class Ended:
    """code: exit code, negative of a run that was killed after so many seconds of processor time."""
    shaken: str
    code: int
    said: str
    folder: pathlib.Path
    seconds: float

    def observables(self, *names):
        file, = self.folder.glob("*.h5")
        with h5py.File(file) as of:
            return [of[f"observables/{name}/value"][:] for name in names]

    def times(self):
        file, = self.folder.glob("*.h5")
        with h5py.File(file) as of:
            return of["observables/centre_of_mass/time"][:]

    def columns(self):
        with open(self.folder / "verification.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return {name: np.array([float(row[name] or "nan") for row in rows]) for name in rows[0]}

    def summary(self):
        return json.loads((self.folder / "summary.json").read_text())


def how_it_ended(run):
    """In words."""
    if run.code < 0:
        return f"no end in {run.seconds} s of processor time"
    if run.code == 0:
        return "completes"
    said = re.search(r"shaken: (.*)", run.said)
    return f"exit code {run.code}" + (f": {said[1]}" if said else "")


def growth(run):
    command = [run.shaken, "patterns", str(run.folder), "--json"]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return abs(found["continuum"]["waves"][0]["multiplier"])


def last_cycle(run, phases=200):
    return run.observables("centre_of_mass")[0][-phases:]


def height(run):
    return float(last_cycle(run).mean())


def rms_of_heights(run, reference):
    ours, theirs = last_cycle(run), last_cycle(reference)
    return 100.0 * float(np.sqrt(np.mean((ours / theirs - 1.0) ** 2)))


def reference(name, source):
    """What a summary holds the measured value against."""
    return lambda run: next(entry["reference"] for entry in run.summary()
                            if entry["name"].startswith(name) and source in entry["source"])


def departure(name):
    """Of the measured value from its reference, in standard errors."""
    def of(run):
        entry = next(entry for entry in run.summary() if entry["name"].startswith(name))
        return (entry["measured"] - entry["reference"]) / entry["standard_error"]
    return of


def summary(name):
    return lambda run: run.summary()[name]["computed"]


def lowest_temperature(run):
    return float(run.columns()["temperature"][0])


WALL = 1000.0  # temperature of the wall of verify_heated


def temperature_at(at):
    def of(run):
        columns = run.columns()
        return float(np.interp(at, columns["height"], columns["temperature"])) / WALL
    return of


def error_of_temperature(run):
    return run.summary()["mean_error"]["temperature"]


def ringing(run):
    """Per cent, a half diameter off the middle, which the start overheats, and four cells off the fronts."""
    columns = run.columns()
    exact, z = columns["exact_temperature"], columns["height"]
    star, middle = exact.max(), 0.5 * (z[0] + z[-1])
    behind = (exact == star) & (np.roll(exact, 4) == star) & (np.roll(exact, -4) == star) & (np.abs(z - middle) > 0.5)
    return 100.0 * float(np.abs(columns["temperature"][behind] / star - 1.0).max())


def validity(run):
    said = [line.strip() for line in run.said.splitlines() if re.search(r"omega tau|Knudsen|\bKn\b", line)]
    return "; ".join(said) or "nothing"


def temperature_of_layer(run):
    """Mean over the cycle of energy without that of height and of the mean motion: 2/3 of the thermal energy a mass."""
    with h5py.File(run.folder / "continuum.h5") as file:
        sums = file["profiles/sums"][:].sum(axis=(0, 1))
    mass, momentum, squares = sums[:, 0], sums[:, 1:4], sums[:, 4:7]
    filled = mass > 0
    thermal = squares[filled] - momentum[filled] ** 2 / mass[filled, None]
    return float(thermal.sum() / 3.0 / mass.sum())


def gained_and_booked(run):
    z, mass, work = run.observables("centre_of_mass", "mass", "body_force_work")
    return (z[-1] - z[0]) * mass[0], -(work[-1] - work[0])


def work_differs(run):
    gained, booked = gained_and_booked(run)
    return 100.0 * abs(booked / gained - 1.0)


def heating(run):
    """Gain of energy and potential energy together, a mass and a time, over the second half of the run; nothing feeds a
    column at rest on a plate at rest."""
    z, mass, energy = run.observables("centre_of_mass", "mass", "energy")
    time, half = run.times(), len(z) // 2
    return float(((energy[-1] - energy[half]) / mass[0] + z[-1] - z[half]) / (time[-1] - time[half]))


def drift(run):
    kinetic, potential = run.observables("kinetic_energy", "potential_energy")
    total = kinetic + potential
    return float(np.abs(total / total[0] - 1.0).max())


def flights(run):
    """The highest over the plate of the first four flights, by a parabola through the three highest samples of each."""
    z, time = run.observables("centre_of_mass")[0], run.times()
    over = z - 0.5 - plate(time)
    tops = [i for i in range(1, len(over) - 1) if over[i - 1] < over[i] >= over[i + 1] and over[i] > 1.0]
    return ", ".join(f"{top_of(*over[i - 1:i + 2]):.4f}" for i in tops[:4])


def top_of(before, middle, after):
    return middle + (after - before) ** 2 / (8.0 * (2.0 * middle - before - after))


def plate(time, acceleration=3.4, frequency=0.1):
    omega = 2.0 * np.pi * frequency
    return acceleration / omega**2 * (1.0 - np.cos(omega * time))
