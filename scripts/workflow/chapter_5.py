# SPDX-License-Identifier: MIT
"""The runs, rows and figures of chapter 5: stripes, their wavelength, their motion, and what the continuum lacks.

Rows are kept under data/expected and made only where one is lacking; ROWS=kept in the environment makes none. Runs, in the words of
workflow/Snakefile, go to OUT/runs and are made again in every new OUT.
"""
import dataclasses

import patterns_study
from rows import Row

STRIPES = "data/scenes/ch5_stripes.toml"
STRIP = "data/scenes/ch5_growth.toml"
DISPERSION = "data/scenes/ch5_dispersion.toml"
DISPERSION_MD = "data/expected/ch5_dispersion_md.csv"
DISPERSION_CONTINUUM = "data/expected/ch5_dispersion_continuum.csv"
GROWTH = "data/expected/ch5_growth.csv"
CONVERGED = "data/expected/ch5_converged.csv"

PUBLISHED = 2.2   # Gamma of the chapter
# The lowest end that the gas of one column does not reach; where it is not 25.
UPPER_END = {"0.15": 80, "0.2": 60, "0.25": 40}
WAVING = 3.6      # Gamma at which the continuum has stripes: its waves grow above 3.36, and at 4.0 the layer has a period of two and is flat (docs/validation.md)
FREQUENCIES = ("0.15", "0.2", "0.25", "0.3", "0.35", "0.4", "0.4174", "0.45", "0.5")

# The open question: each choice that could make the published onset, by the settings that make it.
GOLDSHTEIN = ("continuum.closure=jenkins_richman", "continuum.pair_correlation=goldshtein")
DENSE = ("continuum.closure=jenkins_richman_dense", "continuum.pair_correlation=goldshtein")  # the closure that ftcs can run
CONSTANT = ("continuum.restitution=0.7",)
# Its waves grow by a quarter a cycle: from one per cent they would be full-grown before they are looked at.
FLUID = ("continuum.closure=jenkins_richman_fluid", "continuum.pair_correlation=goldshtein", "initial.wave=1e-5")
CHOICES = {
    "default": GOLDSHTEIN,
    "constant e": GOLDSHTEIN + CONSTANT,
    "carnahan_starling": ("continuum.closure=jenkins_richman", "continuum.pair_correlation=carnahan_starling"),
    "carnahan_starling, constant e": ("continuum.closure=jenkins_richman", "continuum.pair_correlation=carnahan_starling") + CONSTANT,
    "garzo_dufty": ("continuum.closure=garzo_dufty", "continuum.pair_correlation=goldshtein"),
    "fluid transport": FLUID,
    "fluid transport, constant e": FLUID + CONSTANT,
    "Bocquet's viscosity": ("continuum.closure=jenkins_richman_bocquet", "continuum.pair_correlation=goldshtein"),
    "no 1/G terms": DENSE,
    "no 1/G terms, constant e": DENSE + CONSTANT,
    "ftcs, no 1/G terms, C_AD 0.1": DENSE + ("continuum.scheme=ftcs",),
    "ftcs, no 1/G terms, C_AD 0.4": DENSE + ("continuum.scheme=ftcs", "continuum.artificial_dissipation=0.4"),
    "the source's: ftcs, no 1/G terms, constant e": DENSE + CONSTANT + ("continuum.scheme=ftcs",),
}
WIDE = ("continuum.spacing_horizontal=2",)
ACCELERATIONS = ("2.0", "2.2", "2.6", "3.0", "3.4", "3.8")
# On the scene's own columns, 1 wide, what tells whether a choice hangs on the grid; converged_rows() says how much of it the grid is.
SOME = ("2.2", "3.0", "3.4")
ON_NARROW = {"default": ACCELERATIONS, "carnahan_starling": SOME, "garzo_dufty": SOME, "fluid transport": ("2.2",), "no 1/G terms": SOME}
# Others: waves of a fluid's transport grow below 2 (at 1.4 the layer freezes, at 1.6 the wave is full-grown after twelve cycles); ftcs takes eight times as long.
OF_FLUID_STRIP = ("0.4174", "0.35", "0.3", "0.25")   # frequencies; the last two take some ten minutes each
OF_FLUID, OF_FTCS = ("1.8", "2.0", "2.2", "2.6", "3.0"), ("2.2", "3.0", "3.4")
STRIPS = ("2.0", "2.6")   # Gamma of the strips whose waves of momentum are looked at: flat, and with stripes; no whole number of diameters wide
BESIDE_THE_ONSET = ("2.2", "3.0", "3.2", "3.4")
FROZEN = 2.0   # with constant e and less transport than the default's the layer freezes up to here, and the run ends
SQUARES = ("1.8", "2.0", "2.1", "2.15", "2.2", "2.3", "2.6")   # Gamma of the cells of 42 x 42 whose order is looked at


