#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Holds what `shaken plan` foretells against what its scenes then take and miss:

    scripts/check_plans.py [--out out/plans] [--only NAME ...] [--shaken build/release/shaken]

Each scene of SCENES is planned and run. Times are CPU seconds of the whole process. Found error of the continuum: rms over 20 phases of z_cm against a grid four times (where
that is long, twice) as fine, steps half as long for their size, more cycles to settle, under the highest lid that a plan knows (square: twice the planned one; a part of the lid's error then hides). Found error of the MD: scatter of
z_cm over blocks (a tenth of a run, even, at least two cycles) of SEEDS runs of the planned length. Four rows a scene in data/expected/plans.csv, where those of other scenes
stay, and a figure beside the runs. What is there already is not computed again; a row lives in OUT/NAME/rows.json and goes with its folder.
"""
import argparse
import csv
import json
import pathlib
import resource
import subprocess
import sys

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
TABLE = ROOT / "data/expected/plans.csv"
UNKNOWN = float("nan")  # an empty cell would be read as 0
SEEDS = 6
PHASES = 20
LONG = 30.0  # CPU seconds above which the fine grid is twice, not four times as fine
HIGHEST = 400.0  # lid
TIME_WITHIN, ERROR_WITHIN = 1.5, 2.0
COLUMNS = ["scene", "wish", "engine", "quantity", "foretold", "foretold_uncertainty", "found", "found_uncertainty", "ratio", "within", "command"]

CH4, CH5, GROWTH = "ch4_shock", "ch5_stripes", "ch5_growth"
SMALL = ("box.x=12", "box.y=12", "particles.number=864")
WALTON = 'particles.friction={law="walton", beta0=0.35, mu=0.5}'
VELOCITY = 'particles.restitution={law="velocity", e0=0.9, v0=1.0}'
SCENES = {
    "shock": (CH4, (), "--error 0.5%"),
    "shock_seconds": (CH4, (), "--seconds 4"),
    "depth_4.5": (CH4, ("particles.number=1969",), "--error 1%"),
    "depth_13.5": (CH4, ("particles.number=5906",), "--error 0.5%"),
    "velocity_law": (CH4, (VELOCITY,), "--seconds 3"),
    "e_0.75": (CH4, ("particles.restitution=0.75",), "--error 1%"),
    "e_0.8": (CH4, ("particles.restitution=0.8",), "--error 0.4%"),
    "e_0.99": (CH4, ("particles.restitution=0.99",), "--error 2%"),
    "gamma_2": (CH4, ("plate.acceleration=2",), "--error 0.3%"),
    "gamma_6": (CH4, ("plate.acceleration=6",), "--error 2%"),
    "shallow": (CH4, ("particles.number=1312",), "--seconds 3"),
    "faster": (CH4, ("plate.frequency=0.12",), "--error 1%"),
    "stripes_small": (CH5, SMALL, "--error 0.5%"),
    "friction_small": (CH5, (*SMALL, WALTON), "--error 1%"),
    "strip": (GROWTH, (), "--error 1%"),
    "square": (CH5, ("box.x=20", "box.y=20", "particles.number=2400", "sample.settle=6", "sample.phases=20"), "--error 2%"),
}


def words_of(changes):
    return [word for change in changes for word in ("--set", change)]


def cpu_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class Failed(Exception):
    """What `shaken` said in place of a plan, or of what a planned run should give."""


class Check:
    def __init__(self, shaken, out, name):
        self.shaken, self.folder = shaken, out / name
        self.scene, self.changes, self.wish = SCENES[name]
        self.name = name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.planned = self.folder / "planned.toml"
        self.command = " ".join(["shaken plan", f"data/scenes/{self.scene}.toml", *(f"--set '{c}'" for c in self.changes), self.wish])

    def plan(self):
        path = self.folder / "plan.json"
        if not path.exists():
            done = subprocess.run([self.shaken, "plan", ROOT / f"data/scenes/{self.scene}.toml", *words_of(self.changes), *self.wish.split(), "--json",
                                   "--overwrite", "--out", self.planned], capture_output=True, text=True, check=False)
            if done.returncode:
                raise Failed(f"no plan: {last_line(done.stderr)}")
            path.write_text(done.stdout)
        return json.loads(path.read_text())

    def run(self, engine, name, changes):
        """z_cm (cycles averaged, phases) and CPU seconds; kept in a small file, the run itself goes."""
        kept = self.folder / f"{name}.npz"
        if not kept.exists():
            out = self.folder / name
            changes = ["sample.frames=0", "sample.map_bin=0", *changes]
            before = cpu_of_children()
            done = subprocess.run([self.shaken, engine, self.planned, *words_of(changes), "--quiet", "--overwrite", "--out", out], check=False,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            if done.returncode:
                raise Failed(f"{name} fails: {last_line(done.stderr)}")
            seconds = cpu_of_children() - before
            with h5py.File(out / f"{engine}.h5") as file:
                heights = file["observables/centre_of_mass/value"][:]
                average, phases = file["profiles/centre_of_mass"].shape
            heights = heights.reshape(-1, phases)[:, :: phases // PHASES]
            np.savez(kept, heights=heights[-average:], seconds=seconds)
            for file in (*out.glob("*"), out):
                file.rmdir() if file.is_dir() else file.unlink()
        with np.load(kept) as file:
            return file["heights"], float(file["seconds"])

    def continuum(self, plan):
        c = plan["continuum"]
        found, seconds = self.run("continuum", "continuum", [f"sample.average={c['average']}"])
        lid = HIGHEST if c["dimension"] < 3 else 2 * c["lid"]
        more = 3 * seconds * lid / c["lid"] * (c["settle"] + 16) / c["settle"]
        finer = 4 if more * 4**2 < LONG else 2
        changes = ["sample.phases=20", f"continuum.spacing={c['spacing'] / finer}", f"continuum.lid={lid}", "continuum.cfl=0.4", f"sample.settle={c['settle'] + 16}",
                   f"sample.average={max(4, c['average'])}"]
        if c["dimension"] > 1:
            changes += [f"continuum.spacing_horizontal={c['spacing_horizontal'] / 2}", f"sample.settle={c['settle']}", f"sample.average={c['average']}"]
        fine, _ = self.run("continuum", "fine", changes)
        return seconds, relative(found.mean(axis=0), fine.mean(axis=0))

    def grains(self, plan):
        m = plan["md"]
        runs = [self.run("md", f"md_{seed}", [f"md.seed={seed}", f"initial.seed={seed}"]) for seed in range(1, SEEDS + 1)]
        cycles, seconds = zip(*runs)
        parts = len(cycles[0]) // max(2, len(cycles[0]) // 20 * 2)
        blocks = np.array([block.mean(axis=0) for run in cycles for block in np.array_split(run, parts)])
        scatter = np.sqrt(np.mean((blocks.std(axis=0, ddof=1) / blocks.mean(axis=0)) ** 2))
        return float(np.mean(seconds)) * m["seeds"], float(scatter) / np.sqrt(parts * m["seeds"]), 1 / np.sqrt(2 * (SEEDS * parts - 1))

    def rows(self):
        path = self.folder / "rows.json"
        if path.exists():
            return json.loads(path.read_text())
        try:
            rows = self.measured()
        except Failed as failed:
            rows = [{name: UNKNOWN for name in COLUMNS} | {"scene": self.name, "wish": self.wish, "engine": "", "quantity": str(failed), "within": 0,
                                                      "command": self.command}]
        path.write_text(json.dumps(rows, indent=1) + "\n")
        return rows

    def measured(self):
        plan = self.plan()
        rows = []

        def row(engine, quantity, foretold, uncertainty, found, found_uncertainty, within):
            ratio = found / foretold
            rows.append({"scene": self.name, "wish": self.wish, "engine": engine, "quantity": quantity, "foretold": foretold,
                         "foretold_uncertainty": uncertainty, "found": found, "found_uncertainty": found_uncertainty, "ratio": ratio,
                         "within": int(1 / within <= ratio <= within), "command": self.command})

        c, m = plan["continuum"], plan["md"]
        seconds, error = self.continuum(plan)
        row("continuum", "seconds", c["seconds"], UNKNOWN, seconds, UNKNOWN, TIME_WITHIN)
        row("continuum", "error_percent", 100 * c["error"], UNKNOWN, 100 * error, UNKNOWN, ERROR_WITHIN)
        seconds, error, uncertainty = self.grains(plan)
        row("md", "seconds", m["seconds"], UNKNOWN, seconds, UNKNOWN, TIME_WITHIN)
        row("md", "error_percent", 100 * m["error_statistics"], 100 * m["error_statistics"] * m["error_statistics_uncertainty"], 100 * error,
            100 * error * uncertainty, ERROR_WITHIN)
        return rows


def last_line(said):
    return (said.strip().splitlines() or [""])[-1]


def relative(a, b):
    return float(np.sqrt(np.mean((a / b - 1.0) ** 2)))


def said(row):
    if not row["engine"]:
        return row["quantity"] + " (!)"
    return f"{row['engine']} {row['quantity']} {row['foretold']:.3g} -> {row['found']:.3g}{'' if row['within'] else ' (!)'};"


def kept_rows():
    """{scene: rows} of the table, as text."""
    kept = {}
    if TABLE.exists():
        with open(TABLE, newline="") as table:
            for row in csv.DictReader(table):
                kept.setdefault(row["scene"], []).append(row)
    return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/plans")
    parser.add_argument("--only", nargs="+", choices=list(SCENES), default=list(SCENES))
    parser.add_argument("--shaken", type=pathlib.Path, default=ROOT / "build/release/shaken")
    options = parser.parse_args()
    out = options.out.resolve()
    for name in options.only:
        new = Check(options.shaken.resolve(), out, name).rows()
        print(f"{name:16} {new[0]['wish']:14}", *map(said, new), flush=True)
    fresh = {name: json.loads((out / name / "rows.json").read_text()) for name in SCENES if (out / name / "rows.json").exists()}
    done = {name: rows for name, rows in (kept_rows() | fresh).items() if name in SCENES}
    with open(TABLE, "w", newline="") as table:
        writer = csv.DictWriter(table, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()} for rows in done.values() for row in rows)
    kept = [name for name, rows in done.items() if all(int(r["within"]) for r in rows)]
    print(f"{len(kept)} of {len(done)} scenes keep every promise; not: {', '.join(name for name in done if name not in kept) or 'none'}")
    return subprocess.run([sys.executable, "-B", ROOT / "scripts/figures/plans.py", TABLE, out / "figures"], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
