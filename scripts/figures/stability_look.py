# SPDX-License-Identifier: MIT
"""What the stability figures share: the table, a marker for each way to end, and panels of rows."""
import csv

from style import plt

# Told apart by shape as well as by colour (Okabe and Ito 2008).
LOOKS = {
    "completes": {"marker": "o", "color": "#0072B2", "s": 14},
    "slow": {"marker": "^", "color": "#E69F00", "s": 22},
    "refused": {"marker": "s", "facecolors": "none", "edgecolors": "0.55", "s": 12, "linewidths": 0.8},
    "failed": {"marker": "D", "color": "#D55E00", "s": 14},
    "defect": {"marker": "X", "color": "black", "s": 60},
}
WORDS = {"completes": "completes", "slow": "slow: past its budget", "refused": "refused with a sentence (65)",
         "failed": "fails with time and place (1)", "defect": "defect"}
THEORY = {"color": "#009E73", "lw": 1.3}
DEFAULT = {"color": "0.35", "lw": 0.9, "ls": (0, (2, 2))}


def read(folder):
    with open(folder / "stability.csv", newline="") as file:
        return list(csv.DictReader(file))


def is_known(cell):
    """Of a number's cell: neither nan nor empty."""
    return cell not in ("", "nan")


def of_map(rows, name):
    return [row for row in rows if row["map"] == name]


def scatter(axis, rows, height):
    """Each row at its x and at height(row)."""
    for end, look in LOOKS.items():
        shown = [row for row in rows if (row["end"] if row["end"] in LOOKS else "defect") == end]
        if shown:
            axis.scatter([float(row["x"]) for row in shown], [height(row) for row in shown], zorder=3, **look)


def rows_panel(axis, rows, names=None):
    """One line of markers for each y; the first name on top. Returns the height of each."""
    names = names or list(dict.fromkeys(row["y"] for row in rows))
    heights = {name: len(names) - 1 - i for i, name in enumerate(names)}
    scatter(axis, [row for row in rows if row["y"] in heights], lambda row: heights[row["y"]])
    axis.set_yticks(list(heights.values()), list(heights), fontsize=8)
    axis.tick_params(axis="y", which="both", length=0)
    axis.yaxis.set_minor_locator(plt.NullLocator())
    axis.set_ylim(-0.7, len(names) - 0.3)
    return heights


def default(axis, x):
    axis.axvline(x, **DEFAULT)


def theory(axis, x, words):
    """A line, named above the panel."""
    axis.axvline(x, **THEORY)
    axis.annotate(words, (x, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 2), textcoords="offset points", ha="center", va="bottom", fontsize=7.5,
                  color=THEORY["color"])


def title(axis, letter, words):
    axis.set_title(f"({letter}) {words}", loc="left", fontsize=10, pad=14)


def legend(figure, rows):
    ends = {row["end"] if row["end"] in LOOKS else "defect" for row in rows}
    handles = [figure.axes[0].scatter([], [], label=WORDS[end], **look) for end, look in LOOKS.items() if end in ends]
    handles += [plt.Line2D([], [], label="theory", **THEORY), plt.Line2D([], [], label="default of the scenes", **DEFAULT)]
    figure.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=len(handles), fontsize=9)


def columns(rows):
    return {key: [row[key] for row in rows] for key in rows[0]}
