# SPDX-License-Identifier: MIT
"""The motion that figures 5.3 to 5.10 show, as curves over two cycles: landing, shock, the sloshing it turns round, and the wave that the sloshing makes."""
import sys

import numpy as np

import run_folder
from slices import Stripes
from stripe_motion import crossings, motion
from style import DENSITY, LENGTH, PLATE, TEMPERATURE, plt, save

NAME = "figure_5_sloshing"
CAPTION = (
    "Two cycles of stripes, f* = 0.4174. (a) Where the layer is: its lowest and highest thousandth of mass, and the plate. (b) Share of the mass below the hottest height of its lowest 95 per cent: the shock passes from the plate through the layer. "
    "(c) Sloshing: amplitude of the horizontal velocity of the layer, positive away from the peaks of ft = 0. (d) Amplitude of the wave of z_cm. The velocity turns round while the shock passes; the wave, 0.3 to 0.4 of a cycle later."
)
RUNS = (("MD", "md_stripes", "md", DENSITY), ("continuum", "continuum_stripes", "continuum", TEMPERATURE), ("a fluid's transport", "continuum_fluid", "continuum", LENGTH))


def curves(stripes):
    """Phases of two cycles, and each part of the motion at them."""
    ft = np.array(sorted(stripes.times))
    found = [motion(stripes, time) for time in ft]
    return ft, {part: np.array([at[part] for at in found]) for part in found[0]}


def draw(study):
    figure, axes = plt.subplots(4, 1, figsize=(6.6, 9.0), sharex=True, height_ratios=(1.3, 1, 1, 1))
    columns = {}
    for label, run, engine, colour in RUNS:
        stripes = Stripes(study.folder / "runs" / run, engine)
        ft, parts = curves(stripes)
        plate = np.array([stripes.plate(time) for time in ft])
        look = {"color": colour, "lw": 1.1, "label": rf"{label}, $\Gamma$ = {stripes.gamma:g}"}
        for end in ("foot", "crest"):
            axes[0].plot(ft, plate + parts[end], **(look if end == "foot" else look | {"label": None}))
        axes[0].plot(ft, plate, color=PLATE, lw=2.0 if engine == "md" else 0.8, ls="-" if engine == "md" else ":")
        for axis, part in zip(axes[1:], ("mass below the hottest", "sloshing", "height wave")):
            axis.plot(ft, parts[part], **look)
        turned = crossings(ft, parts["sloshing"])
        axes[2].plot(turned, np.zeros(len(turned)), "o", ms=4, color=colour)
        for name, values in {"engine": [label] * len(ft), "Gamma": [stripes.gamma] * len(ft), "ft": ft, "plate/sigma": plate, **parts}.items():
            columns.setdefault(name, []).extend(values)
    for axis, label, letter in zip(axes, (r"$z/\sigma$", "mass below the\nhottest height", r"sloshing, $\sqrt{g\sigma}$", r"wave of $z_{cm}$, $\sigma$"), "abcd"):
        axis.set_ylabel(label)
        axis.text(0.01, 0.97, f"({letter})", transform=axis.transAxes, va="top", fontsize=9)
    for axis in axes[2:]:
        axis.axhline(0, color="0.5", lw=0.8)
    axes[0].legend(loc="center right", bbox_to_anchor=(1, 0.72), fontsize=8)
    axes[3].set_xlabel("$ft$")
    axes[3].set_xlim(0, 2)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
