#!/usr/bin/env python3
"""OUT/table.csv and OUT/table.h5: one row a run, with its values, how it ended, and the numbers of its comparison: table.py OUT"""
import csv
import json
import pathlib
import sys

import h5py
import numpy as np


def flat(values, prefix=""):
    """Numbers of nested tables by keys with dots; lists are left to summary.json."""
    for key, value in values.items():
        if isinstance(value, dict):
            yield from flat(value, f"{prefix}{key}.")
        elif value is None or isinstance(value, (int, float)):
            yield prefix + key, np.nan if value is None else float(value)


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


def main():
    out = pathlib.Path(sys.argv[1])
    study = json.loads((out / "workflow.json").read_text())
    compared_as = {comparison["md"][0]: name for name, comparison in study["comparisons"].items() if len(comparison["md"]) == 1}
    rows = []
    for name, run in study["runs"].items():
        end = json.loads((out / "runs" / name / f"{run['engine']}.end.json").read_text())
        row = {"run": name, "engine": run["engine"], "exit_code": float(end["exit_code"]), "cycle": float(end["cycle"] or np.nan),
               "seconds": end["seconds"]}
        row |= {key: number_or_text(value) for key, _, value in (change.partition("=") for change in end["changes"])}
        if name in compared_as:
            row |= dict(flat(json.loads((out / "comparisons" / compared_as[name] / "summary.json").read_text())))
        rows.append(row)
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(out / "table.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        words = {column for row in rows for column, value in row.items() if isinstance(value, str)}
        writer.writerows({column: row.get(column, "" if column in words else np.nan) for column in columns} for row in rows)
    with h5py.File(out / "table.h5", "w") as file:
        for column in columns:
            values = [row.get(column, np.nan) for row in rows]
            if any(isinstance(value, str) for value in values):
                file.create_dataset(column, data=["" if value is np.nan else str(value) for value in values], dtype=h5py.string_dtype())
            else:
                file.create_dataset(column, data=np.array(values, dtype=float))
    return 0


if __name__ == "__main__":
    sys.exit(main())
