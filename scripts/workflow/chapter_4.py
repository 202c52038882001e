# SPDX-License-Identifier: MIT
"""The runs, comparisons and figures of chapter 4, in the words of workflow/Snakefile."""
import subprocess

import changed
import workflow

SCENE = "data/scenes/ch4_shock.toml"
SEEDS = range(1, 7)
STATES = range(101, 117)  # seeds of the states that one cycle is followed from
FALLING = 0.67            # ft = -0.33, the layer near the top of its flight
RESTITUTIONS = (0.75, 0.80, 0.85, 0.90, 0.95, 0.99, 1.00)
VELOCITY_LAW = 'particles.restitution={law="velocity", e0=0.9, v0=1}'
CLOSURES = {
    "default": (),
    "jr_carnahan_starling": ("continuum.pair_correlation=carnahan_starling",),
    "jr_dense": ("continuum.closure=jenkins_richman_dense",),
    "garzo_dufty": ("continuum.closure=garzo_dufty",),
    "gd_carnahan_starling": ("continuum.closure=garzo_dufty", "continuum.pair_correlation=carnahan_starling"),
}
NUMERICS = {
    "dz_0.4": ("continuum.spacing=0.4",),
    "dz_0.1": ("continuum.spacing=0.1",),
    "cfl_0.4": ("continuum.cfl=0.4",),
    "hll": ("continuum.flux=hll",),
}
LIDS = (60, 80, 100, 120, 200)
WALLS = (80, 200)  # heights of a lid, which bears stress and heat, in the end's place
DEPTHS = {"4.5": (1969, 60, 200), "13.5": (5906, 40, 120)}  # H: particles, cycles averaged, lid


def seeds(k):
    return [f"md.seed={k}", f"initial.seed={k}"]


def e_name(e):
    return f"e{e:.2f}"


def runs():
    all_runs = {}

    def add(name, engine, changes, start=None):
        all_runs[name] = {"engine": engine, "scene": SCENE, "changes": list(changes), "start": start}

    periodic = ["sample.settle=20", "sample.average=5"]
    for k in SEEDS:
        add(f"md_h9_s{k}", "md", seeds(k))
    for name, changes in (CLOSURES | NUMERICS).items():
        add(f"continuum_{name}", "continuum", periodic + list(changes))
    for lid in LIDS:
        add(f"continuum_lid{lid}", "continuum", periodic + [f"continuum.lid={lid}"])
        # Bins reach as high as the lid: a short MD run on the same bins lets the comparison measure the continuum's shock.
        add(f"md_lid{lid}", "md", ["sample.settle=1", "sample.average=2", "sample.frames=0", f"continuum.lid={lid}"])
    for height in WALLS:
        add(f"continuum_wall{height}", "continuum", periodic + [f"continuum.lid={height}", "continuum.upper=lid"])
    for k in STATES:
        add(f"state_s{k}", "md", seeds(k) + ["sample.phases=100", "sample.average=1"])
    one_cycle = [f"initial.phase={FALLING}", "sample.settle=0", "sample.average=2", "sample.frames=0"]
    for e in RESTITUTIONS:
        restitution = [f"particles.restitution={e}"]
        add(f"continuum_{e_name(e)}", "continuum", one_cycle + restitution, "md_h9_s1")
        add(f"continuum_{e_name(e)}_fine", "continuum", one_cycle + restitution + ["continuum.spacing=0.1"], "md_h9_s1")
        for k in STATES:
            add(f"md_{e_name(e)}_s{k}", "md", one_cycle + restitution + seeds(k), f"state_s{k}")
    add("continuum_law", "continuum", periodic + [VELOCITY_LAW])
    for k in SEEDS:
        add(f"md_law_s{k}", "md", seeds(k) + [VELOCITY_LAW, "sample.frames=0"])
    for depth, (number, cycles, lid) in DEPTHS.items():
        layer = [f"particles.number={number}", "sample.frames=0"]
        add(f"continuum_h{depth}", "continuum", periodic + layer + [f"continuum.lid={lid}"])
        add(f"continuum_h{depth}_fine", "continuum", periodic + layer + [f"continuum.lid={lid}", "continuum.spacing=0.1"])
        for k in range(1, 5):
            add(f"md_h{depth}_s{k}", "md", layer + seeds(k) + [f"sample.average={cycles}", f"continuum.lid={lid}"])
    return all_runs


