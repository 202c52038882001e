# SPDX-License-Identifier: MIT
"""What is left of a wave of momentum, on made-up waves: horizontal_momentum_tests.py SOURCE_FOLDER"""
import math
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "scripts/figures"))

import horizontal_momentum


class Momentum(unittest.TestCase):
    def test_what_is_left_of_a_wave_is_what_was_put_in(self):
        """Particles at rest whose transverse velocity is a wave that fades and turns round, of another sign and size each cycle."""
        random = np.random.default_rng(1)
        sides, phases, cycles = np.array([7.0, 9.0]), 4, 6
        within = np.array([1.0, 0.5, 0.25, -0.75])
        place = random.uniform(size=(500, 3)) * [*sides, 1.0]
        wave = np.cos(2 * np.pi * place[:, 0] / sides[0] + 0.3)
        sizes = np.concatenate([(-2.0) ** c * within for c in range(cycles)])
        velocity = np.zeros((phases * cycles, 500, 3))
        velocity[:, :, 1] = sizes[:, None] * wave
        amplitudes = horizontal_momentum.transverse(np.broadcast_to(place, velocity.shape), velocity, sides)
        left = horizontal_momentum.survival(amplitudes, phases, 1)
        np.testing.assert_allclose(left[:5], [1, 0.5, -1.5, -4, -2], rtol=1e-12)  # round-off: one wave, no noise

    def test_a_wave_that_is_turned_round_has_a_negative_factor_and_the_length_below_which_it_is_is_found(self):
        series = np.outer((-0.8) ** np.arange(12), [1.0, 2.0 - 1.0j])
        np.testing.assert_allclose(horizontal_momentum.factor_a_cycle(horizontal_momentum.pairs(series)), -0.8, rtol=1e-12)  # round-off
        wavelengths = 168.0 / np.arange(1, 17)
        self.assertAlmostEqual(horizontal_momentum.turned_below(wavelengths, np.log(wavelengths / 60.0)), 60.0, delta=1e-9)  # round-off
        self.assertTrue(np.isnan(horizontal_momentum.turned_below(wavelengths, np.ones(16))))

    def test_what_lasts_and_what_alternates_do_not_mix_whatever_the_number_of_cycles(self):
        for cycles in range(3, 9):
            sizes = np.repeat(1.0 + 0.5 * (-1.0) ** np.arange(cycles), 4)[:, None]   # four states a cycle
            for left in (horizontal_momentum.factor_a_cycle(horizontal_momentum.pairs(sizes[::4, 0])), horizontal_momentum.survival(sizes, 4, 1)[4]):
                self.assertAlmostEqual(left, 0.75 / 1.25, delta=1e-12, msg=cycles)  # round-off

    def test_the_error_of_a_mean_by_leaving_blocks_out_is_its_standard_error(self):
        values = np.random.default_rng(2).normal(size=100)
        mean, error = horizontal_momentum.without_blocks(values, 100, np.mean)
        self.assertAlmostEqual(mean, values.mean(), delta=1e-12)
        self.assertAlmostEqual(error, values.std(ddof=1) / 10, delta=1e-12)

    def test_a_triangular_lattice_has_order_1_and_a_square_one_none(self):
        rows_of = [(x + 0.5 * (y % 2), y * math.sqrt(0.75)) for y in range(10) for x in range(10)]
        self.assertAlmostEqual(horizontal_momentum.bond_order(np.array(rows_of), np.array([10, 10 * math.sqrt(0.75)])), 1, delta=1e-12)
        square = np.array([(x, y) for y in range(10) for x in range(10)], float)
        self.assertAlmostEqual(horizontal_momentum.bond_order(square, np.array([10.0, 10.0])), 0, delta=1e-12)  # four bonds, round-off


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
