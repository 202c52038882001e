# SPDX-License-Identifier: MIT
"""A sample of the stability maps ends as data/expected/stability.csv says: stability_tests.py SHAKEN SOURCE_FOLDER

The whole table is remade by scripts/reproduce stability. Points beside a boundary are left out here: round-off may move them.
"""
import csv
import pathlib
import sys
import tempfile
import unittest

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "scripts" / "workflow"))
sys.dont_write_bytecode = True
import stability_check  # noqa: E402
import stability_points  # noqa: E402
import stability_runs  # noqa: E402
import stability_table  # noqa: E402

with open(SOURCE / "data/expected/stability.csv", newline="") as file:
    EXPECTED = list(csv.DictReader(file))
A_MAP = 6         # points of each map
CHEAP = 5000.0    # steps and pair collisions a particle
KEYS = ("map", "x", "y")


def key(row):
    return tuple(row[name] for name in KEYS)


def inner():
    """Rows whose neighbours in x, in the same line of a map, end as they do, and that cost little."""
    lines = {}
    for row in EXPECTED:
        lines.setdefault((row["map"], row["y"]), []).append(row)
    for line in lines.values():
        line.sort(key=lambda row: float(row["x"]))
        for i, row in enumerate(line):
            beside = line[max(0, i - 1):i + 2]
            cost = [factor * float(row[name]) for name, factor in (("steps", 1.0), ("contacts a particle", 10.0)) if row[name] not in ("", "nan")]
            if all(other["end"] == row["end"] for other in beside) and row["end"] != "slow" and max(cost, default=0.0) < CHEAP:
                yield row


def sample():
    """Of each map some rows, spread over it, of every way to end."""
    maps = {}
    for row in inner():
        maps.setdefault(row["map"], {}).setdefault(row["end"], []).append(row)
    for ends in maps.values():
        for rows in ends.values():
            count = max(1, A_MAP // len(ends))
            yield from rows[:: max(1, len(rows) // count)][:count]


class Maps(unittest.TestCase):
    def test_the_table_has_every_point_and_no_defect(self):
        points = {(point.map, f"{point.x:g}", str(point.y)) for point in stability_points.points()}
        self.assertEqual({key(row) for row in EXPECTED}, points)
        self.assertEqual([row["command"] for row in EXPECTED if row["end"] in stability_check.DEFECTS], [])
        self.assertGreaterEqual(len(EXPECTED), 400)

    def test_a_sample_of_every_map_ends_as_recorded(self):
        chosen = {key(row): row for row in sample()}
        self.assertEqual({row["map"] for row in chosen.values()}, {row["map"] for row in EXPECTED})
        points = [point for point in stability_points.points() if (point.map, f"{point.x:g}", str(point.y)) in chosen]
        with tempfile.TemporaryDirectory(prefix="shaken_stability_") as out:
            kept = stability_runs.make(SOURCE, SHAKEN, out, [point.run for point in points], jobs=2)
        for row in stability_table.rows_of([without_reference(point) for point in points], kept):
            recorded = chosen[key(row)]
            with self.subTest(row["command"]):
                self.assertEqual(row["end"], recorded["end"], row["message"])
                # How an unstable run dies depends on its last bits.
                if row["end"] != "failed" or "ftcs" not in row["command"]:
                    self.assertEqual(row["message"], recorded["message"])


def without_reference(point):
    return stability_points.Point(point.map, point.x, point.y, point.run)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
