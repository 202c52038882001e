# SPDX-License-Identifier: MIT
"""scripts/mutate on a tiny project with stand-ins for cmake and ctest: mutate_tests.py SOURCE_FOLDER. What is caught, refused, restored, and going on after a cut."""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1])
sys.dont_write_bytecode = True
loader = importlib.machinery.SourceFileLoader("mutate", str(SOURCE / "scripts" / "mutate"))
mutate = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
loader.exec_module(mutate)

# The program of this project is md/sum.txt, its build a look for a bracket, its tests look for words.
CMAKE = """#!/bin/sh
case "$*" in *--build*) if grep -q '(' md/sum.txt; then echo 'sum.txt:1: error: a bracket'; exit 1; fi ;; esac
"""
CTEST = """#!/bin/sh
echo "$*" >> ../ctest_calls
failed() { printf 'The following tests FAILED:\\n\\t  1 - %s (%s)\\nErrors while running CTest\\n' "$1" "$2"; exit 8; }
[ ! -e ../cut ] || { rm ../cut; kill -TERM $PPID; exec sleep 60; }
grep -q 'one plus' md/sum.txt || failed 'md: one is added (of two)' Failed
if grep -q slow md/sum.txt; then failed 'md: it ends' Timeout; fi
case "$*" in *--label-regex* | *--tests-regex*) ;; *) grep -q 'plus two' md/sum.txt || failed 'app: two is added' SEGFAULT ;; esac
echo '  1/2 Test  #1: md: two (slow). .....   Passed    1.20 sec'
echo '  2/2 Test  #2: md: three ...........   Passed    0.90 sec'
"""
FAULT = """[[fault]]
name = "{name}"
file = "{file}"
text = '{text}'
replacement = '{replacement}'
breaks = "the sum"
{more}
"""
FAULTS = [
    dict(name="own", file="md/sum.txt", text="one", replacement="zero"),
    dict(name="others", file="md/sum.txt", text="two", replacement="three", more="drawn = true"),
    dict(name="unseen", file="md/sum.txt", text="is three", replacement="is four"),
    dict(name="slow", file="md/sum.txt", text="a sum", replacement="a slow sum"),
    dict(name="bracket", file="md/sum.txt", text="plus two", replacement="plus (two"),
]
SUM = "a sum:\none plus two\nis three\n"


