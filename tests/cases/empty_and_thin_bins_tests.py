# SPDX-License-Identifier: MIT
"""What compare.h5 and tables say where nothing, or one particle, was seen: empty_and_thin_bins_tests.py SHAKEN SOURCE_FOLDER"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SHAKEN = sys.argv[1]
sys.path += [str(pathlib.Path(sys.argv[2]) / "scripts" / part) for part in ("workflow", "figures")]
import rows  # noqa: E402
import stability_table  # noqa: E402
import tables  # noqa: E402

SMALL = ["particles.number=300", "particles.restitution=0.9", "box.x=6", "box.y=6", "sample.phases=20", "sample.settle=2", "sample.average=5", "sample.frames=0", "continuum.spacing=0.5"]
SCENE = pathlib.Path(sys.argv[2]) / "data/scenes/ch4_shock.toml"
UNKNOWN = ("velocity", "temperature", "temperature_z", "temperature_x", "mach", "mean_free_path")


class EmptyAndThinBins(unittest.TestCase):
    def test_what_no_particle_or_one_has_seen_is_unknown_and_the_layer_is_not(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "compared"
            runs = {engine: pathlib.Path(folder) / engine for engine in ("md", "continuum")}
            for engine, where in runs.items():
                words = [word for setting in SMALL for word in ("--set", setting)]
                subprocess.run([SHAKEN, "-q", engine, SCENE, *words, "--out", where], check=True, stdout=subprocess.DEVNULL)
            subprocess.run([SHAKEN, "-q", "compare", out, "--md", runs["md"], "--continuum", runs["continuum"]], check=True, stdout=subprocess.DEVNULL)
            with h5py.File(runs["md"] / "md.h5") as file:
                visits = file["profiles/sums"][..., 0].sum(axis=0)
            with h5py.File(out / "compare.h5") as file:
                md = {name: file["md"][name][:] for base in (*UNKNOWN, "density") for name in (base, base + "_error")}
                scalars = {name: file["md"][name][:] for name in ("centre_of_mass", "layer/lower", "layer/upper")}
        empty, once = visits == 0, visits == 1
        self.assertGreater(empty.sum(), 20)
        self.assertGreater(once.sum(), 5)
        for name in UNKNOWN:
            self.assertTrue(np.isnan(md[name][empty]).all() and np.isnan(md[name + "_error"][empty]).all(), name)
        self.assertTrue((md["density"][empty] == 0).all() and (md["density_error"][empty] == 0).all())
        self.assertTrue(np.isnan(md["temperature"][once]).all() and np.isfinite(md["velocity"][once]).all())
        self.assertTrue(np.isnan(md["velocity_error"][once]).all(), "a bin of one block has no error")
        self.assertTrue(np.isfinite(md["temperature"][visits > 1]).all())
        for name, values in scalars.items():
            self.assertTrue(np.isfinite(values).all(), name)

    def test_an_unknown_number_is_written_as_such_and_an_empty_cell_read_as_unknown(self):
        """Programs read an empty cell as 0."""
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "rows.csv"
            row = rows.Row("continuum", "a.toml", "plate.acceleration", "2")
            rows.add(table, row, {"mean_square": 1.0, "order": 0.5, "waves": [{"coherent": None}]}, 1.0)
            with open(table, newline="") as file:
                line = next(csv.DictReader(file))
        self.assertNotIn("", line.values())
        self.assertEqual([line[name] for name in ("interpolated_order", "coherent", "mean_square")], ["nan", "nan", "1"])
        self.assertEqual(stability_table.written(None), "nan")
        self.assertEqual([tables.is_known(tables.number(cell)) for cell in ("", "nan", "0")], [False, False, True])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
