# SPDX-License-Identifier: MIT
"""What becomes of horizontal momentum in a layer, and how ordered its lowest plane is, from the whole states of many cycles of an MD run.

A transverse wave v_y(x) has no weight and no pressure to drive it: in a fluid it can only fade, by the viscosity. Amplitudes are a(t) = sum of v_y exp(-2 pi i x/L)
over the particles, L the side of the cell.
"""
import tomllib

import h5py
import numpy as np

from run_folder import RunError
from slices import shear_viscosity

THIN = 1e-3  # volume fraction below which gas is left out: it drags nothing along
NEAR = 1.4   # sigma, closer than which two spheres of a plane are neighbours


def states(path):
    """Positions (times, particles, 3), velocities alike, phases of the states, and the sides of the cell."""
    if not path.is_file():
        raise RunError(f"{path}: not there")
    with h5py.File(path) as file:
        box = tomllib.loads(file["provenance/scene"][()].decode())["box"]
        group = file["particles/all"]
        return group["position/value"][:], group["velocity/value"][:], group["phase"][:], np.array([box["x"], box["y"]])


def transverse(position, velocity, sides):
    """Amplitudes (times, 2) of v_y along x and of v_x along y, one wave in the cell."""
    return np.stack([(velocity[..., 1 - axis] * np.exp(-2j * np.pi * position[..., axis] / sides[axis])).sum(axis=1) for axis in (0, 1)], axis=1)


def along_strip(path, reference, count):
    """Wavelengths (count) of waves along x, and amplitudes (cycles, 2, count) of v_x and v_y in them at one phase of the cycle."""
    if not path.is_file():
        raise RunError(f"{path}: not there")
    with h5py.File(path) as file:
        length = tomllib.loads(file["provenance/scene"][()].decode())["box"]["x"]
        group = file["particles/all"]
        found = []
        for i in np.flatnonzero(np.abs(group["phase"][:] - reference) < 1e-9):
            wave = np.exp(-2j * np.pi * np.outer(np.arange(1, count + 1), group["position/value"][i, :, 0]) / length)
            found.append((wave @ group["velocity/value"][i, :, :2]).T)
    return length / np.arange(1, count + 1), np.array(found)


def whole_periods(cycles):
    """So many cycles that what alternates and what lasts do not mix: of more than one an even number."""
    return cycles if cycles < 2 else cycles // 2 * 2


def pairs(amplitudes):
    """What an amplitude (cycles, ...) has in common with itself a cycle later, and its square: (cycles - 1, 2, ...), of an even number."""
    amplitudes = amplitudes[:whole_periods(len(amplitudes) - 1) + 1]
    return np.stack([(amplitudes[1:] * amplitudes[:-1].conj()).real, np.abs(amplitudes[:-1]) ** 2], axis=1)


def factor_a_cycle(some):
    """Part of each amplitude that is left after a cycle, least squares over some of its pairs: negative where the wave is turned round."""
    common, square = some.sum(axis=0)
    return common / square


def turned_below(wavelengths, factors):
    """The longest wavelength at which a factor passes zero, linear in the logarithm of the wavelength; NaN where it does not. wavelengths descend."""
    for i in range(1, len(factors)):
        if factors[i] < 0 <= factors[i - 1]:
            return float(wavelengths[i] * (wavelengths[i - 1] / wavelengths[i]) ** (factors[i] / (factors[i] - factors[i - 1])))
    return np.nan


def without_blocks(values, blocks, measure):
    """A measure of values (cycles, ...), and its standard error by leaving blocks of cycles out (Tukey 1958)."""
    length = len(values) // blocks
    left = np.array([measure(np.concatenate([values[:b * length], values[(b + 1) * length:]])) for b in range(blocks)])
    return measure(values), np.sqrt((blocks - 1) / blocks * ((left - left.mean(axis=0)) ** 2).sum(axis=0))


def survival(amplitudes, phases, reference):
    """Part of an amplitude at state `reference` of a cycle that is left later, at the states of that cycle and the next: (2 phases - reference)."""
    cycles = amplitudes.reshape(-1, phases, amplitudes.shape[-1])
    cycles = cycles[:whole_periods(len(cycles) - 1) + 1]
    start = cycles[:-1, reference]
    later = np.concatenate([cycles[:-1], cycles[1:]], axis=1)[:, reference:]
    left = (later * start[:, None].conj()).sum(axis=(0, 2)) / (np.abs(start) ** 2).sum()
    return left.real


def bond_order(points, sides):
    """Mean |psi_6| of a plane of points (n, 2) on a periodic cell: 1 in a triangular lattice; NaN without neighbours."""
    found = []
    for at in points:
        bond = points - at
        bond -= sides * np.rint(bond / sides)
        distance = np.hypot(*bond.T)
        near = (distance > 0) & (distance < NEAR)
        if near.sum() > 2:
            found.append(abs(np.exp(6j * np.arctan2(bond[near, 1], bond[near, 0])).mean()))
    return float(np.mean(found)) if found else np.nan


def column_frames(path):
    """[(phase, time, height of cells above the plate, volume fraction, temperature)] of a column's whole states."""
    if not path.is_file():
        raise RunError(f"{path}: not there")
    with h5py.File(path) as file:
        spacing = tomllib.loads(file["provenance/scene"][()].decode())["continuum"]["spacing"]
        found = []
        for name in sorted(file["frames"]):
            frame = file["frames"][name]
            nu = np.pi / 6 * frame["density"][:].ravel()
            found.append((float(frame["phase"][()]), float(frame["time"][()]), (np.arange(nu.size) + 0.5) * spacing, nu, frame["temperature"][:].ravel()))
        return found


def column_at(path, phase):
    """Heights and volume fraction at the state nearest to a phase."""
    return min(column_frames(path), key=lambda frame: abs(frame[0] - phase))[2:4]


def viscous_survival(path, wavenumber, reference):
    """Phases of a cycle from `reference` on, and the part of a transverse wave that the closure's viscosity leaves then.

    The layer moves as one along its depth (k times it is below 2): the rate is k^2 times the integral of mu over that of the density.
    """
    frames = column_frames(path)
    step = frames[1][1] - frames[0][1]
    first = int(np.argmin([abs(frame[0] - reference) for frame in frames]))
    rates = [wavenumber**2 * shear_viscosity(nu[nu > THIN], temperature[nu > THIN]).sum() / (6 / np.pi * nu.sum()) for _, _, _, nu, temperature in frames]
    lost = np.concatenate([[0.0], np.cumsum(np.roll(rates, -first))]) * step
    return reference + np.arange(len(lost)) / len(frames), np.exp(-lost)
