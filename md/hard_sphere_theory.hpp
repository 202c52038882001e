// SPDX-License-Identifier: MIT
// What the literature knows of the uniform hard-sphere gas, elastic or cooling, to hold runs against. Diameter and mass
// 1; phi volume fraction, n = 6 phi/pi, Z = p/(nT), chi pair correlation at contact, e constant restitution,
// a2 fourth cumulant of the velocity, <v^4> = 15 T^2 (1 + a2). `particles`: how many there are, in a periodic box.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace shaken::md::theory {

/// Z of the fluid, Kolafa, Labik and Malijevsky 2004 (Phys. Chem. Chem. Phys. 6, 2335): a series in x = phi/(1 - phi).
/// The paper could not be read. Its coefficients are as others quote them; the powers 10, 14 and 22 of the last three
/// are those under which the series agrees with simulations (docs/validation.md). Fluid only: above phi = 0.571 its
/// pressure falls, from 0.595 on it is negative.
inline double compressibility_fluid(double phi) {
    const double x = phi / (1.0 - phi), x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
    constexpr double low[] = {1.0, 4.0, 6.0, 2.3647684, -0.8698551, 1.1062803, -1.095049, 0.637614};
    double z = 0.0;
    for (int k = 7; k >= 0; --k) z = z * x + low[k];
    return z + x8 * x2 * (-0.2279397 + x4 * (0.1098948 - 0.00906797 * x8));
}

/// Z of Carnahan and Starling 1969.
inline double compressibility_carnahan_starling(double phi) {
    return (1.0 + phi + phi * phi - phi * phi * phi) / std::pow(1.0 - phi, 3);
}

/// Where the fluid freezes and the crystal melts (Hoover and Ree 1968).
inline constexpr double freezing = 0.494, melting = 0.545;

/// Z of the face-centred cubic crystal, Speedy 1998 (J. Phys.: Condens. Matter 10, 4387), from melting on.
inline double compressibility_crystal(double phi) {
    const double z = phi * 3.0 * std::numbers::sqrt2 / std::numbers::pi;  // of close packing
    return 3.0 / (1.0 - z) - 0.5921 * (z - 0.7072) / (z - 0.601);
}

/// Z at equilibrium: of the fluid up to freezing, of the crystal from melting on. Between them both phases stand side
/// by side, and this is a straight line from one to the other: good for estimates of time scales, no reference.
inline double compressibility(double phi) {
    if (phi <= freezing) return compressibility_fluid(phi);
    if (phi >= melting) return compressibility_crystal(phi);
    const double share = (phi - freezing) / (melting - freezing);
    return (1.0 - share) * compressibility_fluid(freezing) + share * compressibility_crystal(melting);
}

/// By how much chi of N particles lies below that of infinitely many, times N: Lebowitz and Percus 1961 (Phys. Rev.
/// 122, 1675), to first order in 1/N. It is S(0)/2 d^2(phi^2 chi)/dphi^2 with S(0) = 1/(d(phi Z)/dphi), and phi^2 chi
/// is (phi Z - phi)/4. For any Z of a fluid; central differences, truncation some 1e-5 of the result. The paper could
/// not be read: equation unchecked, but for the runs of docs/validation.md.
template <typename Compressibility>
double contact_value_deficit(const Compressibility& z, double phi) {
    constexpr double h = 1e-3;
    const double below = (phi - h) * z(phi - h), here = phi * z(phi), above = (phi + h) * z(phi + h);
    const double slope = (above - below) / (2.0 * h), curvature = (above - 2.0 * here + below) / (h * h);
    return curvature / (8.0 * slope);
}

inline constexpr double infinitely_many = std::numeric_limits<double>::infinity();

/// chi from Z = 1 + 4 phi chi; above freezing of infinitely many.
inline double contact_value(double phi, double particles = infinitely_many) {
    const double deficit = phi <= freezing ? contact_value_deficit(compressibility_fluid, phi) / particles : 0.0;
    return (compressibility(phi) - 1.0) / (4.0 * phi) - deficit;
}

/// Z of Carnahan and Starling for N particles.
inline double compressibility_carnahan_starling(double phi, double particles) {
    const auto z = [](double x) { return compressibility_carnahan_starling(x); };
    return z(phi) - 4.0 * phi * contact_value_deficit(z, phi) / particles;
}

/// Z of a gas of constant restitution: every collision transfers (1 + e)/2 of the elastic momentum.
inline double compressibility(double phi, double e, double particles = infinitely_many) {
    return 1.0 + 0.5 * (1.0 + e) * 4.0 * phi * contact_value(phi, particles);
}

/// Collisions per particle and time over sqrt(T); a pair's collision counts for both. Enskog; the shape of the
/// distribution enters as in van Noije and Ernst 1998.
inline double collision_rate(double phi, double a2 = 0.0, double particles = infinitely_many) {
    return 4.0 * std::sqrt(std::numbers::pi) * (6.0 * phi / std::numbers::pi) * contact_value(phi, particles) *
           (1.0 - a2 / 16.0);
}

/// Growth of 1/sqrt(T) with time in a cooling gas, Haff 1983: T = T0/(1 + t/tau)^2, 1/tau = rate sqrt(T0).
inline double cooling_rate(double phi, double e, double a2 = 0.0, double particles = infinitely_many) {
    return 4.0 / std::sqrt(std::numbers::pi) * (1.0 - e * e) * phi * contact_value(phi, particles) *
           (1.0 + 3.0 * a2 / 16.0);
}

/// a2 of a cooling gas to first order in Sonine polynomials, van Noije and Ernst 1998 (Granular Matter 1, 57). Direct
/// simulation gives up to 0.002 less.
inline double cooling_cumulant(double e) {
    return 16.0 * (1.0 - e) * (1.0 - 2.0 * e * e) / (81.0 - 17.0 * e + 30.0 * e * e * (1.0 - e));
}

/// Shear viscosity over sqrt(T), Enskog.
inline double viscosity(double phi) {
    const double g = phi * contact_value(phi);
    return std::sqrt(std::numbers::pi) / 6.0 * (6.0 * phi / std::numbers::pi) *
           (5.0 / (16.0 * g) + 1.0 + 0.8 * (1.0 + 12.0 / std::numbers::pi) * g);
}

/// Self-diffusion over sqrt(T) of the infinite system: Enskog's with the correction of simulations, a polynomial of
/// Erpenbeck and Wood 1991 (Phys. Rev. A 43, 4254), in a cube of the side L less 2.837 T/(6 pi eta L) (Yeh and Hummer
/// 2004, J. Phys. Chem. B 108, 15873).
inline double self_diffusion(double phi) {
    const double n = 6.0 * phi / std::numbers::pi, x = n / std::numbers::sqrt2;
    const double enskog = 1.01896 * 3.0 / (8.0 * n * std::sqrt(std::numbers::pi) * contact_value(phi));
    return enskog * (1.0 + x * (0.054034 + x * (6.3656 - 10.9425 * x)));
}
inline double self_diffusion(double phi, double side) {
    return self_diffusion(phi) - 2.837 / (6.0 * std::numbers::pi * viscosity(phi) * side);
}

}  // namespace shaken::md::theory