def growth_rows():
    def accelerations(choice):
        planned = OF_FLUID if choice[:len(FLUID)] == FLUID else OF_FTCS if "continuum.scheme=ftcs" in choice else ACCELERATIONS
        return [gamma for gamma in planned if CONSTANT[0] not in choice or choice[0] == GOLDSHTEIN[0] or float(gamma) > FROZEN]

    wide = [Row("continuum", STRIP, "plate.acceleration", gamma, choice + WIDE) for choice in CHOICES.values() for gamma in accelerations(choice)]
    return wide + [Row("continuum", STRIP, "plate.acceleration", gamma, CHOICES[name]) for name, planned in ON_NARROW.items() for gamma in planned]


def converged_rows():
    """The default choice on columns ever narrower, and on columns 1 wide with finer rows, shorter steps and higher ends."""
    columns = [(f"continuum.spacing_horizontal={dx}",) for dx in ("2", "1", "0.5", "0.25")]
    others = [(columns[1][0], change) for change in ("continuum.spacing=0.1", "continuum.cfl=0.4", "continuum.lid=50", "continuum.lid=100")]
    return [Row("continuum", STRIP, "plate.acceleration", gamma, choice) for choice in columns + others for gamma in BESIDE_THE_ONSET]


def dispersion_rows():
    """Of MD; two more seeds where the wavelength is furthest from the fit."""
    return [Row("md", DISPERSION, "plate.frequency_star", f) for f in FREQUENCIES] + [
        Row("md", DISPERSION, "plate.frequency_star", "0.4", (f"initial.seed={seed}", f"md.seed={seed}")) for seed in (2, 3)]


def growth_by_wave_rows():
    """Short runs from noise in which every wave of the strip grows or fades on its own."""
    short = ("sample.settle=8", "sample.average=8")
    default = [Row("continuum", DISPERSION, "plate.frequency_star", f, (*short, f"continuum.lid={UPPER_END.get(f, 25)}"), waves=14) for f in FREQUENCIES]
    return default + [dataclasses.replace(row, overrides=row.overrides + FLUID[:1]) for row in default if row.value in OF_FLUID_STRIP]


