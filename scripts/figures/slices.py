# SPDX-License-Identifier: MIT
"""Slices of a layer across its stripes: fields over x and z at the phases of two cycles, of either engine's whole states.

MD: every particle is taken into the plane across the stripes, whatever its place along them, and states a whole number of two cycles
apart are averaged. Continuum: the cells of y = Ly/2. Both are shifted along x so that the pattern's first peak at ft = 0 stands at half a
wavelength. Lengths in sigma, velocities in sqrt(g sigma), laboratory frame.
"""
import dataclasses
import tomllib

import h5py
import numpy as np

from run_folder import RunError

BIN_X, BIN_Z = 2.0, 1.0      # of the MD
FEWEST = 20                  # particles in a bin, for a velocity, a temperature and what follows from them
EMPTY = 1e-3                 # volume fraction below which the continuum is not drawn
PACKING, RESTITUTION = 0.65, 0.7
ORDERED = 0.6                # volume fraction of the MD above which planes of spheres have no pressure by the equation of state


@dataclasses.dataclass
class Slice:
    """Fields of shape (z, x) on edges in sigma; NaN where there is nothing."""
    x: np.ndarray
    z: np.ndarray
    plate: float
    fields: dict


def goldshtein(nu):
    """nu g0, and its derivative in nu."""
    share, power = np.clip(nu / PACKING, 0, 1 - 1e-9), 4 * PACKING / 3
    g0 = 1 / (1 - share**power)
    return nu * g0, g0 + nu * g0**2 * power * share**(power - 1) / PACKING


def pressure(nu, temperature):
    return 6 / np.pi * nu * temperature * (1 + 2 * (1 + RESTITUTION) * goldshtein(nu)[0])


def shear_viscosity(nu, temperature):
    """mu of Jenkins and Richman (1985), all terms, with Goldshtein's pair correlation."""
    g = goldshtein(nu)[0]
    return np.sqrt(np.pi) / 6 * (6 * nu / np.pi) * np.sqrt(temperature) * (5 / 16 / g + 1 + 0.8 * (1 + 12 / np.pi) * g)


def completed(x, z, plate, nu, u_x, u_z, temperature, densest=PACKING):
    """A slice with the pressure of the scene's equation of state, and its slope along x."""
    p = np.where(nu < densest, pressure(nu, temperature), np.nan)
    dx = x[1] - x[0]
    slope = (np.roll(p, -1, axis=1) - np.roll(p, 1, axis=1)) / (2 * dx)
    return Slice(x, z, plate, {"nu": nu, "u_x": u_x, "u_z": u_z, "T": temperature, "P": p, "dP/dx": slope})


