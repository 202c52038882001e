# SPDX-License-Identifier: MIT
"""The way from a field to its noise, by commands alone: noise_of_a_field_tests.py SHAKEN SOURCE_FOLDER"""
import os
import pathlib
import sys
import unittest

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(SOURCE / "scripts/figures"), str(SOURCE / "scripts/workflow")]
os.environ["SHAKEN"] = SHAKEN

import model_scatter


class NoiseOfAField(unittest.TestCase):
    def test_the_noise_of_a_swift_hohenberg_field_is_found_within_20_per_cent(self):
        """F = 0.012 of another seed than the kept curves, told as Gamma with a mean-field onset of 1.965 and a scale of 2."""
        fit = model_scatter.fit_of_field(SHAKEN, SOURCE / "data/expected/ch6_swift_hohenberg.csv", steps=4000, seed=77, settle=4000)
        self.assertAlmostEqual(fit["noise"] / 0.012, 1, delta=0.2)
        self.assertAlmostEqual(fit["mean_field_onset"], 1.965, delta=0.02)  # half a step of the controls
        self.assertAlmostEqual(fit["scale"], 2, delta=0.4)
        # Of 200 draws: fields with this noise and length scatter by a few per cent of it (data/expected/ch6_fit_scatter.csv).
        self.assertTrue(0.0003 < fit["noise_error"] < 0.003, fit["noise_error"])
        self.assertEqual(fit["draws"], 200)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
