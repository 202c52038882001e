# SPDX-License-Identifier: MIT
"""Figure 6.4: squared residual of the Swift-Hohenberg fit against the strength of its noise."""
import json
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, TEMPERATURE, plt, save

NAME = "figure_6_4"
CAPTION = (
    "Figure 6.4. Mean squared difference of <psi^2> between MD and the Swift-Hohenberg model below the onset of order, best scale for each strength "
    "of noise F. Band: the middle 68 per cent of F over bootstrap draws of blocks of cycles and seeds; broken line and grey band: the source's (1.2 +- 0.2)e-2."
)


def draw(study):
    fit = json.loads((study.folder / "fit.json").read_text())
    noise, residual = (np.array([np.nan if r[key] is None else r[key] for r in fit["residuals"]]) for key in ("noise", "residual"))
    published = tables.published(6)["noise"]
    figure, axis = plt.subplots(figsize=(5.4, 4.0))
    axis.axvspan(published["value"] - published["tolerance"], published["value"] + published["tolerance"], color="0.88", lw=0)
    axis.axvline(published["value"], color="0.5", lw=0.9, ls="--", label="source")
    axis.axvspan(fit["noise_low"], fit["noise_high"], color=TEMPERATURE, alpha=0.15, lw=0)
    axis.axvline(fit["noise"], color=TEMPERATURE, lw=1.0, label=f"best, $F$ = {fit['noise']:.2g}")
    axis.plot(noise, residual, "o-", color=DENSITY, lw=1.0, mfc="none")
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlabel(r"strength of the noise $F$")
    axis.set_ylabel(r"$R^2$ of $\langle\psi^2\rangle$, $\sigma^4$")
    axis.legend()
    return save(figure, study.figures, NAME, {"F": noise, "residual/sigma^4": residual})


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
