// SPDX-License-Identifier: MIT
// The right-hand sides at the nodes, with G = a - 2 mu/3, a = lambda, D = div u, written out:
//     dn/dt   = -div(n u)
//     du_i/dt = -u.grad u_i - g_i + [ -d_i p + d_i G D + (G + mu) d_i D + mu lap u_i + sum_j d_j mu (d_j u_i + d_i u_j)
//     ] / n dT/dt   = -u.grad T + (2/3) [ kappa lap T + grad kappa . grad T + (G D - p) D + 2 mu E:E ] / n - sink
// First and second derivatives by three nodes, mixed ones by the four corners.
#include <cmath>

#include "continuum/closures/pressure.hpp"
#include "continuum/ftcs/ftcs.hpp"

namespace shaken::continuum {

/// Element 0 of each array is the lower wall.
struct Ftcs::Column {
    const double* velocity[3];
    const double *density, *temperature, *pressure, *bulk, *shear, *conductivity;
};

Ftcs::Column Ftcs::column(std::int64_t ix, std::int64_t iy) const {
    const std::int64_t nx = grid().nx, ny = grid().ny;
    const std::int64_t f = nodes_.first(nodes_.column((ix + nx) % nx, (iy + ny) % ny));
    return {{now_.velocity_x.data() + f, now_.velocity_y.data() + f, now_.velocity_z.data() + f},
            now_.density.data() + f,
            now_.temperature.data() + f,
            pressure_.data() + f,
            bulk_.data() + f,
            shear_.data() + f,
            conductivity_.data() + f};
}

void Ftcs::difference(std::int64_t c, double gravity, double dt) {
    const std::int64_t ix = c % grid().nx, iy = c / grid().nx, first = nodes_.first(c);
    const Column here = column(ix, iy), east = column(ix + 1, iy), west = column(ix - 1, iy),
                 north = column(ix, iy + 1), south = column(ix, iy - 1), ne = column(ix + 1, iy + 1),
                 nw = column(ix - 1, iy + 1), se = column(ix + 1, iy - 1), sw = column(ix - 1, iy - 1);
    const double dx = grid().dx, dy = grid().dy, dz = grid().dz;
    const double inverse[3] = {0.5 / dx, 0.5 / dy, 0.5 / dz};
    const double squared[3] = {1.0 / (dx * dx), 1.0 / (dy * dy), 1.0 / (dz * dz)};
    const double artificial = strength_ * smallest_spacing_ * smallest_spacing_;
    const double* cooling = cooling_.data() + first;

    for (std::int64_t k = 1; k < grid().nz; ++k) {
        struct Slopes {
            double x, y, z;
        };
        const auto slopes = [&](auto field) -> Slopes {
            return {inverse[0] * (field(east)[k] - field(west)[k]), inverse[1] * (field(north)[k] - field(south)[k]),
                    inverse[2] * (field(here)[k + 1] - field(here)[k - 1])};
        };
        const auto curvatures = [&](auto field) -> Slopes {
            const double centre = field(here)[k];
            return {squared[0] * (field(east)[k] - 2.0 * centre + field(west)[k]),
                    squared[1] * (field(north)[k] - 2.0 * centre + field(south)[k]),
                    squared[2] * (field(here)[k + 1] - 2.0 * centre + field(here)[k - 1])};
        };
        const auto velocity = [](std::size_t i) { return [i](const Column& at) { return at.velocity[i]; }; };
        const double u[3] = {here.velocity[0][k], here.velocity[1][k], here.velocity[2][k]};
        const double n = here.density[k], t = here.temperature[k], mu = here.shear[k];
        const double volume_term = here.bulk[k] - (2.0 / 3.0) * mu;

        const double outflow =
            inverse[0] * (east.density[k] * east.velocity[0][k] - west.density[k] * west.velocity[0][k]) +
            inverse[1] * (north.density[k] * north.velocity[1][k] - south.density[k] * south.velocity[1][k]) +
            inverse[2] *
                (here.density[k + 1] * here.velocity[2][k + 1] - here.density[k - 1] * here.velocity[2][k - 1]);
        const Slopes grad_t = slopes([](const Column& at) { return at.temperature; });
        const Slopes grad_p = slopes([](const Column& at) { return at.pressure; });
        const Slopes grad_bulk = slopes([](const Column& at) { return at.bulk; });
        const Slopes grad_mu_ = slopes([](const Column& at) { return at.shear; });
        const Slopes grad_kappa = slopes([](const Column& at) { return at.conductivity; });
        const double slope_p[3] = {grad_p.x, grad_p.y, grad_p.z};
        const double grad_mu[3] = {grad_mu_.x, grad_mu_.y, grad_mu_.z};
        const double slope_volume[3] = {grad_bulk.x - (2.0 / 3.0) * grad_mu_.x, grad_bulk.y - (2.0 / 3.0) * grad_mu_.y,
                                        grad_bulk.z - (2.0 / 3.0) * grad_mu_.z};
        double d[3][3], dd[3][3];  // d[i][j] = d_j u_i, dd[i][j] = d_j d_j u_i
        for (std::size_t i = 0; i < 3; ++i) {
            const Slopes one = slopes(velocity(i)), two = curvatures(velocity(i));
            d[i][0] = one.x, d[i][1] = one.y, d[i][2] = one.z;
            dd[i][0] = two.x, dd[i][1] = two.y, dd[i][2] = two.z;
        }
        const auto mixed_xy = [&](std::size_t i) {
            return inverse[0] * inverse[1] *
                   (ne.velocity[i][k] - nw.velocity[i][k] - se.velocity[i][k] + sw.velocity[i][k]);
        };
        const auto mixed_xz = [&](std::size_t i) {
            return inverse[0] * inverse[2] *
                   (east.velocity[i][k + 1] - west.velocity[i][k + 1] - east.velocity[i][k - 1] +
                    west.velocity[i][k - 1]);
        };
        const auto mixed_yz = [&](std::size_t i) {
            return inverse[1] * inverse[2] *
                   (north.velocity[i][k + 1] - south.velocity[i][k + 1] - north.velocity[i][k - 1] +
                    south.velocity[i][k - 1]);
        };
        const double divergence = d[0][0] + d[1][1] + d[2][2];
        const double slope_divergence[3] = {dd[0][0] + mixed_xy(1) + mixed_xz(2), mixed_xy(0) + dd[1][1] + mixed_yz(2),
                                            mixed_xz(0) + mixed_yz(1) + dd[2][2]};
        double strain = 0.0;  // E:E
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) strain += 0.25 * (d[i][j] + d[j][i]) * (d[i][j] + d[j][i]);

        const auto at = static_cast<std::size_t>(first + k);
        const double fade = artificial * scene::exponential(-200.0 * sphere_volume * n);
        std::vector<double>* const out[3] = {&next_.velocity_x, &next_.velocity_y, &next_.velocity_z};
        for (std::size_t i = 0; i < 3; ++i) {
            const double laplacian = dd[i][0] + dd[i][1] + dd[i][2];
            double stress =
                -slope_p[i] + slope_volume[i] * divergence + (volume_term + mu) * slope_divergence[i] + mu * laplacian;
            for (std::size_t j = 0; j < 3; ++j) stress += grad_mu[j] * (d[i][j] + d[j][i]);
            const double carried = u[0] * d[i][0] + u[1] * d[i][1] + u[2] * d[i][2];
            (*out[i])[at] = u[i] + dt * (stress / n - carried - (i == 2 ? gravity : 0.0)) + fade * laplacian;
        }
        next_.density[at] = n - dt * outflow;
        const Slopes curve_t = curvatures([](const Column& column_at) { return column_at.temperature; });
        const double laplacian_t = curve_t.x + curve_t.y + curve_t.z;
        double heat = here.conductivity[k] * laplacian_t + grad_kappa.x * grad_t.x + grad_kappa.y * grad_t.y +
                      grad_kappa.z * grad_t.z + (volume_term * divergence - here.pressure[k]) * divergence +
                      2.0 * mu * strain;
        const double sink = cooling[k] * dissipation_(t) * t * std::sqrt(t);
        const double carried = u[0] * grad_t.x + u[1] * grad_t.y + u[2] * grad_t.z;
        next_.temperature[at] = t + dt * ((2.0 / 3.0) * heat / n - carried - sink) + fade * laplacian_t;
    }
}

