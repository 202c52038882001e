# SPDX-License-Identifier: MIT
"""Makes the runs of the stability maps, each in a process of its own with a limit on its time, and keeps how it ended and what it left.

OUT/runs/HASH.json, named by the command: {command, code, said, seconds, numbers, series, profile}. A run that is there is not made again.
numbers: mass and energy made, steps, extremes; series: z_cm at each sample instant; profile: the mean density over height.
"""
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time

import h5py
import numpy as np

STOPPED = 75
CPU_BUDGET = 20.0    # seconds after which a run is asked to stop, and does so with a checkpoint and exit code 75
KILLED_AFTER = 60.0  # what has not ended by itself by then hangs; of wall clock twenty times that


def kept_at(out, run):
    return pathlib.Path(out) / "runs" / (hashlib.sha1(run.command().encode()).hexdigest()[:16] + ".json")


def make(root, shaken, out, runs, jobs):
    """All runs, `jobs` at a time; {run: what is kept of it}."""
    (pathlib.Path(out) / "runs").mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return dict(zip(runs, pool.map(lambda run: made(root, shaken, out, run), runs)))


def made(root, shaken, out, run):
    path = kept_at(out, run)
    if path.is_file():
        return json.loads(path.read_text())
    with tempfile.TemporaryDirectory(dir=out, prefix="run_") as folder:
        kept = {"command": run.command()} | ended(root, shaken, run, pathlib.Path(folder) / "run")
    aside = path.with_suffix(".part")
    aside.write_text(json.dumps(kept) + "\n")
    aside.rename(path)
    return kept


def ended(root, shaken, run, folder):
    words = [str(shaken), run.engine, str(root / f"data/scenes/{run.scene}.toml"), "--quiet", "--out", str(folder),
             *(word for change in run.changes for word in ("--set", change))]
    begin = time.monotonic()
    with open(folder.parent / "said", "w+", errors="replace") as stderr:
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=stderr, env=os.environ | {"OMP_NUM_THREADS": "1"})
        code = watched(process, begin)
        stderr.seek(0)
        # Without the paths of this machine.
        said = stderr.read().strip().replace(str(root) + "/", "").replace(str(folder), "DIR")
    kept = {"code": code, "said": said[:2000], "seconds": round(time.monotonic() - begin, 2), "numbers": {}}
    return kept | left_by(run, folder) if code == 0 else kept


def watched(process, begin):
    """Exit code; None of a run that had to be killed. By the time it computed, so that other work on the machine does not count."""
    asked = False
    while True:
        try:
            code = process.wait(timeout=0.05)
            # A tube of an earlier version kept no checkpoint and ended at once when it was asked to.
            return STOPPED if asked and code == -signal.SIGTERM else code
        except subprocess.TimeoutExpired:
            spent = cpu_seconds(process.pid)
        if spent > CPU_BUDGET and not asked:
            process.terminate()
            asked = True
        if spent > KILLED_AFTER or time.monotonic() - begin > 20.0 * KILLED_AFTER:
            process.kill()
            process.wait()
            return None


