# SPDX-License-Identifier: MIT
"""How well the fit of the noise finds a noise that is known: fields of the Swift-Hohenberg model itself, fitted as measurements are.

A row of the table is one seed and one length of averages. Rows that are there are not made again.
"""
import concurrent.futures
import csv
import json
import pathlib
import subprocess
import tempfile

import rows

KNOWN_NOISE, KNOWN_ONSET = 1.2e-2, 1.965     # the source's F and Gamma_MF at f* = 0.4174
KNOWN_SCALE = 2.0                            # <psi^2> of the MD over that of the model, about
CONTROLS = [round(-0.18 + 0.02 * i, 2) for i in range(19)]
SEEDS = range(77, 87)
LENGTHS = (2000, 12000)                      # steps averaged over: the source's, and six times as many
COLUMNS = ["steps", "seed", "noise", "noise_low", "noise_high", "mean_field_onset", "mean_field_onset_error", "onset", "scale"]


def fit_of_field(shaken, model, steps, seed, settle=8000):
    """What the fit says of one field, told to it as a table against Gamma."""
    words = ["swift-hohenberg", "--noise", str(KNOWN_NOISE), "--seed", str(seed), "--settle", str(settle), "--average", str(steps), "--control", ",".join(map(str, CONTROLS))]
    said = subprocess.run([shaken, *words], check=True, stdout=subprocess.PIPE, text=True).stdout
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
        out = csv.writer(table)
        out.writerow(["value", "mean_square", "order", "mean_square_error", "order_error"])
        for state in map(json.loads, said.splitlines()):
            out.writerow([KNOWN_ONSET * (1 + state["control"]), KNOWN_SCALE * state["mean_square"], state["order"], KNOWN_SCALE * state["mean_square_error"],
                          state["order_error"]])
        table.flush()
        return json.loads(subprocess.run([shaken, "fit-noise", table.name, "--model", model], check=True, stdout=subprocess.PIPE, text=True).stdout)


def fill(table, model, shaken, jobs):
    """Makes the rows that the table lacks, the quick ones first."""
    table = pathlib.Path(table)
    there = {(int(row["steps"]), int(row["seed"])) for row in rows.read(table)}
    lacking = [(steps, seed) for steps in LENGTHS for seed in SEEDS if (steps, seed) not in there]
    if not table.exists():
        table.write_text(",".join(COLUMNS) + "\n")
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for (steps, seed), fit in zip(lacking, pool.map(lambda point: fit_of_field(shaken, model, *point), lacking)):
            with open(table, "a", newline="") as file:
                csv.DictWriter(file, COLUMNS, lineterminator="\n").writerow({"steps": steps, "seed": seed} | {name: rows.digits(fit[name]) for name in COLUMNS[2:]})
            print(f"seed {seed}, {steps} steps: F = {fit['noise']:.3g}", flush=True)
