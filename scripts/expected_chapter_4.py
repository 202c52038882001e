#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Keeps what scripts/reproduce ch4 found in data/expected (ch4_claims.toml, ch4_comparisons.csv, ch4_ledger.json) and prints what moved:

    scripts/expected_chapter_4.py out/ch4
"""
import json
import pathlib
import shutil
import sys
import tomllib

import h5py
import numpy as np

EXPECTED = pathlib.Path(__file__).resolve().parents[1] / "data" / "expected"
HEAD = """# Chapter 4 of the source, Gamma = 3, f = 0.095, e = 0.9, H = 9, from: scripts/reproduce ch4
# MD: six seeds of 150 cycles (error: one standard error); continuum: 5 cycles after 20, dz = 0.2, its upper end at 120. Phases are ft, speeds sqrt(g sigma).
"""
NOTES = {"continuum": "tolerance: round-off and the sensitivity of an argmax to it; a change of method may move them",
         "end_200": "the continuum with its upper end at 200", "wall_80": "a reflecting lid in the end's place", "shock_location": "rms difference in percent, from full formation on, in the lab frame, from that under a stress-free end at 200, by the end and its height",
         "closures": "rms difference of z_cm from MD in percent, floor at the plate",
         "one_cycle": "figure 4.6: mean shock speed from one state at ft = -0.33 (16 states), by e"}
HISTORY = ("formation_phase", "fully_formed_phase", "leaving_phase", "mean_speed", "fully_formed_speed", "fitted_speed")
PAIR = ("zcm_rms_percent", "zcm_rms_percent_half_diameter", "shock_location_rms_fully_formed", "density_rms", "velocity_rms", "temperature_rms")
ENDS = ("lid60", "lid80", "lid100", "lid120", "wall80", "wall200")
CLOSURES = ("jr_carnahan_starling", "jr_dense", "garzo_dufty", "gd_carnahan_starling")
RESTITUTIONS = ("0.75", "0.80", "0.85", "0.90", "0.95", "0.99", "1.00")


def with_errors(table, keys):
    return {name: round(table[name], 4) for key in keys for name in (key, key + "_error") if table.get(name) is not None}


def shock(comparison):
    """Height of the continuum's shock in the lab frame by phase, and the phases from full formation to leaving."""
    with h5py.File(comparison / "compare.h5") as file:
        phase, height = file["phase"][:], file["continuum/shock/location"][:] + file["plate/height"][:]
        formed, leaving = (file[f"continuum/shock/{name}_phase"][()] for name in ("fully_formed", "leaving"))
    return height, (phase > formed - 1e-9) & (phase <= leaving)


def shock_against_the_highest_end(comparisons, name):
    highest, followed = shock(comparisons / "lid200")
    here = shock(comparisons / name)[0]
    return 100 * float(np.sqrt(np.nanmean((here[followed] / highest[followed] - 1) ** 2)))


def claims(comparisons):
    def summary(name):
        return json.loads((comparisons / name / "summary.json").read_text())

    default = summary("default")
    heights = {engine: [round(z, 3) for z in default[engine]["zcm"]] for engine in ("md", "continuum")}
    found = {engine: with_errors(default[engine]["shock"], HISTORY) | with_errors(default[engine], ["max_mach"]) | {"zcm": heights[engine]}
             for engine in ("continuum", "md")}
    found["md"]["zcm_error"] = [round(error, 3) for error in default["md"]["zcm_error"]]
    found["pair"] = with_errors(default, PAIR)
    for name, comparison in (("end_200", "lid200"), ("wall_80", "wall80"), ("wall_200", "wall200")):
        found[name] = {"zcm": [round(z, 3) for z in summary(comparison)["continuum"]["zcm"]]}
    found["shock_location"] = {name: float(f"{shock_against_the_highest_end(comparisons, name):.3g}") for name in ENDS}
    found["law"] = {"md_fitted_speed": round(summary("law")["md"]["shock"]["fitted_speed"], 4),
                    "md_fitted_speed_error": round(summary("law")["md"]["shock"]["fitted_speed_error"], 4),
                    "continuum_fitted_speed": round(summary("law")["continuum"]["shock"]["fitted_speed"], 4)}
    found["closures"] = {name: value for closure in CLOSURES
                         for name, value in ((closure, round(summary(closure)["zcm_rms_percent"], 3)),
                                             (closure + "_error", round(summary(closure)["zcm_rms_percent_error"], 3)))}
    found["one_cycle"] = {}
    for e in RESTITUTIONS:
        md, continuum = (summary(f"e{e}")[engine]["shock"] for engine in ("md", "continuum"))
        found["one_cycle"][e] = {"md": round(md["mean_speed"], 3), "md_error": round(md["mean_speed_error"], 3),
                                 "continuum": round(continuum["mean_speed"], 3), "md_formed": round(md["fully_formed_speed"], 3),
                                 "continuum_formed": round(continuum["fully_formed_speed"], 3)}
    return found


def written(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {written(part)}" for key, part in value.items()) + " }"
    return json.dumps(value)


def text(found):
    parts = [HEAD]
    for section, table in found.items():
        note = f"  # {NOTES[section]}" if section in NOTES else ""
        lines = [f"{json.dumps(key) if '.' in key else key} = {written(value)}" for key, value in table.items()]
        parts.append(f"[{section}]{note}\n" + "\n".join(lines) + "\n")
    return "\n".join(parts)


def moved(before, after, name=""):
    if isinstance(after, dict):
        for key, value in after.items():
            moved(before.get(key, {}) if isinstance(before, dict) else {}, value, f"{name}.{key}" if name else key)
    elif before != after:
        print(f"{name}: {before if before != {} else 'new'} -> {after}")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    out = pathlib.Path(sys.argv[1])
    found = claims(out / "comparisons")
    path = EXPECTED / "ch4_claims.toml"
    moved(tomllib.loads(path.read_text()), found)
    path.write_text(text(found))
    shutil.copy(out / "comparisons.csv", EXPECTED / "ch4_comparisons.csv")
    shutil.copy(out / "figures" / "ledger.json", EXPECTED / "ch4_ledger.json")
    return 0


if __name__ == "__main__":
    sys.exit(main())