def cpu_seconds(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def left_by(run, folder):
    if (folder / "verification.csv").is_file():
        return of_tube(folder)
    if run.engine == "continuum":
        return of_layer(folder)
    return of_grains(folder)


def of_tube(folder):
    with open(folder / "verification.csv") as file:
        rows = list(csv.DictReader(file))
    field = {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}
    summary = json.loads((folder / "summary.json").read_text())
    numbers = {"steps": summary["steps"], "largest_fraction": field["volume_fraction"].max(), "least_fraction": field["volume_fraction"].min(),
               "largest_temperature": field["temperature"].max(), "least_temperature": field["temperature"].min(),
               "largest_speed": np.abs(field["velocity"]).max(), "mean_fraction": field["volume_fraction"].mean()}
    if "mean_error" in summary:
        numbers["distance"] = 100.0 * max(summary["mean_error"]["volume_fraction"] or 0.0, summary["mean_error"]["temperature"] or 0.0)
    return {"numbers": as_floats(numbers), "profile": field["volume_fraction"].tolist(), "temperature": field["temperature"].tolist()}


def of_layer(folder):
    with h5py.File(folder / "continuum.h5") as file:
        seen = {name: group["value"][:] for name, group in file["observables"].items()}
        sums, samples = file["profiles/sums"][..., 0].sum(axis=0), file["profiles/samples"][:].sum(axis=0)
        profile = (sums.sum(axis=0) / samples.sum() / (file["profiles/area"][()] * file["profiles/bin_width"][()]))
    initial = seen["energy"][0] - seen["body_force_work"][0] + seen["collisional_loss"][0] - seen["floor_gain"][0] - seen["dual_energy_gain"][0]
    balance = seen["energy"] - (initial + seen["body_force_work"] - seen["collisional_loss"] + seen["floor_gain"] + seen["dual_energy_gain"])
    turned_over = initial + seen["collisional_loss"]
    numbers = {"steps": seen["steps"][-1], "mass_made": worst(seen["mass"] / seen["mass"][0] - 1.0),
               "energy_made": worst(seen["dual_energy_gain"] / turned_over), "floor_gain": worst(seen["floor_gain"] / turned_over),
               "ledger": worst(balance / turned_over), "least_height": seen["centre_of_mass"].min(), "largest_height": seen["centre_of_mass"].max(),
               "largest_energy": seen["energy"].max(), "largest_fraction": profile.max() * np.pi / 6.0, "least_fraction": profile.min() * np.pi / 6.0}
    return {"numbers": as_floats(numbers), "series": seen["centre_of_mass"].tolist(), "profile": profile.tolist()}


def of_grains(folder):
    with h5py.File(folder / "md.h5") as file:
        seen = {name: group["value"][:] for name, group in file["observables"].items()}
        instants = file["observables/kinetic_energy/time"][:]
        places, velocities = file["particles/all/position/value"][-1], file["particles/all/velocity/value"][-1]
        sides = np.diag(file["particles/all/box/edges/value"][-1] if "value" in file["particles/all/box/edges"] else file["particles/all/box/edges"][()])
        periodic = [word in (b"periodic", "periodic") for word in file["particles/all/box"].attrs["boundary"]]
    kinetic = seen["kinetic_energy"] + seen["rotational_energy"]
    lost = seen["collision_loss"] + seen.get("plate_loss", 0.0) + seen.get("ceiling_loss", 0.0)
    gained = seen.get("plate_work", 0.0) + seen.get("ceiling_work", 0.0)
    total = kinetic + seen.get("potential_energy", 0.0)
    initial = (total + lost - gained)[0]
    numbers = {"particles": len(places), "events_per_particle": seen["pair_collisions"][-1] / len(places),
               "ledger": worst((total + lost - gained - initial) / (abs(initial) + lost)), "overlap": deepest_overlap(places, sides, periodic),
               "drift": worst(np.hypot(seen["momentum_x"], seen["momentum_y"]) / (len(places) * np.sqrt(1e-30 + 2.0 * kinetic[0] / len(places)))),
               "largest_speed": np.abs(velocities).max()}
    if "centre_of_mass" in seen:
        # The plate carries the weight, which is 1 a particle, over time; off it, next to nothing.
        force = np.diff(seen["plate_impulse"]) / np.diff(instants) / len(places)
        numbers["flight"] = float(np.mean(force[len(force) // 2:] < 0.02))
        return {"numbers": as_floats(numbers), "series": seen["centre_of_mass"].tolist()}
    measured = {entry["name"]: entry for entry in json.loads((folder / "summary.json").read_text())}
    pressure = measured["compressibility Z = p/(nT)"]
    return {"numbers": as_floats(numbers | {"pressure": pressure["measured"], "pressure_error": pressure["standard_error"]})}


def deepest_overlap(places, sides, periodic):
    """Of any pair, in sigma; 0 where none touch. Independent of the engine's own audit."""
    deepest = 0.0
    for i in range(len(places) - 1):
        apart = places[i + 1:] - places[i]
        for axis in range(3):
            if periodic[axis]:
                apart[:, axis] -= sides[axis] * np.round(apart[:, axis] / sides[axis])
        deepest = max(deepest, 1.0 - float(np.sqrt((apart**2).sum(axis=1).min())))
    return deepest


def worst(values):
    values = np.atleast_1d(values)
    return float(values[np.argmax(np.abs(values))]) if np.isfinite(values).all() else float("nan")


def as_floats(numbers):
    return {key: float(value) for key, value in numbers.items()}
