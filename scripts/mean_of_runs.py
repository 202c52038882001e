#!/usr/bin/python3
"""Mean and standard error over runs that differ in their seeds: scripts/mean_of_runs.py DIR DIR ...

Reads summary.json of each folder. The rms difference of z_cm is taken of the mean z_cm of all runs, since noise adds to the
rms of a single one; its error is a jackknife over runs. Runs that are not independent are refused (65): the md.h5 that the summaries
name must be there to tell.
"""
import json
import math
import pathlib
import sys

sys.dont_write_bytecode = True
import independent_runs

NUMBERS = ("md.shock.formation_phase", "md.shock.fully_formed_phase", "md.shock.leaving_phase", "md.shock.mean_speed",
           "md.max_mach", "md.width_over_mean_free_path", "md.collisions_per_particle_per_cycle",
           "continuum.shock.formation_phase", "continuum.shock.fully_formed_phase", "continuum.shock.leaving_phase",
           "continuum.shock.mean_speed", "continuum.max_mach", "continuum.width_over_mean_free_path", "shock_location_rms")


def find(summary, key):
    for part in key.split("."):
        summary = (summary or {}).get(part)
    return summary


def mean_and_error(values):
    mean = sum(values) / len(values)
    spread = sum((value - mean) ** 2 for value in values)
    return mean, math.sqrt(spread / (len(values) * (len(values) - 1))) if len(values) > 1 else math.nan


def rms_percent(summaries, lift):
    """Root mean square over equal phases of (continuum + lift - MD)/MD, of the mean heights, in percent."""
    md = [mean_and_error(values)[0] for values in zip(*(s["md"]["zcm"] for s in summaries))]
    continuum = [mean_and_error(values)[0] for values in zip(*(s["continuum"]["zcm"] for s in summaries))]
    return 100 * math.sqrt(sum(((c + lift - m) / m) ** 2 for m, c in zip(md, continuum)) / len(md))


def jackknife(number, summaries):
    whole, n = number(summaries), len(summaries)
    if n < 2:
        return whole, math.nan
    parts = [number(summaries[:i] + summaries[i + 1:]) for i in range(n)]
    mean = sum(parts) / n
    return whole, math.sqrt((n - 1) / n * sum((part - mean) ** 2 for part in parts))


def main():
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    summaries = [json.loads((pathlib.Path(folder) / "summary.json").read_text()) for folder in sys.argv[1:]]
    if code := independent_runs.exit_code_of("mean_of_runs", [run for summary in summaries for run in summary["runs"]["md"]]):
        return code
    if len({len(summary["md"]["zcm"]) for summary in summaries}) > 1:
        print("mean_of_runs: some of these layers have a period of one cycle, some of two; they have no common mean", file=sys.stderr)
        return 65
    print(f"{len(summaries)} runs")
    for key in NUMBERS:
        values = [value for value in (find(summary, key) for summary in summaries) if value is not None]
        if values:
            mean, error = mean_and_error(values)
            print(f"{key:48} {mean:10.5g} +- {error:.2g}   ({len(values)})")
    for name, lift in (("zcm_rms_percent", 0.0), ("zcm_rms_percent_half_diameter", 0.5)):
        value, error = jackknife(lambda runs: rms_percent(runs, lift), summaries)
        print(f"{name:48} {value:10.5g} +- {error:.2g}")
    errors = [s["md"]["zcm_error"] for s in summaries]
    scatter = [mean_and_error(values)[1] * math.sqrt(len(values)) for values in zip(*(s["md"]["zcm"] for s in summaries))]
    said = math.sqrt(sum(e * e for run in errors for e in run) / sum(len(run) for run in errors))
    print(f"{'scatter of z_cm between runs, rms over phases':48} {math.sqrt(sum(s * s for s in scatter) / len(scatter)):10.3g}   a run says {said:.3g}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
