#!/usr/bin/env python3
"""Reads every #include "folder/..." and prints file:line of each arrow that points the wrong way, and of each test that
takes Catch2 from elsewhere than tests/support/catch.hpp, the one file that knows its versions."""
import pathlib
import re
import sys

MAY_INCLUDE = {
    "scene": set(),
    "files": set(),
    "fields": {"scene", "files"},
    "md": {"scene", "files"},
    "continuum": {"scene", "files", "fields"},
    "swift_hohenberg": {"scene"},
    "compare": {"scene", "files", "fields", "md", "continuum"},
    "run": {"scene", "files", "fields", "md", "continuum", "compare"},
    "plan": {"scene", "files", "fields", "md", "continuum", "compare", "run"},
    "app": {"scene", "files", "fields", "md", "continuum", "swift_hohenberg", "compare", "run", "plan"},
}


def wrong_arrows(root):
    for folder, allowed in MAY_INCLUDE.items():
        for source in sorted((root / folder).rglob("*.[ch]pp")):
            for number, line in enumerate(source.read_text().splitlines(), start=1):
                match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
                if not match or "/" not in match[1]:
                    continue
                target = match[1].split("/")[0]
                if target != folder and target not in allowed:
                    yield f"{source.relative_to(root)}:{number}: {folder} may not include {match[1]}"


def versions_of_catch(root):
    for source in sorted((root / "tests").rglob("*.[ch]pp")):
        if source.parent.name == "support":
            continue
        for number, line in enumerate(source.read_text().splitlines(), start=1):
            match = re.search(r"<catch2/[^>]*>|\bCatch::\w+", line)
            if match:
                yield f"{source.relative_to(root)}:{number}: {match[0]} is only in some versions; take it from tests/support/catch.hpp"


if __name__ == "__main__":
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    wrong = [*wrong_arrows(root), *versions_of_catch(root)]
    print("\n".join(wrong) if wrong else "all arrows point the right way")
    sys.exit(1 if wrong else 0)
