// SPDX-License-Identifier: BSD-3-Clause
#include "core/material/shell_material.h"

namespace birdstrike {

double update(const ShellMaterial& m, const ShellStrain& e, double, ShellPoint& p)
{
  const double plane = m.plane_modulus(), g = m.shear_modulus();
  p.xx += plane * (e.xx + m.poisson * e.yy);
  p.yy += plane * (e.yy + m.poisson * e.xx);
  p.xy += g * e.xy;
  p.yz += g * e.yz;
  p.zx += g * e.zx;
  return -m.poisson / (1 - m.poisson) * (e.xx + e.yy);
}

bool can_fail(const ShellMaterial&) { return false; }

} // namespace birdstrike
