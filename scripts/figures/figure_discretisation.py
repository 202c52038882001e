# SPDX-License-Identifier: MIT
"""Work and precision (a): error of the continuum's discretisation against CPU seconds, and against cell updates, one knob a curve."""
import sys

from style import DENSITY, LENGTH, TEMPERATURE, plt, save
from work_precision_chart import columns_of, curve, floor, guide, label_values, main, select, sign

NAME = "figure_discretisation"
SCHEMES = {"muscl": ("o", DENSITY), "weno5": ("s", LENGTH), "ftcs": ("^", TEMPERATURE)}
KNOBS = {"dz": "-", "dx": "--", "cfl": ":"}
PANELS = (("ch4_shock", "z_cm", r"layer (ch4_shock): $z_{cm}(ft)$"), ("ch4_shock", "temperature", r"layer (ch4_shock): $T(z, ft)$"),
          ("stripes", "wave", "strip (ch5_growth): the wave"), ("riemann", "density", "Riemann problem: density"))
AXES = (("cpu_seconds", "CPU seconds of a run"), ("work", "cell updates of a run"))
# A run costs h^-2 in one dimension when steps follow the spacing, so an error h^p falls with the power -p/2 of the cost.
GUIDES = {"ch4_shock": ((-0.5, "$h^1$"), (-1.0, "$h^2$")), "riemann": ((-0.5, "$h^1$"),), "stripes": ((-1.0, r"$\Delta z^2$"), (-2.0, r"$\Delta x^2$"))}
LEAST_RANGE = 50  # of the errors on an axis, so that it has two powers of ten
CAPTION = (
    "Error of the discretisation, per cent (rms over the cycle; T over the layer; the wave over its own size), against an exact solution (Riemann) or the limit of two schemes on the closure of the points (ftcs: without terms in 1/G, as it runs), "
    "whose difference is the grey band: below it nothing is known. Full lines: dz, dashed: dx, dotted: CFL number. Rings: the scene's settings. Crosses: failures."
)


def ends(axis, rows, x):
    """Limits with room, on which guides and bands are then placed."""
    known = [(r[x], r["error_percent"]) for r in rows if r[x] > 0 and r["error_percent"] > 0]
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlim(min(c for c, _ in known) / 1.6, max(c for c, _ in known) * 2.5)
    least, most = min(e for _, e in known), max(e for _, e in known)
    room = max(2.0, (LEAST_RANGE * least / most) ** 0.5)
    axis.set_ylim(least / room, most * room)


def panel(axis, rows, study, quantity, x, with_labels):
    drawn = select(rows, study=study, quantity=quantity)
    ends(axis, drawn, x)
    for scheme, (marker, colour) in SCHEMES.items():
        for knob, line in KNOBS.items():
            one = select(drawn, scheme=scheme, knob=knob)
            fill = {"dz": colour, "dx": "white", "cfl": "white"}[knob]
            curve(axis, one, x, marker=marker, color=colour, ls=line, mfc=fill, ms=4 if knob != "cfl" else 3)
            if with_labels and scheme != "weno5":
                label_values(axis, one, x, {"dz": r"$\Delta z$ ", "dx": r"$\Delta x$ ", "cfl": "cfl "}[knob], xytext=(5, 3), color=colour)
    uncertain = max((r["error_of_error"] for r in drawn), default=0.0)
    if uncertain > axis.get_ylim()[0]:
        floor(axis, uncertain, "error of the reference")
    low, high = axis.get_xlim()
    for slope, words in GUIDES[study]:
        guide(axis, (low * (high / low) ** 0.62, axis.get_ylim()[1] / 2.5), slope, words, 0.7)
    return drawn


def draw(rows, folder, signature):
    panels = [p for p in PANELS if select(rows, study=p[0], quantity=p[1])]
    figure, axes = plt.subplots(2, len(panels), figsize=(3.5 * len(panels), 7.4), sharey="col")
    shown = []
    for i, (study, quantity, title) in enumerate(panels):
        for j, (x, words) in enumerate(AXES):
            drawn = panel(axes[j, i], rows, study, quantity, x, j == 0)
            axes[j, i].set_xlabel(words)
        axes[0, i].set_title(title)
        shown += drawn
    for axis in axes[:, 0]:
        axis.set_ylabel("error, %")
    handles = [plt.Line2D([], [], color=colour, marker=marker, label=scheme) for scheme, (marker, colour) in SCHEMES.items()]
    handles += [plt.Line2D([], [], color="0.3", ls=line, label=knob) for knob, line in KNOBS.items()]
    handles += [plt.Line2D([], [], color="black", marker="o", mfc="none", ls="none", ms=9, label="default"),
                plt.Line2D([], [], color="0.3", marker="x", ls="none", mew=2, ms=7, label="fails")]
    figure.legend(handles=handles, ncols=8, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    sign(figure, signature)
    return save(figure, folder, NAME, columns_of(shown))


if __name__ == "__main__":
    sys.exit(main(draw))
