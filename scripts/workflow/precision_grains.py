# SPDX-License-Identifier: MIT
"""Statistical error of the MD on ch4_shock: how far means over few cycles, few seeds or a narrow box lie from the mean of all long runs, and what no number of
cycles takes away: the width of the box and of the bins.

An error at M cycles is the rms deviation of parts of M cycles from the grand mean, measured, not inferred from error bars; its own error is that of a
standard deviation of so many parts.
"""
import shutil
import subprocess
from dataclasses import dataclass

import h5py
import numpy as np

import precision_points as table
from precision_study import FIELDS, LAYER, PHASES, differences, read_layer, rms, row
from precision_timings import cost_of

CYCLES = (1, 2, 5, 10, 15, 30, 75, 150)   # parts of the short runs up to 10, of the long ones from 15
SEEDS = (1, 2, 4, 8)                      # short runs together
CYCLES_OF_WIDTHS = 30
MOST_PARTS = 16                           # whose shock is looked for


@dataclass
class Part:
    """Cycles of one run in whole blocks: sums (phases, bins, 7), samples (phases), z_cm (phases) and the shock, when it has been looked for."""
    run: str
    blocks: range
    sums: np.ndarray
    samples: np.ndarray
    z_cm: np.ndarray


class Grains:
    """All long runs of one width: their mean, and the distance of parts of runs from it."""

    def __init__(self, study, width):
        self._study, self._width = study, width
        folder = study.folder / "comparisons" / f"md_{width}"
        with h5py.File(folder / "compare.h5") as file:
            self.plate = file["plate/velocity"][:]
        self.mean = read_layer(folder, "md")
        self._inside = self.mean.density > LAYER
        self._sizes = {name: rms(getattr(self.mean, name)[self._inside]) for name in FIELDS}

    def parts(self, run, cycles):
        """The run cut into parts of so many cycles."""
        with h5py.File(self._study.run(run) / "md.h5") as file:
            of = file["profiles"]
            sums, samples, heights = of["sums"][:], of["samples"][:], of["centre_of_mass"][:]
        each = cycles * len(sums) // len(heights)  # blocks a part
        for first in range(0, len(sums) - each + 1, each):
            blocks = range(first, first + each)
            start = first * len(heights) // len(sums)
            yield Part(run, blocks, sums[first:first + each].sum(axis=0), samples[first:first + each].sum(axis=0), heights[start:start + cycles].mean(axis=0))

    def fields(self, parts):
        """n, u relative to the plate and T of several parts together, as fields/phase_moments.hpp has them. Shapes (phases, bins)."""
        sums, samples = sum(p.sums for p in parts), sum(p.samples for p in parts)
        with h5py.File(self._study.run(parts[0].run) / "md.h5") as file:
            volume = file["profiles/area"][()] * file["profiles/bin_width"][()]
        return fields_of(sums, samples, volume, self.plate)

    def deviations(self, parts):
        """Mean squares of the deviation from the grand mean: z_cm relative, fields of their rms over the layer, shock of its height."""
        every = len(self.mean.z_cm) // PHASES
        z_cm = np.mean([p.z_cm for p in parts], axis=0)
        found = {"z_cm": np.mean((z_cm[::every] / self.mean.z_cm[::every] - 1) ** 2)}
        for name, ours in zip(FIELDS, self.fields(parts)):
            found[name] = np.nanmean((ours - getattr(self.mean, name))[self._inside] ** 2) / self._sizes[name] ** 2
        return found

    def shock_deviation(self, parts):
        shock = self._shock(parts)
        both = np.isfinite(shock) & np.isfinite(self.mean.shock)
        return np.mean((shock - self.mean.shock)[both] ** 2) / rms(self.mean.shock[both]) ** 2 if both.any() else np.nan

    def _shock(self, parts):
        """Found by `shaken compare` in copies of the runs that hold these blocks alone."""
        name = "+".join(f"{p.run}_{p.blocks.start}_{len(p.blocks)}" for p in parts)
        folder = self._study.folder / "parts" / name[:200]
        if not (folder / "compare.h5").is_file():
            folders = [copy_of_part(self._study.run(p.run), folder / f"part{i}", p) for i, p in enumerate(parts)]
            md = [word for each in folders for word in ("--md", str(each))]
            partner = self._study.run(f"continuum_{self._width}")
            subprocess.run([self._study.shaken, "compare", folder, *md, "--continuum", partner], check=True, stdout=subprocess.DEVNULL)
            for each in folders:
                shutil.rmtree(each)
        return read_layer(folder, "md").shock

    def errors(self, groups, within_mean):
        """{quantity: (per cent, its error)} of groups of parts; within_mean: they make up the grand mean, which then lies too near."""
        freed = len(groups) / (len(groups) - 1) if within_mean else 1.0
        squares = [self.deviations(parts) for parts in groups]
        found = {name: [s[name] for s in squares] for name in squares[0]}
        found["shock_location"] = [self.shock_deviation(parts) for parts in groups[:MOST_PARTS]]
        percent = {name: 100 * float(np.sqrt(freed * np.nanmean(values))) for name, values in found.items()}
        return {name: (value, value / np.sqrt(2 * max(1, np.isfinite(found[name]).sum() - 1))) for name, value in percent.items()}


