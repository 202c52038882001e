# SPDX-License-Identifier: MIT
"""The points of the stability maps: which run each one is, and which run its answer is held against.

A map is a list of points; x is the number varied, y the row it belongs to (a method and a scene, or a second number).
"""
import dataclasses
import math

from gas_at_rest import Gas


@dataclasses.dataclass(frozen=True)
class Run:
    engine: str
    scene: str
    changes: tuple

    def but(self, *changes):
        """The same with other values; a key given again takes the place of the earlier one."""
        kept = dict(change.split("=", 1) for change in self.changes + changes)
        return dataclasses.replace(self, changes=tuple(f"{key}={value}" for key, value in kept.items()))

    def without(self, *keys):
        """The same with these keys at the scene's values."""
        return dataclasses.replace(self, changes=tuple(change for change in self.changes if change.split("=", 1)[0] not in keys))

    def command(self):
        return " ".join([f"shaken {self.engine} data/scenes/{self.scene}.toml", *(f"--set '{change}'" for change in self.changes)])


@dataclasses.dataclass(frozen=True)
class Point:
    map: str
    x: float
    y: object
    run: Run
    reference: Run = None  # a run of the same flow by another method, on a finer grid


# Short runs of small scenes: some cycles from the flat layer on, which hold its fall, its impact and its shock.
LAYER = Run("continuum", "ch4_shock", ("sample.phases=20", "sample.settle=0", "sample.average=2", "sample.frames=0", "continuum.spacing=0.4"))
STRIP = Run("continuum", "ch5_growth", ("sample.settle=0", "sample.average=1", "sample.map_bin=0", "initial.wave=0.3", "continuum.spacing=0.4", "continuum.spacing_horizontal=2",
                                          "box.x=21", "particles.number=504", "initial.wave_x=1"))
RIEMANN = Run("continuum", "verify_riemann", ("continuum.spacing=0.1",))
COLUMN = Run("continuum", "verify_column", ("continuum.spacing=0.2", "tube.time=10"))
COOLING = Run("continuum", "uniform_cooling", ("sample.settle=0", "sample.duration=1000"))
CLOSED = RIEMANN.but("tube.lower=wall", "tube.upper=wall", "continuum.transport=navier_stokes", "tube.time=2")
GRAINS = Run("md", "collapse_stall", ("sample.settle=0", "sample.average=4", "sample.frames=1", "box.ceiling=200",
                                      "box.x=4.4", "box.y=4.6", "particles.number=202"))
CRYSTAL = Run("md", "uniform_elastic", ("particles.number=256", "sample.settle=1", "sample.duration=2", "sample.interval=0.25"))

FTCS = ("continuum.scheme=ftcs", "continuum.closure=jenkins_richman_dense")  # the closure that it can run
OF_FTCS = ("continuum.artificial_dissipation", "continuum.diffusion_factor")   # keys that no other scheme has a use for
FTCS_LAYER = LAYER.but(*FTCS, "continuum.spacing=0.2", "sample.average=1")  # coarser, it does not survive a second impact
FINE = ("continuum.scheme=weno5", "continuum.flux=hll", "continuum.cfl=0.5")
SCHEMES = {
    "muscl hllc": ("continuum.scheme=muscl", "continuum.flux=hllc"),
    "muscl hll": ("continuum.scheme=muscl", "continuum.flux=hll"),
    "weno5 hllc": ("continuum.scheme=weno5", "continuum.flux=hllc"),
    "weno5 hll": ("continuum.scheme=weno5", "continuum.flux=hll"),
}
DEFAULT, WENO = "muscl hllc", "weno5 hllc"


def fifth_order(run):
    """The same by the fifth-order scheme with a smaller step; the same closure and, where ftcs has the source's wall above a layer, the same end."""
    wall = ("continuum.upper=lid",) if FTCS[0] in run.changes and run.scene in (LAYER.scene, STRIP.scene) else ()
    return run.without(*OF_FTCS).but(*FINE, *wall)


def held(run):
    """What a layer is held against: the fifth-order scheme at half the spacing."""
    return fifth_order(run).but("continuum.spacing=0.2")


def courant():
    for y, scheme in SCHEMES.items():
        for x in (0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0, 1.2, 2.0):
            for words, base in (("layer", LAYER), ("strip", STRIP), ("tube", RIEMANN)):
                run = base.but(*scheme, f"continuum.cfl={x}")
                reference = {"layer": held(run), "strip": base.but(*FINE), "tube": None}[words]  # a tube has an exact solution
                yield Point("cfl", x, f"{y}, {words}", run, reference)


def diffusion():
    for x in (0.04, 0.08, 0.16, 0.24, 0.32, 0.4, 0.5, 0.6, 0.7, 0.8, 1.0, 2.0):
        for y, base in (("layer, dz = 0.2", FTCS_LAYER), ("layer, dz = 0.4", FTCS_LAYER.but("continuum.spacing=0.4", "sample.average=2")),
                        ("strip, dz = 0.4", STRIP), ("tube, dz = 0.1", CLOSED)):
            run = base.but(*FTCS, f"continuum.diffusion_factor={x}")
            reference = held(run) if y.startswith("layer") else fifth_order(run)
            yield Point("diffusion", x, y, run, reference)


