# SPDX-License-Identifier: MIT
"""Plants faults one by one in a worktree of its own and keeps a row of each: which test caught it, or none.

The test that caught a fault in another program runs first, then the quick tests of the fault's folder, then all of the folder,
and the others only where those see nothing. Rows are written as they come: a cut run goes on behind the last one.
"""
import contextlib
import csv
import fcntl
import os
import re
import signal
import subprocess
import sys
import time

import faults as listed

TABLE = "data/expected/faults.csv"
COLUMNS = ["fault", "folder", "drawn", "ended", "suite", "test", "edit", "program"]
CAUGHT, SURVIVED, NO_BUILD, TIMED_OUT = "caught", "survived", "does not build", "timed out"
TREE = "build/mutate"
# Words change no answer, the list and the table change with every fault, and what plants them is not tested by them.
NOT_PROGRAM = ("*.md", listed.LIST, TABLE, "tests/scripts/mutate_tests.py", "scripts/mutate", *(f"scripts/workflow/{name}.py" for name in ("faults", "mutation", "score")))
# What the tests of a folder need beside its own; a folder not named here: its own.
TARGETS = {"compare": ("compare_tests", "shaken"), "scripts": ("shaken",)}
LABELS = {"scripts": "^(scripts|compare|validation)$"}
# The test that the list fits the sources fails with any fault.
LEFT_OUT = "^mutate:"
QUICK = 1.0  # second, of a test that does not wait for the others
SLOW_TESTS = "build/slow_tests"
TOOK = re.compile(r"^\s*\d+/\d+ Test +#\d+: (.*?) \.+ +Passed +([\d.]+) sec", re.M)
FAILED = re.compile(r"^\s+\d+ - (.*) \((?!Not Run|Disabled)([^()]*)\)", re.M)


class InUse(Exception):
    """Another one is at work in the worktree."""


def git(folder, *words):
    return subprocess.run(["git", "-C", folder, *words], check=True, capture_output=True, text=True).stdout.strip()


def program(root):
    """The last commit that touched what is built and run."""
    return git(root, "log", "-1", "--format=%h", "--abbrev=10", "HEAD", "--", ".", *(f":(exclude){path}" for path in NOT_PROGRAM))


