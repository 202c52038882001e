# SPDX-License-Identifier: MIT
"""Work and precision (b): statistical error of the MD against CPU seconds, and against collisions, over cycles, seeds and the width of the box."""
import sys

from matplotlib.ticker import NullFormatter

from style import DENSITY, LENGTH, TEMPERATURE, plt, save
from work_precision_chart import column, columns_of, curve, guide, label_values, main, select, sign

NAME = "figure_statistics"
KNOBS = {"cycles": ("o", "-", TEMPERATURE, "cycles (20 x 20, one seed)"), "seeds": ("D", "--", DENSITY, "seeds of 10 cycles (20 x 20)"),
         "width": ("s", ":", LENGTH, "width of the box (30 cycles, one seed)")}
PANELS = (("z_cm", r"$z_{cm}(ft)$"), ("temperature", r"$T(z, ft)$ over the layer"), ("density", r"$n(z, ft)$ over the layer"), ("shock_location", "height of the shock"))
AXES = (("cpu_seconds", "CPU seconds, settling included"), ("work", "collisions, settling included"))
FLOORS = (("floor_width", 10, "-", "box 10 wide"), ("floor_width", 20, "--", "box 20 wide"), ("floor_bin", 0.5, ":", "bins of 0.5"))
CAPTION = (
    "Statistical error of the MD on ch4_shock, per cent: rms distance of shorter runs from the mean of all long ones. It falls as the square root of the averaged cycles "
    "(dashed guide); 15 cycles of settling are paid first. Horizontal lines: what does not fall, the distance of a narrow box's mean from that of the widest, and what bins lose."
)


def panel(axis, rows, quantity, x, with_labels):
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.xaxis.set_minor_formatter(NullFormatter())
    shown = []
    for knob, (marker, line, colour, _) in KNOBS.items():
        one = select(rows, quantity=quantity, knob=knob)
        curve(axis, one, x, marker=marker, color=colour, ls=line, mfc=colour if knob == "cycles" else "white")
        if with_labels:
            label_values(axis, one, x, {"cycles": "", "seeds": "x", "width": ""}[knob], xytext=(4, 4), color=colour)
        shown += one
    for knob, value, line, words in FLOORS:
        for r in select(rows, quantity=quantity, knob=knob, value=value):
            if not r["error_percent"] > 0:
                continue
            axis.axhline(r["error_percent"], color="0.45", lw=0.9, ls=line)
            axis.axhspan(max(r["error_percent"] - r["error_of_error"], 1e-9), r["error_percent"] + r["error_of_error"], color="0.5", alpha=0.15, lw=0)
            axis.annotate(words, (0.01, r["error_percent"]), xycoords=("axes fraction", "data"), textcoords="offset points", xytext=(2, 2), fontsize=6.5, color="0.35")
            shown.append(r)
    known = column([r for r in shown if r["error_percent"] > 0], "error_percent")
    axis.set_ylim(known.min() / 2, known.max() * 2)
    costs = column(select(rows, quantity=quantity, knob="cycles"), x)
    guide(axis, (costs[-3], known.max()), -0.5, "cost$^{-1/2}$", 0.8)
    return shown


def draw(rows, folder, signature):
    rows = select(rows, study="md")
    figure, axes = plt.subplots(2, len(PANELS), figsize=(14.0, 7.4), sharey="col")
    shown = []
    for i, (quantity, title) in enumerate(PANELS):
        for j, (x, words) in enumerate(AXES):
            drawn = panel(axes[j, i], rows, quantity, x, j == 0)
            axes[j, i].set_xlabel(words)
        axes[0, i].set_title(title)
        shown += drawn
    for axis in axes[:, 0]:
        axis.set_ylabel("error, %")
    handles = [plt.Line2D([], [], color=colour, marker=marker, ls=line, label=words) for marker, line, colour, words in KNOBS.values()]
    handles += [plt.Line2D([], [], color="0.45", ls=line, lw=0.9, label=words) for *_, line, words in FLOORS]
    handles += [plt.Line2D([], [], color="black", marker="o", mfc="none", ls="none", ms=9, label="default")]
    figure.legend(handles=handles, ncols=7, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    sign(figure, signature)
    return save(figure, folder, NAME, columns_of(shown))


if __name__ == "__main__":
    sys.exit(main(draw))
