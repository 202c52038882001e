# SPDX-License-Identifier: MIT
"""Von Neumann's analysis of ftcs about an elastic gas at rest at T = 1, without the terms in 1/G, in one dimension.

A disturbance exp(ikz) of (n, u, T) is multiplied by 1 + dt M(k) a step. With K1 = sin(kh)/h and K2 = 4 sin^2(kh/2)/h^2,
    n' = -i K1 n0 u
    u' = -i K1 (p_n n + p_T T)/n0 - (lambda + 4 mu/3) K2 u/n0       - K2 D u
    T' = (2/3) (-kappa K2 T - i K1 p u)/n0                          - K2 D T
where D dt = C_AD h^2 exp(-200 nu). The step is dt = s n h^2 / max(mu, lambda, kappa).
"""
import numpy as np

NU_MAX = 0.65


class Gas:
    def __init__(self, fraction):
        self.fraction, self.density = fraction, 6.0 * fraction / np.pi
        power = (fraction / NU_MAX) ** (4.0 * NU_MAX / 3.0)
        contact = fraction / (1.0 - power)
        self.chi = 1.0 + 4.0 * contact
        slope = 1.0 / (1.0 - power) + (4.0 * NU_MAX / 3.0) * power / (1.0 - power) ** 2  # d(nu g0)/d nu
        self.p_n = self.chi + 4.0 * fraction * slope
        self.speed = np.sqrt(self.p_n + (2.0 / 3.0) * self.chi**2)  # of sound
        self.shear = np.sqrt(np.pi) / 6.0 * (1.0 + 0.8 * (1.0 + 12.0 / np.pi) * contact)  # these three over n
        self.bulk = 8.0 / (3.0 * np.sqrt(np.pi)) * contact
        self.conductivity = 15.0 * np.sqrt(np.pi) / 16.0 * (1.0 + 1.2 * (1.0 + 32.0 / (9.0 * np.pi)) * contact)
        self.viscosity = self.bulk + 4.0 / 3.0 * self.shear  # of sound waves: nu of the bounds
        self.stiffest = max(self.shear, self.bulk, self.conductivity)

    def growth(self, spacing, factor, strength=0.0):
        """The largest |1 + dt M(k)| over all waves that the grid holds."""
        step = factor * spacing**2 / self.stiffest
        artificial = strength * np.exp(-200.0 * self.fraction) * spacing**2 / step
        n = self.density
        largest = 0.0
        for angle in np.linspace(0.0, np.pi, 129)[1:]:
            first, second = np.sin(angle) / spacing, 4.0 * np.sin(0.5 * angle) ** 2 / spacing**2
            matrix = np.array([[0.0, -1j * first * n, 0.0],
                               [-1j * first * self.p_n / n, -second * (self.viscosity + artificial), -1j * first * self.chi],
                               [0.0, -1j * first * (2.0 / 3.0) * self.chi, -second * ((2.0 / 3.0) * self.conductivity + artificial)]])
            largest = max(largest, np.abs(1.0 + step * np.linalg.eigvals(matrix)).max())
        return largest

    def largest_factor(self, spacing, strength=0.0):
        """The largest stable s, by bisection; 0 where none is."""
        stable = lambda factor: self.growth(spacing, factor, strength) <= 1.0 + 1e-9
        low, high = 1e-4, 10.0
        if not stable(low):
            return 0.0
        for _ in range(40):
            middle = np.sqrt(low * high)
            low, high = (middle, high) if stable(middle) else (low, middle)
        return low

    def cell_reynolds(self, spacing):
        return self.speed * spacing / self.viscosity

    def diffusion_limit(self):
        """s at which explicit diffusion alone becomes unstable: D dt/h^2 = 1/2."""
        return 0.5 * self.stiffest / max(self.viscosity, (2.0 / 3.0) * self.conductivity)

    def convection_limit(self, spacing):
        """s of dt = 2 nu/c^2."""
        return 2.0 * self.viscosity / self.speed**2 * self.stiffest / spacing**2
