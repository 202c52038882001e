# SPDX-License-Identifier: MIT
"""Printed errors are the scatter over seeds, of every number of uniform gases and of a layer: scatter_of_seeds_tests.py SHAKEN SOURCE_FOLDER [SEEDS STUDY ...]"""
import math
import pathlib
import sys
import tempfile

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SEEDS, STUDIES = int(sys.argv[3]), sys.argv[4:]
sys.path.append(str(SOURCE / "scripts"))
import scatter_of_seeds  # noqa: E402

# Statistics: a ratio from n seeds is known to 1/sqrt(2 (n - 1)), 11 % of forty, and those of one study go together. The bounds are those of forty seeds, wider for fewer by three of what is
# known less well.
WIDER = math.exp(3 * (1 / math.sqrt(2 * (SEEDS - 1)) - 1 / math.sqrt(78)))
LEAST, MOST, MEAN = 0.65 / WIDER, 1.5 * WIDER, 1.1 * WIDER

rows = []
for study in STUDIES or scatter_of_seeds.STUDIES:
    scene, settings = scatter_of_seeds.STUDIES[study]
    with tempfile.TemporaryDirectory() as folder:
        runs = scatter_of_seeds.Runs(SHAKEN, folder)
        rows += [(study, *row) for row in scatter_of_seeds.table(list(runs.summaries(SOURCE / f"data/scenes/{scene}.toml", settings, SEEDS)))]
wrong = [f"{study}: {name}: scatter {scatter:.3g}, error {said:.3g}: {ratio:.2f}" for study, name, _, scatter, said, ratio, _ in rows if not LEAST < ratio < MOST]
assert not wrong, "\n".join(wrong)
assert len(rows) > 3, rows
mean = scatter_of_seeds.geometric_mean(row[5] for row in rows)
assert 1 / MEAN < mean < MEAN, mean
print(f"{len(rows)} numbers, geometric mean of scatter over error {mean:.2f}")
