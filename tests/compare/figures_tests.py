# SPDX-License-Identifier: MIT
"""Figures of made-up comparisons: figures_tests.py SOURCE_FOLDER. What is drawn, and the CSV beside it, are the file's values.

All numbers of the made-up files differ, from engine to engine, array to array and place to place, so that none can stand for another.
"""
import csv
import json
import pathlib
import sys
import tempfile
import unittest

import h5py
import numpy as np

SOURCE = pathlib.Path(sys.argv[1])
sys.path[:0] = [str(SOURCE / part) for part in ("scripts/figures", "tests/support")]

import drawn
import run_folder

FOLDER = tempfile.TemporaryDirectory(prefix="shaken_figures_")
PHASES, BINS = 100, 40
PROFILES = ("density", "velocity", "temperature", "temperature_z", "temperature_x", "mach", "mean_free_path")
MEASURES = ("centre_of_mass", "layer/lower", "layer/upper", "max_mach", "max_mach_height", "shock/location", "shock/top", "shock/foot", "shock/width",
            "shock/slope_width", "shock/mach_above", "shock/width_over_mean_free_path", "shock/width_over_mean_free_path_foot", "shock/slope_width_over_mean_free_path_foot")


def write_comparison(folder, seed):
    """compare.h5 and summary.json of a comparison as docs/formats.md lists them, all its numbers random."""
    random = np.random.default_rng(seed)
    folder.mkdir(parents=True)
    with h5py.File(folder / "compare.h5", "w") as file:
        file["provenance/scene"] = "[scene]\n"
        file["phase"] = np.arange(PHASES) / PHASES
        file["height"] = 0.5 * (np.arange(BINS) + 0.5)
        file["plate/height"] = 4.0 * (1 - np.cos(2 * np.pi * np.arange(PHASES) / PHASES))
        file["plate/velocity"] = random.normal(size=PHASES)
        for engine in ("md", "continuum"):
            for name in PROFILES:
                file[f"{engine}/{name}"] = random.uniform(0.1, 0.9, size=(PHASES, BINS))
            for name in MEASURES:
                file[f"{engine}/{name}"] = random.uniform(5.0, 15.0, size=PHASES)
            file[f"{engine}/shock/followed"] = (np.arange(PHASES) // 10 % 2).astype(np.int64)
            for name in PROFILES + MEASURES if engine == "md" else ():
                file[f"md/{name}_error"] = random.uniform(0.01, 0.1, size=file[f"md/{name}"].shape)
    (folder / "summary.json").write_text(json.dumps({"scene": "made up", "md": {}, "continuum": {}}))


def stored(folder, name):
    with h5py.File(folder / "compare.h5") as file:
        return file[name][()]


def draw(name, of):
    """The figure that a script draws, and its CSV by column."""
    with drawn.figures() as seen:
        path = __import__(name).draw(of)
    with open(path.with_suffix(".csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    return seen[-1], {key: np.array([float(row[key]) if row[key] else np.nan for row in rows]) if key not in ("engine",) else [row[key] for row in rows] for key in rows[0]}


class OfOneRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(FOLDER.name) / "run"
        write_comparison(cls.folder, 1)
        cls.run_of = run_folder.Run(cls.folder)

    def value(self, name):
        return stored(self.folder, name)

    def equal(self, found, wanted):
        np.testing.assert_array_equal(np.asarray(found), wanted)   # a CSV has all digits

    def check_against_height(self, name, quantity, factor, column):
        figure, columns = draw(name, self.run_of)
        index = 22   # ft = 0.22
        z = self.value("height") + self.value("plate/height")[index]
        self.equal(columns["z/sigma"], z)
        for engine, said in (("md", "MD"), ("continuum", "continuum")):
            mach, beside = self.value(f"{engine}/mach")[index], self.value(f"{engine}/{quantity}")[index]
            self.equal(columns[f"Ma {said}"], mach)
            np.testing.assert_allclose(columns[column.format(said)], factor * beside, rtol=1e-15)   # round-off
            self.assertTrue(drawn.shows(figure, mach, z), f"Mach numbers of the {said}")
        self.equal(columns["Ma MD error"], self.value("md/mach_error")[index])
        ends = {tuple(sorted(x for x, _ in bar)) for bar in drawn.bars(figure)}
        for value, error in zip(self.value("md/mach")[index], self.value("md/mach_error")[index]):
            self.assertTrue(any(abs(low - (value - error)) < 1e-12 and abs(high - (value + error)) < 1e-12 for low, high in ends), value)
        return figure, z, index

    def test_mach_numbers_and_volume_fraction_against_height(self):
        figure, z, index = self.check_against_height("figure_4_3", "density", np.pi / 6, "nu {}")
        for engine in ("md", "continuum"):
            self.assertTrue(drawn.shows(figure, 10 * (self.value(f"{engine}/density")[index] * np.pi / 6), z), engine)

    def test_mach_numbers_and_mean_free_path_against_height(self):
        figure, z, index = self.check_against_height("figure_4_4", "mean_free_path", 1, "lambda {}/sigma")
        for engine in ("md", "continuum"):
            self.assertTrue(drawn.shows(figure, self.value(f"{engine}/mean_free_path")[index], z), engine)

    def test_one_cycle_of_centre_of_mass_and_shock(self):
        figure, columns = draw("figure_4_2b", self.run_of)
        order = (np.arange(PHASES) + 67) % PHASES   # from ft = -0.33
        phase, plate = columns["ft"], self.value("plate/height")[order]
        np.testing.assert_allclose(phase % 1, order / PHASES, atol=1e-12)   # round-off
        self.assertTrue(drawn.shows(figure, phase, plate))
        for engine, said in (("md", "MD"), ("continuum", "continuum")):
            some = slice(None, None, 2 if engine == "md" else 1)
            followed = self.value(f"{engine}/shock/followed")[order] > 0
            for column, wanted in (("centre of mass", self.value(f"{engine}/centre_of_mass")[order]),
                                   ("shock", np.where(followed, self.value(f"{engine}/shock/location")[order], np.nan) + plate)):
                self.equal(columns[f"{column} {said}/sigma"], wanted)
                self.assertTrue(drawn.shows(figure, phase[some], wanted[some]), f"{column} {said}")
        for edge in ("upper", "lower"):
            wanted = self.value(f"md/layer/{edge}")[order] + plate
            self.equal(columns[f"{edge} edge MD/sigma"], wanted)
            self.assertTrue(drawn.shows(figure, phase[::2], wanted[::2]), edge)

    def test_profiles_at_four_phases(self):
        figure, columns = draw("figure_4_1", self.run_of)
        at = np.rint(columns["ft"] * PHASES).astype(int)
        bin_of = np.tile(np.arange(BINS), 4)
        self.equal(at, np.repeat([0, 15, 22, 40], BINS))
        for engine, said in (("md", "MD"), ("continuum", "continuum")):
            self.equal(columns[f"T {said}/(g sigma)"], self.value(f"{engine}/temperature")[at, bin_of])
            np.testing.assert_allclose(columns[f"nu {said}"], self.value(f"{engine}/density")[at, bin_of] * np.pi / 6, rtol=1e-15)
            for index in (0, 15, 22, 40):
                z = self.value("height") + self.value("plate/height")[index]
                self.assertTrue(drawn.shows(figure, self.value(f"{engine}/temperature")[index], z), (said, index))
                self.assertTrue(drawn.shows(figure, self.value(f"{engine}/density")[index] * np.pi / 6, z), (said, index))

    def test_life_of_the_shock(self):
        figure, columns = draw("figure_4_5", self.run_of)
        shown = np.arange(10, 39)
        self.equal(columns["ft"], shown / PHASES)
        for engine, said in (("md", "MD"), ("continuum", "continuum")):
            largest = self.value(f"{engine}/max_mach")[shown]
            self.equal(columns[f"largest Ma {said}"], largest)
            self.assertTrue(drawn.shows(figure, shown / PHASES, largest), said)
            followed = self.value(f"{engine}/shock/followed")[shown] > 0
            width = np.where(followed, self.value(f"{engine}/shock/width_over_mean_free_path")[shown], np.nan)
            self.assertTrue(drawn.shows(figure, shown / PHASES, width), said)
            self.assertEqual(sum(np.array_equal(values, width, equal_nan=True) for values in columns.values() if not isinstance(values, list)), 1, said)


class OfStudies(unittest.TestCase):
    def test_centre_of_mass_and_shock_of_three_depths(self):
        out = pathlib.Path(FOLDER.name) / "study"
        depths = (("h4.5", 4.5), ("default", 9.0), ("h13.5", 13.5))
        for seed, (name, _) in enumerate(depths):
            write_comparison(out / "comparisons" / name, 10 + seed)
        figure, columns = draw("figure_4_8", run_folder.Study(out))
        for name, depth in depths:
            folder, mine = out / "comparisons" / name, columns["H"] == depth
            order = np.rint(columns["ft"][mine] % 1 * PHASES).astype(int) % PHASES
            plate, phase = stored(folder, "plate/height")[order], columns["ft"][mine]
            for engine, said in (("md", "MD"), ("continuum", "continuum")):
                centre = stored(folder, f"{engine}/centre_of_mass")[order]
                followed = stored(folder, f"{engine}/shock/followed")[order] > 0
                shock = np.where(followed, stored(folder, f"{engine}/shock/location")[order], np.nan) + plate
                some = slice(None, None, 2 if engine == "md" else 1)
                np.testing.assert_array_equal(columns[f"centre of mass {said}/sigma"][mine], centre)
                np.testing.assert_array_equal(columns[f"shock {said}/sigma"][mine], shock)
                self.assertTrue(drawn.shows(figure, phase[some], centre[some]), (name, said))
                self.assertTrue(drawn.shows(figure, phase, shock), (name, said))

    def test_wavelengths_have_bars_of_half_a_wave_to_either_side(self):
        figure, columns = draw("figure_5_2", run_folder.Study(pathlib.Path(FOLDER.name) / "rows"))
        ends = [(bar[0][0], *sorted((bar[0][1], bar[1][1]))) for bar in drawn.bars(figure)]
        self.assertEqual(len(ends), len(columns["f*"]))
        for (x, low, high), frequency, waves in zip(ends, columns["f*"], columns["waves in 168"]):
            self.assertLess(abs(x - frequency), 0.01)   # points of other closures stand beside each other
            self.assertAlmostEqual(low, 168 / (waves + 0.5) / 5.4, delta=1e-12)   # round-off
            self.assertAlmostEqual(high, 168 / (waves - 0.5) / 5.4, delta=1e-12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
