# SPDX-License-Identifier: MIT
"""How well the fit of chapter 6 finds a noise that is known: fields of the Swift-Hohenberg model, each seed by itself."""
import csv
import json
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "figure_6_scatter"
CAPTION = (
    "Noise F and mean-field onset that the fit of figure 6.4 finds for fields of the Swift-Hohenberg model itself, whose noise is 1.2e-2 and whose onset stands at Gamma = 1.965 (cross): one point a seed, bars of one standard error as the fit says; "
    "averages over 2000 steps, as the source's, and over 12,000. Grey: the source's errors. Filled: the fit of the MD's rows."
)


def draw(study):
    with open(study.folder / "scatter.csv", newline="") as file:
        found = [{key: float(cell) for key, cell in row.items()} for row in csv.DictReader(file)]
    fit = json.loads((study.folder / "fit.json").read_text())
    published = tables.published(6)
    figure, axis = plt.subplots(figsize=(5.8, 4.4))
    noise, onset = published["noise"], published["mean_field_onset"]
    axis.axhspan(noise["value"] - noise["tolerance"], noise["value"] + noise["tolerance"], color="0.9", lw=0)
    axis.axvspan(onset["value"] - onset["tolerance"], onset["value"] + onset["tolerance"], color="0.9", lw=0)
    axis.plot(onset["value"], noise["value"], "x", color="black", ms=9, mew=1.6, label="put in (the source's)")
    lengths = sorted({row["steps"] for row in found})
    for steps, marker, colour in zip(lengths, ("o", "s"), (TEMPERATURE, DENSITY)):
        some = [row for row in found if row["steps"] == steps]
        middle, low, high = (np.array([row[key] for row in some]) for key in ("noise", "noise_low", "noise_high"))
        points(axis, [row["mean_field_onset"] for row in some], middle, x_error=[row["mean_field_onset_error"] for row in some],
               y_error=[np.maximum(middle - low, 0), np.maximum(high - middle, 0)], marker=marker, ms=5, color=colour, mfc="white", label=f"found, {steps:,.0f} steps")
    points(axis, [fit["mean_field_onset"]], [fit["noise"]], x_error=[fit["mean_field_onset_error"]], y_error=[[fit["noise"] - fit["noise_low"]], [fit["noise_high"] - fit["noise"]]],
           marker="^", ms=8, color="black", label="found of the MD")
    axis.set_yscale("log")
    axis.set_xlabel(r"mean-field onset $\Gamma_{MF}$")
    axis.set_ylabel(r"strength of the noise $F$")
    axis.legend(fontsize=8)
    return save(figure, study.figures, NAME, {name: [row[name] for row in found] for name in found[0]})


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
