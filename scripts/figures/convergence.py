# SPDX-License-Identifier: MIT
"""Growth of the wave of 21 where columns, rows, steps and the upper end no longer matter, from the rows of ch5_converged.csv."""
import numpy as np

import tables

SPACING, DX = "continuum.spacing", "continuum.spacing_horizontal"
# What else was varied, on columns BASE wide: key, the scene's value, others.
BASE = 1.0
OTHERS = ((SPACING, 0.2, (0.1,)), ("continuum.cfl", 0.8, (0.4,)), ("continuum.lid", 25.0, (50.0, 100.0)))


def read():
    """{(Gamma, dx, key, value): growth}; key and value empty where only the columns differ."""
    found = {}
    for row in tables.rows("ch5_converged.csv"):
        varied = [(key, float(tables.setting(row, key))) for key, *_ in OTHERS if tables.setting(row, key)]
        key, value = varied[0] if varied else ("", "")
        found[row["value"], float(tables.setting(row, DX)), key, value] = tables.factor(row)
    return found


def ladder(growths, gamma):
    """Widths of the columns, the widest first, and growth on them."""
    widths = sorted({dx for at, dx, key, _ in growths if at == gamma and not key}, reverse=True)
    return widths, [growths[gamma, dx, "", ""] for dx in widths]


def limit(growths, gamma):
    """Growth on the finest columns and its error: the last difference between columns, and the largest that each of the others makes."""
    _, on = ladder(growths, gamma)
    base = growths[gamma, BASE, "", ""]
    changes = [max((abs(growths[gamma, BASE, key, value] - base) for value in values if (gamma, BASE, key, value) in growths), default=np.nan)
               for key, _, values in OTHERS]
    return on[-1], abs(on[-1] - on[-2]) + sum(changes)


def onset(growths):
    """Gamma at which the wave neither grows nor fades, and its error, both from the two accelerations beside it."""
    limits = [(gamma, *limit(growths, gamma)) for gamma in sorted({key[0] for key in growths})]
    for (below, low, low_error), (above, high, high_error) in zip(limits, limits[1:]):
        if low < 1 <= high:
            slope = (high - low) / (above - below)
            return below + (1 - low) / slope, max(low_error, high_error) / slope
    return np.nan, np.nan
