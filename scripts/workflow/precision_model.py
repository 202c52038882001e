# SPDX-License-Identifier: MIT
"""Error of the model: the continuum of each closure, with the upper end at 120 and at 200, against the mean of the long MD runs on ch4_shock; with the floor at the
plate and half a diameter up, where no centre of a particle can lie. The error of the error is that of the MD's mean and of the default grid together."""
import numpy as np

import precision_points as table
from precision_continuum import Shock, work_of
from precision_grains import Grains, parts_of_runs
from precision_study import differences, read_layer, row
from precision_timings import cost_of

HALF_DIAMETER, BIN = 0.5, 0.5


def rows(study):
    grains, discretisation, timings, made = Grains(study, 20), Shock(study), study.timings(), []
    seeds = len(table.long_runs(20))
    statistics = grains.errors([[p] for p in parts_of_runs(grains, table.long_runs(20), table.DEFAULT_MD["cycles"])], True)
    grid = discretisation.errors(table.point("ch4_shock", table.DEFAULT_SCHEME, {}))
    uncertain = {q: float(np.hypot(statistics[q][0] / np.sqrt(seeds), grid[q])) for q in grid}
    for point in table.model_points():
        end, work = study.end(point.name), work_of(study, point)
        layer = read_layer(study.folder / "comparisons" / point.name, "continuum") if end["exit_code"] == 0 else None
        cost = work | cost_of(timings.get(point.name), work.get("steps"))
        for suffix, bins in (("", 0), ("_half_diameter", int(HALF_DIAMETER / BIN))):
            found = differences(layer.lifted(bins, HALF_DIAMETER) if bins else layer, grains.mean) if layer else dict.fromkeys(uncertain, np.nan)
            is_default = point.closure == table.Point.closure and point.value("lid") == table.LIDS[0]
            made += [row("model", "continuum", "/".join(point.closure), "lid", point.value("lid"), q + suffix, error, uncertain[q], cost, is_default,
                         "completed" if layer else " ".join(end["said"]), study.command("continuum", point.scene, point.changes)) for q, error in found.items()]
    return made
