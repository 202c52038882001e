# SPDX-License-Identifier: MIT
"""The folder of the study work-precision and what its runs hold, as arrays; and the row that every error becomes.

OUT/HASH holds runs, comparisons and timings made by the program of that git hash, so that another build starts anew. Units: sigma, sqrt(sigma/g).
"""
import csv
import json
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

COLUMNS = ("study", "engine", "scheme", "knob", "value", "quantity", "error_percent", "error_of_error", "cpu_seconds", "cpu_low", "cpu_high",
           "work", "steps", "default", "end", "command")
LAYER = 0.04 * 0.65 * 6 / np.pi  # number density at the edge of the layer
PHASES = 20                      # that z_cm is compared at
FIELDS = ("density", "velocity", "temperature")


@dataclass
class Study:
    root: Path
    out: Path
    folder: Path  # OUT/HASH
    shaken: Path
    jobs: int = 1

    def run(self, name):
        return self.folder / "runs" / name

    def end(self, name, engine="continuum"):
        return json.loads((self.run(name) / f"{engine}.end.json").read_text())

    def timings(self):
        path = self.folder / "timings.json"
        return json.loads(path.read_text()) if path.is_file() else {}

    def command(self, engine, scene, changes):
        return " ".join(["shaken", engine, scene, *(f"--set {change}" for change in changes)])


@dataclass
class Layer:
    """Phase averages of one engine. Shapes: height (bins); z_cm, shock (phases); fields (phases, bins). velocity is relative to the plate; shock, above the
    plate, is NaN unless it is fully formed and in the layer."""
    height: np.ndarray
    z_cm: np.ndarray
    density: np.ndarray
    velocity: np.ndarray
    temperature: np.ndarray
    shock: np.ndarray

    def lifted(self, bins, by):
        """The floor higher by `by` sigma, a whole number of bins: as seen where there is no gas below it."""
        moved = {name: np.concatenate([np.full_like(getattr(self, name)[:, :bins], np.nan), getattr(self, name)[:, :-bins]], axis=1) for name in FIELDS}
        return Layer(self.height, self.z_cm + by, shock=self.shock + by, **moved)


def read_layer(folder, engine):
    """From compare.h5 of a comparison."""
    with h5py.File(Path(folder) / "compare.h5") as file:
        of, phase = file[engine], file["phase"][:]
        shock = of["shock/location"][:]
        formed = of["shock/fully_formed_phase"][()]
        followed = (of["shock/followed"][:] == 1) & (phase >= formed - 1e-9)
        return Layer(file["height"][:], of["centre_of_mass"][:], of["density"][:], of["velocity"][:] - file["plate/velocity"][:][:, None],
                     of["temperature"][:], np.where(followed, shock, np.nan))


def rms(values):
    """Root mean square of what is not NaN."""
    return float(np.sqrt(np.nanmean(np.square(values))))


def differences(ours, reference):
    """Per cent: of z_cm relative at 20 phases; of the fields over the reference's layer and the cycle, of their own rms; of the shock's height above the plate."""
    every = len(reference.z_cm) // PHASES
    inside = reference.density > LAYER
    found = {"z_cm": rms(ours.z_cm[::every] / reference.z_cm[::every] - 1)}
    for name in FIELDS:
        theirs = getattr(reference, name)
        found[name] = rms((getattr(ours, name)[:, :theirs.shape[1]] - theirs)[inside]) / rms(theirs[inside])
    both = np.isfinite(ours.shock) & np.isfinite(reference.shock)
    found["shock_location"] = rms((ours.shock - reference.shock)[both]) / rms(reference.shock[both]) if both.any() else np.nan
    return {name: 100 * value for name, value in found.items()}


def row(study, engine, scheme, knob, value, quantity, error, error_of_error, cost, default, end, command):
    """cost: {cpu_seconds, cpu_low, cpu_high, work, steps}, what is unknown left out."""
    numbers = {"error_percent": error, "error_of_error": error_of_error} | {k: cost.get(k, "") for k in COLUMNS[8:13]}
    numbers = {k: "nan" if v == "" or v is None or not np.isfinite(v) else f"{v:.6g}" if k not in ("work", "steps") else f"{v:.0f}" for k, v in numbers.items()}
    return {"study": study, "engine": engine, "scheme": scheme, "knob": knob, "value": f"{value:g}", "quantity": quantity, **numbers, "default": int(default),
            "end": end, "command": command}


def write_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read_rows(path, as_written=False):
    """Numbers as floats, NaN where there is none; or all as text."""
    with open(path, newline="") as file:
        if as_written:
            return list(csv.DictReader(file))
        return [{k: float(v or "nan") if k in COLUMNS[4:5] + COLUMNS[6:14] else v for k, v in r.items()} for r in csv.DictReader(file)]