void Ftcs::difference_at_wall(std::int64_t c, std::int64_t node, std::int64_t inward, double dt) {
    const std::int64_t ix = c % grid().nx, iy = c / grid().nx;
    const Column here = column(ix, iy), east = column(ix + 1, iy), west = column(ix - 1, iy),
                 north = column(ix, iy + 1), south = column(ix, iy - 1);
    const double half_dx = 0.5 / grid().dx, half_dy = 0.5 / grid().dy;
    const auto flux_z = [&](std::int64_t k) { return here.density[k] * here.velocity[2][k]; };
    const double outflow_z = static_cast<double>(inward) * 0.5 / grid().dz *
                             (4.0 * flux_z(node + inward) - flux_z(node + 2 * inward) - 3.0 * flux_z(node));
    const double outflow =
        half_dx * (east.density[node] * east.velocity[0][node] - west.density[node] * west.velocity[0][node]) +
        half_dy * (north.density[node] * north.velocity[1][node] - south.density[node] * south.velocity[1][node]) +
        outflow_z;
    const auto i = static_cast<std::size_t>(nodes_.first(c) + node);
    next_.density[i] = now_.density[i] - dt * outflow;
    // u and T of a wall follow from their conditions once the step is made.
    next_.velocity_x[i] = now_.velocity_x[i];
    next_.velocity_y[i] = now_.velocity_y[i];
    next_.velocity_z[i] = 0.0;
    next_.temperature[i] = now_.temperature[i];
}

}  // namespace shaken::continuum
