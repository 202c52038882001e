# SPDX-License-Identifier: MIT
"""The timings behind the charts of work and precision: CPU nanoseconds a cell update or a collision, of every point."""
import sys

import numpy as np

from style import plt, save
from work_precision_chart import columns_of, main, select, sign

NAME = "figure_timings"
CAPTION = "CPU seconds over work of every point: median of the repeats, bars from the tenth to the ninetieth percentile. How far the timings behind the charts scatter."


def draw(rows, folder, signature):
    groups = {}
    for r in rows:
        if np.isfinite(r["cpu_seconds"]) and r["work"] > 0:
            label = f"{r['study']} {r['scheme']}"
            groups.setdefault(label, {})[r["command"]] = r
    figure, axis = plt.subplots(figsize=(8.0, 0.32 * len(groups) + 1.6))
    shown = []
    for place, (label, points) in enumerate(sorted(groups.items())):
        ordered = sorted(points.values(), key=lambda r: r["work"])
        for i, r in enumerate(ordered):
            height = place + 0.6 * (i / max(1, len(ordered) - 1) - 0.5)
            each = np.array([r["cpu_low"], r["cpu_seconds"], r["cpu_high"]]) / r["work"] * 1e9
            axis.plot(each[[0, 2]], [height, height], color="0.5", lw=1)
            axis.plot(each[1], height, "o", color="black", ms=3)
            shown.append(r)
    axis.set_xscale("log")
    axis.set_yticks(range(len(groups)), sorted(groups), fontsize=8)
    axis.tick_params(axis="y", which="both", length=0)
    axis.set_xlabel("CPU nanoseconds a cell update (continuum) or a collision (MD); in a row the smallest run is lowest")
    sign(figure, signature)
    return save(figure, folder, NAME, columns_of(shown))


if __name__ == "__main__":
    sys.exit(main(draw))
