# SPDX-License-Identifier: MIT
"""Growth of the wave of 21 where columns, rows, steps and the upper end no longer matter, from the rows of ch5_converged.csv."""
import numpy as np

import tables

DX = "continuum.spacing_horizontal"
# What else was varied, on columns 1 wide.
OTHERS = ("continuum.spacing", "continuum.cfl", "continuum.lid")


def read():
    """{(Gamma, dx, key, value): growth}; key and value empty where only the columns differ."""
    found = {}
    for row in tables.rows("ch5_converged.csv"):
        varied = [(key, float(tables.setting(row, key))) for key in OTHERS if tables.setting(row, key)]
        key, value = varied[0] if varied else ("", "")
        found[row["value"], float(tables.setting(row, DX)), key, value] = tables.factor(row)
    return found


def ladder(growths, gamma):
    """Widths of the columns, the widest first, and growth on them."""
    widths = sorted({dx for at, dx, key, _ in growths if at == gamma and not key}, reverse=True)
    return widths, [growths[gamma, dx, "", ""] for dx in widths]


def largest(growths, key, gamma=None):
    """The largest change that a key makes on one width of columns, at one Gamma or at all; 0 where it was not varied."""
    return max((abs(growth - growths[at, dx, "", ""]) for (at, dx, varied, _), growth in growths.items() if varied == key and gamma in (None, at)), default=0.0)


def limit(growths, gamma):
    """Growth on the finest columns and its error: the last difference between columns, and the largest that each of the others makes, those that
    were not varied at this Gamma by what they make at another."""
    _, on = ladder(growths, gamma)
    changes = [largest(growths, key, gamma) or largest(growths, key) for key in OTHERS]
    return on[-1], abs(on[-1] - on[-2]) + sum(changes)


def onset(growths):
    """Gamma at which the wave neither grows nor fades, and its error, both from the two accelerations beside it."""
    limits = [(gamma, *limit(growths, gamma)) for gamma in sorted({key[0] for key in growths})]
    for (below, low, low_error), (above, high, high_error) in zip(limits, limits[1:]):
        if low < 1 <= high:
            slope = (high - low) / (above - below)
            return below + (1 - low) / slope, max(low_error, high_error) / slope
    return np.nan, np.nan
