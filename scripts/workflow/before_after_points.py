# SPDX-License-Identifier: MIT
"""What scripts/before_after shows: each point is a number that a change moved, the run that gives it by the old program and
by today's, and how it is measured.

Scenes of `old` are those of the old commit. A setting that one of them did not know is named on that side alone.
"""
import dataclasses

import before_after_measures as measure


@dataclasses.dataclass(frozen=True)
class Run:
    engine: str
    scene: str
    settings: tuple = ()

    def command(self):
        settings = (f"--set {setting}" for setting in self.settings)
        return " ".join([f"shaken {self.engine} data/scenes/{self.scene}.toml", *settings])

    def but(self, *settings):
        return dataclasses.replace(self, settings=self.settings + settings)


@dataclasses.dataclass(frozen=True)
class Point:
    topic: str
    what: str
    unit: str
    measure: object            # a function of an `Ended`, or of several
    old: tuple                 # runs
    new: tuple = None          # those of old, if they are the same
    is_long: bool = False      # more than half a minute

    @property
    def runs(self):
        """{side: runs}"""
        return {"old": self.old, "new": self.new or self.old}


def same(topic, what, unit, by, *runs, new=None, is_long=False):
    return Point(topic, what, unit, by, runs, new, is_long)


GROWTH = Run("continuum", "ch5_growth")
SHOCK = Run("continuum", "ch4_shock", ("sample.settle=12", "sample.average=1", "sample.frames=0"))
DENSE = "continuum.closure=jenkins_richman_dense"
FTCS = "continuum.scheme=ftcs"
GAS = Run("md", "uniform_elastic", ("particles.number=500", "sample.settle=0", "sample.duration=0.5"))
HEATED = Run("continuum", "verify_heated")
COLD = ("initial.{0}.velocity={1}", "initial.{0}.temperature=0.01", "initial.{0}.volume_fraction=0.3")
STREAMS = Run("continuum", "verify_riemann", (*(setting.format(*side) for side in (("left", 5), ("right", -5)) for setting in COLD),
                                              "tube.time=0.4", "continuum.spacing=0.0125"))
FAST = Run("continuum", "ch4_shock", (
    "particles.restitution=0.99", "particles.number=200", "plate.acceleration=20", "plate.frequency=3.18", "sample.phases=20",
    "sample.settle=200", "sample.average=20", "sample.frames=0", "continuum.lid=200"))
COOLING = Run("md", "uniform_cooling", ("particles.restitution=0.5", "particles.number=4000"))
AT_REST = Run("continuum", "ch4_shock", (
    "plate.acceleration=0", "plate.frequency=0.1", "particles.number=200", "particles.restitution=1.0", "initial.volume_fraction=0.02",
    "initial.temperature=10", "sample.phases=20", "sample.settle=10", "sample.average=10", "sample.frames=0", "continuum.lid=200"))
SLOW = Run("md", "collapse_stall", (
    "plate.acceleration=0", "particles.number=10", "particles.restitution=1.0", "box.x=20", "box.y=20", "box.ceiling=10000",
    "initial.volume_fraction=0.02", "sample.settle=0", "sample.average=1"))
BALL = Run("md", "collapse_stall", (
    "plate.acceleration=3.4", "plate.frequency=0.1", "particles.number=1", "particles.restitution=0.0", "box.x=4", "box.y=4",
    "box.ceiling=900", "sample.phases=200", "sample.settle=0", "sample.average=20"))


def end_of_layer():
    for height in (25, 50, 100, 200):
        run = GROWTH.but("plate.acceleration=3.0", "continuum.spacing_horizontal=2", f"continuum.lid={height}")
        what = f"growth of a wave of 21 a cycle, Gamma 3.0, dx 2, end at {height}"
        yield same("end", what, "", measure.growth, run, is_long=height > 50)
    for dx in (2, 1, 0.5, 0.25):
        run = GROWTH.but("plate.acceleration=3.2", f"continuum.spacing_horizontal={dx}")
        what = f"growth of a wave of 21 a cycle, Gamma 3.2, dx {dx}, end at 25"
        yield same("grid", what, "", measure.growth, run, is_long=dx < 1)
    for lid in (120, 200):
        run = SHOCK.but(f"continuum.lid={lid}")
        yield same("end", f"z_cm of ch4_shock, mean of a cycle, end at {lid}", "sigma", measure.height, run)


