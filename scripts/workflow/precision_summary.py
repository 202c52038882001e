# SPDX-License-Identifier: MIT
"""OUT/summary.md: the tables of docs/work_precision.md, written from the rows: the defaults, what each scheme needs for an error, what holds the error of a
layer up."""
import numpy as np

QUANTITIES = {"ch4_shock": ("z_cm", "density", "velocity", "temperature", "shock_location"), "stripes": ("z_cm", "wave"), "riemann": ("density", "velocity", "temperature"),
              "md": ("z_cm", "density", "velocity", "temperature", "shock_location")}
WANTED = {("ch4_shock", "z_cm"): (0.3, 0.1, 0.03), ("ch4_shock", "temperature"): (3.0, 1.0, 0.3), ("stripes", "wave"): (10.0, 3.0, 1.0), ("riemann", "density"): (1.0, 0.3, 0.1)}


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def digits(value):
    return "" if not np.isfinite(value) else f"{value:.2g}"


def defaults(rows):
    """One line a study: errors at the scene's settings, CPU seconds and work of the run."""
    found = []
    for study, quantities in QUANTITIES.items():
        at = [r for r in rows if r["study"] == study and r["default"] == 1 and not r["knob"].startswith(("floor", "width"))]
        if not at:
            continue
        errors = {r["quantity"]: r for r in at}
        words = "; ".join(f"{q} {digits(errors[q]['error_percent'])} +- {digits(errors[q]['error_of_error'])}" for q in quantities if q in errors)
        found.append([study, f"{at[0]['scheme']}", words, digits(at[0]["cpu_seconds"]), digits(at[0]["work"])])
    return table(["study", "scheme", "error, %", "CPU s", "updates or collisions"], found)


def cheapest(rows, study, scheme, quantity, error):
    """The point of least CPU seconds at which, and at every finer one of its curve, the error is as small."""
    best = None
    for knob in {r["knob"] for r in rows if r["study"] == study}:
        curve = sorted((r for r in rows if (r["study"], r["scheme"], r["quantity"], r["knob"]) == (study, scheme, quantity, knob) and r["end"] == "completed"),
                       key=lambda r: r["value"])
        for r in curve:
            if not r["error_percent"] <= error:
                break
            if best is None or r["cpu_seconds"] < best["cpu_seconds"]:
                best = r
    return f"{best['knob']} {best['value']:g}: {digits(best['cpu_seconds'])} s" if best else "not reached"


def costs(rows):
    """What each scheme pays for an error."""
    found = []
    for (study, quantity), errors in WANTED.items():
        for error in errors:
            found.append([study, quantity, f"{error:g} %", *(cheapest(rows, study, scheme, quantity, error) for scheme in ("muscl", "weno5", "ftcs"))])
    return table(["study", "quantity", "error", "muscl", "weno5", "ftcs"], found)


def grains(rows):
    """Statistical error of the MD over cycles and widths, and its floors."""
    quantities = QUANTITIES["md"]
    found = []
    for knob in ("cycles", "seeds", "width", "floor_width", "floor_bin"):
        values = sorted({r["value"] for r in rows if r["study"] == "md" and r["knob"] == knob})
        for value in values:
            at = {r["quantity"]: r for r in rows if r["study"] == "md" and r["knob"] == knob and r["value"] == value}
            found.append([knob, f"{value:g}", *(f"{digits(at[q]['error_percent'])} +- {digits(at[q]['error_of_error'])}" if q in at else "" for q in quantities),
                          digits(next(iter(at.values()))["cpu_seconds"])])
    return table(["knob", "value", *quantities, "CPU s"], found)


def models(rows):
    """Error of the model by closure and height of the upper end, floor at the plate and half a diameter up."""
    found = []
    at = [r for r in rows if r["study"] == "model"]
    for scheme in dict.fromkeys(r["scheme"] for r in at):
        for lid in sorted({r["value"] for r in at}):
            errors = {r["quantity"]: digits(r["error_percent"]) for r in at if r["scheme"] == scheme and r["value"] == lid}
            found.append([scheme, f"{lid:g}", *(f"{errors.get(q, '')}; {errors.get(q + '_half_diameter', '')}" for q in QUANTITIES["md"])])
    return table(["closure", "upper end", *QUANTITIES["md"]], found)


def text(rows):
    parts = {"At the defaults": defaults(rows), "What an error costs": costs(rows), "Grains": grains(rows), "Models": models(rows)}
    return "\n".join(f"## {title}\n\n{part}" for title, part in parts.items())
