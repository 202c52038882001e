# SPDX-License-Identifier: MIT
"""The runs of the study work-precision: a table of points of the continuum, one knob a curve, and the MD runs whose parts are the points of the MD."""
from dataclasses import dataclass, field

SCHEMES = ("muscl", "weno5", "ftcs")
CELL = {"ch4_shock": "data/scenes/ch4_shock.toml", "stripes": "data/scenes/ch5_growth.toml",
        "riemann": "data/scenes/verify_riemann.toml", "wave": "data/scenes/verify_wave.toml"}
# What a study sets beside its scene. ch4_shock: the thirteenth cycle, as in bench/continuum.md; what is left of the start is then 2e-5 of z_cm and the
# same in every run. stripes: a wave of 21 diameters, seeded in the density, in its fourth to sixth cycle.
FIXED = {
    "ch4_shock": {"sample.settle": 12, "sample.average": 1, "sample.frames": 0},
    "stripes": {"sample.settle": 3, "sample.average": 3, "sample.maps": 20, "sample.map_bin": 0.5, "initial.wave": 0.1},
    "riemann": {},
    "wave": {"continuum.transport": "inviscid"},
}
KEY = {"dz": "continuum.spacing", "dx": "continuum.spacing_horizontal", "cfl": "continuum.cfl", "lid": "continuum.lid"}
DEFAULT = {"ch4_shock": {"dz": 0.2, "cfl": 0.8}, "stripes": {"dx": 1.0, "dz": 0.2, "cfl": 0.8}, "riemann": {"dz": 0.025, "cfl": 0.8},
           "wave": {"dz": 2.0, "cfl": 0.8}}
DEFAULT_SCHEME = "muscl"
# (study, scheme, knob): values. All else is the scene's.
CURVES = {
    ("ch4_shock", "muscl", "dz"): (1.6, 0.8, 0.4, 0.2, 0.1),
    ("ch4_shock", "weno5", "dz"): (1.6, 0.8, 0.4, 0.2, 0.1),
    ("ch4_shock", "ftcs", "dz"): (0.8, 0.4, 0.2),
    ("ch4_shock", "muscl", "cfl"): (1.0, 0.8, 0.4, 0.2, 0.1),
    ("ch4_shock", "weno5", "cfl"): (1.0, 0.8, 0.4, 0.2),
    ("stripes", "muscl", "dz"): (0.8, 0.4, 0.2, 0.1),
    ("stripes", "weno5", "dz"): (0.8, 0.4, 0.2, 0.1),
    ("stripes", "ftcs", "dz"): (0.4, 0.2),
    ("stripes", "muscl", "dx"): (6.0, 3.0, 2.0, 1.0),
    ("stripes", "weno5", "dx"): (6.0, 3.0, 2.0, 1.0),
    ("stripes", "ftcs", "dx"): (3.0, 2.0),
    ("stripes", "muscl", "cfl"): (1.0, 0.8, 0.4),
    ("riemann", "muscl", "dz"): (0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003125),
    ("riemann", "weno5", "dz"): (0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003125),
    ("riemann", "ftcs", "dz"): (0.1, 0.025),
    ("riemann", "muscl", "cfl"): (1.0, 0.8, 0.4, 0.2),
    ("riemann", "weno5", "cfl"): (1.0, 0.8, 0.4, 0.2),
    ("wave", "muscl", "dz"): (20.0, 10.0, 5.0, 2.0),
    ("wave", "weno5", "dz"): (20.0, 10.0, 5.0, 2.0),
}
# Runs that references are extrapolated from: the spacings are halved along one axis at a time.
REFERENCES = {
    "ch4_shock": ({"dz": 0.2}, {"dz": 0.1}, {"dz": 0.05}),
    "stripes": ({"dx": 2.0, "dz": 0.2}, {"dx": 1.0, "dz": 0.2}, {"dx": 2.0, "dz": 0.1}, {"dx": 1.0, "dz": 0.1}),
}
REFERENCE_SCHEMES = ("muscl", "weno5")
# Of the Riemann problem's ends, ftcs knows walls only; no wave reaches an end in the time of the scene.
WALLS = {"tube.lower": "wall", "tube.upper": "wall"}

# MD on ch4_shock. width: (particles, seeds, cycles averaged); the layer is 3937 particles on 20 x 20. From 24 on
# a wave stands in the box, and the layer is no longer flat (docs/choosing.md).
WIDTHS = {10: (984, (1, 2, 3, 4), 150), 20: (3937, (1, 2, 3, 4), 150), 28: (7717, (1, 2), 60)}
SHORT_SEEDS, SHORT_CYCLES = tuple(range(101, 117)), 10
SETTLE = 15
DEFAULT_MD = {"cycles": 150, "seeds": 1, "width": 20}
BINS = 0.125  # of the run that says what bins of 0.5 and 1 leave out

CLOSURES = {
    ("jenkins_richman", "goldshtein"): {},
    ("jenkins_richman", "carnahan_starling"): {"continuum.pair_correlation": "carnahan_starling"},
    ("garzo_dufty", "goldshtein"): {"continuum.closure": "garzo_dufty"},
    ("garzo_dufty", "carnahan_starling"): {"continuum.closure": "garzo_dufty", "continuum.pair_correlation": "carnahan_starling"},
    ("jenkins_richman_dense", "goldshtein"): {"continuum.closure": "jenkins_richman_dense"},
    ("jenkins_richman_fluid", "goldshtein"): {"continuum.closure": "jenkins_richman_fluid"},
    ("jenkins_richman_bocquet", "goldshtein"): {"continuum.closure": "jenkins_richman_bocquet"},
}
LIDS = (120.0, 200.0)  # the first is the scene's
DEFAULT_CLOSURE, DENSE = ("jenkins_richman", "goldshtein"), ("jenkins_richman_dense", "goldshtein")


