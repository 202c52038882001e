# SPDX-License-Identifier: MIT
"""A run is counted once: what averages over runs refuses those that are not independent, and a key that cannot act says so: run_counted_twice_tests.py SHAKEN SOURCE_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SHAKEN, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENE = SOURCE / "tests/support/small_layer.toml"


def sets(settings):
    return [word for setting in settings for word in ("--set", setting)]


class CountedTwice(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls._folder.name)
        cls.run_of("md", "a")
        cls.run_of("md", "again")
        cls.run_of("md", "later", "sample.settle=4")
        cls.run_of("md", "b", "md.seed=2")
        cls.from_file = cls.run_of("md", "from_a", *cls.start("a", 5))
        cls.run_of("md", "from_a_too", *cls.start("a", 6))
        cls.run_of("md", "from_a_later", *cls.start("a", 7), "sample.settle=1")
        cls.run_of("md", "from_b", *cls.start("b", 5))
        cls.run_of("continuum", "c")

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    @classmethod
    def start(cls, name, seed):
        return f'initial.file="{cls.folder / name}/md.checkpoint"', f"md.seed={seed}", f"initial.seed={seed}", "sample.settle=0"

    @classmethod
    def run_of(cls, engine, name, *settings):
        return subprocess.run([SHAKEN, "-q", engine, SCENE, *sets(["sample.phases=20", *settings]), "--out", cls.folder / name],
                              check=True, capture_output=True, text=True).stdout

    def compare(self, to, *runs):
        named = [word for run in runs for word in ("--md", self.folder / run)]
        return subprocess.run([SHAKEN, "compare", self.folder / to, *named, "--continuum", self.folder / "c"], capture_output=True, text=True)

    def assert_refused(self, done, *words):
        self.assertEqual(done.returncode, 65, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_compare_refuses_runs_that_are_not_independent(self):
        for one, other, why in (("a", "a", "one file"), ("a", "again", "start alike"), ("a", "later", "start alike"),
                                ("from_a", "from_a_too", "share 4 cycles"), ("from_a", "from_a_later", "share 3 cycles")):
            with self.subTest(one=one, other=other):
                self.assert_refused(self.compare("refused", "b", one, other), f"{one}/md.h5 and ", f"{other}/md.h5 are not independent", why)
                self.assertFalse((self.folder / "refused").exists())

    def test_other_seeds_other_states_and_what_follows_a_run_are_averaged(self):
        for runs in (("a", "b"), ("from_a", "from_b"), ("a", "from_a")):
            with self.subTest(runs=runs):
                self.assertEqual(self.compare("_".join(runs), *runs).returncode, 0)

    def test_means_of_comparisons_too(self):
        for run in ("a", "again", "b", "from_a", "from_a_later"):
            self.assertEqual(self.compare(f"of_{run}", run).returncode, 0)

        def mean(*runs):
            folders = [self.folder / f"of_{run}" for run in runs]
            return subprocess.run([sys.executable, SOURCE / "scripts/mean_of_runs.py", *folders], capture_output=True, text=True)
        self.assertEqual(mean("a", "b").returncode, 0)
        self.assert_refused(mean("a", "a"), "a/md.h5 are not independent", "one file")
        self.assert_refused(mean("a", "again"), "a/md.h5 and ", "again/md.h5", "start alike")
        self.assert_refused(mean("b", "from_a", "from_a_later"), "from_a_later/md.h5", "share 3 cycles")
        (self.folder / "again/md.h5").rename(self.folder / "again/aside.h5")
        gone = mean("a", "again")
        (self.folder / "again/aside.h5").rename(self.folder / "again/md.h5")
        self.assertEqual((gone.returncode, gone.stderr.count("\n")), (66, 1))

    def test_lid_study_too(self):
        done = subprocess.run([sys.executable, SOURCE / "scripts/lid_study.py", self.folder / "a", self.folder / "again"], capture_output=True, text=True)
        self.assert_refused(done, "are not independent", "start alike")

    def test_a_row_twice_is_no_second_run(self):
        table = self.folder / "onset.csv"
        table.write_text("value,mean_square,order\n2.1,0.1,0.2\n2.2,0.15,0.25\n2.1,0.1,0.2\n")
        self.assert_refused(subprocess.run([SHAKEN, "fit-noise", table], capture_output=True, text=True), "onset.csv:2 and ", "onset.csv:4", "one run twice")

    def test_seeds_beside_a_file_are_said_to_have_no_part(self):
        said = "md.seed and initial.seed have no part"
        self.assertIn(said, self.from_file)
        self.assertEqual(self.compare("said", "from_a", "from_b").stdout.count(said), 1)
        self.assertIn(said, json.loads((self.folder / "said/summary.json").read_text())["md"]["notes"][0])
        self.assertNotIn(said, self.run_of("md", "plain", "md.seed=5"))

    def test_a_phase_without_a_file_is_refused(self):
        for command in ("md", "continuum", "run"):
            with self.subTest(command=command):
                done = subprocess.run([SHAKEN, command, SCENE, *sets(["initial.phase=0.5"]), "--out", self.folder / "phase"], capture_output=True, text=True)
                self.assert_refused(done, "initial.phase = 0.5 needs initial.file")
                self.assertFalse((self.folder / "phase").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
