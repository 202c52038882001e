# SPDX-License-Identifier: MIT
"""Errors of samples that remember each other are those that seeds show: blocks_shorter_than_memory_tests.py SHAKEN SOURCE_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.append(str(SOURCE / "scripts"))
import scatter_of_seeds  # noqa: E402

SCENE = SOURCE / "data/scenes/uniform_elastic.toml"
GAS = ["particles.number=100", "initial.volume_fraction=0.1", "sample.frames=0", "sample.settle=10", "sample.interval=0.02"]


class BlocksShorterThanMemory(unittest.TestCase):
    def runs(self, seeds, *settings):
        with tempfile.TemporaryDirectory() as folder:
            return list(scatter_of_seeds.Runs(SHAKEN, folder).summaries(SCENE, [*GAS, *settings], seeds))

    def test_the_scatter_over_seeds_is_what_a_run_says(self):
        """Statistics: the scatter of forty seeds is known to 11 %, so two of these and the fifth that errors are right to."""
        rows = list(scatter_of_seeds.table(self.runs(40, "sample.duration=40")))
        self.assertEqual([name for name, *_ in rows], ["compressibility Z = p/(nT)", "collision rate / sqrt(T)", "fourth cumulant a2"])
        for name, _, scatter, said, ratio, seeds in rows:
            with self.subTest(name=name, scatter=scatter, said=said):
                self.assertEqual(seeds, 40)
                self.assertGreater(ratio, 0.65)
                self.assertLess(ratio, 1.5)

    def test_a_run_as_short_as_its_memory_says_so(self):
        """A particle collides 3.5 times in it; a2 remembers four collisions."""
        a2 = [{entry["name"]: entry for entry in run}["fourth cumulant a2"] for run in self.runs(20, "sample.duration=2")]
        self.assertGreaterEqual(sum(entry["too_short"] for entry in a2), 18)
        self.assertLess(max(entry["independent_samples"] for entry in a2 if entry["too_short"]), 17)
        with tempfile.TemporaryDirectory() as folder:
            words = [word for setting in [*GAS, "sample.duration=2"] for word in ("--set", setting)]
            said = subprocess.run([SHAKEN, "-q", "md", SCENE, *words, "--out", folder], check=True, capture_output=True, text=True).stdout
            summary = {entry["name"]: entry for entry in json.loads((pathlib.Path(folder) / "summary.json").read_text())}
        lines = {name: next(line for line in said.splitlines() if line.startswith(name)) for name in summary}
        self.assertIn("+- at least ", lines["fourth cumulant a2"])
        self.assertIn("too short to tell", lines["fourth cumulant a2"])
        self.assertNotIn("standard errors", lines["fourth cumulant a2"])
        self.assertFalse(summary["compressibility Z = p/(nT)"]["too_short"])
        self.assertIn("standard errors", lines["compressibility Z = p/(nT)"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