def closure_of(study, scheme):
    """The closure of a scheme's curves: the default one, and the one that ftcs can run where the gas asks any. A scheme is held against the limit of its own."""
    return DENSE if scheme == "ftcs" and study in REFERENCES else DEFAULT_CLOSURE


@dataclass(frozen=True)
class Point:
    """One run of the continuum, as a point of one or more curves."""
    study: str
    scheme: str
    settings: tuple = ()  # ((knob, value), ...), what departs from the scene's defaults
    closure: tuple = DEFAULT_CLOSURE
    curves: tuple = field(default=(), compare=False)

    @property
    def name(self):
        words = [self.study, self.scheme, *(f"{knob}{value:g}" for knob, value in self.settings)]
        return "_".join(words + list(self.closure if self.closure != Point.closure else ()))

    @property
    def scene(self):
        return CELL["ch4_shock" if self.study == "model" else self.study]

    @property
    def changes(self):
        """The settings of the command, SECTION.KEY=VALUE."""
        fixed = dict(FIXED["ch4_shock" if self.study == "model" else self.study])
        if self.scheme != DEFAULT_SCHEME:
            fixed["continuum.scheme"] = self.scheme
        if self.study == "riemann" and self.scheme == "ftcs":
            fixed |= WALLS
        if self.closure == DENSE and self.study in REFERENCES:
            fixed["continuum.upper"] = "lid"  # the end that ftcs has
        fixed |= CLOSURES[self.closure] | {KEY[knob]: value for knob, value in self.settings}
        return [f"{key}={value}" for key, value in fixed.items()]

    def value(self, knob):
        return dict(self.settings).get(knob, DEFAULT.get(self.study, {}).get(knob))


def point(study, scheme, settings, closure=None):
    """Settings equal to the defaults are left out, so that two curves share the point where they cross. Without a closure: that of the scheme's curves."""
    usual = DEFAULT.get(study, {})
    return Point(study, scheme, tuple(sorted((k, v) for k, v in settings.items() if usual.get(k) != v)), closure or closure_of(study, scheme))


def curve(study, scheme, knob):
    return [point(study, scheme, {knob: value}) for value in CURVES[study, scheme, knob]]


def reference_points(study, scheme, closure=DEFAULT_CLOSURE):
    return [point(study, scheme, settings, closure) for settings in REFERENCES[study]]


def reference_closures(study):
    return list(dict.fromkeys(closure_of(name, scheme) for name, scheme, _ in CURVES if name == study))


def bases(study, scheme, closure):
    """The coarsest of the three spacings that the strip's order is observed from; of the scheme's own closure it is a point of its curve."""
    return [point(study, scheme, {"dz": 0.4}, closure)] if study == "stripes" else []


def model_points():
    return [point("model", DEFAULT_SCHEME, {"lid": lid}, closure) for closure in CLOSURES for lid in LIDS]


def continuum_points():
    points = [p for key in CURVES for p in curve(*key)]
    points += [p for study in REFERENCES for closure in reference_closures(study) for scheme in REFERENCE_SCHEMES
               for p in (*reference_points(study, scheme, closure), *bases(study, scheme, closure))]
    return list(dict.fromkeys(points + model_points()))


def box(width):
    return [f"box.x={width}", f"box.y={width}", f"particles.number={WIDTHS[width][0]}"] if width != DEFAULT_MD["width"] else []


def grains(width, seed, cycles, settle=SETTLE):
    return box(width) + [f"md.seed={seed}", f"initial.seed={seed}", f"sample.settle={settle}", f"sample.average={cycles}", "sample.frames=0"]


def long_runs(width):
    return [f"md_{width}_s{seed}" for seed in WIDTHS[width][1]]


def md_runs():
    """{name: settings} of the MD's runs."""
    runs = {f"md_{width}_s{seed}": grains(width, seed, cycles) for width, (_, seeds, cycles) in WIDTHS.items() for seed in seeds}
    runs |= {f"md_short_s{seed}": grains(20, seed, SHORT_CYCLES) for seed in SHORT_SEEDS}
    runs["md_bins"] = grains(20, SHORT_SEEDS[0], SHORT_CYCLES) + [f"sample.bin={BINS}"]
    # Partners: the comparison that measures a continuum run wants an MD run on the same bins.
    runs |= {f"md_partner_{lid:g}": grains(20, 1, 2, settle=1) + [f"continuum.lid={lid:g}"] for lid in LIDS}
    return runs


def workflow_runs():
    """All runs in the words of workflow/Snakefile."""
    runs = {p.name: {"engine": "continuum", "scene": p.scene, "changes": p.changes} for p in continuum_points()}
    for width in WIDTHS:  # partners of MD runs in comparisons
        changes = box(width) + ["sample.settle=1", "sample.average=1", "sample.frames=0"]
        runs[f"continuum_{width}"] = {"engine": "continuum", "scene": CELL["ch4_shock"], "changes": changes}
    return runs | {name: {"engine": "md", "scene": CELL["ch4_shock"], "changes": changes} for name, changes in md_runs().items()}


def partner(p):
    return f"md_partner_{p.value('lid') or LIDS[0]:g}"


def workflow_comparisons():
    """One a continuum run of the layer, and one a width of the MD: profiles and shock, measured by the program."""
    found = {p.name: {"md": [partner(p)], "continuum": p.name} for p in continuum_points() if p.study in ("ch4_shock", "model")}
    return found | {f"md_{width}": {"md": long_runs(width), "continuum": f"continuum_{width}"} for width in WIDTHS}
