# SPDX-License-Identifier: MIT
"""Where the schemes of the continuum live and die: figure_stability_continuum.py OUT, of scripts/reproduce stability."""
import sys
from pathlib import Path

import numpy as np

from stability_look import THEORY, columns, default, legend, of_map, read, rows_panel, scatter, theory, title
from style import plt, save

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "workflow"))
from gas_at_rest import NU_MAX, Gas  # noqa: E402

NAME = "figure_stability_continuum"
SPLIT = 0.02
QUIET, THIN, THIN_SPACING, REST_FACTOR = Gas(0.2), Gas(1e-4), 0.2, 0.04  # the gases of scripts/workflow/stability_points.py


def courant(axis, rows):
    rows_panel(axis, of_map(rows, "cfl"))
    axis.axvspan(1.0, 2.1, color="0.93", zorder=0)
    axis.set(xlim=(0, 2.1), xlabel="Courant number, continuum.cfl")
    theory(axis, 1.0, "limit of an unsplit scheme")
    default(axis, 0.8)


def diffusion(axis, rows):
    rows_panel(axis, of_map(rows, "diffusion"))
    axis.set(xscale="log", xlabel="diffusion factor of ftcs, $s$")
    theory(axis, QUIET.diffusion_limit(), r"$D\,\Delta t/h^2 = 1/2$")
    default(axis, 0.16)


def spacing(axis, rows):
    rows_panel(axis, of_map(rows, "spacing_horizontal"))
    axis.set(xscale="log", xlabel=r"spacing across columns, $\Delta x/\sigma$")
    default(axis, 2.0)


def fraction(axis, rows):
    """Two scales side by side: decades where it is dilute, even ones where it is dense."""
    rows = of_map(rows, "volume_fraction")
    names = list(dict.fromkeys(row["y"] for row in rows))
    grid = axis.get_subplotspec().subgridspec(1, 2, width_ratios=[1.0, 1.5], wspace=0.03)
    thin, dense = (axis.figure.add_subplot(place) for place in grid)
    axis.remove()
    rows_panel(thin, [row for row in rows if float(row["x"]) <= SPLIT], names)
    rows_panel(dense, [row for row in rows if float(row["x"]) > SPLIT], names)
    thin.set(xscale="log", xlim=(4e-9, 2.5e-2))
    dense.set(xlim=(0.0, 0.73), yticklabels=[])
    dense.set_xlabel(r"volume fraction at the start, $\nu$", x=0.2)
    theory(dense, NU_MAX, "packing")
    default(dense, 0.3)
    return thin


def restitution(axis, rows):
    rows_panel(axis, of_map(rows, "restitution"))
    axis.set(xlabel=r"restitution, $e$ or $e_0$")
    default(axis, 0.9)


def acceleration(axis, rows):
    rows_panel(axis, of_map(rows, "acceleration"))
    axis.set(xscale="log", xlabel=r"peak acceleration, $\Gamma$")
    axis.set_xticks([0.5, 1, 2, 3, 5, 10], ["0.5", "1", "2", "3", "5", "10"])
    theory(axis, 1.0, "lift-off")
    for periods in (1, 2):
        theory(axis, np.sqrt(1.0 + (periods * np.pi) ** 2), f"plug flies {periods}$T$")


def upper_end(axis, rows):
    rows_panel(axis, of_map(rows, "upper_end"))
    axis.set(xlabel=r"peak acceleration, $\Gamma$", xlim=(0.9, 8.3))
    theory(axis, 1.0, "lift-off")


def reynolds(axis, rows):
    shown = [row | {"x": QUIET.cell_reynolds(float(row["x"]))} for row in of_map(rows, "cell_reynolds")]
    scatter(axis, shown, lambda row: float(row["y"]))
    spacings = np.geomspace(0.04, 10.0, 80)
    numbers = QUIET.cell_reynolds(spacings)
    axis.plot(numbers, [QUIET.largest_factor(h) for h in spacings], **THEORY)
    axis.plot(numbers, [QUIET.convection_limit(h) for h in spacings], color=THEORY["color"], lw=0.9, ls=":")
    axis.set(xscale="log", yscale="log", ylim=(0.015, 1.3), xlim=(0.08, 20), xlabel=r"cell Reynolds number of sound, $c h/D$  (dotted: $\Delta t = 2D/c^2$)", ylabel="diffusion factor, $s$")
    axis.axhline(0.16, color="0.35", lw=0.9, ls=(0, (2, 2)))


def artificial(axis, rows):
    all_rows = of_map(rows, "artificial_dissipation")
    tube = [row for row in all_rows if not row["y"].startswith("gas")]
    scatter(axis, tube, lambda row: np.log10(float(row["y"])))
    strengths = np.linspace(0.0, 0.5, 60)
    limits = [THIN.largest_factor(THIN_SPACING, strength) for strength in strengths]
    axis.plot(strengths, np.log10(np.maximum(limits, 0.004)), **THEORY)
    heights = {f"gas at rest, {d}D": 0.15 + 0.25 * d for d in (1, 2, 3)}
    scatter(axis, [row for row in all_rows if row["y"] in heights], lambda row: heights[row["y"]])
    for d, height in zip((1, 2, 3), heights.values()):
        axis.plot([(0.5 / d - 2.0 / 3.0 * REST_FACTOR) / np.exp(-200.0 * THIN.fraction)] * 2, [height - 0.1, height + 0.1], **THEORY)
    axis.text(0.72, 0.36, "$1/(2d) - 2s/3$", fontsize=8, color=THEORY["color"])
    ticks = {np.log10(s): f"tube, $s$ = {s}" for s in (0.02, 0.08, 0.16, 0.32, 0.5)} | {height: name for name, height in heights.items()}
    axis.set_yticks(list(ticks), list(ticks.values()), fontsize=8)
    axis.yaxis.set_minor_locator(plt.NullLocator())
    axis.set(xlim=(-0.04, 1.04), ylim=(-1.85, 1.05), xlabel=r"artificial dissipation, $C_\mathrm{AD}$")
    default(axis, 0.1)


def draw(folder):
    rows = read(folder)
    figure, axes = plt.subplots(5, 2, figsize=(12.0, 18.0), gridspec_kw={"height_ratios": [1.25, 0.95, 0.7, 1.1, 1.3]})
    panels = (courant, fraction, restitution, acceleration, diffusion, spacing, reynolds, artificial, upper_end)
    titles = ("Courant number", "dilute to dense", "restitution", "acceleration", "ftcs: explicit diffusion", "finite volumes: narrow columns",
              "ftcs without artificial dissipation, gas at rest", "ftcs: artificial dissipation", "the end above a layer")
    for axis, panel, words, letter in zip(axes.flat, panels, titles, "abcdefghi"):
        title(panel(axis, rows) or axis, letter, words)
    axes.flat[-1].remove()
    legend(figure, rows)
    shown = [row for row in rows if row["map"] in {"cfl", "diffusion", "spacing_horizontal", "volume_fraction", "restitution", "acceleration",
                                                  "cell_reynolds", "artificial_dissipation", "upper_end"}]
    return save(figure, folder / "figures", NAME, columns(shown))


if __name__ == "__main__":
    print(draw(Path(sys.argv[1])))