class Stripes:
    """The two cycles of one engine in a run folder with whole states of several cycles (sample.frame_cycles)."""

    def __init__(self, folder, engine):
        self.path = folder / f"{engine}.h5"
        if not self.path.is_file():
            raise RunError(f"{self.path}: not there")
        self.engine = engine
        with h5py.File(self.path) as file:
            self.scene = tomllib.loads(file["provenance/scene"][()].decode())
            self.across, self.offset = self._pattern(file["height_maps"])
            self._frames(file)
        self.gamma = self.scene["plate"]["acceleration"]
        self.width = self.scene["box"]["xy"[self.across]]

    def _pattern(self, maps):
        """Axis across the stripes and the place of a peak along it, at ft = 0 of the first of the two cycles."""
        chosen = np.flatnonzero((np.abs(maps["phase"][:]) < 1e-9) & (maps["cycle"][:] % 2 == 0))
        height = maps["height"][chosen[-1]]
        power = [np.abs(np.fft.rfft(height.mean(axis=1 - axis)))[1:] for axis in (1, 0)]
        across = int(power[1].max() > power[0].max())
        profile = height.mean(axis=across)
        waves = 1 + int(np.argmax(power[across]))
        length = maps.attrs["length_x" if across == 0 else "length_y"]
        amplitude = np.fft.rfft(profile)[waves]
        peak = (-np.angle(amplitude) / (2 * np.pi * waves) * length + 0.5 * length / len(profile)) % (length / waves)
        self.wavelength = length / waves
        return across, peak - self.wavelength / 2

    def _frames(self, file):
        """Where each state of the two cycles is: {ft in [0, 2): [frames]}."""
        if self.engine == "md":
            phase = file["particles/all/phase"][:]
            cycle = np.rint(file["particles/all/position/step"][:] / self.scene["sample"]["phases"] - phase).astype(int)
        else:
            frames = [file["frames"][name] for name in sorted(file["frames"])]
            phase, cycle = (np.array([frame[key][()] for frame in frames]) for key in ("phase", "cycle"))
        self.times = {}
        for number, (c, p) in enumerate(zip(cycle, phase)):
            self.times.setdefault(round(float(c % 2 + p), 6), []).append(number)

    def _found(self, ft):
        key = min(self.times, key=lambda time: abs(time - ft))
        if abs(key - ft) > 1e-3:
            raise RunError(f"{self.path}: no state at ft = {ft:g}; sample.frames and sample.frame_cycles = 2 keep one")
        return self.times[key]

    def plate(self, ft):
        plate, depth = self.scene["plate"], 0.9 * self.scene["particles"]["number"] / (self.scene["box"]["x"] * self.scene["box"]["y"])
        frequency = plate.get("frequency") or plate["frequency_star"] / np.sqrt(depth)
        return plate["acceleration"] / (2 * np.pi * frequency) ** 2 * (1 - np.cos(2 * np.pi * ft))

    def particles(self, ft, last=False):
        """x across the stripes, place along them, z, and u_x, u_z of the particles; of the last such state only, or of all."""
        with h5py.File(self.path) as file:
            numbers = self._found(ft)[-1:] if last else self._found(ft)
            r = np.concatenate([file["particles/all/position/value"][n] for n in numbers])
            v = np.concatenate([file["particles/all/velocity/value"][n] for n in numbers])
        a = self.across
        return (r[:, a] - self.offset) % self.width, r[:, 1 - a], r[:, 2], v[:, a], v[:, 1 - a], v[:, 2], len(numbers)

    def heights(self, ft, shares):
        """Heights below which such shares of the mass lie."""
        if self.engine == "md":
            return np.quantile(self.particles(ft)[2], shares)
        with h5py.File(self.path) as file:
            row = file[f"frames/{self._found(ft)[-1]:05d}/density"][:].sum(axis=(1, 2))
            spacing = file["grid/spacing"][2]
        below = np.concatenate([[0], np.cumsum(row)]) / row.sum()
        return self.plate(ft) + np.interp(shares, below, spacing * np.arange(len(below)))

    def at(self, ft, top=25.0):
        """The slice at ft in [0, 2), up to the height `top`."""
        return self._of_md(ft, top) if self.engine == "md" else self._of_continuum(ft, top)

    def _of_md(self, ft, top):
        x, _, z, u, v, w, states = self.particles(ft)
        plate = self.plate(ft)
        edges = np.linspace(0, self.width, round(self.width / BIN_X) + 1), plate + np.arange(0, top - plate + BIN_Z, BIN_Z)
        along = self.scene["box"]["yx"[self.across]]

        def summed(weights):
            return np.histogram2d(z, x, bins=(edges[1], edges[0]), weights=weights)[0]

        count = summed(np.ones_like(x))
        nu = np.pi / 6 * count / (states * along * BIN_Z * self.width / (len(edges[0]) - 1))
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = [summed(c) / count for c in (u, v, w)]
            square = sum(summed(c * c) / count - m * m for c, m in zip((u, v, w), mean)) / 3
        # A sample's variance is (N - 1)/N of the gas's.
        temperature = np.where(count >= FEWEST, square * count / np.maximum(count - 1, 1), np.nan)
        mean = [np.where(count >= FEWEST, m, np.nan) for m in mean]
        nu = np.where(count > 0, nu, np.nan)
        return completed(edges[0], edges[1], plate, nu, mean[0], mean[2], temperature, ORDERED)

    def _of_continuum(self, ft, top):
        with h5py.File(self.path) as file:
            frame = file[f"frames/{self._found(ft)[-1]:05d}"]
            cells, spacing = file["grid/cells"][:], file["grid/spacing"][:]
            middle = cells[1 - self.across] // 2
            cut = (lambda f: f[:, middle, :]) if self.across == 0 else (lambda f: f[:, :, middle])
            density, u, w, temperature = (cut(frame[name][:]) for name in ("density", "velocity_" + "xy"[self.across], "velocity_z", "temperature"))
        plate = self.plate(ft)
        rows = min(len(density), int((top - plate) / spacing[2]) + 1)
        shift = -int(round(self.offset / spacing[self.across]))
        nu, u, w, temperature = (np.roll(f[:rows], shift, axis=1) for f in (np.pi / 6 * density, u, w, temperature))
        shown = nu > EMPTY
        nu, u, w, temperature = (np.where(shown, f, np.nan) for f in (nu, u, w, temperature))
        x = np.linspace(0, self.width, cells[self.across] + 1)
        return completed(x, plate + spacing[2] * np.arange(rows + 1), plate, nu, u, w, temperature)
