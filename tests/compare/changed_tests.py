# SPDX-License-Identifier: MIT
"""scripts/reproduce --changed with a stand-in for the program: changed_tests.py SOURCE_FOLDER. What is stale, and that a cut remake goes on where it was."""
import contextlib
import io
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(SOURCE / "scripts" / "workflow"))
sys.dont_write_bytecode = True
import changed  # noqa: E402
import patterns_study  # noqa: E402
import probe  # noqa: E402
import rows  # noqa: E402

SCENE = """[scene]
name = "small"
kind = "layer"
[plate]
acceleration = 2.0
[particles]
number = 100
[box]
x = 10.0
y = 10.0
[md]
seed = 1
[continuum]
spacing = 0.4
"""
# Knows the commands that rows need. Its answer is a function of the settings; it stops at the run that the file cut_at names.
PROGRAM = '''#!/usr/bin/python3 -SE
import json, pathlib, sys, tomllib
DEFAULTS, FACTOR = {defaults}, {factor}
words = sys.argv[1:]
if words == ["--version"]:
    print("shaken 1 ({name})"); sys.exit(0)
if words[0] == "patterns":
    engine = next(e for e in ("md", "continuum") if pathlib.Path(words[1], e + ".h5").exists())
    found = dict(mean_square=FACTOR[engine], mean_square_error=0.1, order=1.0, order_error=0.1,
                 waves=[dict(wavelength=21.0, angle=0.0)], blocks=[dict(mean_square=1.0, power_by_angle=[0.0] * 21)] * 2)
    print(json.dumps({{engine: found}})); sys.exit(0)
resumed = pathlib.Path(words[words.index("--resume") + 1]) if "--resume" in words else None
scene = tomllib.loads((resumed / "scene.toml" if resumed else pathlib.Path(words[1])).read_text())
for section, keys in DEFAULTS.items():
    scene[section] = keys | scene.get(section, {{}})
for at, word in enumerate(words):
    if word == "--set":
        key, _, value = words[at + 1].partition("=")
        section, _, name = key.partition(".")
        scene.setdefault(section, {{}})[name] = tomllib.loads("a=" + value)["a"]
text = "".join(f"[{{s}}]\\n" + "".join(f"{{k}} = {{json.dumps(v)}}\\n" for k, v in keys.items()) for s, keys in scene.items())
if words[0] == "scene":
    print(text, end=""); sys.exit(0)
folder = resumed or pathlib.Path(words[words.index("--out") + 1])
folder.mkdir(parents=True, exist_ok=True)
(folder / "scene.toml").write_text(text)
if "shaken_probe_" not in str(folder):
    with open("made", "a") as file:
        print(words[0], scene["plate"]["acceleration"], "resumed" if resumed else "", file=file)
    cut = pathlib.Path("cut_at")
    if cut.exists() and cut.read_text() == str(scene["plate"]["acceleration"]):
        cut.unlink(); (folder / (words[0] + ".checkpoint")).touch(); sys.exit(75)
(folder / (words[0] + ".h5")).touch()
(folder / "verification.csv").write_text("height,velocity\\n1.0," + str(FACTOR[words[0]] * scene["plate"]["acceleration"]) + "\\n")
'''
DEFAULTS = {"continuum": {"upper": "lid", "lid": 80.0}, "md": {"shell": 0.0}}
FACTOR = {"md": 1.0, "continuum": 1.0}
MD, CONTINUUM, OTHER = "data/expected/rows_md.csv", "data/expected/rows_continuum.csv", "data/expected/rows_other.csv"


class Study:
    """Two engines on one scene, and one on another."""
    FIGURES = {"figure": {"rows": [
        (MD, [rows.Row("md", "data/scenes/small.toml", "plate.acceleration", g) for g in ("2.0", "2.5")]
         + [rows.Row("md", "data/scenes/small.toml", "plate.acceleration", "2.0", ("md.seed=2",))]),
        (CONTINUUM, [rows.Row("continuum", "data/scenes/small.toml", "plate.acceleration", g) for g in ("2.0", "2.5", "3.0")]),
        (OTHER, [rows.Row("continuum", "data/scenes/other.toml", "plate.acceleration", "2.0", ('continuum.upper="lid"',))])]}}

    @classmethod
    def kept(cls, root):
        return patterns_study.kept(root, "study", cls.FIGURES, {})

    @classmethod
    def remake(cls, today, parts):
        return patterns_study.remake(today, parts, cls.FIGURES, {}, lambda *_: 0)


