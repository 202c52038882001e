# SPDX-License-Identifier: MIT
"""How a run of the stability maps ended, and whether what it left can be believed.

completes  exit code 0, and the answer passes the checks below
slow       stopped by its limit of time with a checkpoint (exit code 75), or past the stated number of steps or contacts
refused    exit code 65 and a sentence
failed     exit code 1 and a sentence with the time and the place
Defects, of which there should be none: wrong (completed, but a check says no), mute (no sentence), crash, hang.
"""
import math
import re

ENDS = ("completes", "slow", "refused", "failed", "wrong", "mute", "crash", "hang")
DEFECTS = ENDS[4:]

# What a sentence is about, and how it is known; the first that fits.
MESSAGES = (
    ("outside the range", r"is outside [(\[]|must be (at least|at most|greater)"),
    ("cannot start", r"do not fit|is not below|is below the top|is too low|stand .* high|overlap by|does not fit below"),
    ("collapse", r"inelastic collapse in cycle \d+ at t = .* particles \d+ and \d+"),
    ("clock stands still", r"the clock stands still in cycle \d+ at t = "),
    ("unstable step", r"at time .* a step of .* is unstable .* height"),
    ("frozen", r"held at the temperature floor"),
    ("mass made", r"at time .* of the mass \(at most .* height"),
    ("energy made", r"at time .* of the energy .* height"),
    ("step too short", r"is asked for at time .* height"),
    ("no state", r"(left the states there are|no step can be made) at time .* height"),
)

MOST_STEPS_A_CYCLE = 100_000     # of the continuum; the defaults make 900
MOST_CONTACTS = 10_000           # pair collisions a particle in the whole run; a shaken layer makes 60 a cycle

# Per cent from the reference or the exact solution. Truncation on these coarse grids: the worst points have 2.3 (thin layers), 0.9, 5.0 (a
# shock in 100 cells) and 1.2; cooling is exact to round-off. Grains against the continuum are the model's difference, 10.5 at 10 g.
MOST_DISTANCE = {"layer": 3.0, "strip": 2.0, "tube": 6.0, "column": 2.0, "cooling": 1e-6, "grains": 15.0}
ROUND_OFF = 1e-9
MOST_MASS_MADE, MOST_ENERGY_MADE = 0.1, 0.25  # what ftcs is allowed before it must say so


def end_of(point, kept, reference):
    """(end, message, numbers): numbers are those of the check."""
    code, said = kept["code"], kept["said"]
    if code is None:
        return "hang", "", {}
    if code < 0 or code > 125:
        return "crash", "", {}
    message = next((name for name, pattern in MESSAGES if re.search(pattern, said, re.DOTALL)), "")
    if code == 75:
        return "slow", "stopped with a checkpoint", {}
    if code != 0:
        return {65: "refused", 1: "failed"}.get(code, "mute") if message else "mute", message, {}
    numbers = kept["numbers"] | {"distance": distance(kept, reference)}
    numbers = {key: value for key, value in numbers.items() if value is not None}
    doubt = doubts(point, kept, numbers)
    if doubt:
        return "wrong", doubt, numbers
    slow = numbers.get("steps", 0) > MOST_STEPS_A_CYCLE * max(1, cycles(point.run)) or numbers.get("events_per_particle", 0) > MOST_CONTACTS
    return "slow" if slow else "completes", "", numbers


def cycles(run):
    given = dict(change.split("=", 1) for change in run.changes)
    return int(given.get("sample.average", 1))


