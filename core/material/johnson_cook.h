// SPDX-License-Identifier: BSD-3-Clause
// The strength law of Johnson and Cook, put together of its three factors.
#pragma once

#include "core/material/shell_material.h"

namespace birdstrike {

//! sigma = [A + B eps_p^n] [1 + C ln(rate/eps0)] [1 - T*^m]; factors and limits in power_hardening.h, rate_law.h and
//! plastic_heat.h. Source: G. R. Johnson, W. H. Cook, 7th Int. Symp. on Ballistics (1983) 541.
struct JohnsonCook
{
  double A, B, n;            //!< [Pa], [Pa], [-]
  double C = 0;              //!< 0: no effect of rate [-]
  double reference_rate = 1; //!< eps0 [1/s]
  double m = 0;              //!< 0: no effect of temperature [-]
};

//! Makes \p law the strength of the material. Room and melting temperature are those of material.heat.
inline void set_strength(ShellMaterial& material, const JohnsonCook& law)
{
  material.hardening = PowerHardening{law.A, law.B, law.n};
  if (law.C != 0)
    material.rate = LogarithmicRate{1 / law.C, law.reference_rate};
  else
    material.rate = NoRateEffect{};
  material.heat.exponent = law.m;
}

} // namespace birdstrike
