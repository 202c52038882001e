# SPDX-License-Identifier: MIT
"""What is kept under data/ for figures: rows of sweeps (data/expected), published numbers (data/references)."""
import csv
import re
import tomllib
from pathlib import Path

import numpy as np

LEFT = 1e-5          # sigma, of waves that began with some 1e-2
SMALLEST = 1e-3      # sigma, over the wave of the density that was put in: what is smaller after eight cycles has nothing left of it
PUT_IN = "0.01"      # of the density, the scene's
WAVELENGTH = 21.0
GROWN = 8            # cycles of these runs over which growth is measured
ALTERNATING = 0.4
FACTORS, UNCERTAIN = (0.21, 1.049), 0.15   # tells_its_factor of compare/patterns/fluctuations.hpp
DATA = Path(__file__).resolve().parents[2] / "data"


def rows(name):
    """Rows of data/expected/NAME, numbers as floats; none where there is no such table."""
    path = DATA / "expected" / name
    if not path.is_file():
        return []
    with open(path, newline="") as table:
        return [{key: number(cell) for key, cell in row.items()} for row in csv.DictReader(table)]


def waves_of_strip(frequency, closure):
    """Waves of the continuum's strip of ch5_dispersion_continuum.csv at one frequency that alternate and of which more than LEFT is left."""
    return [row for row in rows("ch5_dispersion_continuum.csv") if row["value"] == frequency and setting(row, "continuum.closure", "jenkins_richman") == closure
            and row["multiplier"] < 0 and row["root_mean_square"] > LEFT]


def is_known(cell):
    """Of a cell of rows(): neither nan nor empty."""
    return isinstance(cell, float) and not np.isnan(cell)


def number(cell):
    try:
        return float(cell)
    except (TypeError, ValueError):
        return cell


def merged(table, columns=("mean_square", "relative_mean_square", "order"), errors=("mean_square_error", "order_error")):
    """One row a value, ascending: means over the rows (seeds) of it, errors of those means: from the rows' own or from their scatter, whichever is more."""
    found = []
    for value in sorted({row["value"] for row in table}):
        same = [row for row in table if row["value"] == value]
        row = {"value": value} | {name: float(np.mean([r[name] for r in same])) for name in columns}
        own = {name: float(np.sqrt(np.sum(np.square([r[name] for r in same]))) / len(same)) for name in errors}
        scatter = {name: float(np.std([r[name.removesuffix("_error")] for r in same], ddof=1) / np.sqrt(len(same))) if len(same) > 1 else 0.0 for name in errors}
        found.append(row | {name: max(own[name], scatter[name]) for name in errors})
    return found


def setting(row, key, default=None):
    """What a row's command sets a key to."""
    found = re.search(re.escape(key) + r"=(\S+)", row["command"])
    return found[1] if found else default


def published(chapter):
    """{key: number} of data/references/chapter_N.toml."""
    return {entry["key"]: entry for entry in references(chapter)["number"]}


def references(chapter):
    return tomllib.loads((DATA / "references" / f"chapter_{chapter}.toml").read_text())


def small_waves(wavelength, scene="data/scenes/ch6_onset.toml"):
    """Rows of the MD's fluctuations in a cell, of one wavelength, by Gamma."""
    return sorted((row for row in fluctuations(scene) if abs(row["wavelength"] / wavelength - 1) < 1e-3), key=lambda row: row["value"])


def fluctuations(scene):
    """Rows of the MD's fluctuations in runs of a scene below the onset, of waves whose alternating part has a factor that says something: told to
    UNCERTAIN and inside the fit's ends. The part itself may be uncertain by more than that where a wave remembers itself for as long as the run."""
    onset = published(6)["onset"]["value"]
    return [row for row in rows("ch6_fluctuations_md.csv") if f" {scene}" in row["command"] and row["value"] <= onset
            and row["alternating_factor_error"] < UNCERTAIN and FACTORS[0] < row["alternating_factor"] < FACTORS[1]]


def growth_rows():
    """Rows of ch5_growth.csv in which the wave that was put in is what is left and alternates, with more than SMALLEST of its size."""
    return [row for row in rows("ch5_growth.csv")
            if alternates(row) and row["coherent"] > SMALLEST * float(setting(row, "initial.wave", PUT_IN)) and abs(row["wavelength"] / WAVELENGTH - 1) < 0.1]


def factor(row):
    """Growth a cycle of the wave's alternating part; of the whole wave in rows that hold no other, which is the same where nothing else is left."""
    alternating = row.get("alternating_multiplier")
    return abs(alternating if isinstance(alternating, float) else row["multiplier"])


def alternates(row):
    """Whether the wave alternates: from cycle to cycle where a row says so, or else as <psi^2> is that of a wave that only alternates and grows by the
    row's factor, to a factor of ALTERNATING: its alternating mean squared, over both."""
    if isinstance(row.get("alternating_multiplier"), float):
        return not np.isnan(row["alternating_multiplier"])
    sizes = abs(row["multiplier"]) ** np.arange(GROWN)
    return 2 * row["coherent"] ** 2 / row["mean_square"] > ALTERNATING * sizes.mean() ** 2 / (sizes**2).mean()


def growth_onset(closure="jenkins_richman", pair="goldshtein", restitution=None, wide=None, scheme=None):
    """Gamma at which the continuum's wave of 21 neither grows nor fades, between the rows of ch5_growth.csv; NaN if it does not cross."""
    chosen = sorted((row["value"], np.log(factor(row))) for row in growth_rows()
                    if setting(row, "closure", "jenkins_richman") == closure and setting(row, "pair_correlation", "goldshtein") == pair
                    and setting(row, "continuum.restitution") == restitution and setting(row, "spacing_horizontal") == wide
                    and setting(row, "continuum.scheme") == scheme)
    for (low, before), (high, after) in zip(chosen, chosen[1:]):
        if before < 0 <= after:
            return low - before * (high - low) / (after - before)
    return float("nan")
