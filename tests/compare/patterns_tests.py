# SPDX-License-Identifier: MIT
"""Chapters 5 and 6 in small: patterns_tests.py SHAKEN SOURCE_FOLDER

Short runs of both engines and of the Swift-Hohenberg model, the rows kept under data/expected against what is claimed of them, and
every figure that rows and small runs can draw. Tolerances say what they are of.
"""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path[:0] = [str(SOURCE / part) for part in ("scripts/figures", "scripts/workflow", "tests/support")]
os.environ["SHAKEN"] = SHAKEN

import convergence
import drawn
import figure_5_2
import figure_5_growth
import figure_6_tables
import rows
import run_folder
import slices
import tables

EXPECTED = SOURCE / "data/expected"
FOLDER = tempfile.TemporaryDirectory(prefix="shaken_patterns_")
OUT = pathlib.Path(FOLDER.name)
WIDE = "continuum.spacing_horizontal=2"
# A strip of two wavelengths; no whole number of diameters across, where rows of spheres would lock.
STRIP = ["box.x=42", "box.y=5.3", "particles.number=1336", "sample.phases=40", "sample.settle=24", "sample.average=16", "sample.map_bin=2",
         "sample.frames=8", "sample.frame_cycles=16"]
WAVE = ["initial.wave=0.5", "initial.wave_x=2", "initial.wave_y=0", "continuum.dimension=2", "continuum.spacing=0.4", "continuum.lid=25",
        "sample.settle=6", "sample.average=2", "sample.frame_cycles=2"]


def shaken(*words):
    return subprocess.run([SHAKEN, *map(str, words)], check=True, stdout=subprocess.PIPE, text=True).stdout


def run(engine, name, scene, *changes):
    """A run of a scene under OUT/runs, made once."""
    folder = OUT / "runs" / name
    if not folder.exists():
        shaken(engine, SOURCE / "data/scenes" / scene, "-q", "--out", folder, *[word for change in changes for word in ("--set", change)])
    return folder


def pattern(engine, folder):
    return json.loads(shaken("patterns", folder, "--json"))[engine]


def small_md():
    return run("md", "md_stripes", "ch5_stripes.toml", "plate.acceleration=2.6", *STRIP)


def small_continuum():
    return run("continuum", "continuum_stripes", "ch5_stripes.toml", "plate.acceleration=3.6", *STRIP, *WAVE)


def fluid_stands_in():
    """The other continuum's run where a figure is only drawn: its closure takes ten times as long."""
    link = OUT / "runs" / "continuum_fluid"
    if not link.is_symlink():
        link.symlink_to(small_continuum())


def growth(gamma):
    folder = run("continuum", f"growth_{gamma}", "ch5_growth.toml", f"plate.acceleration={gamma}", WIDE)
    return pattern("continuum", folder)["waves"][0]["multiplier"]


class Stripes(unittest.TestCase):
    def test_md_makes_stripes_of_21_that_turn_over_every_cycle(self):
        found = pattern("md", small_md())
        strongest = found["waves"][0]
        self.assertEqual((strongest["waves_x"], strongest["waves_y"]), (2, 0))
        # Measured -1.002; a wave that did not alternate would have +1, noise anything. Statistics of 16 cycles.
        self.assertAlmostEqual(strongest["multiplier"], -1, delta=0.1)
        self.assertGreater(strongest["coherent"], 10 * strongest["coherent_error"])
        self.assertGreater(found["order"], 0.8)

    def test_slices_hold_all_particles_and_change_sides_after_a_cycle(self):
        stripes = slices.Stripes(small_md(), "md")
        self.assertAlmostEqual(stripes.wavelength, 21)
        first, second = stripes.at(0.0, top=40), stripes.at(1.0, top=40)
        volume = np.outer(np.diff(first.z), np.diff(first.x)) * 5.3
        self.assertAlmostEqual(6 / np.pi * np.nansum(first.fields["nu"] * volume) / 1336, 1, delta=1e-9)  # round-off: none lost
        profiles = []
        for piece in (first, second):
            z = (piece.z[1:] + piece.z[:-1])[:, None] / 2
            nu = np.nan_to_num(piece.fields["nu"])
            profiles.append((nu * z).sum(axis=0) / nu.sum(axis=0))
        wave = [np.fft.rfft(profile)[2] for profile in profiles]
        self.assertLess((wave[1] / wave[0]).real, -0.5)   # -1 but for noise
        self.assertLess(wave[0].real, 0)                  # the shift along x puts a peak at half a wavelength, 10.5

    def test_the_continuum_s_wave_fades_at_2_2_and_grows_at_3_8(self):
        kept = {row["value"]: row["multiplier"] for row in tables.rows("ch5_growth.csv")
                if row["command"].endswith(f"continuum.closure=jenkins_richman --set continuum.pair_correlation=goldshtein --set {WIDE}")}
        found = {gamma: growth(gamma) for gamma in (2.2, 3.8)}
        for gamma in found:
            # The same run but for round-off, which another compiler may grow: the factor of a wave that fades is of small numbers.
            self.assertAlmostEqual(found[gamma], kept[gamma], delta=0.005)
        self.assertLess(abs(found[2.2]), 0.85)
        self.assertGreater(abs(found[3.8]), 1.0)


