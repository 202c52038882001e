# SPDX-License-Identifier: MIT
"""The motion of stripes in numbers, from the slices of one engine over two cycles: the wave of the height, the sloshing that carries it, where the heat of the landing is.

Amplitudes are of cos k(x - x0) for the height, of sin k(x - x0) for the velocity, x0 the place of a peak at ft = 0: positive sloshing runs away from that peak.
"""
import numpy as np

from slices import BIN_Z

FOOT, CREST = 0.001, 0.999   # shares of the mass below which, above which, a layer's ends are told
LAYER = 0.95                 # share of the mass whose hottest height is sought: the gas above is hot at all times


def motion(stripes, ft):
    """{part: value} at one of the phases of two cycles; lengths in sigma, velocities in sqrt(g sigma). foot, crest and top (of a gas: the lid) are above the plate, densest is a mean over x and BIN_Z of height."""
    piece = stripes.at(ft, top=60.0)
    x, z = ((edges[1:] + edges[:-1]) / 2 for edges in (piece.x, piece.z))
    nu, u, temperature = (np.nan_to_num(piece.fields[name]) for name in ("nu", "u_x", "T"))
    told = np.where(np.isfinite(piece.fields["u_x"]), nu, 0)   # where a velocity is known
    angle = 2 * np.pi * (x - stripes.wavelength / 2) / stripes.wavelength
    thick = max(1, round(BIN_Z / (z[1] - z[0])))
    column, row = nu.sum(axis=0), nu.sum(axis=1)
    height = (nu * z[:, None]).sum(axis=0) / column
    below = np.cumsum(row) / row.sum()
    foot, crest, top = stripes.heights(ft, (FOOT, CREST, 1.0)) - piece.plate
    hot = np.where(below < LAYER, (nu * temperature).sum(axis=1) / np.maximum(row, 1e-300), 0)
    return {"height wave": 2 * float(np.mean(height * np.cos(angle))), "sloshing": 2 * float((told * u * np.sin(angle)).sum() / told.sum()),
            "densest": float(np.convolve(nu.mean(axis=1), np.full(thick, 1 / thick), "valid").max()), "mass below the hottest": float(below[np.argmax(hot)]), "foot": float(foot), "crest": float(crest), "top": float(top)}


def crossings(ft, values):
    """Phases at which a curve passes through zero, linear between its points."""
    turned = np.flatnonzero(np.sign(values[1:]) * np.sign(values[:-1]) < 0)
    return [float(ft[i] + (ft[i + 1] - ft[i]) * values[i] / (values[i] - values[i + 1])) for i in turned]
