# SPDX-License-Identifier: MIT
"""The charts of speed against accuracy, held by a few points made again: work_precision_tests.py SHAKEN SOURCE_FOLDER

Errors against data/expected/work_precision.csv; no times, which are the machine's. Tolerances say what they are of.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(SOURCE / "scripts" / folder) for folder in ("workflow", "figures")]
import figure_model  # noqa: E402
import precision_continuum  # noqa: E402
import precision_points as table  # noqa: E402
from precision_study import Study, read_rows, rms  # noqa: E402

ROWS = read_rows(SOURCE / "data/expected/work_precision.csv")
FOLDER = tempfile.TemporaryDirectory(prefix="shaken_work_precision_")
STUDY = Study(SOURCE, pathlib.Path(FOLDER.name), pathlib.Path(FOLDER.name), SHAKEN)


def recorded(study, scheme, knob, value, quantity, of="error_percent"):
    found = [r[of] for r in ROWS if (r["study"], r["scheme"], r["knob"], r["value"], r["quantity"]) == (study, scheme, knob, value, quantity)]
    assert len(found) == 1, (study, scheme, knob, value, quantity)
    return found[0]


def run(engine, scene, name, changes):
    folder = STUDY.run(name)
    if not folder.exists():
        words = [word for change in changes for word in ("--set", change)]
        subprocess.run([SHAKEN, engine, str(SOURCE / scene), *words, "-q", "--out", str(folder)], check=True, stdout=subprocess.DEVNULL,
                       env=os.environ | {"OMP_NUM_THREADS": "1"})
    return folder


def order(errors, spacings):
    return math.log(errors[0] / errors[-1]) / math.log(spacings[0] / spacings[-1])


class WorkPrecision(unittest.TestCase):
    def test_the_exact_riemann_problem_gives_the_recorded_errors_at_the_order_of_its_jumps(self):
        spacings = (0.1, 0.05, 0.025)
        for scheme in ("muscl", "weno5"):
            errors = []
            for dz in spacings:
                point = table.point("riemann", scheme, {"dz": dz})
                run("continuum", point.scene, point.name, point.changes)
                errors.append(precision_continuum.Riemann(STUDY).errors(point)["density"])
                # Round-off and its amplification by limiters.
                self.assertAlmostEqual(errors[-1] / recorded("riemann", scheme, "dz", dz, "density"), 1, delta=0.01)
            # A shock is of first order in the mean, a contact of p/(p+1): 2/3 to 5/6; a spread of 0.1 from where cells lie to the jumps.
            self.assertTrue(2 / 3 - 0.1 < order(errors, spacings) < 1.1, (scheme, errors))

    def test_a_wave_of_sound_loses_as_little_as_recorded_with_the_order_of_the_scheme(self):
        spacings = (20.0, 10.0)
        for scheme, least in (("muscl", 1.9), ("weno5", 2.9)):  # weno5: third order in time, its steps following the spacing
            errors = []
            for dz in spacings:
                point = table.point("wave", scheme, {"dz": dz})
                run("continuum", point.scene, point.name, point.changes)
                errors.append(precision_continuum.Wave(STUDY).errors(point)["wave"])
                self.assertAlmostEqual(errors[-1] / recorded("wave", scheme, "dz", dz, "wave"), 1, delta=0.01)  # round-off
            self.assertGreater(order(errors, spacings), least, (scheme, errors))

    def test_grids_of_the_layer_lie_as_far_apart_as_their_recorded_errors_allow(self):
        heights = {}
        for scheme, dz in (("muscl", 1.6), ("muscl", 0.8), ("muscl", 0.2), ("weno5", 0.4)):
            point = table.point("ch4_shock", scheme, {"dz": dz})
            with h5py.File(run("continuum", point.scene, point.name, point.changes) / "continuum.h5") as file:
                phases = file["profiles/centre_of_mass"].shape[1]
                heights[scheme, dz] = file["profiles/centre_of_mass"][0, :: phases // 20]
        fine, fine_error = heights["muscl", 0.2], recorded("ch4_shock", "muscl", "dz", 0.2, "z_cm")
        for (scheme, dz), ours in heights.items():
            distance, error = 100 * rms(ours / fine - 1), recorded("ch4_shock", scheme, "dz", dz, "z_cm")
            # The triangle of both grids and the reference; 0.001 % for rounding and a cycle that is settled to 2e-5.
            self.assertLessEqual(distance, error + fine_error + 1e-3, (scheme, dz))
            self.assertGreaterEqual(distance, abs(error - fine_error) - 1e-3, (scheme, dz))

    def test_single_cycles_of_grains_scatter_as_recorded(self):
        expected = tomllib.loads((SOURCE / "data/expected/ch4_claims.toml").read_text())["md"]["zcm"]
        folder = run("md", table.CELL["ch4_shock"], "md", table.grains(20, 7, 10, settle=10))
        with h5py.File(folder / "md.h5") as file:
            phases = file["profiles/centre_of_mass"].shape[1]
            heights = file["profiles/centre_of_mass"][:, :: phases // 20]
        ours = 100 * math.sqrt(np.mean((heights / np.array(expected) - 1) ** 2))
        # Statistics: ten cycles, of which neighbours are alike, so that some four are independent; three standard errors of a standard deviation of four.
        self.assertLess(abs(math.log(ours / recorded("md", "events", "cycles", 1, "z_cm"))), 3 / math.sqrt(2 * 4))

    def test_recorded_errors_of_grains_fall_as_the_root_of_cycles_and_of_the_area(self):
        for quantity in ("density", "temperature"):
            for knob, slope in (("cycles", -0.5), ("width", -1.0)):
                curve = {r["value"]: r for r in ROWS if (r["study"], r["knob"], r["quantity"]) == ("md", knob, quantity)}
                # Boxes of flat layers: from 24 on a wave stands in the box (docs/choosing.md), which is no noise.
                ends = min(curve), max(value for value in curve if knob != "width" or value < 24)
                errors = [curve[value]["error_percent"] for value in ends]
                # Statistics: the relative errors of both ends, three of them, and slow modes (a factor of 1.5) that make neighbouring cycles alike.
                spread = math.hypot(*(curve[value]["error_of_error"] / curve[value]["error_percent"] for value in ends))
                allowed = (math.log(1.5) + 3 * spread) / math.log(ends[1] / ends[0])
                self.assertAlmostEqual(order(errors, ends), slope, delta=min(allowed, 0.4), msg=f"{quantity} over {knob}")

    def test_the_default_grid_is_far_below_the_error_of_the_model(self):
        model = recorded("model", "jenkins_richman/goldshtein", "lid", table.LIDS[0], "z_cm")
        self.assertLess(recorded("ch4_shock", "muscl", "dz", 0.2, "z_cm"), model / 20)
        longest = max(r["value"] for r in ROWS if (r["study"], r["knob"]) == ("md", "cycles"))
        self.assertLess(recorded("md", "events", "cycles", longest, "z_cm"), model / 5)

    def test_the_chart_of_the_model_draws_every_row_and_names_the_ends_that_it_draws(self):
        rows = [r for r in ROWS if r["study"] == "model"]
        figure, axis = plt.subplots()
        figure_model.panel(axis, ROWS, "z_cm")
        drawn = sorted(y for line in axis.get_lines() if line.get_marker() in ("o", "s") and line.get_markersize() == 6 for y in line.get_ydata())
        plt.close(figure)
        self.assertEqual(drawn, sorted(r["error_percent"] for r in rows if r["quantity"] in ("z_cm", "z_cm_half_diameter")))
        words = [handle.get_label() for handle in figure_model.handles(ROWS)]
        self.assertEqual(words, [f"end at {end:g}, floor {floor}" for end in table.LIDS for floor in ("at the plate", "half a diameter up")])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
