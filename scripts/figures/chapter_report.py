# SPDX-License-Identifier: MIT
"""OUT/report.html: the figures of a chapter and the numbers of every comparison, in one file: chapter_report.py OUT "command" ["title"]."""
import base64
import csv
import html
import importlib
import json
import re
import sys
from pathlib import Path

from report import STYLE, figure, find, shown

COLUMNS = (("zcm_rms_percent", "z<sub>cm</sub> rms, %"), ("zcm_rms_percent_half_diameter", "floor half a diameter up"),
           ("shock_location_rms_fully_formed", "shock location rms, &sigma;"), ("density_rms", "n rms"), ("velocity_rms", "u rms"),
           ("temperature_rms", "T rms"), ("md.shock.mean_speed", "shock speed, MD"), ("continuum.shock.mean_speed", "continuum"))


def in_order(path):
    """5.2 before 5.10, and what has a name after what has a number."""
    return [(part.isalpha(), int(part) if part.isdigit() else 0, part) for part in re.findall(r"\d+|[a-z]+", path.stem)]


def main():
    if len(sys.argv) not in (3, 4):
        print("usage: chapter_report.py OUT COMMAND [TITLE]", file=sys.stderr)
        return 2
    out, command = Path(sys.argv[1]), sys.argv[2]
    title = sys.argv[3] if len(sys.argv) > 3 else "Chapter 4: shocks in a shaken layer, molecular dynamics and hydrodynamics"
    drawn = sorted((out / "figures").glob("figure_*.png"), key=in_order)
    modules = [(importlib.import_module(path.stem), path) for path in drawn]
    summaries = {path.parent.name: json.loads(path.read_text()) for path in sorted((out / "comparisons").glob("*/summary.json"))}
    head = "".join(f"<th>{words}</th>" for _, words in COLUMNS)
    rows = "".join(f"<tr><td>{html.escape(name)}</td>" + "".join(f'<td class="number">{shown(*find(s, key))}</td>' for key, _ in COLUMNS) + "</tr>"
                   for name, s in summaries.items() if "md" in s)
    table = f"<h2>Every comparison</h2><table><tr><th></th>{head}</tr>{rows}</table>" if summaries else ""
    pictures = "".join(figure(module, path) + movie(path.with_suffix(".mp4")) + f'<p class="small">Made by: {html.escape(command)}</p>' for module, path in modules)
    (out / "report.html").write_text(f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>shaken: {html.escape(title)}</title><style>{STYLE}</style></head><body>
<h1>{html.escape(title)}</h1>
<p>Made by <code>{html.escape(command)}</code>. Errors are one standard error of the MD (blocks of cycles or runs left out).</p>
{pictures}{table}</body></html>
""", encoding="utf-8")
    if summaries:
        write_table(out, summaries)
    print(out / "report.html")
    return 0


def movie(path):
    """The movie beside a figure, if there is one, inside the page."""
    if not path.is_file():
        return ""
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<video controls loop width="100%" src="data:video/mp4;base64,{data}"></video>'


def write_table(out, summaries):
    with open(out / "comparisons.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["comparison"] + [word for key, _ in COLUMNS for word in (key, key + "_error")])
        for name, s in summaries.items():
            if "md" in s:
                writer.writerow([name] + ["nan" if value is None else value for key, _ in COLUMNS for value in find(s, key)])


if __name__ == "__main__":
    sys.exit(main())
