# SPDX-License-Identifier: MIT
"""A layer whose cycles alternate, from Gamma 4 on, is averaged over even and odd cycles apart: period_two_tests.py SHAKEN SOURCE_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENE = """
[scene]
name = "period two"
[plate]
acceleration = 4.5
frequency_star = 0.4
[particles]
number = 200
restitution = {law = "velocity", e0 = 0.7, v0 = 1}
[box]
x = 5.0
y = 5.0
ceiling = 300.0
[sample]
phases = 20
settle = 24
average = 11
[continuum]
spacing = 0.4
lid = 100.0
"""
LAYER = 0.026 * 6 / np.pi  # number density


class PeriodTwo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls._folder.name)
        (cls.folder / "scene.toml").write_text(SCENE)
        for engine in ("md", "continuum"):
            cls.run_of(engine, "a")
        cls.said = cls.compare("a")
        cls.run_of("continuum", "later", "sample.settle=25")
        cls.run_of("md", "later", "sample.settle=25", "sample.average=10", "md.seed=2", "initial.seed=2")
        cls.run_of("md", "other", "sample.average=10", "md.seed=3", "initial.seed=3")
        cls.compare("later")
        cls.compare("other", continuum="a")
        cls.compare("both", ["other", "later"], "a")
        for engine in ("md", "continuum"):
            cls.run_of(engine, "one", "plate.acceleration=3", "particles.restitution=0.9", "sample.settle=4", "sample.average=10")
        cls.compare("one")

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    @classmethod
    def run_of(cls, engine, name, *settings):
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([SHAKEN, "-q", engine, cls.folder / "scene.toml", *words, "--out", cls.folder / engine / name], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def compare(cls, name, md=(), continuum=None):
        runs = [word for run in md or [name] for word in ("--md", cls.folder / "md" / run)]
        return subprocess.run([SHAKEN, "-q", "compare", cls.folder / name, *runs, "--continuum", cls.folder / "continuum" / (continuum or name)],
                              check=True, capture_output=True, text=True).stdout

    def summary(self, name):
        return json.loads((self.folder / name / "summary.json").read_text())

    def heights(self, name, engine="md"):
        with h5py.File(self.folder / engine / name / f"{engine}.h5") as file:
            return file["profiles/centre_of_mass"][:]

    def temperature_of_layer(self, name):
        """Mean over the mass of the layer, of all phases of compare.h5."""
        with h5py.File(self.folder / name / "compare.h5") as file:
            density, temperature = file["md/density"][:], file["md/temperature"][:]
        layer = (density > LAYER) & np.isfinite(temperature)
        return np.average(temperature[layer], weights=density[layer])

    def temperature_of_all_cycles(self, name):
        with h5py.File(self.folder / "md" / name / "md.h5") as file:
            sums = file["profiles/sums"][:].sum(axis=0)
            density = sums[..., 0] / (11 * file["profiles/area"][()] * file["profiles/bin_width"][()])
        mass = np.where(sums[..., 0] > 0, sums[..., 0], 1)[..., None]
        variance = (sums[..., 4:7] / mass - (sums[..., 1:4] / mass) ** 2).mean(axis=-1)
        return np.average(variance[density > LAYER], weights=density[density > LAYER])

    def test_temperature_is_about_the_mean_of_the_own_flow(self):
        # Twenty phases of 200 grains in five or six cycles: 0.27 from the cycles of either parity alone, 1.07 together.
        self.assertGreater(self.temperature_of_all_cycles("a"), 0.8)
        for name in ("a", "later", "other", "both"):
            self.assertTrue(0.2 < self.temperature_of_layer(name) < 0.35, (name, self.temperature_of_layer(name)))

    def test_both_engines_have_a_period_of_two_and_it_is_said(self):
        found = self.summary("a")
        for engine in ("md", "continuum"):
            self.assertEqual(found[engine]["period"], 2)
            self.assertEqual(len(found[engine]["zcm"]), 40)
            self.assertIn("even and odd cycles are averaged apart", " ".join(found[engine]["notes"]))
            self.assertIn("shock", found[engine]["second_cycle"])
        self.assertEqual(self.said.count("period: 2 cycles"), 2)
        self.assertEqual(self.said.count("in the second cycle"), 2)
        with h5py.File(self.folder / "a" / "compare.h5") as file:
            self.assertEqual((file["phase"].attrs["period"], file["md"].attrs["period"]), (2, 2))
            np.testing.assert_allclose(file["phase"][:], np.arange(40) / 20, atol=1e-12)

    def test_the_higher_cycle_is_first_whichever_was_sampled_first(self):
        for name in ("a", "later"):
            for engine in ("md", "continuum"):
                z = self.heights(name, engine)
                even, odd = z[::2].mean(axis=0), z[1::2].mean(axis=0)
                first, second = (even, odd) if even.mean() > odd.mean() else (odd, even)
                np.testing.assert_allclose(self.summary(name)[engine]["zcm"], np.concatenate((first, second)), rtol=1e-12)
        self.assertNotEqual(*(z[::2].mean() > z[1::2].mean() for z in (self.heights("a", "continuum"), self.heights("later", "continuum"))))
        # One layer of the continuum, averaged from one cycle later on: what it still settles.
        one, other = (np.array(self.summary(name)["continuum"]["zcm"]) for name in ("a", "later"))
        self.assertLess(np.abs(one - other).max(), 0.1)

    def test_runs_that_began_with_either_cycle_are_averaged_flow_by_flow(self):
        one, other, both = (np.array(self.summary(name)["md"]["zcm"]) for name in ("later", "other", "both"))
        self.assertLess(np.abs(one - other).max(), 3.0)  # statistics: flows differ by up to 13
        self.assertTrue((both >= np.minimum(one, other) - 1e-9).all() and (both <= np.maximum(one, other) + 1e-9).all())

    def test_errors_are_those_of_the_cycles_of_a_flow(self):
        z, error = self.heights("a"), np.array(self.summary("a")["md"]["zcm_error"])
        parts = [part.std(axis=0, ddof=1) / len(part) ** 0.5 for part in (z[::2], z[1::2])]
        if z[::2].mean() < z[1::2].mean():
            parts.reverse()
        # Blocks are of two or three cycles, of which either flow has one or two: the jackknife is right to first order.
        self.assertLess(abs(np.log(np.median(error / np.concatenate(parts)))), np.log(1.3))
        self.assertLess(error.max(), 0.8)  # 2.1 with even and odd cycles in one

    def test_a_layer_of_period_one_is_as_it_was(self):
        found = self.summary("one")
        z = self.heights("one")
        for engine in ("md", "continuum"):
            self.assertEqual((found[engine]["period"], len(found[engine]["zcm"]), "second_cycle" in found[engine]), (1, 20, False))
        np.testing.assert_allclose(found["md"]["zcm"], z.mean(axis=0), rtol=1e-12)
        np.testing.assert_allclose(found["md"]["zcm_error"], z.std(axis=0, ddof=1) / len(z) ** 0.5, rtol=1e-6)
        with h5py.File(self.folder / "one" / "compare.h5") as file:
            self.assertEqual((file["phase"].attrs["period"], file["md/temperature"].shape[0], "second_cycle" in file["md/shock"]), (1, 20, False))

    def test_the_report_says_it_and_has_its_figures(self):
        (self.folder / "a" / "md.h5").symlink_to(self.folder / "md" / "a" / "md.h5")
        subprocess.run([SHAKEN, "-q", "report", self.folder / "a"], check=True, capture_output=True)
        page = (self.folder / "a" / "report.html").read_text()
        for words in ("Period of the layer: 2 cycles (MD), 2 cycles (continuum)", "In the second cycle", '<td class="number">1.95</td>'):
            self.assertIn(words, page)
        self.assertIn("data:image/png;base64,", page)
        self.assertNotIn("could not be drawn", page)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
