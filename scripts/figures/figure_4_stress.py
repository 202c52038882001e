# SPDX-License-Identifier: MIT
"""Beyond the source: normal stress and its kinetic part against height, and the anisotropy of T, at four phases.

Total normal stress at a height h above the plate from the balance of momentum of all that lies above it, the same for both engines:
P_zz(h) = d/dt M(h) + N(h) - n u (u - u_p), with M and N the momentum and number per area above h (m = g = 1).
"""
import sys

import numpy as np

import run_folder
from run_folder import LAYER_VOLUME_FRACTION
from style import DENSITY, TEMPERATURE, plt, save

NAME = "figure_4_stress"
PHASES = (0.15, 0.22, 0.30, 0.40)
CAPTION = (
    "Left: normal stress P_zz (dark) and its kinetic part n T_z (pale) against height above the plate; right: T_z (dark) and T_x (pale): MD (markers) and continuum (lines, "
    "T_z there differs from T_x by the gradient of u inside a bin alone). The total is from the balance of momentum, so that it holds what collisions carry; bars: one standard error over the runs."
)


def normal_stress(run, density, velocity, index):
    """At the lower edges of the bins, from central differences in time over one sample step each way; arrays (phases, bins)."""
    count = len(run.phase)
    step = 1.0 / (count * run.scene["plate"]["frequency"])
    width = run.height[1] - run.height[0]

    def above(values):
        return np.append(np.cumsum(values[::-1])[::-1], 0.0)[:-1] * width

    velocity = np.where(density > 0, velocity, 0.0)
    momentum = [above(density[i % count] * velocity[i % count]) for i in (index - 1, index + 1)]
    n, u = density[index], velocity[index]
    carried = n * u * (u - run.plate_velocity[index])
    at_edge = 0.5 * (carried + np.append(0.0, carried[:-1]))
    at_edge[0] = 0.0
    return (momentum[1] - momentum[0]) / (2 * step) + above(n) - at_edge


def standard_error(run, index):
    """Of MD's stress, over the runs that were averaged."""
    stresses = [normal_stress(run, density, velocity, index) for density, velocity in run.each_md_run()]
    return np.std(stresses, axis=0, ddof=1) / np.sqrt(len(stresses)) if len(stresses) > 1 else np.full(run.height.shape, np.nan)


def draw(study):
    run = study.run("default")
    figure, axes = plt.subplots(len(PHASES), 2, figsize=(7.0, 10.0), sharey=True)
    columns = {}
    edge = run.height - 0.5 * (run.height[1] - run.height[0])
    for row, ft in zip(axes, PHASES):
        index = run.nearest(ft)
        part = {"ft": np.full(len(edge), ft), "lower edge/sigma": edge}
        for engine, name, color, look in ((run.continuum, "continuum", DENSITY, {"ls": "-"}), (run.md, "MD", TEMPERATURE, {"ls": "none", "marker": "o", "ms": 2.5})):
            enough = engine.volume_fraction[index] > 0.2 * LAYER_VOLUME_FRACTION
            total = np.where(enough, normal_stress(run, engine("density"), engine("velocity"), index), np.nan)
            error = np.where(enough, standard_error(run, index), np.nan) if engine is run.md else None
            tz, tx = (np.where(enough, engine(f"temperature_{axis}")[index], np.nan) for axis in "zx")
            row[0].errorbar(total, edge, xerr=error, color=color, elinewidth=0.8, **look)
            row[0].plot(engine("density")[index] * tz, run.height, color=color, alpha=0.4, **look)
            row[1].plot(tz, run.height, color=color, label=f"$T_z$, {name}", **look)
            row[1].plot(tx, run.height, color=color, alpha=0.4, label=f"$T_x$, {name}", **look)
            if error is not None:
                part |= {f"P_zz {name} error": error}
            part |= {f"P_zz {name}": total, f"n T_z {name}": engine("density")[index] * tz, f"T_z {name}": tz, f"T_x {name}": tx}
        row[0].text(0.95, 0.9, f"$ft = {ft:.2f}$", transform=row[0].transAxes, ha="right")
        row[0].set_ylim(0, 25)
        row[0].set_xlim(left=0)
        row[0].set_ylabel(r"height above the plate$/\sigma$")
        columns = {key: np.append(columns.get(key, []), values) for key, values in part.items()}
    axes[0, 1].legend(fontsize=8)
    axes[-1, 0].set_xlabel(r"$P_{zz}\,\sigma^2/(mg)$")
    axes[-1, 1].set_xlabel(r"$T/(g\sigma)$")
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