def runs():
    two_cycles = ["sample.phases=40", "sample.average=8", "sample.frames=40", "sample.map_bin=1"]
    of_md = two_cycles + ["sample.frame_cycles=8"]
    large = ["box.x=126", "box.y=126", "particles.number=95256", "sample.phases=20", "sample.frames=0", "sample.average=2"]
    # Stripes that grow from noise by 3 per cent a cycle take hundreds of cycles: the continuum starts from a wave.
    waves_of_21 = [*two_cycles, "sample.settle=40", "sample.frame_cycles=2", "initial.wave=0.5", "initial.noise=0", "initial.wave_x=2", "initial.wave_y=0",
                   "continuum.dimension=2", "continuum.spacing=0.2", "continuum.lid=25"]

    def run(engine, scene, changes):
        return {"engine": engine, "scene": scene, "changes": changes, "start": None}

    # Below the onset of both engines, and no whole number of diameters wide, where rows of spheres would lock: horizontal momentum of a flat layer.
    flat = ["plate.acceleration=2.0", "box.x=21.4", "box.y=21.4", "particles.number=2748", "sample.map_bin=0"]
    return {
        "md_flat": run("md", STRIPES, [*flat, "sample.phases=20", "sample.settle=40", "sample.average=100", "sample.frames=20", "sample.frame_cycles=100"]),
        "continuum_flat": run("continuum", STRIPES, [*flat, "sample.phases=40", "sample.settle=20", "sample.average=2", "sample.frames=40", "continuum.dimension=1",
                                                     "continuum.spacing=0.1", "continuum.lid=25", "initial.noise=0"]),
        **{f"md_strip_{gamma}": run("md", DISPERSION, [f"plate.acceleration={gamma}", "box.y=10.5", "particles.number=10584", "sample.settle=100", "sample.average=100", "sample.frames=4",
                                                 "sample.frame_cycles=100"])
           for gamma in STRIPS},
        **{f"md_square_{gamma}": run("md", STRIPES, [f"plate.acceleration={gamma}", "sample.phases=20", "sample.settle=100", "sample.average=2", "sample.frames=20",
                                                     "sample.frame_cycles=2", "sample.map_bin=0"]) for gamma in SQUARES},
        "md_stripes": run("md", STRIPES, [f"plate.acceleration={PUBLISHED}", "sample.settle=300", *of_md]),
        "continuum_stripes": run("continuum", STRIPES, [f"plate.acceleration={WAVING}", *waves_of_21, "continuum.spacing_horizontal=1.0"]),
        "continuum_fluid": run("continuum", STRIPES, [f"plate.acceleration={PUBLISHED}", *waves_of_21, "continuum.spacing_horizontal=2.0",
                                                      "continuum.closure=jenkins_richman_fluid"]),
        "md_large": run("md", STRIPES, [f"plate.acceleration={PUBLISHED}", "sample.settle=150", "sample.map_bin=1", *large]),
    }


SIDE_BY_SIDE = {"runs": ["md_stripes", "continuum_stripes"]}
ALL_THREE = {"runs": ["md_stripes", "continuum_stripes", "continuum_fluid"]}
# runs: what OUT/runs must hold; rows: (table, rows) to be filled first; long: made only when asked for by name.
FIGURES = {
    "figure_5_1": ALL_THREE,
    "figure_5_1_large": {"runs": ["md_large"], "long": True},
    "figure_5_2": {"rows": [(DISPERSION_MD, dispersion_rows()), (DISPERSION_CONTINUUM, growth_by_wave_rows())]},
    "figure_5_3": {"runs": ["md_stripes"]},
    "figure_5_4": SIDE_BY_SIDE,
    "figure_5_5": SIDE_BY_SIDE,
    "figure_5_6": SIDE_BY_SIDE,
    "figure_5_7": SIDE_BY_SIDE,
    "figure_5_8": SIDE_BY_SIDE,
    "figure_5_9": SIDE_BY_SIDE,
    "figure_5_10": SIDE_BY_SIDE,
    "figure_5_movie": SIDE_BY_SIDE,
    "figure_5_momentum": {"runs": ["md_flat", "continuum_flat", *(f"md_square_{gamma}" for gamma in SQUARES)]},
    "figure_5_elastic": {"runs": [*(f"md_strip_{gamma}" for gamma in STRIPS), "continuum_flat"]},
    "figure_5_sloshing": ALL_THREE,
    "figure_5_fluid": {"runs": ["md_stripes", "continuum_fluid"]},
    "figure_5_growth": {"rows": [(GROWTH, growth_rows())]},
    "figure_5_converged": {"rows": [(CONVERGED, converged_rows())]},
}


def make(root, out, figures, jobs, dry_run, command):
    """The chapter, or the named figures of it; an exit code."""
    return patterns_study.make(root, out, FIGURES, runs(), figures, jobs, dry_run, command, "Chapter 5: patterns in a shaken layer")


def kept(root):
    return patterns_study.kept(root, "ch5", FIGURES, runs())


def remake(today, parts):
    return patterns_study.remake(today, parts, FIGURES, runs(), make)
