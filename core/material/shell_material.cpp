// SPDX-License-Identifier: BSD-3-Clause
// Return to the yield surface in plane stress.
#include "core/material/shell_material.h"

#include "core/error.h"
#include "core/format_text.h"

#include <algorithm>
#include <cmath>

namespace birdstrike {
namespace {

constexpr double tolerance = 2e-9; // of q over the yield stress
constexpr int most_iterations = 200;

//! Stress by sum and difference: xx = a + b, yy = a - b, so that q^2 = a^2 + 3 (b^2 + xy^2 + yz^2 + zx^2).
struct Split
{
  double a, b, xy, yz, zx;

  double shears_2() const { return 3 * (b * b + xy * xy + yz * yz + zx * zx); }
};

Split split(const ShellPoint& p) { return {0.5 * (p.xx + p.yy), 0.5 * (p.xx - p.yy), p.xy, p.yz, p.zx}; }

void set_stress(const Split& stress, ShellPoint& point)
{
  point.xx = stress.a + stress.b;
  point.yy = stress.a - stress.b;
  point.xy = stress.xy;
  point.yz = stress.yz;
  point.zx = stress.zx;
}

//! Moduli of the sum and of the shears over lambda [Pa].
struct Moduli
{
  double sum, shear;
};

//! The stress after flow by lambda.
struct Returned
{
  double sum_factor, shear_factor; //!< on the trial stress
  double q, inverse_q;             //!< [Pa], [1/Pa]
  double plastic_strain;           //!< lambda q [-]
};

Returned returned(double lambda, const Moduli& k, double a_2, double shears_2)
{
  const double sums = 1 + k.sum * lambda, shears = 1 + k.shear * lambda;
  const double both = 1 / (sums * shears), s = both * shears, t = both * sums; // one division
  const double q_2 = a_2 * s * s + shears_2 * t * t, inverse_q = 1 / std::sqrt(q_2), q = q_2 * inverse_q;
  return {s, t, q, inverse_q, lambda * q};
}

//! Lambda of the end state, and it.
//! \param hardens    a law with at()  \param hastens  likewise
//! \param inverse_dt 1/dt, or 0 for none
template <class HardeningLaw, class Rate>
std::pair<double, Returned> flow(const HardeningLaw& hardens, const Rate& hastens, const ShellPoint& point,
                                 const Moduli& k, double a_2, double shears_2, double inverse_dt,
                                 double& slow_yield)
{
  const double trial = std::sqrt(a_2 + shears_2), excess = trial / point.yield - 1;
  // At the upper bound q is at most the slow yield stress of the begin, which the end's cannot fall below.
  double low = 0, high = excess / std::min(k.sum, k.shear);
  double lambda = excess / k.shear;
  if (inverse_dt > 0 && point.plastic_rate > 0) { // about as fast as in the step before
    const double guess = point.plastic_rate / inverse_dt;
    lambda = guess / (trial - k.shear * guess);
  }
  if (!(lambda > 0 && lambda < high))
    lambda = high;

  for (int i = 0; i < most_iterations; ++i) {
    const Returned at = returned(lambda, k, a_2, shears_2);
    const YieldPoint slow = hardens.at(point.plastic_strain + at.plastic_strain);
    const RateFactor fast = hastens.at(at.plastic_strain * inverse_dt);
    slow_yield = slow.stress * point.softening;
    const double yield = slow_yield * fast.factor, value = yield * at.inverse_q - 1;
    if (std::abs(value) < tolerance)
      return {lambda, at};
    (value < 0 ? low : high) = lambda;
    // q' / q = -[a^2 K s + shears^2 3G t] / q^2, both stresses those of the end.
    const double s = at.sum_factor, t = at.shear_factor;
    const double fall =
        (a_2 * k.sum * s * s * s + shears_2 * k.shear * t * t * t) * at.inverse_q * at.inverse_q;
    const double yield_over_strain =
        slow.slope * point.softening * fast.factor + slow_yield * fast.slope * inverse_dt;
    // d(plastic strain) / d(lambda) is q (1 - lambda fall).
    const double slope = yield_over_strain * (1 - lambda * fall) + yield * at.inverse_q * fall;
    const double next = lambda - value / slope;
    if (!(next > low && next < high)) { // the bounds can be many decades apart
      lambda = low > 0 ? std::sqrt(low) * std::sqrt(high) : 0.01 * high;
      continue;
    }
    // What is left after this step, by its second order: x^2 f'' is at most x f' for powers and logarithms, and that of
    // 1/q at most (3G lambda)^2.
    const double share = next / lambda - 1, turn = std::min(k.shear * lambda, 1.0);
    const double left =
        0.5 * share * share * (yield_over_strain * at.plastic_strain * at.inverse_q + turn * turn);
    lambda = next;
    if (left < tolerance) {
      const Returned end = returned(lambda, k, a_2, shears_2);
      slow_yield += slow.slope * point.softening * (end.plastic_strain - at.plastic_strain);
      return {lambda, end};
    }
  }
  const Returned inside = returned(high, k, a_2, shears_2);
  slow_yield = hardens.at(point.plastic_strain + inside.plastic_strain).stress * point.softening;
  return {high, inside};
}

//! What is left of update() when the trial stress is outside of the surface, or the surface is not known yet.
//! \param before, trial  stress before and after an elastic step
//! \return plastic strain of xx + yy
[[gnu::noinline]] double plastic_step(const ShellMaterial& material, const Split& before, const Split& trial,
                                      double dt, ShellPoint& point)
{
  const double a_2 = trial.a * trial.a, shears_2 = trial.shears_2();
  if (point.yield == 0) {
    point.softening = material.heat.softening(point.temperature_rise);
    point.yield =
        point.softening *
        std::visit([&](const auto& law) { return law.at(point.plastic_strain).stress; }, material.hardening);
  }
  if (!(a_2 + shears_2 > point.yield * point.yield)) {
    set_stress(trial, point);
    return 0;
  }
  const Moduli k{0.5 * material.young / (1 - material.poisson), 3 * material.shear_modulus()};
  const double inverse_dt = dt > 0 ? 1 / dt : 0;
  double slow_yield = point.yield;
  const auto [lambda, end] = std::visit(
      [&](const auto& hardens, const auto& hastens) {
        return flow(hardens, hastens, point, k, a_2, shears_2, inverse_dt, slow_yield);
      },
      material.hardening, material.rate);

  const double s = end.sum_factor, t = end.shear_factor;
  const Split after{trial.a * s, trial.b * t, trial.xy * t, trial.yz * t, trial.zx * t};
  set_stress(after, point);
  point.plastic_strain += end.plastic_strain;
  point.plastic_rate = end.plastic_strain * inverse_dt;
  // Plastic strains over the step: lambda a of xx + yy, 3 lambda b of xx - yy, 3 lambda tau of each gamma.
  const double begin_work = before.a * after.a + 3 * (before.b * after.b + before.xy * after.xy +
                                                      before.yz * after.yz + before.zx * after.zx);
  point.plastic_work += 0.5 * lambda * (end.q * end.q + begin_work);

  if (material.heat.specific_heat > 0) {
    point.temperature_rise = material.heat.rise(point.plastic_work, material.density);
    const double softening = material.heat.softening(point.temperature_rise);
    slow_yield *= softening / point.softening;
    point.softening = softening;
  }
  point.yield = slow_yield;
  if (!std::holds_alternative<NoFailure>(material.failure)) {
    const FlowState state{2.0 / 3 * after.a / end.q, point.plastic_rate,
                          material.heat.homologous(point.temperature_rise)};
    point.damage +=
        end.plastic_strain / std::visit([&](const auto& law) { return law.strain(state); }, material.failure);
  }
  return lambda * after.a;
}

} // namespace

double update(const ShellMaterial& material, const ShellStrain& strain, double dt, ShellPoint& point)
{
  const double G = material.shear_modulus(), K = 0.5 * material.young / (1 - material.poisson);
  const Split before = split(point);
  const Split trial{before.a + K * (strain.xx + strain.yy), before.b + G * (strain.xx - strain.yy),
                    before.xy + G * strain.xy, before.yz + G * strain.yz, before.zx + G * strain.zx};
  double plastic = 0, sum = trial.a;
  if (!(trial.a * trial.a + trial.shears_2() > point.yield * point.yield)) {
    set_stress(trial, point);
  } else {
    plastic = plastic_step(material, before, trial, dt, point);
    sum = 0.5 * (point.xx + point.yy);
  }
  return -2 * material.poisson / material.young * (sum - before.a) - plastic;
}

double von_mises_stress(const ShellPoint& point)
{
  const Split stress = split(point);
  return std::sqrt(stress.a * stress.a + stress.shears_2());
}

double elastic_energy(const ShellMaterial& material, const ShellPoint& p)
{
  return 0.5 * ((p.xx * p.xx + p.yy * p.yy - 2 * material.poisson * p.xx * p.yy) / material.young +
                (p.xy * p.xy + p.yz * p.yz + p.zx * p.zx) / material.shear_modulus());
}

void ShellMaterial::check() const
{
  const auto fail = [&](const std::string& problem) {
    throw InputError("material " + name + ": " + problem);
  };
  if (!(std::isfinite(density) && density > 0))
    fail("the density must be positive");
  if (!(std::isfinite(young) && young > 0))
    fail("Young's modulus must be positive");
  if (!(poisson > -1 && poisson < 0.5))
    fail(format_text("Poisson's ratio is %.6g and must be above -1 and below 0.5", poisson));
  try {
    std::visit([](const auto& law) { law.check(); }, hardening);
    std::visit([](const auto& law) { law.check(); }, rate);
    heat.check();
    std::visit([](const auto& law) { law.check(); }, failure);
  } catch (const InputError& error) {
    fail(error.what());
  }
}

std::string ShellMaterial::describe() const
{
  const auto words = [](const auto& law) { return law.describe(); };
  std::string text = format_text("%s: density %.6g kg/m3, E %.6g GPa, nu %.4g; ", name.c_str(), density,
                                 young / 1e9, poisson);
  text += std::visit(words, hardening);
  if (!std::holds_alternative<NoYield>(hardening)) {
    text += "; " + std::visit(words, rate);
    if (heat.exponent > 0)
      text += format_text("; softens with T*^%.4g between %.6g and %.6g K", heat.exponent, heat.room,
                          heat.melting);
    text += "; " + std::visit(words, failure);
  }
  return text;
}

} // namespace birdstrike
