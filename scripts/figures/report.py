# SPDX-License-Identifier: MIT
"""DIR/report.html: the figures and the numbers of a run beside the published ones, in one file without outside parts."""
import base64
import html
import sys
import tomllib
from pathlib import Path

import figure_4_1
import figure_4_2b
import figure_4_3
import figure_4_5
from run_folder import Run, RunError

FIGURES = (figure_4_1, figure_4_2b, figure_4_3, figure_4_5)
PHASES_A_CYCLE = 20  # of z_cm in summary.json
REFERENCES = Path(__file__).resolve().parents[2] / "data" / "references" / "chapter_4.toml"
STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
table { border-collapse: collapse; width: 100%; font-size: 0.92rem; }
th, td { border-bottom: 1px solid #ddd; padding: 0.35rem 0.6rem; text-align: left; vertical-align: top; }
th { border-bottom: 2px solid #888; } td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
.yes { color: #1b7837; } .no { color: #b2182b; font-weight: 600; }
.notes { border-left: 4px solid #b2182b; background: #fdf3f1; padding: 0.5rem 1rem 0.5rem 2rem; }
figure { margin: 1.5rem 0; } figure img { max-width: 100%; height: auto; display: block; margin: 0 auto; }
figcaption, .small { font-size: 0.88rem; color: #555; }
"""


def main():
    if len(sys.argv) != 2:
        print("usage: report.py DIR", file=sys.stderr)
        return 2
    try:
        run = Run(sys.argv[1])
        target = run.folder / "report.html"
        target.write_text(page(run, [(module, drawn(module, run)) for module in FIGURES]), encoding="utf-8")
    except RunError as error:
        print(f"shaken: {error}", file=sys.stderr)
        return 66
    except (OSError, KeyError, ValueError) as error:
        print(f"shaken: {sys.argv[1]}: the report cannot be made: {error}", file=sys.stderr)
        return 74 if isinstance(error, OSError) else 65
    return 0


def drawn(module, run):
    """Path of the figure, or in words why there is none: a layer without a shock has no picture of one."""
    try:
        return module.draw(run)
    except (ValueError, IndexError, TypeError) as error:
        print(f"shaken: {module.NAME} cannot be drawn: {error}", file=sys.stderr)
        return str(error)


def page(run, images):
    references = tomllib.loads(REFERENCES.read_text())
    name = html.escape(run.summary["scene"])
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>shaken: {name}</title><style>{STYLE}</style></head><body>
<h1>{name}: molecular dynamics and hydrodynamics of one shaken layer</h1>
<p>Lengths in particle diameters, times in (diameter/gravity)<sup>1/2</sup>. MD numbers carry one standard error (blocks of
cycles left out). A verdict (MD / continuum) is given only where a bound
or a tolerance was stated beforehand.</p>
<p>{period(run.summary)}</p>
{notes(run.summary)}
<h2>Numbers</h2>
{number_table(run.summary, references, run.is_of(references["scene"]))}
{second_cycle(run.summary)}
<h2>Where the equations hold</h2>
{validity_table(run.summary)}
<h2>Figures</h2>
{"".join(figure(module, path) for module, path in images)}
<h2>Centre of mass over the period</h2>
{centre_table(run.summary)}
<h2>What it took</h2>
{cost_table(run.summary)}
</body></html>
"""


def number_table(summary, references, judged):
    """Beside the references if the run is of their scene, else alone."""
    rows = []
    for number in references["number"]:
        if number["engines"]:
            md, continuum = find(summary["md"], number["key"]), find(summary["continuum"], number["key"])
        else:
            md, continuum = find(summary, number["key"]), None
        place = html.escape(number["place"])
        cells = [html.escape(number["words"]), f'<span title="{place}">{published(number)}</span>' if judged else "&ndash;"]
        if number["engines"]:
            cells += [shown(*md), shown(*continuum)]
            verdicts = [verdict(number, value[0]) for value in (md, continuum) if value[0] is not None]
        else:
            cells += [f'<td class="number" colspan="2">{shown(*md)}</td>']
            verdicts = [verdict(number, md[0])]
        rows.append(row(cells, verdicts if judged else []))
    table = "<table><tr><th>what</th><th>reference</th><th>MD</th><th>continuum</th><th>within</th></tr>" + "".join(rows) + "</table>"
    if judged:
        return table + origins(references)
    return table + '<p class="small">No reference is known for this scene. Phases above 1 belong to the next cycle.</p>'


def period(summary):
    """Over how many cycles each engine repeats itself."""
    def words(engine):
        cycles = summary[engine].get("period")
        return "too few cycles to tell" if not cycles else "1 cycle" if cycles == 1 else f"{cycles} cycles"
    return f"Period of the layer: {words('md')} (MD), {words('continuum')} (continuum)."


def second_cycle(summary):
    """The shock of the second cycle, where even and odd cycles are averaged apart."""
    if "second_cycle" not in summary["md"]:
        return ""
    keys = (("shock.formation_phase", "shock forms at ft"), ("shock.leaving_phase", "shock leaves the layer at ft"),
            ("shock.mean_speed", "mean shock speed"), ("max_mach", "largest Mach number"))
    rows = "".join(
        f'<tr><td>{words}</td>' + "".join(f'<td class="number">{shown(*find(summary[engine]["second_cycle"], key))}</td>' for engine in ("md", "continuum")) + "</tr>"
        for key, words in keys
    )
    return ("<h2>In the second cycle</h2><p>The numbers above, and figures of single phases, are of the first, the one with the higher centre of mass.</p>"
            f"<table><tr><th>what</th><th>MD</th><th>continuum</th></tr>{rows}</table>")


def notes(summary):
    """What limits the numbers, before them."""
    blocks = ""
    for engine, heading in (("md", "What to know of this MD"), ("continuum", "What to know of this continuum")):
        items = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in summary[engine].get("notes", []))
        blocks += f'<h2>{heading}</h2><ul class="notes">{items}</ul>' if items else ""
    return blocks


def validity_table(summary):
    """How far the continuum was driven beyond what its equations assume."""
    values = summary["continuum"].get("validity")
    if not values:
        return "<p>The continuum's run does not say: an earlier version made it.</p>"
    keys = (("knudsen", "Knudsen number, the mean free path times |dT/dz|/T", 1, ""),
            ("omega_tau", "&omega;&tau;, 2&pi;f times the mean time between collisions", 1, ""),
            ("packed_share", "share of all mass above &nu; = 0.6", 100, " %"))
    rows = "".join(
        f'<tr><td>{words}</td><td class="number">{factor * values[key]:.2g}{unit}</td>'
        f'<td class="number">{factor * values[key + "_largest"]:.2g}{unit}</td><td class="number">{factor * values[key + "_limit"]:.2g}{unit}</td></tr>'
        for key, words, factor, unit in keys
    )
    return ("<table><tr><th>continuum</th><th>mean, over the layer by mass and over the averaged cycles</th><th>largest</th><th>limit of the mean</th></tr>"
            f"{rows}</table>")


def row(cells, verdicts):
    body = "".join(c if c.startswith("<td") else f'<td class="number">{c}</td>' if i else f"<td>{c}</td>" for i, c in enumerate(cells))
    marks = [f'<span class="{"yes" if v else "no"}">{"yes" if v else "no"}</span>' for v in verdicts if v is not None]
    mark = " / ".join(marks) or "&ndash;"
    return f'<tr>{body}<td class="number">{mark}</td></tr>'


def find(values, key):
    """A number and its error by a key with dots; None where the summary has none."""
    *path, last = key.split(".")
    for part in path:
        values = values.get(part) or {}
    return values.get(last), values.get(last + "_error")


def published(number):
    value = f'{number["value"]:g}'
    match number["relation"]:
        case "near":
            return f'{value} &plusmn; {number["tolerance"]:g}'
        case "above":
            return f"&gt; {value}"
        case "below":
            return f"&lt; {value}"
    return f"&asymp; {value}"


def verdict(number, value):
    if value is None:
        return None if number["relation"] == "about" else False
    match number["relation"]:
        case "near":
            return abs(value - number["value"]) <= number["tolerance"]
        case "above":
            return value > number["value"]
        case "below":
            return value < number["value"]
    return None


def shown(value, error=None):
    if value is None:
        return "&ndash;"
    if not error:
        return f"{value:.4g}"
    places = max(0, 1 - int(f"{error:e}".split("e")[1]))
    return f"{value:.{places}f} &plusmn; {error:.{places}f}"


def origins(references):
    used = sorted({number["origin"] for number in references["number"]})
    items = "".join(f"<li>{html.escape(references['origins'][o])}</li>" for o in used)
    return f'<ul class="small">{items}</ul>'


def centre_table(summary):
    md, errors, continuum = summary["md"]["zcm"], summary["md"]["zcm_error"], summary["continuum"]["zcm"]
    rows = "".join(
        f'<tr><td class="number">{k / PHASES_A_CYCLE:.2f}</td><td class="number">{shown(md[k], errors[k])}</td>'
        f'<td class="number">{continuum[k]:.3f}</td><td class="number">{100 * (continuum[k] - md[k]) / md[k]:+.2f}</td>'
        f'<td class="number">{100 * (continuum[k] + 0.5 - md[k]) / md[k]:+.2f}</td></tr>'
        for k in range(len(md))
    )
    return ("<table><tr><th>ft</th><th>MD</th><th>continuum, floor at the plate</th><th>difference, %</th>"
            f"<th>floor half a diameter up, %</th></tr>{rows}</table>")


def cost_table(summary):
    keys = (("wall_seconds", "wall-clock seconds"), ("cpu_seconds", "processor seconds"),
            ("collisions_per_particle_per_cycle", "pair collisions per particle per cycle"), ("steps_per_cycle", "steps per cycle"))
    rows = "".join(
        f'<tr><td>{words}</td><td class="number">{shown(summary["md"].get(key))}</td>'
        f'<td class="number">{shown(summary["continuum"].get(key))}</td></tr>'
        for key, words in keys
    )
    return f"<table><tr><th></th><th>MD</th><th>continuum</th></tr>{rows}</table>"


def figure(module, path):
    if not isinstance(path, Path):
        return f"<p>{module.NAME} could not be drawn: {html.escape(path)}.</p>"
    data = base64.b64encode(path.read_bytes()).decode()
    caption = html.escape(module.CAPTION)
    return f'<figure><img alt="{module.NAME}" src="data:image/png;base64,{data}"><figcaption>{caption}</figcaption></figure>'


if __name__ == "__main__":
    sys.exit(main())
