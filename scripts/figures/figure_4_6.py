# SPDX-License-Identifier: MIT
"""Figure 4.6: mean speed of one shock against the restitution coefficient, from one state at ft = -0.33."""
import sys

import numpy as np

import run_folder
from style import DENSITY, TEMPERATURE, plt, points, save

NAME = "figure_4_6"
RESTITUTIONS = (0.75, 0.80, 0.85, 0.90, 0.95, 0.99, 1.00)
SPEEDS = (("mean_speed", "from formation", 1.0, "o"), ("fully_formed_speed", "from full formation", 0.45, "s"))
CAPTION = (
    "Figure 4.6. Mean speed of the shock in the frame of the plate until it leaves the layer, against e: MD (markers, mean over 16 states, "
    "bars of one standard error) and continuum (lines, bands of the grid error). From its formation (dark) and from full formation (pale). Left axis in "
    "sqrt(g sigma), right axis in diameters a cycle."
)


def draw(study):
    figure, axis = plt.subplots(figsize=(5.6, 4.4))
    summaries = {e: (study.summary(f"e{e:.2f}"), study.summary(f"e{e:.2f}_fine")) for e in RESTITUTIONS}
    summaries = {e: both for e, both in summaries.items() if "md" in both[0]}
    e = np.array(list(summaries))
    columns = {"e": e}

    def number(engine, key, which=0):
        values = [both[which][engine]["shock"].get(key) for both in summaries.values()]
        return np.array([np.nan if value is None else value for value in values])

    for key, words, alpha, marker in SPEEDS:
        continuum = number("continuum", key)
        grid = 4 / 3 * np.abs(continuum - number("continuum", key, 1))
        axis.plot(e, continuum, color=DENSITY, alpha=alpha, label=f"continuum, {words}")
        axis.fill_between(e, continuum - grid, continuum + grid, color=DENSITY, alpha=0.2 * alpha, lw=0)
        points(axis, e, number("md", key), y_error=number("md", key + "_error"), marker=marker, color=TEMPERATURE, alpha=alpha, label=f"MD, {words}")
        columns |= {f"MD {words}/sqrt(g sigma)": number("md", key), f"MD {words} error": number("md", key + "_error"),
                    f"continuum {words}/sqrt(g sigma)": continuum, f"continuum {words} grid error": grid}
    frequency = study.run(f"e{e[0]:.2f}").scene["plate"]["frequency"]
    axis.set_ylim(0, 22)
    a_cycle = axis.secondary_yaxis("right", functions=(lambda v: v / frequency, lambda v: v * frequency))
    a_cycle.set_ylabel(r"$v_\mathrm{shock}/(f\sigma)$")
    axis.tick_params(axis="y", which="both", right=False)
    axis.set_xlabel(r"$e$")
    axis.set_ylabel(r"$v_\mathrm{shock}/\sqrt{g\sigma}$")
    axis.legend(loc="upper left", fontsize=8)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