def names():
    full = SHOCK.but("continuum.lid=80", 'continuum.upper="lid"')  # the end that ftcs keeps, where the scene had it, for all
    dense, rms = full.but(DENSE), measure.rms_of_heights
    yield same("names", "ftcs under the closure jenkins_richman", "", measure.how_it_ended, full.but(FTCS))
    yield same("names", "z_cm of ftcs from that of muscl, closure the scene's", "%", rms, full.but(FTCS), full)
    yield same("names", "z_cm of ftcs from that of muscl, closure jenkins_richman_dense for both", "%", rms, dense.but(FTCS), dense)
    yield same("names", "z_cm of muscl, jenkins_richman_dense, from jenkins_richman", "%", rms, dense, full)


def fluid():
    for fraction in (0.1, 0.2, 0.3, 0.4, 0.45, 0.49):
        gas = GAS.but(f"initial.volume_fraction={fraction}")
        for name, what in (("compressibility", "Z"), ("collision rate", "collision rate over sqrt(T)")):
            yield same("fluid", f"{what} of Kolafa, Labik and Malijevsky at {fraction} (today: for so few particles)", "", measure.reference(name, "Kolafa"), gas)


def steady():
    for time in (4000, 4001):
        run = HEATED.but(f"tube.time={time}")
        largest = measure.summary("largest_error_of_temperature")
        yield same("steady state", f"largest error of T, verify_heated at {time}", "", largest, run)
        yield same("steady state", f"T of the lowest cell, verify_heated at {time}", "", measure.lowest_temperature, run)
    for cfl in (0.8, 0.2, 0.05):
        run = HEATED.but("continuum.closure=garzo_dufty", "tube.time=20000", f"continuum.cfl={cfl}")
        what = f"T at 6300 over that of the wall, garzo_dufty, cfl {cfl}"
        yield same("heat along grad n", what, "", measure.temperature_at(6300.0), run, is_long=cfl < 0.8)


def shocks():
    for limiter in ("van_leer", "minmod"):
        run = STREAMS.but(f"continuum.limiter={limiter}")
        yield same("strong shock", f"T behind the fronts, largest departure, {limiter}", "%", measure.ringing, run)
        yield same("strong shock", f"L1 error of T, {limiter}", "", measure.error_of_temperature, run)


def validity():
    yield same("validity", "what the run says of Kn and omega tau", "", measure.validity, FAST)
    yield same("validity", "T of the layer, mass-weighted", "", measure.temperature_of_layer, FAST, is_long=True)
    for fraction, settle, duration in ((0.01, 500, 2000), (0.002, 2500, 10000)):
        gas = COOLING.but(f"initial.volume_fraction={fraction}", f"sample.settle={settle}", f"sample.duration={duration}",
                          f"sample.interval={duration // 100}")
        what = f"a2 at e = 0.5 from the dilute theory, volume fraction {fraction}"
        yield same("validity", what, "standard errors", measure.departure("fourth cumulant"), gas, is_long=True)


def work_of_gravity():
    for spacing in (1.0, 0.5, 0.25):
        run = AT_REST.but(f"continuum.spacing={spacing}")
        what = f"potential energy gained and work booked differ, dz {spacing}"
        yield same("work of gravity", what, "%", measure.work_differs, run)
        what = f"heating of the column at rest, dz {spacing}"
        yield same("work of gravity", what, "a mass and time", measure.heating, run)


def slow_plate():
    for frequency in ("1e-3", "1e-4", "1e-5"):
        what = f"energy of an elastic gas, largest drift, f = {frequency}"
        yield same("slow plate", what, "", measure.drift, SLOW.but(f"plate.frequency={frequency}"))
    what = "a ball of e = 0 over a plate of Gamma 3.4: highest over the plate in its flights"
    yield same("slow plate", what, "sigma", measure.flights, BALL)


def points():
    topics = (end_of_layer, names, fluid, steady, shocks, validity, work_of_gravity, slow_plate)
    return [point for topic in topics for point in topic()]
