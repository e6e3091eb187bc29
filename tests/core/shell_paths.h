// SPDX-License-Identifier: GPL-3.0-or-later
// Materials and strain paths for tests of shell materials.
#pragma once

#include "core/material/johnson_cook.h"

#include <cmath>

namespace shell_paths {

using namespace birdstrike;

inline ShellMaterial elastic()
{
  ShellMaterial material;
  material.name = "test";
  material.density = 2700;
  material.young = 70e9;
  material.poisson = 0.33;
  return material;
}

inline ShellMaterial linear(double yield, double plastic_modulus)
{
  ShellMaterial material = elastic();
  material.hardening = LinearHardening{yield, plastic_modulus};
  return material;
}

//! Al 2024-T3.
inline ShellMaterial johnson_cook()
{
  ShellMaterial material = elastic();
  material.heat = {.specific_heat = 875, .share = 0.9, .room = 294, .melting = 775, .start = 294};
  set_strength(material, {.A = 369e6, .B = 684e6, .n = 0.73, .C = 0.0083, .m = 1.7});
  return material;
}

//! Total strains so far and work by the mean stress of each step.
struct Path
{
  ShellMaterial material;
  ShellPoint point{};
  double xx = 0, yy = 0, zz = 0, work = 0;

  void step(const ShellStrain& d, double dt = 0)
  {
    const ShellPoint before = point;
    zz += update(material, d, dt, point);
    xx += d.xx;
    yy += d.yy;
    work +=
        0.5 * ((before.xx + point.xx) * d.xx + (before.yy + point.yy) * d.yy + (before.xy + point.xy) * d.xy +
               (before.yz + point.yz) * d.yz + (before.zx + point.zx) * d.zx);
  }

  //! One step of uniaxial stress along x: the strain across is the one that leaves no stress there.
  void stretch(double d_xx, double dt = 0)
  {
    // yy rises with its strain: halve between bounds that enclose any flow.
    double low = -2 * std::abs(d_xx), high = 2 * std::abs(d_xx);
    const double residual = point.yy / material.young;
    low -= std::abs(residual);
    high += std::abs(residual);
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (low + high);
      ShellPoint trial = point;
      update(material, {d_xx, middle, 0, 0, 0}, dt, trial);
      (trial.yy < 0 ? low : high) = middle;
    }
    step({d_xx, 0.5 * (low + high), 0, 0, 0}, dt);
  }
};

//! q of a stress over the yield stress that the law asks for at the rate of the step.
inline double over_yield(const ShellMaterial& material, const ShellPoint& point, double softening_before)
{
  const double slow =
      std::visit([&](const auto& law) { return law.at(point.plastic_strain).stress; }, material.hardening);
  const double fast =
      std::visit([&](const auto& law) { return law.at(point.plastic_rate).factor; }, material.rate);
  return von_mises_stress(point) / (slow * fast * softening_before);
}

} // namespace shell_paths