def distance(kept, reference):
    """Per cent: of z_cm over the run, or of the density profile; from the exact solution where there is one."""
    if "distance" in kept["numbers"]:
        return kept["numbers"]["distance"]
    if reference is None or reference["code"] != 0:
        return None
    if "series" in kept:
        pairs = list(zip(kept["series"], reference["series"]))
        # Grains are compared by their mean over the second half: single cycles are chaotic.
        if "particles" in kept["numbers"]:
            half = len(pairs) // 2
            ours, theirs = (sum(column[half:]) / (len(pairs) - half) for column in zip(*pairs))
            return 100.0 * abs(ours / theirs - 1.0)
        return 100.0 * math.sqrt(sum((a / b - 1.0) ** 2 for a, b in pairs) / len(pairs))
    pairs = list(zip(kept["profile"], reference["profile"]))
    return 100.0 * sum(abs(a - b) for a, b in pairs) / sum(b for _, b in pairs)


def kind_of(point):
    run = point.run
    if run.engine == "md":
        return "pressure" if run.scene == "uniform_elastic" else "grains"
    if run.scene.startswith("ch4_"):
        return "layer"
    return {"ch5_growth": "strip", "ch5_stripes": "strip", "verify_column": "column", "uniform_cooling": "cooling"}.get(run.scene, "tube")


def doubts(point, kept, numbers):
    """Why the answer cannot be believed, or nothing."""
    ftcs = "continuum.scheme=ftcs" in point.run.changes
    if any(not math.isfinite(value) for value in numbers.values()):
        return "not a number"
    limits = {"mass_made": MOST_MASS_MADE if ftcs else ROUND_OFF, "energy_made": MOST_ENERGY_MADE, "ledger": ROUND_OFF,
              "overlap": ROUND_OFF, "drift": ROUND_OFF, "distance": MOST_DISTANCE.get(kind_of(point), math.inf)}
    for key, most in limits.items():
        if abs(numbers.get(key, 0.0)) > most:
            return f"{key} {numbers[key]:.3g}, at most {most:g}"
    if point.run.engine == "continuum" and not 0.0 < numbers.get("least_fraction", 1.0) <= numbers.get("largest_fraction", 0.0) < 0.65:
        return "volume fraction outside (0, 0.65)"
    if point.map == "packing" and "pressure" in numbers:
        return doubt_of_pressure(point.x, numbers)
    if is_quiet(point) and not rests(point, numbers):
        return f"a tube at rest has come to move: speed {numbers['largest_speed']:.3g}"
    return ""


def is_quiet(point):
    return point.map in ("cell_reynolds", "artificial_dissipation") and kind_of(point) == "tube"


def rests(point, numbers):
    """A step of one per cent cannot make waves of more than a few per cent."""
    mean = numbers["mean_fraction"]
    return numbers["largest_speed"] < 0.05 and numbers["largest_fraction"] < 1.03 * mean and numbers["least_fraction"] > 0.97 * mean


def fluid_pressure(phi):
    """Kolafa, Labik and Malijevsky 2004, up to melting: md/hard_sphere_theory.hpp."""
    x = phi / (1.0 - phi)
    coefficients = {0: 1.0, 1: 4.0, 2: 6.0, 3: 2.3647684, 4: -0.8698551, 5: 1.1062803, 6: -1.095049, 7: 0.637614,
                    10: -0.2279397, 14: 0.1098948, 22: -0.00906797}
    return sum(c * x**k for k, c in coefficients.items())


def crystal_pressure(phi):
    """Face-centred cubic: Speedy 1998 (J. Phys.: Condens. Matter 10, 4387)."""
    z = phi / (math.pi / math.sqrt(18.0))
    return 3.0 / (1.0 - z) - 0.5921 * (z - 0.7072) / (z - 0.601)


FREEZES, MELTS = 0.494, 0.545


def doubt_of_pressure(phi, numbers):
    known = [law(phi) for law, holds in ((fluid_pressure, phi < MELTS), (crystal_pressure, phi > FREEZES)) if holds]
    # Small and short: five standard errors and five per cent; between freezing and melting anything between the two.
    margin = 5.0 * numbers["pressure_error"] + 0.05 * max(known)
    if min(known) - margin < numbers["pressure"] < max(known) + margin:
        return ""
    return f"pressure {numbers['pressure']:.4g}, theory {' to '.join(f'{value:.4g}' for value in known)}"
