# SPDX-License-Identifier: MIT
"""Where event-driven MD lives and dies: figure_stability_md.py OUT, of scripts/reproduce stability."""
import sys
from pathlib import Path

import numpy as np

from stability_look import THEORY, columns, default, is_known, legend, of_map, read, rows_panel, scatter, theory, title
from style import plt, save

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "workflow"))
from stability_check import FREEZES, MELTS, crystal_pressure, fluid_pressure  # noqa: E402

NAME = "figure_stability_md"
REMEDIES = ("elastic_below", "contact_time", "e(v)")


def collapse(axis, rows):
    rows = of_map(rows, "collapse")
    depths = [row for row in rows if row["y"] not in REMEDIES]
    scatter(axis, depths, lambda row: np.log2(float(row["y"])))
    height = {name: 4.1 + 0.4 * i for i, name in enumerate(REMEDIES)}
    scatter(axis, [row for row in rows if row["y"] in REMEDIES], lambda row: height[row["y"]])
    # A column of N particles on a wall collapses in one dimension where e < tan^2(pi/4 (1 - 1/N)): Bernu and Mazighi 1990.
    layers = np.geomspace(1.05, 13.0, 200)
    axis.plot(np.tan(0.25 * np.pi * (1.0 - 1.0 / layers)) ** 2, np.log2(layers), **THEORY)
    # Free particles: N = ln(4/(1 - e))/(1 - e), McNamara and Young 1992.
    e = np.linspace(0.05, 0.79, 200)
    axis.plot(e, np.log2(np.log(4.0 / (1.0 - e)) / (1.0 - e)), color=THEORY["color"], lw=0.9, ls=":")
    axis.text(0.61, np.log2(5.0), "column of $N = H/\\sigma$ on a wall,\none dimension (dotted: free)", fontsize=8, color=THEORY["color"], va="top")
    ticks = {np.log2(d): str(d) for d in (1, 2, 3, 4, 6, 9)} | {h: name for name, h in height.items()}
    axis.set_yticks(list(ticks), list(ticks.values()), fontsize=8)
    axis.yaxis.set_minor_locator(plt.NullLocator())
    axis.set(xlim=(0.27, 1.03), ylim=(-0.4, 5.3), xlabel="restitution, $e$ (constant) or $e_0$", ylabel=r"depth $H/\sigma$; with remedy, $H = 9$")
    default(axis, 0.9)


def acceleration(axis, rows):
    rows_panel(axis, of_map(rows, "grains_acceleration"))
    marks(axis)


def marks(axis):
    axis.set(xscale="log", xlabel=r"peak acceleration, $\Gamma$", xlim=(0.45, 11))
    axis.set_xticks([0.5, 1, 2, 3, 5, 10], ["0.5", "1", "2", "3", "5", "10"])
    theory(axis, 1.0, "lift-off")
    for periods in (1, 2):
        theory(axis, np.sqrt(1.0 + (periods * np.pi) ** 2), f"plug flies {periods}$T$")


def plug_flight(acceleration):
    """Flight of a body that sticks to the plate, in periods, from the plate's motion alone; mean over 40 flights."""
    if acceleration <= 1.0:
        return 0.0
    flights, instants = [], np.linspace(0.0, 12.0, 48001)
    leaves = np.arcsin(1.0 / acceleration)
    phase = leaves
    for _ in range(40):
        # Heights in g/omega^2, times in 1/omega: the plate is at Gamma sin(phase), from its middle.
        t = 2.0 * np.pi * instants[1:]
        gap = acceleration * (np.sin(phase) + np.cos(phase) * t - np.sin(phase + t)) - 0.5 * t**2
        flight = t[np.argmax(gap < -1e-9)]
        lands = phase + flight
        turned = lands % (2.0 * np.pi)
        # Leaves at once where the plate already falls faster than it would, else waits for the next chance.
        wait = 0.0 if acceleration * np.sin(turned) > 1.0 and np.cos(turned) > 0.0 else (leaves - turned) % (2.0 * np.pi)
        flights.append((flight, flight + wait))
        phase = (lands + wait) % (2.0 * np.pi)
    later = np.array(flights[20:])
    return later[:, 0].sum() / later[:, 1].sum()


def flight(axis, rows):
    for name, look in (("e = 0.9", {"marker": "o", "color": "#0072B2"}), ("e(v), e0 = 0.5", {"marker": "s", "color": "#D55E00", "mfc": "none"})):
        shown = [row for row in of_map(rows, "grains_acceleration") if row["y"] == name and is_known(row["flight/period"])]
        axis.plot([float(row["x"]) for row in shown], [float(row["flight/period"]) for row in shown], ls="none", label=name, **look)
    accelerations = np.geomspace(0.5, 10.0, 300)
    axis.plot(accelerations, [plug_flight(a) for a in accelerations], label="plug that sticks", **THEORY)
    axis.set(ylabel="share of time off the plate", ylim=(-0.03, 1.03))
    axis.legend(fontsize=7, loc="upper left")
    marks(axis)


def packing(axis, rows):
    rows_panel(axis, of_map(rows, "packing"), ["gas", "layer"])
    axis.set(xlabel=r"volume fraction at the start, $\nu$", xlim=(0.0, 0.78))
    theory(axis, np.pi / np.sqrt(18.0), "close packing")
    default(axis, 0.3)


def pressure(axis, rows):
    shown = [row for row in of_map(rows, "packing") if row["y"] == "gas" and is_known(row["pressure"])]
    axis.plot([float(row["x"]) for row in shown], [float(row["pressure"]) for row in shown], "o", color="#0072B2", ms=3.5, zorder=3)
    fluid, crystal = np.linspace(0.02, MELTS, 100), np.linspace(FREEZES, 0.7402, 400)
    axis.plot(fluid, [fluid_pressure(phi) for phi in fluid], **THEORY)
    axis.plot(crystal, [crystal_pressure(phi) for phi in crystal], color=THEORY["color"], lw=1.3, ls="--")
    axis.axvspan(FREEZES, MELTS, color="0.93", zorder=0)
    axis.set(yscale="log", xlim=(0.0, 0.78), xlabel=r"volume fraction, $\nu$", ylabel="$p/(nT)$, $e = 1$")
    axis.text(0.03, 0.92, "full: fluid (Kolafa and others 2004)\ndashed: crystal (Speedy 1998)", transform=axis.transAxes, fontsize=7, va="top")


def draw(folder):
    rows = read(folder)
    figure = plt.figure(figsize=(12.0, 8.6))
    grid = figure.add_gridspec(3, 2, height_ratios=[0.8, 0.8, 1.2], width_ratios=[1, 1.05])
    places = {"a": grid[:, 0], "b": grid[0, 1], "c": grid[1, 1]}
    right = grid[2, 1].subgridspec(2, 1, height_ratios=[0.35, 1.0])
    axes = [figure.add_subplot(place) for place in (*places.values(), right[0], right[1])]
    titles = ("constant restitution: inelastic collapse", "acceleration", "time off the plate, $H = 9$", "packing", "")
    for axis, panel, words, letter in zip(axes, (collapse, acceleration, flight, packing, pressure), titles, "abcd "):
        panel(axis, rows)
        if words:
            title(axis, letter, words)
    legend(figure, rows)
    return save(figure, folder / "figures", NAME, columns([row for row in rows if row["map"] in ("collapse", "grains_acceleration", "packing")]))


if __name__ == "__main__":
    print(draw(Path(sys.argv[1])))
