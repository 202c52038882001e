# SPDX-License-Identifier: MIT
"""What chapters 5 and 6 share: fill the rows that figures need, make their runs, draw them, and write the report."""
import os
import pathlib
import subprocess

import rows
import workflow


def make(root, out, all_figures, runs, figures, jobs, dry_run, command, title, makers=()):
    """figures: names asked for; all that are not long when empty. makers: {name of a file under `out`: maker(root, out)}. An exit code."""
    wanted = {name: needs for name, needs in all_figures.items() if name in figures or not (figures or needs.get("long"))}
    tables = [(root / table, planned) for needs in wanted.values() for table, planned in needs.get("rows", [])]
    shaken = os.environ.get("SHAKEN", str(root / "build/release/shaken"))
    for table, planned in tables:
        lacking = rows.missing(table, planned)
        print(f"{table.relative_to(root)}: {len(planned) - len(lacking)} rows of {len(planned)} are there", flush=True)
        if dry_run:
            print("".join(f"  lacking: {row.command}\n" for row in lacking), end="")
        elif os.environ.get("ROWS") != "kept":
            os.chdir(root)  # rows name their scenes from there
            code = rows.fill(table, planned, shaken, pathlib.Path(out).resolve() / "rows")
            if code:
                return code
    # The tables are inputs of a figure: one more row, and it is drawn again. What a maker makes is not there yet in a dry run.
    drawn = {name: {"runs": needs.get("runs", []),
                    "files": [str(root / table) for table, _ in needs.get("rows", []) if (root / table).is_file()]
                    + [str(pathlib.Path(out).resolve() / made) for made in needs.get("files", []) if not dry_run]}
             for name, needs in wanted.items()}
    for made in dict.fromkeys(file for needs in wanted.values() for file in needs.get("files", []) if not dry_run):
        makers[made](root, out)
    code = workflow.make(root, out, workflow.select(runs, {}, drawn, everything=False), jobs, dry_run)
    if code or dry_run:
        return code
    report = [root / "scripts/figures/chapter_report.py", out, command, title]
    return subprocess.run(["/usr/bin/python3", "-B", *map(str, report)], check=False).returncode
