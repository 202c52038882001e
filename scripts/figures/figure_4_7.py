# SPDX-License-Identifier: MIT
"""Figure 4.7: shock and centre of mass in MD, constant e = 0.9 against e(v_n) with e0 = 0.9."""
import sys

import numpy as np

import run_folder
from figure_4_2b import START, in_layer
from style import DENSITY, PLATE, TEMPERATURE, plt, points, save

NAME = "figure_4_7"
CAPTION = (
    "Figure 4.7. Shock location (red) and centre of mass (blue) in MD over one cycle: constant e = 0.9 (open) and e(v_n) with e0 = 0.9 "
    "(crosses); six seeds each, bars of one standard error. Thick line: the plate. Below: difference of the two laws."
)


def draw(study):
    constant, law = study.run("default"), study.run("law")
    count = len(constant.phase)
    first = int(np.ceil((START % 1.0) * count - 1e-9))
    order = (first + np.arange(count)) % count
    phase = constant.phase[order] - (order >= first)
    plate = constant.plate_height[order]
    some = slice(None, None, max(1, count // 50))
    figure, (axis, below) = plt.subplots(2, 1, figsize=(6.0, 6.0), sharex=True, height_ratios=(2.2, 1))
    axis.plot(phase, plate, color=PLATE, lw=3)
    axis.text(phase[-1], plate[-1] - 1, "plate", ha="right", va="top", fontsize=9)
    columns = {"ft": phase}
    for what, color, words in (("centre_of_mass", DENSITY, "centre of mass"), ("shock/location", TEMPERATURE, "shock")):
        lift = plate if what == "shock/location" else 0.0
        values, errors = {}, {}
        for run, name, look in ((constant, "constant e", {"marker": "o", "mfc": "none"}), (law, "e(v)", {"marker": "x"})):
            values[name] = (in_layer(run.md) if what == "shock/location" else run.md(what))[order] + lift
            errors[name] = run.md.error(what)[order]
            points(axis, phase[some], values[name][some], y_error=errors[name][some], color=color, label=f"{words}, {name}", **look)
            columns |= {f"{words} {name}/sigma": values[name], f"{words} {name} error/sigma": errors[name]}
        points(below, phase[some], (values["e(v)"] - values["constant e"])[some], y_error=np.hypot(*errors.values())[some], marker=".", color=color)
    below.axhline(0, color="0.5", lw=0.8, ls=":")
    below.set_ylabel(r"difference$/\sigma$")
    below.set_xlabel(r"$ft$")
    below.set_ylim(-2, 2)
    axis.set_ylabel(r"height $z/\sigma$")
    axis.set_xlim(phase[0], phase[-1])
    axis.set_ylim(0, 40)
    axis.legend(loc="upper left", fontsize=8, ncols=2)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
