#!/usr/bin/env python3
"""OUT/stability.csv: one row a point of the stability maps: stability_table.py ROOT SHAKEN OUT JOBS [--dry-run]

Runs what is not there yet, counts how the points ended, and ends with 1 where one ended in a way that it must not.
"""
import collections
import csv
import pathlib
import resource
import shutil
import sys

import stability_check
import stability_points
import stability_runs

COLUMNS = ("map", "x", "y", "end", "message", "distance/percent", "mass made", "energy made", "ledger", "steps", "contacts a particle",
           "flight/period", "pressure", "command")
NUMBERS = ("distance", "mass_made", "energy_made", "ledger", "steps", "events_per_particle", "flight", "pressure")


def rows_of(points, kept):
    """A row a point; kept: what stability_runs.make returns."""
    for point in points:
        reference = kept[point.reference] if point.reference else None
        end, message, numbers = stability_check.end_of(point, kept[point.run], reference)
        row = (point.map, f"{point.x:g}", str(point.y), end, message, *(written(numbers.get(key)) for key in NUMBERS), point.run.command())
        yield dict(zip(COLUMNS, row))


def written(number):
    """Round-off differs from machine to machine. An empty cell would be read as 0."""
    return "nan" if number is None else "0" if abs(number) < 1e-9 else f"{number:.3g}"


def runs_of(points):
    return list(dict.fromkeys(run for point in points for run in (point.run, point.reference) if run))


def main():
    if len(sys.argv) not in (5, 6):
        print(__doc__, file=sys.stderr)
        return 2
    root, shaken, out, jobs = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3]), int(sys.argv[4])
    points = stability_points.points()
    runs = runs_of(points)
    missing = [run for run in runs if not stability_runs.kept_at(out, run).is_file()]
    print(f"{len(points)} points of {len(runs)} runs, {len(missing)} to make", file=sys.stderr)
    if "--dry-run" in sys.argv:
        return 0
    for left in out.glob("run_*"):
        shutil.rmtree(left)
    rows = list(rows_of(points, stability_runs.make(root, shaken, out, runs, jobs)))
    with open(out / "stability.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    counts = collections.Counter(row["end"] for row in rows)
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(", ".join(f"{counts[end]} {end}" for end in stability_check.ENDS if counts[end]), f"({spent.ru_utime + spent.ru_stime:.0f} s of CPU)")
    for row in rows:
        if row["end"] in stability_check.DEFECTS:
            print(f"{row['end']}: {row['message']}: {row['command']}", file=sys.stderr)
    return 1 if any(counts[end] for end in stability_check.DEFECTS) else 0


if __name__ == "__main__":
    sys.exit(main())