class Mutate(unittest.TestCase):
    def setUp(self):
        aside = tempfile.TemporaryDirectory()
        self.addCleanup(aside.cleanup)
        self.root = pathlib.Path(aside.name) / "project"
        for folder in ("md", "tests", "data/expected", "app"):
            (self.root / folder).mkdir(parents=True)
        programs = pathlib.Path(aside.name) / "bin"
        programs.mkdir()
        for name, script in (("cmake", CMAKE), ("ctest", CTEST)):
            (programs / name).write_text(script)
            (programs / name).chmod(0o755)
        before = dict(os.environ)
        self.addCleanup(lambda: (os.environ.clear(), os.environ.update(before)))
        os.environ["PATH"] = f"{programs}:{os.environ['PATH']}"
        (self.root / "md/sum.txt").write_text(SUM)
        (self.root / "app/main.cpp").write_text("// A comment.\n#include <a>\n\nint main() {\n    return 0;\n}\n")
        (self.root / ".gitignore").write_text("/build/\n")
        self.list(FAULTS)
        self.git("init", "-q")
        self.git("config", "user.name", "A")
        self.git("config", "user.email", "a@b.c")
        self.commit()

    def list(self, faults):
        (self.root / "tests/faults.toml").write_text("# A comment.\n" + "".join(FAULT.format(**{"more": ""} | fault) for fault in faults))

    def git(self, *words):
        return subprocess.run(["git", "-C", self.root, *words], check=True, capture_output=True, text=True).stdout

    def commit(self):
        self.git("add", ".")
        self.git("commit", "-q", "-m", "one")

    def mutate(self, *words):
        """(exit code, lines printed, lines complained)"""
        said, complained = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
            try:
                code = mutate.main(self.root, list(words))
            except SystemExit as end:
                code = end.code
        return code, said.getvalue().splitlines(), complained.getvalue().splitlines()

    def rows(self):
        return {name: (row["ended"], row["suite"], row["test"]) for name, row in mutate.mutation.rows(self.root / "data/expected/faults.csv").items()}

    def calls(self):
        """How often ctest was called since it was last asked."""
        path = self.root / "build/ctest_calls"
        number = len(path.read_text().splitlines()) if path.exists() else 0
        path.unlink(missing_ok=True)
        return number

    def test_a_row_says_how_each_fault_ended_and_the_sources_are_as_before(self):
        code, said, complained = self.mutate()
        self.assertEqual((code, complained), (1, []))
        self.assertEqual(said, ["own: caught by md: one is added (of two)", "others: caught by app: two is added", "unseen: survived", "slow: timed out by md: it ends",
                                "bracket: does not build"])
        self.assertEqual(self.rows(), {"own": ("caught", "folder", "md: one is added (of two)"), "others": ("caught", "all", "app: two is added"),
                                       "unseen": ("survived", "", ""), "slow": ("timed out", "folder", "md: it ends"),
                                       "bracket": ("does not build", "folder", "sum.txt:1: error: a bracket")})
        self.assertEqual(self.git("status", "--short").split(), ["??", "data/"])
        self.assertEqual((self.root / "md/sum.txt").read_text(), SUM)
        self.assertEqual((self.root / "build/mutate/md/sum.txt").read_text(), SUM)

    def test_the_tests_of_the_folder_come_first_and_the_one_of_the_list_never(self):
        self.mutate("--only", "others")
        calls = (self.root / "build/ctest_calls").read_text().splitlines()
        self.assertEqual(["--label-regex ^md$" in call for call in calls], [False, True, True, False])
        self.assertTrue(all("--exclude-regex ^mutate:" in call and "--stop-on-failure" in call for call in calls))
        # The quick tests of the folder before those that took over a second.
        self.assertEqual([r"|^md: two \(slow\)\.$" in call for call in calls], [False, True, False, False])

    def test_the_test_that_caught_it_in_another_program_comes_first(self):
        self.mutate("--only", "own")
        (self.root / "app/main.cpp").write_text("int main() {}\n")
        self.commit()
        self.calls()
        self.mutate("--only", "own")
        calls = (self.root / "build/ctest_calls").read_text().splitlines()
        self.assertEqual(len(calls), 2)  # as it is, and with the fault
        self.assertIn(r"--tests-regex ^md: one is added \(of two\)$", calls[1])
        self.assertEqual(self.rows()["own"], ("caught", "folder", "md: one is added (of two)"))

    def test_a_survivor_that_says_why_is_no_failure(self):
        self.list([FAULTS[2] | dict(more="survives = 'nobody reads it'")])
        self.assertEqual(self.mutate()[0], 0)
        said = self.mutate("--score")[1]
        self.assertEqual(said[3], "| md | 1 | 0 | 0 | 0 | 1 | 0 | 0 | 0 | 0 |")
        self.assertEqual(said[-1], "survived: unseen, md/sum.txt: nobody reads it")

    def test_texts_that_are_gone_or_stand_twice_are_refused_with_their_places(self):
        self.list([FAULTS[0] | dict(text="five"), FAULTS[1] | dict(text="s"), FAULTS[2] | dict(file="md/none.txt")])
        self.commit()
        code, said, complained = self.mutate()
        self.assertEqual((code, said), (65, []))
        self.assertEqual(complained, ["mutate: tests/faults.toml:2: own: its text is gone from md/sum.txt",
                                      "mutate: tests/faults.toml:9: others: its text stands 3 times in md/sum.txt",
                                      "mutate: tests/faults.toml:16: unseen: there is no md/none.txt"])
        self.assertEqual(self.mutate("--dry-run")[2], complained)
        self.assertEqual(self.calls(), 0)

    def test_entries_that_are_no_faults_are_refused(self):
        for change, why in ((dict(name="others"), "others: the name is taken"), (dict(replacement="one"), "own: it changes nothing"),
                            (dict(file="elsewhere/a"), "own: elsewhere/a is in none of scene"), (dict(more="drawn = 1"), "own: drawn is no key, or not of its type"),
                            (dict(more="by = 'a'"), "own: by is no key")):
            self.list([FAULTS[1], FAULTS[0] | change])
            code, _, complained = self.mutate()
            self.assertEqual(code, 65)
            self.assertTrue(complained[0].startswith("mutate: tests/faults.toml:9: " + why), complained)

    def test_a_cut_run_goes_on_where_it_was(self):
        self.assertEqual(self.mutate("--only", "own")[0], 0)
        (self.root / "build/cut").touch()
        self.assertEqual(self.mutate("--only", "own", "--only", "others")[::2], (75, ["mutate: stopped; called again it goes on"]))
        self.assertEqual(list(self.rows()), ["own"])
        self.assertEqual((self.root / "build/mutate/md/sum.txt").read_text(), SUM)
        self.calls()
        code, said, _ = self.mutate("--only", "own", "--only", "others")
        self.assertEqual((code, said, self.calls()), (0, ["others: caught by app: two is added"], 3))

    def test_what_a_killed_run_left_planted_is_taken_back(self):
        self.mutate("--only", "own")
        (self.root / "build/mutate/md/sum.txt").write_text("planted")
        self.assertEqual(self.mutate("--only", "others")[1], ["others: caught by app: two is added"])
        self.assertEqual((self.root / "build/mutate/md/sum.txt").read_text(), SUM)

    def test_rows_of_another_program_or_another_edit_are_made_again(self):
        self.mutate("--only", "own", "--only", "others")
        self.list([FAULTS[0] | dict(replacement="ten"), *FAULTS[1:]])
        self.assertEqual(self.mutate("--only", "own", "--only", "others")[1], ["own: caught by md: one is added (of two)"])
        (self.root / "NEWS.md").write_text("words")
        self.commit()
        self.assertEqual(self.mutate("--only", "own", "--only", "others")[1], [])
        (self.root / "app/main.cpp").write_text("int main() {}\n")
        self.commit()
        self.assertEqual(len(self.mutate("--only", "own", "--only", "others")[1]), 2)

    def test_a_program_that_fails_as_it_is_gets_no_fault(self):
        (self.root / "md/sum.txt").write_text(SUM.replace("plus two", "plus nothing, but two"))
        self.commit()
        code, said, complained = self.mutate("--only", "own")
        self.assertEqual((code, said), (1, []))
        self.assertRegex(complained[0], "^mutate: no fault planted: [0-9a-f]+ as committed fails: app: two is added$")
        self.assertEqual(self.rows(), {})

    def test_what_is_not_committed_is_not_measured(self):
        (self.root / "md/sum.txt").write_text("nothing")
        self.assertEqual(self.mutate("--only", "own")[0], 0)
        self.assertEqual((self.root / "md/sum.txt").read_text(), "nothing")

    def test_changed_takes_the_faults_of_changed_files_and_others_by_a_seed(self):
        (self.root / "app/main.cpp").write_text("int main() { return 1; }\n")
        many = [FAULTS[0] | dict(name=f"own_{i}") for i in range(50)]
        self.list([*many, dict(name="ends", file="app/main.cpp", text="return 1", replacement="return 2")])
        code, said, _ = self.mutate("--changed", "HEAD", "--seed", "3", "--dry-run")
        self.assertEqual((code, said[0], len(said)), (0, "seed 3", 22))
        self.assertEqual(said[-1], "app/main.cpp:1: ends: the sum")
        self.assertEqual(self.mutate("--changed", "HEAD", "--seed", "3", "--dry-run")[1], said)
        self.assertNotEqual(self.mutate("--changed", "HEAD", "--seed", "4", "--dry-run")[1][1:], said[1:])
        self.assertEqual(self.mutate("--changed", "no_such_commit")[0], 2)

    def test_lines_are_drawn_from_code_alone(self):
        self.assertEqual(self.mutate("--draw", "9", "--seed", "1")[1], ["seed 1", "app/main.cpp:4: int main() {", "app/main.cpp:5: return 0;"])
        self.assertEqual(self.mutate("--draw", "9", "--seed", "1", "--only", "md")[1], ["seed 1"])

    def test_a_wrong_name_is_a_wrong_command(self):
        code, _, complained = self.mutate("--only", "mf")
        self.assertEqual(code, 2)
        self.assertTrue(complained[0].startswith("mutate: there is no fault or folder mf"), complained)


class Ours(unittest.TestCase):
    def test_every_fault_applies_to_the_sources(self):
        every = mutate.faults.read(SOURCE)
        mutate.faults.hold_to(SOURCE, every)
        self.assertEqual({fault.folder for fault in every}, set(mutate.faults.FOLDERS))
        self.assertGreaterEqual(len(every), 100)
        self.assertGreaterEqual(sum(fault.drawn for fault in every), 50)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
