# SPDX-License-Identifier: MIT
"""Tables 6.1 and 6.2: the Rayleigh-Benard analogue of the noise, n c_p T/(mu kappa d) at the densest place of the continuum."""
import sys

import h5py
import numpy as np

import run_folder
import tables
from run_folder import RunError
from slices import RESTITUTION, goldshtein, shear_viscosity
from style import DENSITY, LENGTH, plt, save

NAME = "figure_6_tables"
CAPTION = (
    "Tables 6.1 and 6.2. n c_p T/(mu kappa d) at the densest place of a continuum cell of 126 x 10, Gamma = 2.2, d = 5.4, over the cycle after thirty, and (right) the ratio "
    "of q0 times it, f* = 0.4174 over 0.25: ours with the sink of e(v) (full markers) and with constant e = 0.7, as the source (open), the source's (crosses)."
)
FREQUENCIES = (("0.25", LENGTH, "s"), ("0.4174", DENSITY, "^"))


def specific_heat(nu):
    """c_p = 3/2 + chi^2/(chi + nu dchi/dnu), chi = 1 + 2 (1 + e) G (the source's equation 6.4)."""
    g, slope = goldshtein(nu)
    chi = 1 + 2 * (1 + RESTITUTION) * g
    return 1.5 + chi**2 / (chi + nu * 2 * (1 + RESTITUTION) * slope)


def noise_coefficient(nu, temperature, depth):
    """n c_p T/(mu kappa d), with the viscosity and conductivity of Jenkins and Richman (1985), all terms."""
    n, root = 6 * nu / np.pi, np.sqrt(temperature)
    g = goldshtein(nu)[0]
    conductivity = 15 * np.sqrt(np.pi) / 16 * n * root * (5 / 24 / g + 1 + 1.2 * (1 + 32 / (9 * np.pi)) * g)
    return n * specific_heat(nu) * temperature / (shear_viscosity(nu, temperature) * conductivity * depth)


def of_run(path, phases, depth):
    """The coefficient at the densest cell, and nu and T there, at each phase."""
    if not path.is_file():
        raise RunError(f"{path}: not there")
    found = []
    with h5py.File(path) as file:
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        at = np.array([frame["phase"][()] for frame in frames])
        for phase in phases:
            frame = frames[int(np.argmin(np.abs(at - phase)))]
            density = frame["density"][:].ravel()
            densest = int(np.argmax(density))
            nu, temperature = np.pi / 6 * density[densest], frame["temperature"][:].ravel()[densest]
            found.append((noise_coefficient(nu, temperature, depth), nu, temperature))
    return np.array(found).T


def draw(study):
    source = tables.references(6)["rayleigh_benard"]
    phases, depth = np.array(source["phases"]), source["depth"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 4.0))
    columns = {"ft": phases}
    ours = {}
    for frequency, colour, marker in FREQUENCIES:
        for law, fill in (("", colour), ("_constant", "none")):
            ours[frequency + law], nu, temperature = of_run(study.folder / "runs" / f"states_{frequency}{law}" / "continuum.h5", phases, depth)
            left.plot(phases, ours[frequency + law], marker=marker, color=colour, mfc=fill, lw=0.7, label=f"$f^*$ = {frequency}" if not law else None)
            columns |= {f"F_RB f*={frequency}{law}": ours[frequency + law], f"nu f*={frequency}{law}": nu, f"T f*={frequency}{law}": temperature}
        left.plot(phases, source[frequency], "x", color=colour, ms=6)
        columns[f"F_RB f*={frequency} source"] = source[frequency]
    q_ratio = source["wavelengths"]["0.25"] / source["wavelengths"]["0.4174"]
    for law, fill in (("", "black"), ("_constant", "none")):
        ratio = q_ratio * ours["0.4174" + law] / ours["0.25" + law]
        right.plot(phases, ratio, "o", color="black", mfc=fill, ls="-", lw=0.7)
        columns[f"ratio{law}"] = ratio
    right.plot(phases, source["ratio"], "x", color="black", ms=6)
    columns["ratio source"] = source["ratio"]
    right.axhline(1.0, color="0.6", lw=0.8)
    for axis in (left, right):
        axis.set_yscale("log")
        axis.set_xlabel(r"$ft$")
    left.set_ylabel(r"$n c_p T/(\mu\kappa d)$")
    right.set_ylabel(r"ratio of $q_0 n c_p T/(\mu\kappa d)$")
    left.legend()
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))
