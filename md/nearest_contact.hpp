// SPDX-License-Identifier: MIT
// The innermost loop: which neighbour a particle touches first, if both go on as they do.
// Written three times, plainly and for four (AVX2) and eight (AVX-512) neighbours at a time; all do the same operations
// in the same order on each neighbour, so they find the same time to the last bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#if defined(__AVX2__)
#pragma GCC diagnostic push  // GCC 12 warns of variables that its own header leaves unset on purpose
#pragma GCC diagnostic ignored "-Wuninitialized"
#ifndef __clang__  // which does not know the name
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

#include "md/contact_time.hpp"
#include "md/neighbour_lists.hpp"
#include "md/particle.hpp"

namespace shaken::md {

struct Contact {
    double delay;  // from now; `never` if no neighbour is touched
    std::uint32_t partner;
};

/// Of particle p, which must be at its position of `now`. Of equal times any may be named, always the same one.
inline Contact nearest_contact_plain(const Particle& p, double now, std::span<const std::uint32_t> neighbours,
                                     const Particle* particles, const Periodic& x, const Periodic& y,
                                     const Periodic& z) {
    Contact first{never, 0};
    for (const std::uint32_t j : neighbours) {
        const Particle& q = particles[j];
        const double flight = now - q.time;
        const double vx = q.velocity_x - p.velocity_x;
        const double vy = q.velocity_y - p.velocity_y;
        const double vz = q.velocity_z - p.velocity_z;
        const double rx = x.image(q.x + q.velocity_x * flight - p.x);
        const double ry = y.image(q.y + q.velocity_y * flight - p.y);
        const double rz = z.image(q.z + q.velocity_z * flight - p.z);
        const double r_dot_v = rx * vx + ry * vy + rz * vz;
        if (r_dot_v >= 0.0) continue;
        const double r_squared = rx * rx + ry * ry + rz * rz;
        // Not before gap / (-2 r.v), because the root in the denominator is at most -r.v: most need no root.
        if (r_squared - 1.0 >= -2.0 * first.delay * r_dot_v) continue;
        const double delay = time_to_contact(r_dot_v, r_squared, vx * vx + vy * vy + vz * vz);
        if (delay < first.delay) first = {delay, j};
    }
    return first;
}

#if defined(__AVX2__)

namespace four {

/// Four neighbours' records turned into vectors of one quantity each.
struct Records {
    __m256d x, y, z, velocity_x, velocity_y, velocity_z, time;
};

inline void transpose(__m256d a, __m256d b, __m256d c, __m256d d, __m256d& first, __m256d& second, __m256d& third,
                      __m256d& fourth) {
    const __m256d ab_even = _mm256_unpacklo_pd(a, b), ab_odd = _mm256_unpackhi_pd(a, b);
    const __m256d cd_even = _mm256_unpacklo_pd(c, d), cd_odd = _mm256_unpackhi_pd(c, d);
    first = _mm256_permute2f128_pd(ab_even, cd_even, 0x20);
    second = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x20);
    third = _mm256_permute2f128_pd(ab_even, cd_even, 0x31);
    fourth = _mm256_permute2f128_pd(ab_odd, cd_odd, 0x31);
}

inline Records load(const Particle* a, const Particle* b, const Particle* c, const Particle* d) {
    const auto head = [](const Particle* p) { return _mm256_load_pd(&p->x); };
    const auto tail = [](const Particle* p) { return _mm256_load_pd(&p->velocity_y); };
    Records r;
    __m256d stamps;
    transpose(head(a), head(b), head(c), head(d), r.x, r.y, r.z, r.velocity_x);
    transpose(tail(a), tail(b), tail(c), tail(d), r.velocity_y, r.velocity_z, r.time, stamps);
    return r;
}

inline __m256d image(__m256d difference, __m256d length, __m256d per_length) {
    const __m256d turns =
        _mm256_round_pd(_mm256_mul_pd(difference, per_length), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    return _mm256_sub_pd(difference, _mm256_mul_pd(length, turns));
}

}  // namespace four

/// As nearest_contact_plain. Inside: no neighbour is seen across a periodic boundary.
template <bool Inside>
inline Contact nearest_contact_four(const Particle& p, double now, std::span<const std::uint32_t> neighbours,
                                    const Particle* particles, const Periodic& x, const Periodic& y,
                                    const Periodic& z) {
    const __m256d px = _mm256_set1_pd(p.x), py = _mm256_set1_pd(p.y), pz = _mm256_set1_pd(p.z);
    const __m256d pu = _mm256_set1_pd(p.velocity_x), pv = _mm256_set1_pd(p.velocity_y),
                  pw = _mm256_set1_pd(p.velocity_z);
    const __m256d present = _mm256_set1_pd(now), zero = _mm256_setzero_pd(), one = _mm256_set1_pd(1.0);
    const __m256d none = _mm256_set1_pd(never);
    __m256d first = none;
    __m256d who = zero;  // each lane's group of four, as a number
    const std::uint32_t* const list = neighbours.data();
    const std::size_t count = neighbours.size();
    for (std::size_t k = 0; k < count; k += 4) {
        // Places past the end repeat the particle itself, at rest to itself: it never collides.
        const auto at = [&](std::size_t n) { return k + n < count ? particles + list[k + n] : &p; };
        const four::Records q = four::load(at(0), at(1), at(2), at(3));
        const __m256d flight = _mm256_sub_pd(present, q.time);
        const __m256d vx = _mm256_sub_pd(q.velocity_x, pu);
        const __m256d vy = _mm256_sub_pd(q.velocity_y, pv);
        const __m256d vz = _mm256_sub_pd(q.velocity_z, pw);
        __m256d rx = _mm256_sub_pd(_mm256_add_pd(q.x, _mm256_mul_pd(q.velocity_x, flight)), px);
        __m256d ry = _mm256_sub_pd(_mm256_add_pd(q.y, _mm256_mul_pd(q.velocity_y, flight)), py);
        __m256d rz = _mm256_sub_pd(_mm256_add_pd(q.z, _mm256_mul_pd(q.velocity_z, flight)), pz);
        if constexpr (!Inside) {
            rx = four::image(rx, _mm256_set1_pd(x.length), _mm256_set1_pd(x.per_length));
            ry = four::image(ry, _mm256_set1_pd(y.length), _mm256_set1_pd(y.per_length));
            rz = four::image(rz, _mm256_set1_pd(z.length), _mm256_set1_pd(z.per_length));
        }
        const auto dot = [](__m256d ax, __m256d ay, __m256d az, __m256d bx, __m256d by, __m256d bz) {
            return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(ax, bx), _mm256_mul_pd(ay, by)), _mm256_mul_pd(az, bz));
        };
        const __m256d r_dot_v = dot(rx, ry, rz, vx, vy, vz);
        const __m256d gap = _mm256_sub_pd(dot(rx, ry, rz, rx, ry, rz), one);
        const __m256d discriminant =
            _mm256_sub_pd(_mm256_mul_pd(r_dot_v, r_dot_v), _mm256_mul_pd(dot(vx, vy, vz, vx, vy, vz), gap));
        const __m256d meets =
            _mm256_and_pd(_mm256_cmp_pd(r_dot_v, zero, _CMP_LT_OQ), _mm256_cmp_pd(discriminant, zero, _CMP_GE_OQ));
        const __m256d root = _mm256_sqrt_pd(_mm256_and_pd(discriminant, meets));
        __m256d delay = _mm256_max_pd(zero, _mm256_div_pd(gap, _mm256_sub_pd(root, r_dot_v)));
        delay = _mm256_blendv_pd(none, delay, meets);
        const __m256d sooner = _mm256_cmp_pd(delay, first, _CMP_LT_OQ);
        first = _mm256_blendv_pd(first, delay, sooner);
        who = _mm256_blendv_pd(who, _mm256_castsi256_pd(_mm256_set1_epi64x(static_cast<long long>(k))), sooner);
    }
    alignas(32) double delays[4];
    alignas(32) long long groups[4];
    _mm256_store_pd(delays, first);
    _mm256_store_si256(reinterpret_cast<__m256i*>(groups), _mm256_castpd_si256(who));
    std::size_t best = 0;
    for (std::size_t lane = 1; lane < 4; ++lane)
        if (delays[lane] < delays[best]) best = lane;
    if (delays[best] == never) return {never, 0};
    return {delays[best], list[static_cast<std::size_t>(groups[best]) + best]};
}

