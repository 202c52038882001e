# SPDX-License-Identifier: MIT
"""What the charts of scripts/reproduce work-precision share: rows, curves, the ring of the default, slope guides, bands of floors, and the line of provenance."""
import json
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "workflow"))
from precision_study import read_rows  # noqa: E402


def select(rows, **wanted):
    return sorted((r for r in rows if all(r[k] == v for k, v in wanted.items())), key=lambda r: r["value"])


def column(rows, name):
    return np.array([r[name] for r in rows], dtype=float)


def curve(axis, rows, x, **look):
    """Errors against cost, with bars: of ten timings along x, of the reference or the statistics along y; the default in a ring, failures as crosses."""
    alive = [r for r in rows if r["end"] == "completed" and np.isfinite(r[x]) and r["error_percent"] > 0]
    if alive:
        cost, error = column(alive, x), column(alive, "error_percent")
        sideways = np.abs([cost - column(alive, "cpu_low"), column(alive, "cpu_high") - cost]) if x == "cpu_seconds" else None
        upward = column(alive, "error_of_error")
        # Below its own error an error is not known: the bar reaches down to a tenth of the point and no farther.
        axis.errorbar(cost, error, xerr=sideways, yerr=[np.minimum(upward, 0.9 * error), upward], elinewidth=0.7, **look)
    for r in rows:
        if r["end"] != "completed" and np.isfinite(r[x]):
            axis.plot(r[x], r["error_percent"] if np.isfinite(r["error_percent"]) else 0.7 * axis.get_ylim()[1], "x", color=look.get("color"), ms=8, mew=2)
    for r in alive:
        if r["default"]:
            axis.plot(r[x], r["error_percent"], "o", ms=11, mfc="none", mec="black", mew=1.3, zorder=5)


def label_values(axis, rows, x, knob, **look):
    """The knob's value beside its first, default and last point."""
    alive = [r for r in rows if r["end"] == "completed" and np.isfinite(r[x]) and r["error_percent"] > 0]
    for r in alive:
        if r in (alive[0], alive[-1]) or (r["default"] and "z" in knob):
            axis.annotate(f"{knob}{r['value']:g}", (r[x], r["error_percent"]), textcoords="offset points", fontsize=6.5, **look)


def guide(axis, start, slope, words, decades=1.0, color="0.45"):
    """A straight line of that slope from start = (x, y)."""
    x = np.array([start[0], start[0] * 10**decades])
    y = start[1] * (x / start[0]) ** slope
    axis.plot(x, y, color=color, lw=0.9, ls=(0, (4, 2)))
    axis.annotate(words, (x[1], y[1]), textcoords="offset points", xytext=(2, -2), fontsize=7, color=color)


def floor(axis, percent, words, color="0.6", at=0.02):
    """Everything below is not known."""
    low = axis.get_ylim()[0]
    axis.axhspan(low, percent, color=color, alpha=0.25, lw=0, zorder=0)
    axis.set_ylim(bottom=low)
    axis.text(at, percent, " " + words, transform=axis.get_yaxis_transform(), va="bottom", fontsize=6.5, color="0.3")


def provenance(shaken, timings, command):
    """Version, compiler and flags, processor, number of timings, command: one line or two under a figure."""
    said = subprocess.run([shaken, "--version"], capture_output=True, text=True, check=True).stdout
    version, compiler, flags = (re.search(pattern, said)[1].strip() for pattern in (r"(shaken .*)", r"compiler +(.*)", r"flags +(.*)"))
    processor = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo", encoding="utf-8") if line.startswith("model name")), "unknown processor")
    counts = [len(repeats) for repeats in json.loads(Path(timings).read_text()).values()] if Path(timings).is_file() else [0]
    times = f"{min(counts)}" if min(counts) == max(counts) else f"{min(counts)} to {max(counts)}"
    return (f"{version}, {compiler}, {flags}; {processor}, one thread; CPU seconds: user and system, median of {times} timing{'' if times == '1' else 's'}, bars from the tenth to the "
            f"ninetieth percentile.\nMade by: {command}")


def sign(figure, text):
    """Under the figure, in lines as wide as it is."""
    a_line = int(21 * figure.get_figwidth())
    lines = [line for part in text.split("\n") for line in textwrap.wrap(part, a_line)]
    figure.supxlabel("\n".join(lines), fontsize=6.5, color="0.35", x=0.01, ha="left")


def columns_of(rows):
    """The rows drawn, for the CSV beside the figure."""
    return {name: [r[name] for r in rows] for name in rows[0]}


def main(draw):
    """figure_x.py OUT TIMINGS SHAKEN COMMAND, as scripts/workflow/work_precision.py calls it."""
    if len(sys.argv) != 5:
        print(f"usage: {Path(sys.argv[0]).name} OUT TIMINGS SHAKEN COMMAND   (made by scripts/reproduce work-precision)", file=sys.stderr)
        return 2
    out, timings, shaken, command = sys.argv[1:]
    path = draw(read_rows(Path(out) / "work_precision.csv"), Path(out) / "figures", provenance(shaken, timings, command))
    print(path)
    return 0
