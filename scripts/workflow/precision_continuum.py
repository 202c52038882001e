# SPDX-License-Identifier: MIT
"""Errors of the continuum's discretisation: against exact solutions, or against a reference extrapolated from two schemes. The reference's own error is their
difference together with a quarter of the extrapolation: both schemes share how they step through diffusion, so that their difference alone says too little.
"""
import csv
import json

import h5py
import numpy as np

import precision_points as table
from precision_study import FIELDS, Layer, differences, read_layer, rms, row
from precision_timings import cost_of

WAVELENGTH, STRIP, BIN = 21.0, 42.0, 0.5
ONE_STEP = "1 step: nothing bounds it by the speed of sound"
# Energy that the second energy equation put in, as a share of what collisions took out, from which a run that went through is not believed. Of ftcs the same
# entry books what its differences gain or lose, which it never claims to keep.
MOST_ENERGY_FROM_NOWHERE = 0.01


def observed_order(coarse, middle, fine):
    """From three spacings halved; at least 1 and at most 2, the orders that the methods have on this flow."""
    return float(np.clip(np.log2(rms(coarse - middle) / rms(middle - fine)), 1.0, 2.0))


def extrapolated(middle, fine, order):
    return fine + (fine - middle) / (2.0**order - 1.0)


def limit_of_layer(layers):
    """Richardson's limit of three grids, each quantity with its own order."""
    arrays = {}
    for name in ("z_cm", "shock", *FIELDS):
        coarse, middle, fine = (getattr(layer, name) for layer in layers)
        arrays[name] = extrapolated(middle, fine, observed_order(coarse, middle, fine))
    return Layer(layers[-1].height, **arrays)


def together(between, extrapolation):
    """Error of a reference: difference of the schemes' limits, and a quarter of the way from the finest grid to the limit."""
    return {name: float(np.hypot(between[name], extrapolation[name] / 4)) for name in between}


def mean_of(layers):
    return Layer(layers[0].height, **{n: np.mean([getattr(layer, n) for layer in layers], axis=0) for n in ("z_cm", "shock", *FIELDS)})


class Shock:
    """ch4_shock: phase averages of the thirteenth cycle, against the limit of one closure."""

    def __init__(self, study, closure=table.DEFAULT_CLOSURE):
        self._study = study
        grids = [[self.layer(p) for p in table.reference_points("ch4_shock", scheme, closure)] for scheme in table.REFERENCE_SCHEMES]
        limits = [limit_of_layer(layers) for layers in grids]
        self.reference = mean_of(limits)
        self.error_of_reference = together(differences(*limits), differences(limits[0], grids[0][-1]))

    def layer(self, point):
        return read_layer(self._study.folder / "comparisons" / point.name, "continuum")

    def errors(self, point):
        return differences(self.layer(point), self.reference)


class Stripes:
    """The strip: modes 0, 1 and 2 of z_cm(x), wavelengths of 21 and 10.5, at every phase of three cycles."""

    def __init__(self, study, closure=table.DEFAULT_CLOSURE):
        self._study, self._closure = study, closure
        limits, finest = zip(*(self._limit(scheme) for scheme in table.REFERENCE_SCHEMES))
        self.reference = np.mean(limits, axis=0)
        self.error_of_reference = together(self._differences(*limits), self._differences(finest[0], limits[0]))

    def _limit(self, scheme):
        def modes(**settings):
            return self.modes(table.point("stripes", scheme, settings, self._closure))
        order = observed_order(modes(dz=0.4), modes(dz=0.2), modes(dz=0.1))
        finest = modes(dx=1.0, dz=0.1)
        along, across = (finest - modes(dx=1.0, dz=0.2)) / (2.0**order - 1.0), (finest - modes(dx=2.0, dz=0.1)) / 3.0
        return finest + along + across, finest

    def modes(self, point):
        """Shape (instants, 3): mean of z_cm and its amplitudes, of cells as wide as the point's."""
        with h5py.File(self._study.run(point.name) / "continuum.h5") as file:
            rows = file["height_maps/cycle"][:] >= table.FIXED["stripes"]["sample.settle"]
            heights = file["height_maps/height"][rows].mean(axis=1)
        x = (np.arange(heights.shape[1]) + 0.5) * STRIP / heights.shape[1]
        found = [heights.mean(axis=1)]
        for m in (1, 2):
            k = 2 * np.pi * m / WAVELENGTH
            # Means over a cell, then over bins, take this share from a cosine (np.sinc(x) = sin(pi x)/(pi x)).
            share = np.sinc(k * point.value("dx") / 2 / np.pi) ** 2 / np.sinc(k * BIN / 2 / np.pi)
            found.append(2 * np.mean(heights * np.cos(k * x), axis=1) / share)
        return np.stack(found, axis=1)

    @staticmethod
    def _differences(ours, reference):
        gap, mean = ours - reference, np.mean(reference[:, 0])
        return {"z_cm": 100 * float(np.sqrt(np.mean(gap[:, 0] ** 2 + (gap[:, 1] ** 2 + gap[:, 2] ** 2) / 2))) / mean,
                "wave": 100 * rms(gap[:, 1]) / rms(reference[:, 1])}

    def errors(self, point):
        return self._differences(self.modes(point), self.reference)