#endif

#if defined(__AVX512F__)

namespace eight {

/// Eight neighbours' records turned into vectors of one quantity each.
struct Records {
    __m512d x, y, z, velocity_x, velocity_y, velocity_z, time;
};

template <class At>
inline Records load(At at) {
    const auto record = [&](std::size_t n) { return _mm512_load_pd(&at(n)->x); };
    const __m512d a = record(0), b = record(1), c = record(2), d = record(3);
    const __m512d e = record(4), f = record(5), g = record(6), h = record(7);
    // Pairs of x, z, velocity_y, time (even) and of y, velocity_x, velocity_z, stamp (odd), 128 bits each.
    const __m512d ab_even = _mm512_unpacklo_pd(a, b), ab_odd = _mm512_unpackhi_pd(a, b);
    const __m512d cd_even = _mm512_unpacklo_pd(c, d), cd_odd = _mm512_unpackhi_pd(c, d);
    const __m512d ef_even = _mm512_unpacklo_pd(e, f), ef_odd = _mm512_unpackhi_pd(e, f);
    const __m512d gh_even = _mm512_unpacklo_pd(g, h), gh_odd = _mm512_unpackhi_pd(g, h);
    constexpr int lower = 0x44, upper = 0xee, first = 0x88, second = 0xdd;
    const __m512d x_z = _mm512_shuffle_f64x2(ab_even, cd_even, lower),
                  x_z_2 = _mm512_shuffle_f64x2(ef_even, gh_even, lower);
    const __m512d v_t = _mm512_shuffle_f64x2(ab_even, cd_even, upper),
                  v_t_2 = _mm512_shuffle_f64x2(ef_even, gh_even, upper);
    const __m512d y_u = _mm512_shuffle_f64x2(ab_odd, cd_odd, lower),
                  y_u_2 = _mm512_shuffle_f64x2(ef_odd, gh_odd, lower);
    const __m512d w_s = _mm512_shuffle_f64x2(ab_odd, cd_odd, upper),
                  w_s_2 = _mm512_shuffle_f64x2(ef_odd, gh_odd, upper);
    return {_mm512_shuffle_f64x2(x_z, x_z_2, first),  _mm512_shuffle_f64x2(y_u, y_u_2, first),
            _mm512_shuffle_f64x2(x_z, x_z_2, second), _mm512_shuffle_f64x2(y_u, y_u_2, second),
            _mm512_shuffle_f64x2(v_t, v_t_2, first),  _mm512_shuffle_f64x2(w_s, w_s_2, first),
            _mm512_shuffle_f64x2(v_t, v_t_2, second)};
}

inline __m512d image(__m512d difference, const Periodic& axis) {
    constexpr int nearest_quietly = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
    const __m512d turns =
        _mm512_roundscale_pd(_mm512_mul_pd(difference, _mm512_set1_pd(axis.per_length)), nearest_quietly);
    return _mm512_sub_pd(difference, _mm512_mul_pd(_mm512_set1_pd(axis.length), turns));
}

inline __m512d dot(__m512d ax, __m512d ay, __m512d az, __m512d bx, __m512d by, __m512d bz) {
    return _mm512_add_pd(_mm512_add_pd(_mm512_mul_pd(ax, bx), _mm512_mul_pd(ay, by)), _mm512_mul_pd(az, bz));
}

}  // namespace eight