def fields_of(sums, samples, volume, plate):
    with np.errstate(invalid="ignore", divide="ignore"):
        mass = sums[..., 0]
        mean = sums[..., 1:4] / mass[..., None]
        variance = (sums[..., 4:7] / mass[..., None] - mean**2) * np.where(mass > 1, mass / (mass - 1), np.nan)[..., None]
        return mass / (samples[:, None] * volume), mean[..., 2] - plate[:, None], variance.mean(axis=-1)


def copy_of_part(source, target, part):
    target.mkdir(parents=True, exist_ok=True)
    shutil.copy(source / "md.h5", target / "md.h5")
    with h5py.File(target / "md.h5", "r+") as file:
        of = file["profiles"]
        cycles = len(of["centre_of_mass"]) // len(of["sums"])
        blocks = slice(part.blocks.start, part.blocks.stop)
        kept = {"sums": of["sums"][blocks], "samples": of["samples"][blocks],
                "centre_of_mass": of["centre_of_mass"][part.blocks.start * cycles:part.blocks.stop * cycles]}
        for name, values in kept.items():
            del of[name]
            of[name] = values
    return target


def coarser(sums, factor):
    """Bins put together."""
    phases, bins, moments = sums.shape
    return sums[:, :bins // factor * factor].reshape(phases, -1, factor, moments).sum(axis=2)


def floor_of_bins(study, grains):
    """{width: {quantity: (per cent, its error)}}: what bins of the scene's width, and of twice it, lose of the fields in bins a quarter as wide. The loss is taken
    in two halves of the cycles, whose product has no noise in the mean."""
    with h5py.File(study.run("md_bins") / "md.h5") as file:
        of = file["profiles"]
        sums, samples, area = of["sums"][:], of["samples"][:], of["area"][()]
    middle = len(sums) // 2
    halves = [(sums[part].sum(axis=0), samples[part].sum(axis=0)) for part in (slice(0, middle), slice(middle, None))]
    whole = fields_of(sums.sum(axis=0), samples.sum(axis=0), area * table.BINS, grains.plate)
    inside = whole[0] > LAYER
    floors = {}
    for width in (0.5, 1.0):
        factor = int(width / table.BINS)
        losses = []
        for total, counted in halves:
            fine = fields_of(total, counted, area * table.BINS, grains.plate)
            coarse = fields_of(coarser(total, factor), counted, area * width, grains.plate)
            losses.append([np.repeat(c, factor, axis=1) - f[:, :c.shape[1] * factor] for c, f in zip(coarse, fine)])
        floors[width] = {name: loss_of(one, other, f, inside) for name, one, other, f in zip(FIELDS, *losses, whole)}
    return floors


def loss_of(one, other, field, inside):
    """Per cent of the field's rms over the layer, and its error."""
    inside = inside[:, :one.shape[1]]
    product = (one * other)[inside]
    product = product[np.isfinite(product)] / rms(field[:, :one.shape[1]][inside]) ** 2
    loss = float(np.sqrt(max(0.0, product.mean())))
    return 100 * loss, 100 * float(product.std() / np.sqrt(len(product))) / (2 * max(loss, 1e-6))


def collisions(study, run):
    """(in all, a cycle once settled) of a run."""
    with h5py.File(study.run(run) / "md.h5") as file:
        count = file["observables/pair_collisions/value"][:]
        phases = len(file["profiles/samples"][0])
    settled = count[table.SETTLE * phases:]
    return float(count[-1]), float(settled[-1] - settled[0]) / (len(settled) - 1) * phases


def parts_of_runs(grains, runs, cycles, most=None):
    return [part for run in runs for part in list(grains.parts(run, cycles))[:most]]


def groups_of_curves(grains):
    """(knob, value, cycles, seeds, groups of parts, whether they make up the grand mean), on the scene's box."""
    short_runs = [f"md_short_s{seed}" for seed in table.SHORT_SEEDS]
    for cycles in CYCLES:
        if cycles <= table.SHORT_CYCLES:
            yield "cycles", cycles, cycles, 1, [[p] for p in parts_of_runs(grains, short_runs, cycles, 2)], False
        else:
            yield "cycles", cycles, cycles, 1, [[p] for p in parts_of_runs(grains, table.long_runs(20), cycles)], True
    wholes = parts_of_runs(grains, short_runs, table.SHORT_CYCLES)
    for seeds in SEEDS:
        yield "seeds", seeds, table.SHORT_CYCLES, seeds, [wholes[i:i + seeds] for i in range(0, len(wholes), seeds)], False


class Cost:
    """Collisions and CPU seconds of so many cycles and seeds on a box, settling included."""

    def __init__(self, study):
        self._study, self._timings = study, study.timings()

    def __call__(self, width, cycles, seeds=1):
        run = table.long_runs(width)[0]
        whole, each = collisions(self._study, run)
        work = seeds * (whole + each * (cycles - table.WIDTHS[width][2]))
        return {"work": work} | cost_of(self._timings.get(run), whole, work)


def command_of(study, width, cycles):
    return study.command("md", table.CELL["ch4_shock"], table.grains(width, "K", cycles))


def rows_of_widths(study, widths, cost):
    """Scatter at equal cycles, and what the mean of a narrow box keeps from that of the widest however long it runs (with the statistical error of both)."""
    made, widest = [], max(widths)
    statistics = {}
    for width, grains in widths.items():
        groups = [[p] for p in parts_of_runs(grains, table.long_runs(width), CYCLES_OF_WIDTHS)]
        found = grains.errors(groups, True)
        statistics[width] = {q: error / np.sqrt(len(groups)) for q, (error, _) in found.items()}
        made += [row("md", "md", "events", "width", width, q, *pair, cost(width, CYCLES_OF_WIDTHS), width == table.DEFAULT_MD["width"], "completed",
                     command_of(study, width, CYCLES_OF_WIDTHS)) for q, pair in found.items()]
    for width in sorted(widths)[:-1]:
        floors = differences(widths[width].mean, widths[widest].mean)
        made += [row("md", "md", "events", "floor_width", width, q, error, np.hypot(statistics[width][q], statistics[widest][q]), {},
                     width == table.DEFAULT_MD["width"], "completed", command_of(study, width, table.WIDTHS[width][2])) for q, error in floors.items()]
    return made


def rows(study):
    widths = {width: Grains(study, width) for width in table.WIDTHS}
    grains, cost, made = widths[table.DEFAULT_MD["width"]], Cost(study), []
    for knob, value, cycles, seeds, groups, within in groups_of_curves(grains):
        is_default = knob == "cycles" and value == table.DEFAULT_MD["cycles"]
        made += [row("md", "md", "events", knob, value, q, *found, cost(20, cycles, seeds), is_default, "completed", command_of(study, 20, cycles))
                 for q, found in grains.errors(groups, within).items()]
    made += rows_of_widths(study, widths, cost)
    for width, floors in floor_of_bins(study, grains).items():
        made += [row("md", "md", "events", "floor_bin", width, q, *found, {}, width == 0.5, "completed",
                     study.command("md", table.CELL["ch4_shock"], table.md_runs()["md_bins"])) for q, found in floors.items()]
    return made
