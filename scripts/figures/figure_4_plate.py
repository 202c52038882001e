# SPDX-License-Identifier: MIT
"""Beyond the source: force on the plate and energy that the plate takes out of the layer, against phase, and the ledger of one cycle."""
import json
import sys

import h5py
import numpy as np

import run_folder
from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "figure_4_plate"
CAPTION = (
    "Force on the plate per area (upper), energy lost in collisions with the plate per area and time, which is the heat flux into it "
    "(middle), and collisional loss in the layer per area and time (lower), against phase: MD (markers, bars of one standard error over six seeds) and continuum "
    "(lines, lighter: half the spacing). The continuum lets no heat through the plate. Dotted: the layer's weight."
)
PER_CYCLE = ("plate_work", "collision_loss", "plate_loss")


def rates(path, names, per_area):
    """Mean rate of each growing quantity over the averaged cycles, between one sample instant and the next: {name: (phases)}."""
    with h5py.File(path) as file:
        scene = run_folder.tomllib.loads(file["provenance/scene"][()].decode())
        phases, settle = scene["sample"]["phases"], scene["sample"]["settle"]
        step = 1.0 / (phases * scene["plate"]["frequency"])
        area = scene["box"]["x"] * scene["box"]["y"] if per_area else 1.0
        found = {}
        for name in names:
            total = file[f"observables/{name}/value"][()][settle * phases:]
            cycles = (len(total) - 1) // phases
            change = np.diff(total)[:cycles * phases].reshape(cycles, phases)
            found[name] = change.mean(axis=0) / step / area
        return found, scene, step


def draw(study):
    runs = study.summary("default")["runs"]
    names = ("plate_impulse", "plate_loss", "collision_loss", "plate_work")
    each = [rates(f"{run}/md.h5", names, True) for run in runs["md"]]
    _, scene, step = each[0]
    md = {name: np.array([found[name] for found, _, _ in each]) for name in names}
    continuum = rates(f"{runs['continuum']}/continuum.h5", ("plate_impulse", "collisional_loss"), False)[0]
    finer = rates(f"{study.summary('dz_0.1')['runs']['continuum']}/continuum.h5", ("plate_impulse", "collisional_loss"), False)[0]
    weight = scene["particles"]["number"] / (scene["box"]["x"] * scene["box"]["y"])
    phases = len(continuum["plate_impulse"])
    phase = (np.arange(phases) + 0.5) / phases
    mean = {name: values.mean(axis=0) for name, values in md.items()}
    error = {name: values.std(axis=0, ddof=1) / np.sqrt(len(values)) for name, values in md.items()}
    sign = {"md": np.sign(mean["plate_impulse"].sum()), "continuum": np.sign(continuum["plate_impulse"].sum())}
    force, force_error = sign["md"] * mean["plate_impulse"], error["plate_impulse"]
    of_continuum = sign["continuum"] * continuum["plate_impulse"]

    figure, axes = plt.subplots(3, 1, figsize=(5.8, 8.4), sharex=True)
    axes[0].plot(phase, of_continuum, color=DENSITY)
    axes[0].plot(phase, sign["continuum"] * finer["plate_impulse"], color=DENSITY, alpha=0.4, lw=1)
    points(axes[0], phase, force, y_error=force_error, marker="o", ms=2.5, color=TEMPERATURE)
    axes[0].axhline(weight, color="0.5", lw=0.8, ls=":")
    axes[0].set_ylabel(r"force$\cdot\sigma^2/(mg)$")
    points(axes[1], phase, mean["plate_loss"], y_error=error["plate_loss"], marker="o", ms=2.5, color=TEMPERATURE)
    axes[1].axhline(0.0, color=DENSITY)
    axes[1].set_ylabel(r"heat flux into the plate")
    axes[2].plot(phase, continuum["collisional_loss"], color=DENSITY, label="continuum")
    points(axes[2], phase, mean["collision_loss"], y_error=error["collision_loss"], marker="o", ms=2.5, color=TEMPERATURE, label="MD")
    axes[2].set_ylabel("collisional loss")
    axes[2].set_xlabel(r"$ft$")
    axes[2].set_xlim(0, 1)
    axes[2].legend()
    write_ledger(study, md, sign["continuum"] * continuum["plate_impulse"], continuum["collisional_loss"], scene, step, weight, sign["md"])
    return save(figure, study.figures, NAME, {
        "ft": phase, "force MD": force, "force MD error": force_error, "force continuum": of_continuum,
        "force continuum, half the spacing": sign["continuum"] * finer["plate_impulse"],
        "heat flux into the plate MD": mean["plate_loss"], "heat flux MD error": error["plate_loss"],
        "collisional loss MD": mean["collision_loss"], "collisional loss MD error": error["collision_loss"],
        "collisional loss continuum": continuum["collisional_loss"],
    })


def write_ledger(study, md, force, loss, scene, step, weight, sign):
    """Energies of one cycle a particle, m g sigma: figures/ledger.json. The plate's work on the continuum is force times velocity."""
    period = 1.0 / scene["plate"]["frequency"]
    amplitude = scene["plate"]["acceleration"] * (period / (2 * np.pi)) ** 2
    phases = len(force)
    height = amplitude * (1 - np.cos(2 * np.pi * np.arange(phases + 1) / phases))
    per_particle = step / weight
    ledger = {"md": {}, "continuum": {"plate_work": float((force * np.diff(height)).sum() / weight),
                                      "collision_loss": float(loss.sum() * per_particle), "plate_loss": 0.0,
                                      "mean_force_over_weight": float(force.mean() / weight), "peak_force": float(force.max()),
                                      "peak_phase": float((np.argmax(force) + 0.5) / phases)}}
    for name in PER_CYCLE:
        values = md[name].sum(axis=1) * per_particle
        ledger["md"][name], ledger["md"][name + "_error"] = float(values.mean()), float(values.std(ddof=1) / np.sqrt(len(values)))
    pushed = sign * md["plate_impulse"]
    peak = pushed.max(axis=1)
    ledger["md"] |= {"mean_force_over_weight": float(pushed.mean() / weight), "peak_force": float(peak.mean()),
                     "peak_force_error": float(peak.std(ddof=1) / np.sqrt(len(peak))), "peak_phase": float((np.argmax(pushed.mean(axis=0)) + 0.5) / phases)}
    study.figures.mkdir(parents=True, exist_ok=True)
    (study.figures / "ledger.json").write_text(json.dumps(ledger, indent=1) + "\n")


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