class Rows(unittest.TestCase):
    def test_growth_converges_over_the_columns_and_the_map_is_its_coarsest_grid(self):
        growths = convergence.read()
        for gamma in (2.2, 3.0, 3.2, 3.4):
            widths, on = convergence.ladder(growths, gamma)
            self.assertEqual(widths, [2.0, 1.0, 0.5, 0.25])
            steps = np.abs(np.diff(on))
            self.assertLess(steps[-1], steps[0])   # truncation: half the columns, less of a change
            self.assertLess(steps[-1], 0.01)
            value, error = convergence.limit(growths, gamma)
            self.assertEqual(value, on[-1])
            # All four add up; rows and steps were varied at each of these.
            rows, shorter = (abs(growths[gamma, 1.0, key, varied] - on[1]) for key, varied in (("continuum.spacing", 0.1), ("continuum.cfl", 0.4)))
            self.assertGreaterEqual(error, steps[-1] + rows + shorter - 1e-12)   # round-off
        of_map = {row["value"]: tables.factor(row) for row in tables.growth_rows() if figure_5_growth.family(row) == ("jenkins_richman", "goldshtein", "muscl", "0.1", "e(v)", 2.0)}
        for gamma in (2.2, 3.0, 3.4):
            self.assertAlmostEqual(of_map[gamma], growths[gamma, 2.0, "", ""], delta=1e-6)   # the rows' digits
        gamma, error = convergence.onset(growths)
        self.assertGreater(gamma, 3.2)
        self.assertLess(gamma, 3.4)
        self.assertLess(error, 0.4)

    def test_wavelengths_of_md_lie_on_the_fit_to_experiments(self):
        fit = tables.references(5)["dispersion"]
        found = {row["value"]: row for row in tables.rows("ch5_dispersion_md.csv")}
        inside = [f for f in found if fit["lowest"] <= f < fit["highest"]]
        self.assertGreaterEqual(len(inside), 1)
        for f in inside:
            wanted = figure_5_2.LENGTH / figure_5_2.DEPTH / (fit["offset"] + fit["factor"] * f ** fit["exponent"])
            # Waves in the strip. Half a wave is its quantisation, one is what seeds differ by (8, 7 and 8 at 0.4).
            self.assertLess(abs(found[f]["waves_x"] - wanted), 1.5, f)

    def test_md_s_wave_of_21_fades_below_the_onset_and_the_long_wave_hardly(self):
        factor = {wave: {row["value"]: row["alternating_factor"] for row in tables.small_waves(wave)} for wave in (21.0, 42.0)}
        for gamma in (1.95, 2.0, 2.05, 2.1):
            self.assertLess(factor[21.0][gamma], 0.95)  # 0.71 to 0.868, +- 0.06 to 0.014
        for gamma in (1.95, 2.05):
            self.assertGreater(factor[42.0][gamma], 0.95)  # 0.989 and 0.983, +- 0.007

    def test_order_of_md_sets_in_within_0_05_of_2_15(self):
        onset = tables.merged(tables.rows("ch6_onset_md.csv"))
        order = {row["value"]: row["order"] for row in onset}
        self.assertLess(order[2.1], 0.3)
        self.assertGreater(order[2.2], 0.6)
        squares = [row["mean_square"] for row in onset]
        self.assertEqual(squares, sorted(squares))  # grows all the way, below onset too

    def test_a_row_is_made_once_with_its_blocks(self):
        table = OUT / "rows.csv"
        scene = str(SOURCE / "tests/support/small_layer.toml")
        wanted = [rows.Row("md", scene, "md.seed", "1", ("sample.map_bin=1",))]
        self.assertEqual(rows.fill(table, wanted, SHAKEN), 0)
        once = table.read_text()
        self.assertEqual(rows.fill(table, wanted, SHAKEN), 0)
        self.assertEqual(table.read_text(), once)
        with open(table.with_suffix(".blocks.csv")) as file:
            blocks = list(csv.DictReader(file))
        mean = sum(float(block["mean_square"]) for block in blocks) / len(blocks)
        self.assertAlmostEqual(mean / tables.number(once.splitlines()[1].split(",")[1]), 1, delta=1e-4)  # six digits are kept