@contextlib.contextmanager
def worktree(root):
    """HEAD as committed, in a folder whose build lasts; what a cut run left planted is taken back."""
    tree = root / TREE
    tree.parent.mkdir(exist_ok=True)
    with open(tree.with_suffix(".lock"), "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise InUse(f"{TREE} is in use by another scripts/mutate") from None
        git(root, "worktree", "prune")
        if (tree / ".git").exists():
            git(tree, "checkout", "--force", "--detach", git(root, "rev-parse", "HEAD"))
        else:
            git(root, "worktree", "add", "--detach", tree, "HEAD")
        yield tree


class Bench:
    """Builds and tests one tree, within `limit` seconds a fault."""

    def __init__(self, tree, jobs, limit):
        self.tree, self.jobs, self.limit = tree, str(jobs), limit

    def run(self, words, until):
        """(exit code, output); TimeoutExpired ends all that it started."""
        child = subprocess.Popen(words, cwd=self.tree, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
        try:
            said, _ = child.communicate(timeout=max(0.0, until - time.monotonic()))
            return child.returncode, said
        finally:
            if child.poll() is None:
                end_all(child)

    def outcome(self, suites):
        """(ended, suite, test) of the tree as it stands, after the first of (suite, targets, arguments of ctest) that fails."""
        until = time.monotonic() + self.limit
        try:
            for suite, targets, chosen in suites:
                code, said = self.run(["cmake", "--build", "--preset", "release", "--parallel", self.jobs, *(["--target", *targets] if targets else [])], until)
                if code:
                    return NO_BUILD, suite, first_error(said)
                left_out = [LEFT_OUT, *(self.slow_tests() if suite == "quick" else [])]
                code, said = self.run(["ctest", "--preset", "release", "--stop-on-failure", "--parallel", self.jobs, "--exclude-regex", "|".join(left_out), *chosen], until)
                found = FAILED.search(said)
                if found:
                    return TIMED_OUT if found[2] == "Timeout" else CAUGHT, suite, found[1]
                if code:
                    raise RuntimeError(f"ctest ended with {code} and names no test:\n{said[-2000:]}")
                self.said = said
        except subprocess.TimeoutExpired:
            return TIMED_OUT, suite, ""
        return SURVIVED, "", ""

    def unmutated(self, today):
        """Whether all tests pass; asked once for each program."""
        passed = self.tree / "build" / "passed_unmutated"
        if passed.is_file() and passed.read_text() == today:
            return SURVIVED, "", ""
        code, said = self.run(["cmake", "--preset", "release", "-D", "BUILD_TESTING=ON"], time.monotonic() + self.limit)
        ended = (NO_BUILD, "", first_error(said)) if code else self.outcome([("all", (), ())])
        if ended[0] == SURVIVED:
            passed.parent.mkdir(exist_ok=True)
            (self.tree / SLOW_TESTS).write_text("".join(f"{name}\n" for name, seconds in TOOK.findall(self.said) if float(seconds) > QUICK))
            passed.write_text(today)
        return ended

    def slow_tests(self):
        path = self.tree / SLOW_TESTS
        return [exactly(name) for name in path.read_text().splitlines()] if path.is_file() else []

    def try_fault(self, fault, seen_by=""):
        """seen_by: the test that caught it in another program, if any."""
        path = self.tree / fault.file
        kept = path.read_bytes()
        path.write_bytes(kept.replace(fault.text.encode(), fault.replacement.encode()))
        targets = TARGETS.get(fault.folder, (f"{fault.folder}_tests",))
        own = ("--no-tests=ignore", "--label-regex", LABELS.get(fault.folder, f"^{fault.folder}$"))
        suites = [("quick", targets, own), ("folder", targets, own), ("all", (), ())]
        is_own = seen_by.startswith(f"{fault.folder}:") and fault.folder != "scripts"
        if seen_by:
            suites.insert(0, ("known", targets if is_own else (), ("--no-tests=ignore", "--tests-regex", exactly(seen_by))))
        try:
            ended, suite, test = self.outcome(suites)
            return ended, {"quick": "folder", "known": "folder" if is_own else "all"}.get(suite, suite), test
        finally:
            path.write_bytes(kept)


def exactly(name):
    """A regular expression of ctest's that matches this name alone."""
    return "^" + re.sub(r"([][.*+?|^$()\\])", r"\\\1", name) + "$"


def end_all(child):
    """Ninja asked to end takes its compilers along; killed, it leaves them."""
    os.killpg(child.pid, signal.SIGTERM)
    try:
        child.communicate(timeout=10)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)
        child.communicate()


def first_error(said):
    found = re.search(r"^.*\b(?:error|Error|FAILED)\b.*$", said, re.M)
    return found[0].strip()[:120] if found else ""


def rows(table):
    """{fault: row}; none where there is no table."""
    if not table.is_file():
        return {}
    with open(table, newline="") as file:
        return {row["fault"]: row for row in csv.DictReader(file)}


def write(table, every, known):
    """The rows in the order of the list; those of faults that it no longer holds go."""
    aside = table.with_suffix(".part")
    with open(aside, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(known[fault.name] for fault in every if fault.name in known)
    aside.rename(table)


def lacking(chosen, known, today):
    """Those without a row of this edit of this program."""
    return [fault for fault in chosen if fault.name not in known or (known[fault.name]["edit"], known[fault.name]["program"]) != (fault.edit, today)]


def make(root, every, chosen, jobs, limit):
    """Makes the rows that lack of the chosen faults; an exit code: 0 when each chosen one is caught or says why it is not."""
    today, table = program(root), root / TABLE
    with worktree(root) as tree:
        listed.hold_to(tree, chosen)
        bench = Bench(tree, jobs, limit)
        ended, _, test = bench.unmutated(today)
        if ended != SURVIVED:
            print(f"mutate: no fault planted: {today} as committed {'fails' if ended == CAUGHT else ended}: {test}", file=sys.stderr)
            return 1
        known = rows(table)
        for fault in lacking(chosen, known, today):
            ended, suite, test = bench.try_fault(fault, known[fault.name]["test"] if known.get(fault.name, {}).get("ended") == CAUGHT else "")
            row = {"fault": fault.name, "folder": fault.folder, "drawn": "yes" if fault.drawn else "no", "ended": ended, "suite": suite, "test": test,
                   "edit": fault.edit, "program": today}
            write(table, every, rows(table) | {fault.name: row})
            print(f"{fault.name}: {ended}{f' by {test}' if test and ended != NO_BUILD else ''}", flush=True)
    known = rows(table)
    return 1 if any(known[fault.name]["ended"] == NO_BUILD or known[fault.name]["ended"] == SURVIVED and not fault.survives for fault in chosen) else 0
