# SPDX-License-Identifier: MIT
"""Figure 6.3: mean square and order of the MD's pattern beside the Swift-Hohenberg model that fits them."""
import json
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, LENGTH, TEMPERATURE, plt, points, save

NAME = "figure_6_3"
CAPTION = (
    "Figure 6.3. (a) Mean square of the pattern and (b) share of its power in the strongest of 21 directions, against the peak acceleration: MD "
    "(triangles, bars of one standard error; downward: begun from the stripes of 2.2; filled: the spectrum interpolated to polar coordinates, by which one plane wave of the cell has 0.28 and no more) and the noisy Swift-Hohenberg model of the fitted noise (lines), scaled as the fit says. Full upright "
    "line: onset of long-range order in MD; dotted: mean-field onset of the fit. Broken: the source's 2.15 and 1.965."
)
WHITE_NOISE = 0.061  # P_max of white noise averaged over many maps of 21 x 21 bins
PLANE_WAVE = 0.28    # of one wave with two wavelengths along the cell, interpolated (compare/patterns/polar_spectrum.hpp)


def model_at(noise, model):
    """(control, <psi^2>, P_max) at a noise between two of the table, linear in its logarithm."""
    strengths = np.array(sorted({row["noise"] for row in model}))
    curves = {s: np.array([[r["control"], r["mean_square"], r["order"]] for r in model if r["noise"] == s]) for s in strengths}
    above = int(np.clip(np.searchsorted(strengths, noise), 1, len(strengths) - 1))
    low, high = strengths[above - 1], strengths[above]
    share = np.clip(np.log(noise / low) / np.log(high / low), 0, 1)
    mixed = (1 - share) * curves[low] + share * curves[high]
    return mixed[:, 0], curves[low][:, 1] ** (1 - share) * curves[high][:, 1] ** share, mixed[:, 2]


def draw(study):
    fit = json.loads((study.folder / "fit.json").read_text())
    published = tables.published(6)
    rows = tables.merged(tables.rows("ch6_onset_md.csv"))
    gamma, square, square_error, order, order_error = (np.array([row[key] for row in rows]) for key in
                                                       ("value", "mean_square", "mean_square_error", "order", "order_error"))
    control, model_square, model_order = model_at(fit["noise"], tables.rows("ch6_swift_hohenberg.csv"))
    model_gamma = fit["mean_field_onset"] * (1 + control)
    figure, (upper, lower) = plt.subplots(2, 1, figsize=(5.8, 6.8), sharex=True)
    points(upper, gamma, square, y_error=square_error, marker="^", ms=6, color=DENSITY, mfc="none", label="MD")
    upper.plot(model_gamma, fit["scale"] * model_square, color="black", lw=1.2,
               label=f"Swift-Hohenberg, $F$ = {fit['noise']:.2g} ({fit['noise_low']:.2g} to {fit['noise_high']:.2g})")
    upper.set_ylabel(r"$\langle\psi^2\rangle/\sigma^2$")
    points(lower, gamma, order, y_error=order_error, marker="^", ms=6, color=DENSITY, mfc="none")
    lower.plot(model_gamma, model_order, color="black", lw=1.2)
    down = tables.rows("ch6_onset_down_md.csv")
    for axis, key in ((upper, "mean_square"), (lower, "order")):
        points(axis, [row["value"] for row in down], [row[key] for row in down], y_error=[row[f"{key}_error"] for row in down], marker="v", ms=6, color=LENGTH, mfc="none",
               label="MD, from the stripes of 2.2")
    interpolated = [row for row in tables.rows("ch6_onset_md.csv") if tables.is_known(row.get("interpolated_order"))]
    points(lower, *([row[key] for row in interpolated] for key in ("value", "interpolated_order")), y_error=[row["interpolated_order_error"] for row in interpolated],
           marker="^", ms=5, color=TEMPERATURE)
    lower.axhline(PLANE_WAVE, color=TEMPERATURE, lw=0.7)
    lower.text(gamma[0], PLANE_WAVE + 0.01, "a plane wave, interpolated", fontsize=7, color=TEMPERATURE)
    lower.axhline(WHITE_NOISE, color="0.6", lw=0.7)
    lower.text(gamma[0], WHITE_NOISE + 0.01, "white noise", fontsize=7, color="0.4")
    lower.set_ylabel(r"$P_{\max}$")
    lower.set_ylim(0, 1.02)
    lower.set_xlabel(r"peak acceleration $\Gamma$")
    for axis in (upper, lower):
        axis.axvline(fit["onset"], color=DENSITY, lw=0.9)
        axis.axvline(fit["mean_field_onset"], color="black", lw=0.9, ls=":")
        for key in ("onset", "mean_field_onset"):
            axis.axvline(published[key]["value"], color="0.55", lw=0.9, ls="--")
        axis.set_xlim(min(1.65, gamma[0] - 0.05), max(2.35, gamma[-1] + 0.05))
    top = upper.secondary_xaxis("top", functions=(lambda g: g / fit["mean_field_onset"] - 1, lambda e: fit["mean_field_onset"] * (1 + e)))
    top.set_xlabel(r"$\epsilon = (\Gamma - \Gamma_{MF})/\Gamma_{MF}$")
    upper.tick_params(top=False, which="both")
    upper.legend(loc="upper left", fontsize=8)
    upper.set_ylim(0, 1.15 * max(square.max(), 0.1))
    count = len(gamma) + len(down) + len(control)
    by_polar = {row["value"]: row["interpolated_order"] for row in interpolated}
    return save(figure, study.figures, NAME, {
        "of": ["MD"] * len(gamma) + ["MD from stripes"] * len(down) + ["model"] * len(control), "Gamma": [*gamma, *(row["value"] for row in down), *model_gamma],
        "mean square/sigma^2": [*square, *(row["mean_square"] for row in down), *(fit["scale"] * model_square)],
        "error": [*square_error, *(row["mean_square_error"] for row in down), *[np.nan] * len(control)],
        "P_max": [*order, *(row["order"] for row in down), *model_order], "P_max error": [*order_error, *(row["order_error"] for row in down), *[np.nan] * len(control)],
        "P_max interpolated": [*[by_polar.get(g, np.nan) for g in gamma], *(row["interpolated_order"] for row in down), *[np.nan] * len(control)],
        "F": [fit["noise"]] * count, "Gamma_MF": [fit["mean_field_onset"]] * count})


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