/// As nearest_contact_four.
template <bool Inside>
inline Contact nearest_contact_eight(const Particle& p, double now, std::span<const std::uint32_t> neighbours,
                                     const Particle* particles, const Periodic& x, const Periodic& y,
                                     const Periodic& z) {
    const __m512d px = _mm512_set1_pd(p.x), py = _mm512_set1_pd(p.y), pz = _mm512_set1_pd(p.z);
    const __m512d pu = _mm512_set1_pd(p.velocity_x), pv = _mm512_set1_pd(p.velocity_y),
                  pw = _mm512_set1_pd(p.velocity_z);
    const __m512d present = _mm512_set1_pd(now), zero = _mm512_setzero_pd(), one = _mm512_set1_pd(1.0);
    __m512d first = _mm512_set1_pd(never);
    __m512i who = _mm512_setzero_si512();  // each lane's group of eight, as a number
    const std::uint32_t* const list = neighbours.data();
    const std::size_t count = neighbours.size();
    for (std::size_t k = 0; k < count; k += 8) {
        // Places past the end repeat the particle itself, at rest to itself: it never collides.
        const eight::Records q =
            eight::load([&](std::size_t n) { return k + n < count ? particles + list[k + n] : &p; });
        const __m512d flight = _mm512_sub_pd(present, q.time);
        const __m512d vx = _mm512_sub_pd(q.velocity_x, pu);
        const __m512d vy = _mm512_sub_pd(q.velocity_y, pv);
        const __m512d vz = _mm512_sub_pd(q.velocity_z, pw);
        __m512d rx = _mm512_sub_pd(_mm512_add_pd(q.x, _mm512_mul_pd(q.velocity_x, flight)), px);
        __m512d ry = _mm512_sub_pd(_mm512_add_pd(q.y, _mm512_mul_pd(q.velocity_y, flight)), py);
        __m512d rz = _mm512_sub_pd(_mm512_add_pd(q.z, _mm512_mul_pd(q.velocity_z, flight)), pz);
        if constexpr (!Inside) {
            rx = eight::image(rx, x);
            ry = eight::image(ry, y);
            rz = eight::image(rz, z);
        }
        const __m512d r_dot_v = eight::dot(rx, ry, rz, vx, vy, vz);
        const __m512d gap = _mm512_sub_pd(eight::dot(rx, ry, rz, rx, ry, rz), one);
        const __m512d discriminant =
            _mm512_sub_pd(_mm512_mul_pd(r_dot_v, r_dot_v), _mm512_mul_pd(eight::dot(vx, vy, vz, vx, vy, vz), gap));
        const __mmask8 meets =
            _mm512_cmp_pd_mask(r_dot_v, zero, _CMP_LT_OQ) & _mm512_cmp_pd_mask(discriminant, zero, _CMP_GE_OQ);
        const __m512d root = _mm512_maskz_sqrt_pd(meets, discriminant);
        const __m512d delay = _mm512_max_pd(zero, _mm512_div_pd(gap, _mm512_sub_pd(root, r_dot_v)));
        const __mmask8 sooner = _mm512_mask_cmp_pd_mask(meets, delay, first, _CMP_LT_OQ);
        first = _mm512_mask_mov_pd(first, sooner, delay);
        who = _mm512_mask_mov_epi64(who, sooner, _mm512_set1_epi64(static_cast<long long>(k)));
    }
    const double soonest = _mm512_reduce_min_pd(first);
    if (soonest == never) return {never, 0};
    const auto lane = static_cast<std::size_t>(
        std::countr_zero(static_cast<unsigned>(_mm512_cmp_pd_mask(first, _mm512_set1_pd(soonest), _CMP_EQ_OQ))));
    alignas(64) long long groups[8];
    _mm512_store_si512(groups, who);
    return {soonest, list[static_cast<std::size_t>(groups[lane]) + lane]};
}

#endif

/// The first contact of particle p with one of its neighbours. inside: none is seen across a periodic boundary.
inline Contact nearest_contact(const Particle& p, double now, std::span<const std::uint32_t> neighbours,
                               const Particle* particles, const Periodic& x, const Periodic& y, const Periodic& z,
                               [[maybe_unused]] bool inside) {
#if defined(__AVX512F__)
    if (inside) return nearest_contact_eight<true>(p, now, neighbours, particles, x, y, z);
    return nearest_contact_eight<false>(p, now, neighbours, particles, x, y, z);
#elif defined(__AVX2__)
    if (inside) return nearest_contact_four<true>(p, now, neighbours, particles, x, y, z);
    return nearest_contact_four<false>(p, now, neighbours, particles, x, y, z);
#else
    return nearest_contact_plain(p, now, neighbours, particles, x, y, z);
#endif
}

}  // namespace shaken::md