class Changed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """What the first program keeps, copied for each test."""
        aside = tempfile.TemporaryDirectory()
        cls.addClassCleanup(aside.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        cls.kept = pathlib.Path(aside.name) / "kept"
        first = cls()
        first.root = cls.kept
        first.keep()

    def setUp(self):
        self.root = self.kept.with_name(self.id())
        shutil.copytree(self.kept, self.root)
        os.environ["SHAKEN"] = str(self.root / "shaken")

    def keep(self):
        (self.root / "data/scenes").mkdir(parents=True)
        (self.root / "data/expected").mkdir()
        for name in ("small", "other"):
            (self.root / f"data/scenes/{name}.toml").write_text(SCENE)
        self.program("first")
        self.assertEqual(self.changed()[0], 0)
        self.assertEqual(self.made(), {"md": 3, "continuum": 4})

    def program(self, name, defaults=DEFAULTS, factor=FACTOR):
        path = self.root / "shaken"
        path.write_text(PROGRAM.format(name=name, defaults=defaults, factor=factor))
        path.chmod(0o755)
        os.environ["SHAKEN"] = str(path)

    def changed(self, dry_run=False):
        """(exit code, lines of what is stale)"""
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            code = changed.make(self.root, {"study": Study}, None, 2, dry_run, "")
        return code, [" ".join(line.split()) for line in said.getvalue().splitlines() if " stale " in line or " past " in line]

    def stale(self):
        return self.changed(dry_run=True)[1]

    def made(self):
        """{engine: runs made since it was last asked}"""
        path = self.root / "made"
        engines = [line.split()[0] for line in path.read_text().splitlines()] if path.exists() else []
        path.unlink(missing_ok=True)
        return {engine: engines.count(engine) for engine in sorted(set(engines), reverse=True)}

    def test_nothing_changed_nothing_stale(self):
        self.assertEqual(self.stale(), [])
        self.program("the same by another compiler", factor={"md": 1.0 + 1e-8, "continuum": 1.0 - 1e-8})
        self.assertEqual(self.stale(), [])
        self.assertEqual(self.changed(), (0, []))
        self.assertEqual(self.made(), {})

    def test_a_changed_scene_makes_its_own_rows_stale(self):
        scene = self.root / "data/scenes/other.toml"
        scene.write_text(SCENE.replace("number = 100", "number = 101"))
        self.assertEqual(self.stale(), ["study rows_other.csv stale continuum 1 of 1: particles.number 100 -> 101"])
        scene.write_text("# A comment.\n" + SCENE)
        self.assertEqual(self.stale(), [])

    def test_a_changed_continuum_leaves_grains_alone_and_is_made_again_once(self):
        self.program("second", factor=FACTOR | {"continuum": 1.01})
        self.assertEqual(self.stale(), ["study rows_continuum.csv stale continuum 3 of 3: its probe differs",
                                        "study rows_other.csv stale continuum 1 of 1: its probe differs"])
        self.assertEqual(self.changed()[0], 0)
        self.assertEqual(self.made(), {"continuum": 4})
        table = rows.read(self.root / CONTINUUM)
        self.assertEqual([(row["value"], row["mean_square"]) for row in table], [("2.0", "1.01"), ("2.5", "1.01"), ("3.0", "1.01")])
        self.assertEqual({row["mean_square"] for row in rows.read(self.root / MD)}, {"1"})
        self.assertEqual(self.stale(), [])

    def test_a_moved_default_leaves_alone_the_rows_that_name_the_old_one(self):
        self.program("second", defaults=DEFAULTS | {"continuum": {"upper": "stress_free", "lid": 80.0, "new": 1}})
        self.assertEqual(self.stale(), ["study rows_continuum.csv stale continuum 3 of 3: continuum.upper lid -> stress_free"])

    def test_changed_grains_keep_their_blocks_in_step(self):
        self.program("second", factor=FACTOR | {"md": 1.01})
        self.assertEqual(self.stale(), ["study rows_md.csv stale md 3 of 3: its probe differs"])
        self.assertEqual(self.changed()[0], 0)
        blocks = rows.read((self.root / MD).with_suffix(".blocks.csv"))
        self.assertEqual(sorted((block["value"], block["run"], block["block"]) for block in blocks),
                         [(value, run, block) for value, run in (("2.0", "1"), ("2.0", "2"), ("2.5", "1")) for block in ("0", "1")])

    def test_a_cut_remake_goes_on_where_it_was(self):
        self.program("second", factor=FACTOR | {"continuum": 1.01})
        (self.root / "cut_at").write_text("2.5")
        self.assertEqual(self.changed()[0], 75)
        self.assertEqual(self.made(), {"continuum": 2})
        self.assertEqual(self.stale()[0], "study rows_continuum.csv stale continuum 2 of 3: its probe differs")
        self.assertEqual(self.changed()[0], 0)
        self.assertIn("continuum 2.5 resumed", (self.root / "made").read_text())
        self.assertEqual(self.made(), {"continuum": 3})
        self.assertEqual({row["mean_square"] for row in rows.read(self.root / CONTINUUM)}, {"1.01"})

    def test_a_cut_run_of_an_older_program_does_not_go_on(self):
        self.program("second", factor=FACTOR | {"continuum": 1.01})
        (self.root / "cut_at").write_text("2.5")
        self.changed()
        self.program("third", factor=FACTOR | {"continuum": 1.02})
        self.assertEqual(self.changed()[0], 0)
        self.assertNotIn("resumed", (self.root / "made").read_text())
        self.assertEqual({row["mean_square"] for row in rows.read(self.root / CONTINUUM)}, {"1.02"})

    def test_rows_that_lack_or_are_no_longer_asked_for(self):
        table = self.root / CONTINUUM
        lines = table.read_text().splitlines(keepends=True)
        table.write_text("".join(lines[:-1]) + lines[-1].replace("acceleration=3.0", "acceleration=9.0"))
        self.assertEqual(self.stale(), ["study rows_continuum.csv stale continuum 1 of 3: lacking",
                                        "study rows_continuum.csv past 1 rows that are no longer asked for"])
        self.assertEqual(self.changed()[0], 0)
        self.assertEqual([row["value"] for row in rows.read(table)], ["2.0", "2.5", "3.0"])


class Numbers(unittest.TestCase):
    def test_six_digits_count_and_sums_that_cancel_do_not(self):
        self.assertEqual(probe.differing({"a": 1.0, "b": 1e-12}, {"a": 1.0 + 1e-7, "b": -1e-12}), [])
        self.assertEqual(probe.differing({"a": 1.0, "old": 2.0}, {"a": 1.0 + 1e-5, "new": 3.0}), ["a"])
        self.assertEqual(probe.differing({"end": "failed"}, {"a": 1.0}), ["end"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