class Riemann:
    """Mean difference from the exact solution over the tube, per cent of its mean; without transport, so of any closure."""

    def __init__(self, study, *_):
        self._study = study
        self.error_of_reference = {}

    def errors(self, point):
        with open(self._study.run(point.name) / "verification.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        found = {}
        for name, key in zip(FIELDS, ("volume_fraction", "velocity", "temperature")):
            ours, exact = (np.array([float(r[prefix + key]) for r in rows]) for prefix in ("", "exact_"))
            found[name] = 100 * float(np.sum(np.abs(ours - exact)) / np.sum(np.abs(exact)))
        return found


class Wave:
    """Sound without transport, which keeps its amplitude: error of its speed, and what a period takes from it; of any closure."""

    def __init__(self, study, *_):
        self._study = study
        self.error_of_reference = {}

    def errors(self, point):
        summary = json.loads((self._study.run(point.name) / "summary.json").read_text())
        length, speed = 400.0, summary["sound_speed"]["exact"]
        k = 2 * np.pi / length
        kept = np.exp(-summary["attenuation"]["computed"] * k**2 * length / speed)
        return {"sound_speed": 100 * abs(summary["sound_speed"]["error"]), "wave": 100 * abs(1 - kept)}


MEASURES = {"ch4_shock": Shock, "stripes": Stripes, "riemann": Riemann, "wave": Wave}


def work_of(study, point):
    """Cell updates (cells times whole steps) and steps of a run; empty where it did not end."""
    folder = study.run(point.name)
    if (folder / "continuum.h5").is_file():
        with h5py.File(folder / "continuum.h5") as file:
            steps = file["observables/steps/value"][-1]
            return {"work": steps * np.prod(file["grid/cells"][:], dtype=float), "steps": steps}
    if (folder / "summary.json").is_file():
        steps = json.loads((folder / "summary.json").read_text())["steps"]
        with open(folder / "verification.csv", encoding="utf-8") as file:
            return {"work": steps * (sum(1 for _ in file) - 1), "steps": steps}
    return {}


def how_it_ended(study, point, steps):
    """"completed", or what went wrong, be it only seen in the books."""
    end = study.end(point.name)
    if end["exit_code"] != 0:
        return " ".join(end["said"])
    if steps <= 1:
        return ONE_STEP
    if point.scheme != "ftcs" and (study.run(point.name) / "continuum.h5").is_file():
        with h5py.File(study.run(point.name) / "continuum.h5") as file:
            gained, lost = (file[f"observables/{name}/value"][-1] for name in ("dual_energy_gain", "collisional_loss"))
        if abs(gained) > MOST_ENERGY_FROM_NOWHERE * abs(lost):
            return f"energy from nowhere: {100 * gained / lost:.2g} % of the collisional loss"
    return "completed"


def rows(study):
    made, timings = [], study.timings()
    measures = {(name, closure): measure(study, closure) for name, measure in MEASURES.items() for closure in table.reference_closures(name)}
    for (name, scheme, knob), values in table.CURVES.items():
        measure = measures[name, table.closure_of(name, scheme)]
        for value in values:
            point = table.point(name, scheme, {knob: value})
            died, work = study.end(point.name)["exit_code"] != 0, work_of(study, point)
            says = how_it_ended(study, point, work.get("steps", 0))
            found = {q: np.nan for q in measure.error_of_reference} if died else measure.errors(point)
            default = scheme == table.DEFAULT_SCHEME and value == table.DEFAULT[name][knob]
            cost = work | cost_of(timings.get(point.name), work.get("steps"))
            command = study.command("continuum", point.scene, point.changes)
            made += [row(name, "continuum", scheme, knob, value, quantity, error, measure.error_of_reference.get(quantity, 0.0), cost, default, says,
                         command) for quantity, error in found.items()]
    return made
