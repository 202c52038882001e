# SPDX-License-Identifier: MIT
"""Tables of pattern measures that grow by one row a run, under data/expected; scripts/pattern_rows is the command."""
import csv
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

COLUMNS = ["value", "mean_square", "mean_square_error", "relative_mean_square", "order", "order_error", "interpolated_order", "interpolated_order_error", "wavelength", "angle",
           "coherent_share", "coherent", "coherent_error", "multiplier", "alternating_multiplier", "waves_x", "waves_y", "seconds", "command"]
WAVE_COLUMNS = ["value", "waves_x", "root_mean_square", "coherent", "coherent_error", "multiplier", "seconds", "command"]
FLUCTUATION_COLUMNS = ["value", "first_cycle", "wavelength", "waves", "power", "persistent", "persistent_error", "persistent_factor", "persistent_factor_error",
                       "alternating", "alternating_error", "alternating_factor", "alternating_factor_error", "seconds", "command"]
ONE_RUN = pathlib.Path(__file__).with_name("one_run.py")
ANGLES = 21
MOST_WAVES = 1000000  # all there are


@dataclasses.dataclass(frozen=True)
class Row:
    """One run of a sweep: a scene with `key` at `value`, and other changes."""
    engine: str
    scene: str
    key: str
    value: str
    overrides: tuple = ()
    waves: int = 0   # above 0: a line for each of so many waves along x, in place of one for the run
    fluctuations: int | None = None   # a line for each of the longest wavelengths: what lasts of it and what alternates, from this cycle on

    @property
    def settings(self):
        return [f"{self.key}={self.value}", *self.overrides]

    @property
    def command(self):
        return " ".join(["shaken", self.engine, self.scene, *(f"--set {setting}" for setting in self.settings)])

    @property
    def folder(self):
        """Its name where runs are kept."""
        words = [setting.partition(".")[2].replace("=", "_") for setting in self.settings]
        return "_".join([self.engine, pathlib.Path(self.scene).stem, *words])


def read(table):
    """Rows of a table as dictionaries of text; none where there is no table."""
    if not pathlib.Path(table).exists():
        return []
    with open(table, newline="") as file:
        return list(csv.DictReader(file))


def missing(table, wanted):
    known = {row["command"] for row in read(table)}
    return [row for row in wanted if row.command not in known]


def fill(table, wanted, shaken, runs=None, renewal=None):
    """Makes the rows that `table` lacks, one after another; an exit code. Runs are kept and taken up again under `runs`, if given. renewal: makes
    those that it calls stale anew in their place (patterns_study.Renewal)."""
    table = pathlib.Path(table)
    lacking = missing(table, wanted)
    for row in [row for row in wanted if row in lacking or renewal and renewal.is_stale(row)]:
        with tempfile.TemporaryDirectory() as aside:
            folder = pathlib.Path(runs or aside) / row.folder
            if renewal:
                renewal.prepare(folder, row)
            ended = folder / f"{row.engine}.end.json"
            if not ended.is_file():
                code = subprocess.run([sys.executable, "-B", ONE_RUN, shaken, row.engine, folder, row.scene, *row.settings], check=False).returncode
                if code:
                    return code
            end = json.loads(ended.read_text())
            remove(table, row.command)
            if end["exit_code"]:
                print(f"{row.command}: {' '.join(end['said'])}; no row", file=sys.stderr)
                continue
            first = [] if row.fluctuations is None else ["--from", str(row.fluctuations)]
            printed = subprocess.run([shaken, "patterns", folder, "--json", "--waves", str(MOST_WAVES), *first], check=True, capture_output=True, text=True)
        found, seconds = json.loads(printed.stdout)[row.engine], end["seconds"]
        if row.waves:
            along = [wave for wave in found["waves"] if wave["waves_y"] == 0 and 0 < wave["waves_x"] <= row.waves]
            add_lines(table, row, WAVE_COLUMNS, sorted(along, key=lambda wave: wave["waves_x"]), seconds)
        elif row.fluctuations is not None:
            add_lines(table, row, FLUCTUATION_COLUMNS, [line | {"first_cycle": row.fluctuations} for line in found["fluctuations"]], seconds)
        else:
            add(table, row, found, seconds)
        if renewal:
            renewal.made(row)
    return 0


def remove(table, command):
    """Takes the lines of one run out of a table, and its blocks out of the table beside."""
    table = pathlib.Path(table)
    lines = read(table)
    if not any(line["command"] == command for line in lines):
        return
    blocks = table.with_suffix(".blocks.csv")
    if blocks.exists():
        value = next(float(line["value"]) for line in lines if line["command"] == command)
        number = [line["command"] for line in lines if float(line["value"]) == value].index(command) + 1
        # Runs of one value are numbered in the order of the table: those behind move up.
        others = [block for block in read(blocks) if (float(block["value"]), int(block["run"])) != (value, number)]
        for block in others:
            block["run"] = int(block["run"]) - (float(block["value"]) == value and int(block["run"]) > number)
        write(blocks, others)
    write(table, [line for line in lines if line["command"] != command])


def write(table, lines):
    """The table with these lines, under the columns that it has."""
    with open(table, newline="") as file:
        columns = next(csv.reader(file))
    aside = table.with_suffix(".part")
    with open(aside, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)
    aside.rename(table)


def add(table, row, found, seconds):
    """A row, and its blocks of cycles in the table beside."""
    columns = COLUMNS
    if table.exists():
        with open(table, newline="") as file:
            columns = next(csv.reader(file))
    else:
        table.write_text(",".join(columns) + "\n")
    cells = {name: found[name] for name in columns if name in found}
    cells |= {name: found["waves"][0][name] for name in columns if name in found["waves"][0]}
    cells |= {"value": row.value, "seconds": round(seconds, 1), "command": row.command}
    with open(table, "a", newline="") as file:
        csv.DictWriter(file, columns, restval="nan", lineterminator="\n").writerow({name: digits(cell) for name, cell in cells.items()})
    print(f"{row.command}: <psi^2> {digits(found['mean_square'])}, P_max {digits(found['order'])}", flush=True)
    if row.engine == "md":
        add_blocks(table, row, found)


def add_blocks(table, row, found):
    """The spectrum of each block of cycles; a continuum's cycles do not scatter."""
    run = sum(float(other["value"]) == float(row.value) for other in read(table))
    blocks = table.with_suffix(".blocks.csv")
    if not blocks.exists():
        blocks.write_text(",".join(["value", "run", "block", "mean_square", *(f"power_{a}" for a in range(ANGLES))]) + "\n")
    with open(blocks, "a", newline="") as file:
        for number, block in enumerate(found["blocks"]):
            csv.writer(file, lineterminator="\n").writerow([row.value, run, number, digits(block["mean_square"]), *map(digits, block["power_by_angle"])])


def add_lines(table, row, columns, lines, seconds):
    """Lines of one run, the longest wave first."""
    if not table.exists():
        table.write_text(",".join(columns) + "\n")
    with open(table, "a", newline="") as file:
        for line in lines:
            cells = line | {"value": row.value, "seconds": round(seconds, 1), "command": row.command}
            csv.DictWriter(file, columns, lineterminator="\n").writerow({name: digits(cells[name]) for name in columns})
    print(f"{row.command}: {len(lines)} waves", flush=True)


def digits(cell):
    return "nan" if cell is None else f"{cell:.6g}" if isinstance(cell, float) else cell
