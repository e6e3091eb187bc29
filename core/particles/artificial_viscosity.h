// SPDX-License-Identifier: BSD-3-Clause
// Terms of artificial viscosity that belong to one particle. Those of pairs are in pair_kernels.cpp:
//   Q_ij = w_ij f_ij (-alpha c_ij mu_ij + beta mu_ij^2)
//   mu_ij = h_ij v_ij.x_ij / (r^2 + 0.01 h_ij^2) where the two approach, else 0
// with means over both particles; w = rho / x^2 is what the density becomes beside the weights V of sph_rates.h.
// Source: J. J. Monaghan, Annu. Rev. Astron. Astrophys. 30 (1992) 543.
#pragma once

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
//! thick as syrup. After D. S. Balsara, J. Comput. Phys. 121 (1995) 357, with the strain rate beside the
//! vorticity. \param g  velocity gradient, row-major [1/s]
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

} // namespace birdstrike
