# SPDX-License-Identifier: MIT
"""The faults that scripts/mutate plants (tests/faults.toml): read, held to the sources, drawn.

A fault is a text that stands once in a file, and what replaces it.
"""
import ast
import dataclasses
import hashlib
import random
import re
import tomllib

LIST = "tests/faults.toml"
FOLDERS = ("scene", "files", "fields", "md", "continuum", "swift_hohenberg", "compare", "run", "plan", "app", "scripts")
KEYS = {"name": str, "file": str, "text": str, "replacement": str, "breaks": str, "drawn": bool, "survives": str}
MAY_LACK = {"drawn", "survives"}


class NotApplicable(Exception):
    """Entries that do not fit the sources, a line each, with their places."""


@dataclasses.dataclass(frozen=True)
class Fault:
    """entry: its line in the list; survives: why no test can see it, where none does."""
    entry: int
    name: str
    file: str
    text: str
    replacement: str
    breaks: str
    drawn: bool = False
    survives: str = ""

    @property
    def folder(self):
        return self.file.partition("/")[0]

    @property
    def edit(self):
        """Tells this edit from another under the same name."""
        return hashlib.sha1("\0".join((self.file, self.text, self.replacement)).encode()).hexdigest()[:8]

    def line(self, source):
        """The first line that changes."""
        return source[:source.index(self.text)].count("\n") + 1


def read(root):
    """The faults in the order of the list; NotApplicable names every entry that is not one."""
    written = (root / LIST).read_text()
    try:
        entries = tomllib.loads(written).get("fault", [])
    except tomllib.TOMLDecodeError as error:
        raise NotApplicable(f"{LIST}: {error}") from None
    lines = [number for number, line in enumerate(written.splitlines(), 1) if line.strip() == "[[fault]]"]
    faults, wrong = [], []
    for line, entry in zip(lines, entries):
        why = why_no_fault(entry, {fault.name for fault in faults})
        if why:
            wrong.append(f"{LIST}:{line}: {entry.get('name', 'a fault')}: {why}")
        else:
            faults.append(Fault(line, **entry))
    if wrong:
        raise NotApplicable("\n".join(wrong))
    return faults


def why_no_fault(entry, names):
    wrong = [key for key, value in entry.items() if type(value) is not KEYS.get(key)]
    if wrong:
        return f"{wrong[0]} is no key, or not of its type; known: {' '.join(KEYS)}"
    lacking = [key for key in KEYS if key not in entry and key not in MAY_LACK]
    if lacking:
        return f"{lacking[0]} is lacking"
    if not entry["text"] or entry["text"] == entry["replacement"]:
        return "it changes nothing"
    if entry["file"].partition("/")[0] not in FOLDERS:
        return f"{entry['file']} is in none of {' '.join(FOLDERS)}"
    return "the name is taken" if entry["name"] in names else None


def hold_to(tree, faults):
    """Raises NotApplicable where a text is gone from the sources under `tree`, or stands there more than once."""
    wrong = []
    for fault in faults:
        path = tree / fault.file
        times = path.read_text().count(fault.text) if path.is_file() else 0
        if times != 1:
            why = f"there is no {fault.file}" if not path.is_file() else f"its text stands {times} times in {fault.file}" if times else f"its text is gone from {fault.file}"
            wrong.append(f"{LIST}:{fault.entry}: {fault.name}: {why}")
    if wrong:
        raise NotApplicable("\n".join(wrong))


def draw(root, files, number, seed):
    """(file, line, code) of so many code lines, each as likely as any other."""
    lines = [(file, line, code) for file in sorted(files) for line, code in code_lines(file, (root / file).read_text())]
    return sorted(random.Random(seed).sample(lines, min(number, len(lines))))


def code_lines(file, source):
    """(line, code) of what can be wrong: no comments, includes, imports, closing brackets."""
    lines = list(enumerate(source.splitlines(), 1))
    if file.endswith((".cpp", ".hpp")):
        return [(n, line.strip()) for n, line in lines if re.search(r"\w", line) and not re.match(r"\s*(//|#|\*|using|namespace|}  // namespace)", line)]
    if not file.endswith(".py") and not re.match(r"#!.*python", source):
        return []
    statements = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.stmt)]
    wanted = {node.lineno for node in statements if not isinstance(node, (ast.Import, ast.ImportFrom))
              and not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))}
    return [(n, line.strip()) for n, line in lines if n in wanted]
