# SPDX-License-Identifier: MIT
"""One look for all figures: colours told apart by colour-blind readers, and saving as PNG, PDF and CSV."""
import csv
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

TEMPERATURE = "#b2182b"
DENSITY = "#2166ac"
MACH = "#7a3b9a"
LENGTH = "#1b7837"
SHOCK_SHADE = "#d9d9d9"
PLATE = "black"

plt.style.use(Path(__file__).with_name("shaken.mplstyle"))


def points(axis, x, y, x_error=None, y_error=None, **look):
    """MD: markers with bars of one standard error."""
    look = {"linestyle": "none", "elinewidth": 0.8, "markeredgewidth": 0.8} | look
    return axis.errorbar(x, y, xerr=x_error, yerr=y_error, **look)


def bands(axis, z, x, error, color):
    """The continuum's grid error, left and right of a line of x against height."""
    axis.fill_betweenx(z, x - error, x + error, color=color, alpha=0.25, lw=0)


def save(figure, folder, name, columns):
    """Writes name.png, name.pdf and name.csv; columns: {header with unit: values}, all of one length."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    # A fixed date keeps two runs of the same data the same file.
    figure.savefig(folder / f"{name}.png", metadata={"Software": None})
    figure.savefig(folder / f"{name}.pdf", metadata={"CreationDate": None})
    plt.close(figure)
    with open(folder / f"{name}.csv", "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))
    return folder / f"{name}.png"
