# SPDX-License-Identifier: MIT
"""scripts/sweep: its values, its table, and that a cut sweep goes on: sweep_tests.py SHAKEN SOURCE_FOLDER. Needs snakemake; skipped without."""
import csv
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

os.environ["SHAKEN"] = sys.argv[1]
SOURCE = pathlib.Path(sys.argv[2])
SCENE = str(SOURCE / "tests/support/small_layer.toml")
loader = importlib.machinery.SourceFileLoader("sweep", str(SOURCE / "scripts/sweep"))
sweep = importlib.util.module_from_spec(importlib.util.spec_from_loader("sweep", loader))
loader.exec_module(sweep)


class Sweep(unittest.TestCase):
    def test_values_are_decimal_and_end_at_the_last(self):
        self.assertEqual(sweep.values_of("particles.restitution=0.75:1:0.05")[1], ["0.75", "0.80", "0.85", "0.90", "0.95", "1.00"])
        self.assertEqual(sweep.values_of("md.seed=1:4"), ("md.seed", ["1", "2", "3", "4"]))
        self.assertEqual(sweep.values_of("continuum.flux=hll,hllc")[1], ["hll", "hllc"])
        for wrong in ("seed=1:4", "md.seed", "md.seed=4:1", "md.seed=1:4:0", "md.seed=a:b"):
            with self.assertRaises(ValueError):
                sweep.values_of(wrong)

    def test_seeds_do_not_concern_the_continuum(self):
        study = sweep.study(SCENE, [("particles.restitution", ["0.8", "0.9"]), ("md.seed", ["1", "2", "3"])], [], ["md", "continuum"])
        engines = [run["engine"] for run in study["runs"].values()]
        self.assertEqual((engines.count("md"), engines.count("continuum"), len(study["comparisons"])), (6, 2, 6))

    @unittest.skipUnless(shutil.which("snakemake"), "snakemake is not installed")
    def test_a_cut_sweep_goes_on_and_leaves_one_row_a_run(self):
        with tempfile.TemporaryDirectory() as out:
            command = [str(SOURCE / "scripts/sweep"), SCENE, "--vary", "md.seed=1:2", "--out", out]
            self.assertEqual(subprocess.run(command, capture_output=True).returncode, 0)
            kept = pathlib.Path(out, "runs/md_md.seed_1/md.h5")
            before = kept.stat().st_mtime_ns
            lost = pathlib.Path(out, "runs/md_md.seed_2/md.end.json")
            lost.unlink()
            self.assertEqual(subprocess.run(command, capture_output=True).returncode, 0)
            self.assertTrue(lost.is_file())
            self.assertEqual(kept.stat().st_mtime_ns, before)
            with open(pathlib.Path(out, "table.csv")) as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(sorted(row["engine"] for row in rows), ["continuum", "md", "md"])
            self.assertTrue(all(float(row["exit_code"]) == 0 for row in rows))
            found = sorted(float(row["zcm_rms_percent"]) for row in rows if row["engine"] == "md")
            wanted = sorted(json.loads(path.read_text())["zcm_rms_percent"] for path in pathlib.Path(out, "comparisons").glob("*/summary.json"))
            np.testing.assert_allclose(found, wanted, rtol=1e-5)   # the digits of the table
            self.assertLess(found[0], found[1])                    # each its own


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
