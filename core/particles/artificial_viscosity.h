// SPDX-License-Identifier: BSD-3-Clause
// Artificial viscosity: the terms that belong to one particle, and what the pair loops (pair_kernels.cpp) do with them.
//
// Pairs get a stress Q_ij beside p / x^2 (sph_rates.h). With d = x_i - x_j, r = |d|, w = rho / x^2 (what the density
// becomes beside the weights V) and means c, h over both:
//
// "pairwise", "switched" (J. J. Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543):
//   Q = w f (-alpha c mu + beta mu^2),  mu = h v_ij.d / (r^2 + 0.01 h^2) where the two approach, else 0
//   f = 1, or shear_switch() below, with means of w and f.
//
// "limited":
//   Q = W U (alpha c + beta U),  U = max(0, -(v_ij.d - R_ij) / r),  W = 2 w_i w_j / (w_i + w_j)
// U is the jump in velocity along the line that is left when each side's velocity is carried to the middle by its own
// gradient G; R_ij = (1 - f) limiter(d.G_i d, d.G_j d), with the harmonic mean for a limiter (B. van Leer, J. Comput.
// Phys. 32 (1979) 101; for SPH: N. Frontiere, C. D. Raskin, J. M. Owen, J. Comput. Phys. 332 (2017) 160). A smooth flow
// has U = O(r^3), so the jet before the plate, which shears, stays thin, while disorder from particle to particle,
// which a gradient does not see, is damped in full. In a plane compression f = plane_compression() = 1 and nothing is
// carried: a front then has the whole jump, without which the particles behind it ring. U is bounded by the raw
// approach speed, so Q heats and never cools. The harmonic W is that of an acoustic Riemann problem and bounds what
// dense matter does to thin matter. U in place of Monaghan's mu keeps close pairs from a push h / r times too strong,
// which is what makes the first layers on a plate overshoot.
#pragma once

#include <algorithm>
#include <array>

namespace birdstrike {

//! Shock pressure q of 5.58 [Pa]; none in expansion.
//! \param divergence  div v [1/s]
//! \param length      characteristic length, cube root of the volume [m]
inline double bulk_viscosity(double density, double sound_speed, double divergence, double length,
                             double linear, double quadratic)
{
  if (divergence >= 0)
    return 0;
  const double rate = -divergence * length;
  return density * rate * (quadratic * rate + linear * sound_speed);
}

//! f = D^2 / (D^2 + S:S/2 + |w|^2/2) with D = div v, S the trace-free strain rate, w the vorticity: near 1
//! where the flow compresses, near 0 where it shears or turns. Undiminished pair viscosity makes a jet as
//! thick as syrup. After D. S. Balsara, J. Comput. Phys. 121 (1995) 357, with the strain rate beside the vorticity.
//! \param g  velocity gradient, row-major [1/s]
inline double shear_switch(const std::array<double, 9>& g)
{
  const double divergence = g[0] + g[4] + g[8], third = divergence / 3;
  const double sxx = g[0] - third, syy = g[4] - third, szz = g[8] - third;
  const double sxy = 0.5 * (g[1] + g[3]), sxz = 0.5 * (g[2] + g[6]), syz = 0.5 * (g[5] + g[7]);
  const double strain = sxx * sxx + syy * syy + szz * szz + 2 * (sxy * sxy + sxz * sxz + syz * syz);
  const double wx = g[7] - g[5], wy = g[2] - g[6], wz = g[3] - g[1];
  const double vorticity = wx * wx + wy * wy + wz * wz;
  const double d2 = divergence * divergence, all = d2 + 0.5 * strain + 0.5 * vorticity;
  return all > 0 ? d2 / all : 1;
}

//! The same, scaled so that it is 1 in a plane compression, whose own strain rate gives S:S/2 = D^2/3.
inline double plane_compression(const std::array<double, 9>& g)
{
  return std::min(1.0, 4.0 / 3.0 * shear_switch(g));
}

} // namespace birdstrike