def comparisons():
    base = [f"md_h9_s{k}" for k in SEEDS]
    found = {name: {"md": base, "continuum": f"continuum_{name}"} for name in CLOSURES | NUMERICS}
    found |= {f"lid{lid}": {"md": [f"md_lid{lid}"], "continuum": f"continuum_lid{lid}"} for lid in LIDS}
    found |= {f"wall{height}": {"md": [f"md_lid{height}"], "continuum": f"continuum_wall{height}"} for height in WALLS}
    for e in RESTITUTIONS:
        for grid in ("", "_fine"):
            found[e_name(e) + grid] = {"md": [f"md_{e_name(e)}_s{k}" for k in STATES],
                                       "continuum": f"continuum_{e_name(e)}{grid}", "first_cycle": True}
    found["law"] = {"md": [f"md_law_s{k}" for k in SEEDS], "continuum": "continuum_law"}
    for depth in DEPTHS:
        for grid in ("", "_fine"):
            found[f"h{depth}{grid}"] = {"md": [f"md_h{depth}_s{k}" for k in range(1, 5)], "continuum": f"continuum_h{depth}{grid}"}
    return found


ONE_CYCLE = [e_name(e) + grid for e in RESTITUTIONS for grid in ("", "_fine")]
FIGURES = {
    "figure_4_1": {"comparisons": ["default", "dz_0.1"]},
    "figure_4_2": {"comparisons": [e_name(e) for e in (0.99, 0.90, 0.85)]},
    "figure_4_3": {"comparisons": ["default", "dz_0.1"]},
    "figure_4_4": {"comparisons": ["default", "dz_0.1"]},
    "figure_4_5": {"comparisons": ["default", "dz_0.1"]},
    "figure_4_6": {"comparisons": ONE_CYCLE},
    "figure_4_7": {"comparisons": ["default", "law"]},
    "figure_4_plate": {"comparisons": ["default", "dz_0.1"]},
    "figure_4_stress": {"comparisons": ["default"]},
    "figure_4_8": {"comparisons": ["default", "dz_0.1", "h4.5", "h4.5_fine", "h13.5", "h13.5_fine"]},
}


def make(root, out, figures, jobs, dry_run, command):
    """The chapter, or the named figures of it; Snakemake's exit code, or that of the report."""
    wanted = {name: needs for name, needs in FIGURES.items() if not figures or name in figures}
    code = workflow.make(root, out, workflow.select(runs(), comparisons(), wanted, everything=not figures), jobs, dry_run)
    if code or dry_run:
        return code
    report = [root / "scripts/figures/chapter_report.py", out, command]
    return subprocess.run(["/usr/bin/python3", "-B", *map(str, report)], check=False).returncode


def kept(_root):
    """The tables ch4_* of data/expected, which are made of all runs together."""
    return [changed.Part("ch4_claims, _comparisons", "ch4", [changed.run_of(runs(), name, profiles=True) for name in runs()])]


def remake(today, parts):
    """The stale runs of the chapter, its figures, and what is kept of it."""
    part, = parts
    changed.prepare(today.stamps(part), today.out, runs(), runs(), profiles=True)
    code = make(today.root, today.out, [], today.jobs, False, today.command)
    if code:
        return code
    code = subprocess.run(["/usr/bin/python3", "-B", today.root / "scripts/expected_chapter_4.py", today.out], check=False).returncode
    if not code:
        today.stamps(part).record(part.runs)
    return code