def horizontal_spacing():
    for x in (0.5, 1.0, 2.0, 3.0, 5.25, 7.0):
        for y in (DEFAULT, WENO):
            run = STRIP.but(*SCHEMES[y], f"continuum.spacing_horizontal={x}")
            yield Point("spacing_horizontal", x, y, run, STRIP.but(*FINE, "continuum.spacing_horizontal=1"))


def volume_fraction():
    for x in (1e-8, 1e-6, 1e-4, 1e-3, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.62, 0.64, 0.649, 0.65, 0.7):
        side = max(2.0, math.sqrt(math.pi / (6.0 * x)))  # a layer ten diameters high, of at least ten particles
        number = round(10.0 * x * side**2 * 6.0 / math.pi)
        layer = LAYER.but(f"initial.volume_fraction={x:g}", f"box.x={side:.6g}", f"box.y={side:.6g}", f"particles.number={max(1, number)}",
                          "continuum.lid=40", "sample.average=1")
        source = layer.but(*FTCS, "continuum.spacing=0.2")
        # So short that no wave reaches an end.
        half = f"initial.left.volume_fraction={x:g}", f"initial.right.volume_fraction={0.5 * x:g}", f"tube.time={min(0.6, 3.0 / Gas(min(x, 0.649)).speed):.3g}"
        for y in (DEFAULT, WENO):
            yield Point("volume_fraction", x, f"{y}, tube", RIEMANN.but(*SCHEMES[y], *half))
            yield Point("volume_fraction", x, f"{y}, column", COLUMN.but(*SCHEMES[y], f"initial.volume_fraction={x:g}"))
            yield Point("volume_fraction", x, f"{y}, layer", layer.but(*SCHEMES[y]), held(layer) if x <= 0.55 else None)
        yield Point("volume_fraction", x, f"{DEFAULT}, cooling", COOLING.but(f"initial.volume_fraction={x:g}"))
        closed = CLOSED.but(*FTCS, *half)
        yield Point("volume_fraction", x, "ftcs, tube", closed, fifth_order(closed))
        yield Point("volume_fraction", x, "ftcs, layer", source, held(source) if x <= 0.55 else None)


def restitution():
    for x in (0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.8, 0.9, 0.95, 1.0):
        layer = LAYER.but(f"particles.restitution={x}")
        law = LAYER.but(f'particles.restitution={{law="velocity", e0={x}}}')
        source = FTCS_LAYER.but(f"particles.restitution={x}")
        affordable = x >= 0.6  # below, the layer is so near packing that the finer grid is past its budget
        for y in (DEFAULT, WENO):
            yield Point("restitution", x, f"{y}, layer", layer.but(*SCHEMES[y]), held(layer) if affordable else None)
        if affordable or x == 0.3:
            yield Point("restitution", x, "ftcs, layer", source, held(source) if affordable else None)
        yield Point("restitution", x, f"{DEFAULT}, cooling", COOLING.but(f"particles.restitution={x}"))
        yield Point("restitution", x, f"{DEFAULT}, e(v)", law, held(law) if affordable else None)


ACCELERATIONS = (0.5, 0.9, 1.1, 1.5, 2.0, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0)


def acceleration():
    for x in ACCELERATIONS:
        layer = LAYER.but(f"plate.acceleration={x}", "plate.frequency=0.2")
        for y in (DEFAULT, WENO):
            yield Point("acceleration", x, f"{y}, layer", layer.but(*SCHEMES[y]), held(layer))
        source = FTCS_LAYER.but(f"plate.acceleration={x}", "plate.frequency=0.2")
        yield Point("acceleration", x, "ftcs, layer", source, held(source))


# Cells of three dimensions, and the layers of chapter 4 that are deeper and shallower than its own.
THREE = Run("continuum", "ch5_stripes", ("box.x=12", "box.y=12", "particles.number=864", "continuum.dimension=3", "continuum.spacing=0.4",
                                         "continuum.spacing_horizontal=2", "sample.phases=20", "sample.maps=4", "sample.settle=0", "sample.average=2", "sample.frames=0"))
LIMITS = {15: "ch4_limit_deep_15", 18: "ch4_limit_deep_18", 3: "ch4_limit_shallow"}


def upper_end():
    for y in ("stress_free", "lid"):
        end = f"continuum.upper={y}"
        for e in (0.6, 0.7, 0.8, 0.9, 0.98):
            for x in (1.1, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0):
                yield Point("upper_end", x, f"{y}, e = {e}", LAYER.but(end, f"plate.acceleration={x}", f"particles.restitution={e}", "sample.average=4"))
        for x in (2.2, 4.0, 8.0):
            yield Point("upper_end", x, f"{y}, 3D", THREE.but(end, f"plate.acceleration={x}"))
        for depth, scene in LIMITS.items():
            yield Point("upper_end", 3.0, f"{y}, H = {depth}", dataclasses.replace(LAYER, scene=scene).but(end, "sample.average=4"))