class Model(unittest.TestCase):
    def test_the_noise_coefficient_is_made_of_the_closure_s_values(self):
        """Against mu, kappa of physics at nu = 0.4, T = 1, e = 0.7, and the sound speed, c^2 = T chi (1 + 2/3 chi + nu chi'/chi)."""
        nu, mu, kappa, sound = 0.4, 1.29962695, 5.27841943, 5.64608591
        n, chi = 6 * nu / math.pi, 1 + 3.4 * 1.16461491
        slope = (sound**2 / chi - 1 - 2 / 3 * chi) * chi   # nu dchi/dnu
        wanted = n * (1.5 + chi**2 / (chi + slope)) / (mu * kappa * 5.4)
        self.assertAlmostEqual(figure_6_tables.noise_coefficient(nu, 1.0, 5.4) / wanted, 1, delta=1e-6)  # digits of the values


# Columns of a figure's CSV that are coordinates of its points and lines, or colours of its maps, whose CSV keeps five digits.
DRAWN = {"figure_5_momentum": ("MD", "continuum"), "figure_5_elastic": ("wavelength/sigma", "factor a cycle"), "figure_5_2": ("wavelength/H",),
         "figure_5_growth": ("Gamma", "factor a cycle"), "figure_5_converged": ("dx/sigma", "growth a cycle"), "figure_6_2": ("Gamma",),
         "figure_6_3": ("Gamma", "mean square/sigma^2", "P_max"), "figure_6_4": ("F", "residual/sigma^4"),
         "figure_6_5": ("Gamma", "mean square over mean height squared"), "figure_6_scatter": ("noise", "mean_field_onset"),
         "figure_6_fluctuations": ("Gamma", "factor a cycle"), "figure_5_sloshing": ("ft", "height wave", "sloshing"), "figure_5_3": (),
         "figure_5_1": ("psi/sigma",), "figure_5_4": ("nu",), "figure_5_8": ("nu", "T"), "figure_5_fluid": ("nu", "u_x"), "figure_5_9": ("u_z", "P"),
         "figure_5_10": ("u_x", "dP/dx")}
MAPS = {"figure_5_1", "figure_5_4", "figure_5_8", "figure_5_fluid", "figure_5_9", "figure_5_10"}