QUIET_CELLS, QUIET_STEPS, QUIET_FRACTION = 64, 4000, 0.2


def quiet(fraction, spacing, factor, *changes):
    """A tube at rest with a step of density of one per cent, under ftcs, for some thousand steps."""
    step = factor * spacing**2 / Gas(fraction).stiffest
    return CLOSED.but(*FTCS, f"continuum.spacing={spacing:g}", f"tube.length={QUIET_CELLS * spacing:g}", f"tube.time={QUIET_STEPS * step:.4g}",
                      f"continuum.diffusion_factor={factor:g}", f"initial.left.volume_fraction={1.005 * fraction:g}",
                      f"initial.right.volume_fraction={0.995 * fraction:g}", *changes)


def reynolds():
    for spacing in (0.05, 0.2, 0.5, 1.0, 1.4, 2.0, 3.0, 5.0, 8.0):
        for factor in (0.02, 0.04, 0.08, 0.16, 0.32, 0.5, 0.7, 0.8):
            yield Point("cell_reynolds", spacing, factor, quiet(QUIET_FRACTION, spacing, factor, "continuum.artificial_dissipation=0"))


THIN_FRACTION, THIN_SPACING = 1e-4, 0.2


# Thin gas at rest on cubic cells, so hot that it fills them evenly; its steps are so short that artificial dissipation alone is in doubt.
REST = LAYER.but(*FTCS, "plate.acceleration=0", "plate.frequency=0.5", "particles.restitution=1.0", "particles.number=1", "box.x=15", "box.y=15",
                 "initial.volume_fraction=1e-4", "initial.temperature=100", "initial.noise=0.01", "continuum.spacing=1",
                 "continuum.spacing_horizontal=1", "continuum.lid=24", "continuum.diffusion_factor=0.04", "sample.average=1")
ONE_COLUMN = ("initial.noise=0",)  # which has none beside it to differ from


def artificial_dissipation():
    strengths = (0.0, 0.1, 0.15, 0.2, 0.24, 0.3, 0.4, 0.45, 0.48, 0.55, 0.7, 1.0)
    for x in strengths:
        given = f"continuum.artificial_dissipation={x}"
        for factor in (0.02, 0.08, 0.16, 0.32, 0.5):
            yield Point("artificial_dissipation", x, factor, quiet(THIN_FRACTION, THIN_SPACING, factor, given))
        for d in (1, 2, 3):
            run = REST.but(given, f"continuum.dimension={d}", *(ONE_COLUMN if d == 1 else ()))
            yield Point("artificial_dissipation", x, f"gas at rest, {d}D", run, held(REST.but("continuum.dimension=1", *ONE_COLUMN)))


def collapse():
    area = 4.4 * 4.6
    for x in (0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.8, 0.9, 1.0):
        for depth in (1, 2, 3, 4, 6, 9):
            yield Point("collapse", x, depth, GRAINS.but(f"particles.restitution={x}", f"particles.number={round(depth / 0.9 * area)}"))
        for remedy, value in (("elastic_below", "particles.collapse_speed=0.1"), ("contact_time", "particles.collapse_time=0.001")):
            yield Point("collapse", x, remedy, GRAINS.but(f"particles.restitution={x}", f"particles.collapse={remedy}", value))
        yield Point("collapse", x, "e(v)", GRAINS.but(f'particles.restitution={{law="velocity", e0={x}}}'))


def grains_acceleration():
    for x in ACCELERATIONS:
        shaken = GRAINS.but(f"plate.acceleration={x}", "plate.frequency=0.2", "box.ceiling=200")
        for y, change in (("e = 0.9", ("particles.restitution=0.9",)), ("e(v), e0 = 0.9", ('particles.restitution={law="velocity", e0=0.9}',)),
                          ("e(v), e0 = 0.5", ('particles.restitution={law="velocity", e0=0.5}',))):
            run = shaken.but(*change)
            fluid = dataclasses.replace(run, engine="continuum").but("continuum.spacing=0.4", "sample.frames=0")
            yield Point("grains_acceleration", x, y, run, fluid)


def packing():
    for x in (0.05, 0.1, 0.2, 0.3, 0.4, 0.45, 0.49, 0.52, 0.545, 0.58, 0.6, 0.62, 0.65, 0.68, 0.7, 0.72, 0.735, 0.739, 0.74, 0.7405, 0.75):
        yield Point("packing", x, "gas", CRYSTAL.but(f"initial.volume_fraction={x}"))
        yield Point("packing", x, "layer", GRAINS.but(f"initial.volume_fraction={x}", "particles.restitution=0.9", "sample.average=2"))


MAPS = (courant, diffusion, horizontal_spacing, volume_fraction, restitution, acceleration, upper_end, reynolds, artificial_dissipation,
        collapse, grains_acceleration, packing)


def points():
    return [point for one in MAPS for point in one()]