class Figures(unittest.TestCase):
    def draw(self, name):
        """The rows of a figure's CSV, of which the columns that are drawn stand among the coordinates and colours of what is drawn."""
        with drawn.figures() as seen:
            path = __import__(name).draw(run_folder.Study(OUT))
        with open(path.with_suffix(".csv")) as file:
            found = list(csv.DictReader(file))
        known = drawn.numbers(seen[-1])
        for column in DRAWN[name]:
            share = drawn.share_drawn(known, [tables.number(row[column]) for row in found], 6e-6 if name in MAPS else 1e-9)
            self.assertEqual(share, 1, f"{name}: {column} of its CSV is not what is drawn")
        return found

    def test_figures_of_rows(self):
        fit = shaken("fit-noise", EXPECTED / "ch6_onset_md.csv", "--model", EXPECTED / "ch6_swift_hohenberg.csv")
        (OUT / "fit.json").write_text(fit)
        (OUT / "scatter.csv").write_text((EXPECTED / "ch6_fit_scatter.csv").read_text())
        for name in ("figure_5_2", "figure_5_growth", "figure_5_converged", "figure_6_2", "figure_6_3", "figure_6_4", "figure_6_5", "figure_6_scatter", "figure_6_fluctuations"):
            self.assertGreater(len(self.draw(name)), 3, name)

    def test_figures_of_small_runs(self):
        small_continuum()
        small_md()
        fluid_stands_in()
        self.assertEqual(len(self.draw("figure_5_1")), 3 * 21 * 3)  # bins of 2 x 1.8, three panels
        self.draw("figure_5_3")
        for name in ("figure_5_4", "figure_5_8", "figure_5_fluid", "figure_5_9", "figure_5_10"):
            drawn = self.draw(name)
            self.assertEqual({row["engine"] for row in drawn}, {"MD", "continuum"})

    def test_stripes_slosh_towards_and_away_from_their_peaks(self):
        small_continuum()
        small_md()
        fluid_stands_in()
        drawn = self.draw("figure_5_sloshing")
        for engine in ("MD", "continuum"):
            curve = {float(row["ft"]): float(row["sloshing"]) for row in drawn if row["engine"] == engine}
            self.assertLess(curve[0.0], 0)     # falling, towards the peaks
            self.assertGreater(curve[0.5], 0)  # after the landing, away from where they were
            self.assertGreater(curve[1.0], 0)  # a cycle later the other way
            self.assertLess(curve[1.5], 0)
            if engine == "MD":  # the continuum, after six cycles, still settles
                for ft in (0.0, 0.25, 0.5, 0.75):
                    # Measured 0.01 of the largest to 0.06: statistics of eight cycles of 1336 grains.
                    self.assertAlmostEqual(curve[ft + 1], -curve[ft], delta=0.15 * max(map(abs, curve.values())))

    def test_a_flat_layer_of_md_lands_as_a_crystal(self):
        flat = ["plate.acceleration=2.0", "box.x=12.3", "box.y=12.3", "particles.number=908", "sample.phases=20", "sample.map_bin=0", "sample.frames=20"]
        run("md", "md_flat", "ch5_stripes.toml", *flat, "sample.settle=30", "sample.average=20", "sample.frame_cycles=20")
        run("continuum", "continuum_flat", "ch5_stripes.toml", *flat, "sample.settle=8", "sample.average=2", "continuum.dimension=1", "continuum.spacing=0.2",
            "continuum.lid=25", "initial.noise=0")
        drawn = self.draw("figure_5_momentum")
        self.assertEqual(len(drawn), 21)
        # Measured 0.9 to 1; a disordered plane of disks has about 0.5.
        self.assertGreater(float(drawn[0]["psi_6 of the lowest plane"]), 0.8)
        fluid = [float(row["continuum"]) for row in drawn]
        self.assertEqual(fluid, sorted(fluid, reverse=True))  # only lost
        small_md()
        for name, of in (("md_strip_2.0", "md_flat"), ("md_strip_2.6", "md_stripes")):
            (OUT / "runs" / name).symlink_to(OUT / "runs" / of)
        self.assertEqual(len(self.draw("figure_5_elastic")), 2 * 2 * 16)

    def test_a_figure_that_is_not_there_is_refused_and_a_plan_told(self):
        reproduce = [SOURCE / "scripts/reproduce", "ch6", "--out", str(OUT / "plan")]
        wrong = subprocess.run([*reproduce, "--figure", "6.9"], capture_output=True, text=True)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("6.tables", wrong.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
