// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "shell_paths.h"

#include <catch2/catch.hpp>

#include <random>

using namespace shell_paths;

namespace {

const TabulatedHardening table({0, 0.02, 0.1}, {300e6, 360e6, 420e6});

//! Every hardening law with every rate law.
std::vector<ShellMaterial> samples()
{
  std::vector<ShellMaterial> all;
  const Hardening hardenings[] = {NoYield{}, LinearHardening{300e6, 500e6}, LinearHardening{300e6, 0},
                                  PowerHardening{369e6, 684e6, 0.26}, table};
  const RateLaw rates[] = {NoRateEffect{}, CowperSymonds{40.4, 5}, LogarithmicRate{1 / 0.014, 1},
                           LogarithmicRate{1 / 0.1, 200}}; // a kink in the midst of the rates
  for (const Hardening& hardening : hardenings)
    for (const RateLaw& rate : rates)
      for (const bool heats : {false, true}) {
        ShellMaterial material = elastic();
        material.hardening = hardening;
        material.rate = rate;
        if (heats)
          material.heat = {.specific_heat = 900, .melting = 900, .exponent = 1.1};
        material.failure = JohnsonCookDamage{.D1 = 0.1, .D2 = 0.1, .D3 = -1.5, .D4 = 0.01, .D5 = 1};
        all.push_back(material);
      }
  return all;
}

} // namespace

TEST_CASE("an elastic point follows Hooke's law in plane stress", "[shell-material]")
{
  const ShellMaterial m = elastic();
  Path path{m};
  path.step({1e-3, -4e-4, 6e-4, 2e-4, -3e-4}, 1e-6);
  CHECK(path.point.xx == Approx(m.plane_modulus() * (1e-3 - 0.33 * 4e-4)));
  CHECK(path.point.yy == Approx(m.plane_modulus() * (0.33 * 1e-3 - 4e-4)));
  CHECK(path.point.xy == Approx(m.shear_modulus() * 6e-4));
  CHECK(path.point.yz == Approx(m.shear_modulus() * 2e-4));
  CHECK(path.point.zx == Approx(m.shear_modulus() * -3e-4));
  CHECK(path.zz == Approx(-0.33 / 0.67 * (1e-3 - 4e-4)));
  CHECK(path.point.plastic_strain == 0);
  CHECK(path.work == Approx(elastic_energy(m, path.point)).epsilon(1e-13));
  CHECK(von_mises_stress({.xx = 100, .yy = 100}) == Approx(100));
  CHECK(von_mises_stress({.xx = 100, .yy = -100}) == Approx(100 * std::sqrt(3)));
  CHECK(von_mises_stress({.yz = 100}) == Approx(100 * std::sqrt(3)));
}

TEST_CASE("uniaxial stress follows the bilinear curve through loading, unloading and reverse",
          "[shell-material]")
{
  const double E = 70e9, yield = 300e6, H = 2e9, tangent = E * H / (E + H);
  CHECK(plastic_modulus(E, tangent) == Approx(H));
  Path path{linear(yield, H)};
  const auto go_to = [&](double strain, int steps) {
    const double d = (strain - path.xx) / steps;
    for (int k = 0; k < steps; ++k)
      path.stretch(d);
  };
  go_to(0.02, 50);
  const double top = yield + tangent * (0.02 - yield / E);
  CHECK(path.point.xx == Approx(top).epsilon(1e-7));
  CHECK(std::abs(path.point.yy) < 1e-6 * top);
  CHECK(path.point.plastic_strain == Approx(0.02 - top / E).epsilon(1e-7));
  CHECK(path.point.yield == Approx(top).epsilon(1e-7));
  go_to(0.018, 4); // elastic
  CHECK(path.point.xx == Approx(top - E * 0.002).epsilon(1e-7));
  go_to(-0.01, 50); // isotropic: it yields at -top
  const double turn = 0.02 - 2 * top / E;
  CHECK(path.point.xx == Approx(-(top + tangent * (turn + 0.01))).epsilon(1e-7));
}

TEST_CASE("biaxial stress and pure shear follow their exact curves in one step or many", "[shell-material]")
{
  const double yield = 250e6, H = 1e9;
  const ShellMaterial m = linear(yield, H);
  const double E = m.young, G = m.shear_modulus();
  for (const int steps : {1, 7, 100}) {
    // xx = yy = s: q = s, d eps_p = 2 d eps - 2 (1 - nu) ds / E.
    Path both{m};
    for (int k = 0; k < steps; ++k)
      both.step({0.03 / steps, 0.03 / steps, 0, 0, 0});
    const double s = (yield + 2 * H * 0.03) / (1 + 2 * H * (1 - 0.33) / E);
    CHECK(both.point.xx == Approx(s).epsilon(1e-8));
    CHECK(both.point.yy == Approx(s).epsilon(1e-8));
    CHECK(both.point.plastic_strain == Approx((s - yield) / H).epsilon(1e-6));
    // gamma: q = sqrt3 tau, d eps_p = d gamma_p / sqrt3. In the plane or across it.
    for (const bool across : {false, true}) {
      Path shear{m};
      for (int k = 0; k < steps; ++k)
        shear.step({0, 0, across ? 0 : 0.05 / steps, across ? 0.03 / steps : 0, across ? 0.04 / steps : 0});
      const double root = std::sqrt(3.0), tau = (yield / root + H / 3 * 0.05) / (1 + H / (3 * G));
      const double found = across ? std::hypot(shear.point.yz, shear.point.zx) : shear.point.xy;
      CHECK(found == Approx(tau).epsilon(1e-8));
      CHECK(shear.zz == 0);
    }
  }
}

TEST_CASE("Johnson and Cook's curve at a fixed rate, cold", "[shell-material]")
{
  ShellMaterial m = johnson_cook();
  m.heat.specific_heat = 0; // isothermal
  const double rate = 500, dt = 2e-7;
  Path path{m};
  for (int k = 0; k < 2000; ++k) // to 20 % of strain
    path.stretch(rate * dt, dt);
  const double strain = path.point.plastic_strain, flow_rate = path.point.plastic_rate;
  CHECK(strain == Approx(0.2 - path.point.xx / m.young).epsilon(1e-9));
  CHECK(flow_rate == Approx(rate).epsilon(0.02)); // the rest is elastic, hardening over E
  CHECK(path.point.xx ==
        Approx((369e6 + 684e6 * std::pow(strain, 0.73)) * (1 + 0.0083 * std::log(flow_rate))).epsilon(1e-8));
}

TEST_CASE("heat of plastic work softens Johnson and Cook's metal", "[shell-material]")
{
  const ShellMaterial m = johnson_cook();
  const double dt = 1e-7;
  Path path{m};
  double softening = 1;
  for (int k = 0; k < 4000; ++k) {
    softening = path.point.softening;
    path.stretch(1000 * dt, dt);
  }
  const ShellPoint& p = path.point;
  CHECK(p.temperature_rise == Approx(0.9 * p.plastic_work / (2700 * 875)).epsilon(1e-12));
  CHECK(p.temperature_rise > 50);
  const double T = p.temperature_rise / (775 - 294);
  CHECK(p.softening == Approx(1 - std::pow(T, 1.7)).epsilon(1e-12));
  CHECK(p.xx == Approx((369e6 + 684e6 * std::pow(p.plastic_strain, 0.73)) *
                       (1 + 0.0083 * std::log(p.plastic_rate)) * softening)
                    .epsilon(1e-8));
  CHECK(m.heat.softening(1e6) == PlasticHeat::least_factor);
  CHECK(m.heat.softening(-50) == 1);
}

TEST_CASE("Cowper and Symonds double the yield stress of mild steel at 40.4/s", "[shell-material]")
{
  ShellMaterial m = linear(200e6, 0);
  m.rate = CowperSymonds{40.4, 5};
  const double dt = 1e-6;
  Path path{m};
  for (int k = 0; k < 3000; ++k)
    path.step({0, 0, std::sqrt(3.0) * 40.4 * dt, 0, 0}, dt);
  CHECK(path.point.plastic_rate == Approx(40.4).epsilon(1e-6));
  CHECK(von_mises_stress(path.point) == Approx(400e6).epsilon(1e-6));
  CHECK(path.point.yield == Approx(200e6));
  // Without a length of step nothing is fast.
  ShellPoint slow;
  update(m, {0, 0, 0.1, 0, 0}, 0, slow);
  CHECK(von_mises_stress(slow) == Approx(200e6).epsilon(1e-8));
}

TEST_CASE("the end of a plastic step is on the yield surface and plastic flow keeps the volume",
          "[shell-material]")
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const ShellMaterial& m : samples()) {
    INFO(m.describe());
    Path path{m};
    for (int k = 0; k < 2000; ++k) {
      const double size = std::pow(10, -5 + 1.5 * (1 + share(random))), dt = 1e-6;
      const ShellPoint before = path.point;
      const double zz = path.zz;
      const ShellStrain d{size * share(random), size * share(random), size * share(random),
                          size * share(random), size * share(random)};
      path.step(d, dt);
      const ShellPoint& p = path.point;
      const bool flowed = p.plastic_strain > before.plastic_strain;
      const double softening = before.yield > 0 ? before.softening : 1;
      const double over = over_yield(m, p, softening);
      CAPTURE(k, size, over);
      REQUIRE(over < 1 + 1e-8);
      if (flowed)
        REQUIRE(over > 1 - 1e-8);
      // Elastic strains by Hooke's law, the rest plastic; its trace is zero.
      const double E = m.young, nu = m.poisson, d_xx = p.xx - before.xx, d_yy = p.yy - before.yy;
      const double trace = (1 - 2 * nu) / E * (d_xx + d_yy);
      REQUIRE(d.xx + d.yy + (path.zz - zz) - trace ==
              Approx(0).margin(1e-12 * size + 1e-9 * std::abs(trace)));
      // Flow is along the normal at the end.
      if (flowed && size > 1e-3) {
        const double d_eps = p.plastic_strain - before.plastic_strain, q = von_mises_stress(p);
        REQUIRE(d.xx - (d_xx - nu * d_yy) / E == Approx(d_eps / q * (p.xx - 0.5 * p.yy)).margin(1e-8 * size));
        REQUIRE(d.zx - (p.zx - before.zx) / m.shear_modulus() ==
                Approx(3 * d_eps / q * p.zx).margin(1e-8 * size));
      }
    }
    CHECK(path.work == Approx(elastic_energy(m, path.point) + path.point.plastic_work).epsilon(1e-8));
    if (!std::holds_alternative<NoYield>(m.hardening)) {
      CHECK(path.point.plastic_strain > 0.2);
      CHECK(path.point.damage > 0.2);
    }
  }
}

TEST_CASE("steps of any size end finite and admissible", "[shell-material]")
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(-1, 1), decade(-30, 90);
  for (const ShellMaterial& m : samples()) {
    INFO(m.describe());
    ShellPoint p;
    for (int k = 0; k < 3000; ++k) {
      if (k % 10 == 0)
        p = {};
      const double size = std::pow(10, decade(random)),
                   dt = k % 7 == 0 ? 0 : std::pow(10, -9 + 3 * share(random));
      CAPTURE(k, size, dt);
      const double softening = p.yield > 0 ? p.softening : 1, strain = p.plastic_strain;
      const double thickness = update(
          m, {size * share(random), size * share(random), size * share(random), size * share(random), 0}, dt,
          p);
      for (const double value :
           {p.xx, p.yy, p.xy, p.yz, p.zx, p.plastic_strain, p.plastic_work, p.temperature_rise, thickness})
        REQUIRE(std::isfinite(value));
      REQUIRE(p.damage >= 0);
      REQUIRE(p.plastic_strain >= strain);
      if (p.plastic_strain > strain)
        REQUIRE(over_yield(m, p, softening) < 1 + 1e-7);
    }
  }
}

TEST_CASE("halving the steps halves the error of a curved path", "[shell-material]")
{
  const ShellMaterial m = johnson_cook();
  const auto end = [&](int steps) {
    Path path{m};
    double t = 0;
    for (int k = 0; k < steps; ++k) { // strain turns from stretch to shear within 0.1 ms
      const double from = t, to = t + 1.0 / steps;
      path.step({0.05 * (std::sin(1.5 * to) - std::sin(1.5 * from)), 0.02 * (to - from),
                 0.08 * (std::cos(1.5 * from) - std::cos(1.5 * to)), 0.01 * (to * to - from * from), 0},
                1e-4 / steps);
      t = to;
    }
    return path;
  };
  const Path fine = end(20000);
  double last = 0;
  for (const int steps : {100, 200, 400, 800}) {
    const Path coarse = end(steps);
    const double error = std::hypot(coarse.point.xx - fine.point.xx, coarse.point.yy - fine.point.yy,
                                    coarse.point.xy - fine.point.xy);
    CAPTURE(steps, error);
    if (last > 0)
      CHECK(last / error == Approx(2).epsilon(0.15));
    else
      CHECK(error < 5e6);
    last = error;
    CHECK(coarse.work == Approx(elastic_energy(m, coarse.point) + coarse.point.plastic_work).epsilon(1e-8));
  }
}

TEST_CASE("uniaxial tension breaks at Johnson and Cook's strain for a triaxiality of one third",
          "[shell-material]")
{
  ShellMaterial m = linear(300e6, 400e6);
  m.failure = JohnsonCookDamage{.D1 = 0.112, .D2 = 0.123, .D3 = -1.5};
  const double limit = 0.112 + 0.123 * std::exp(-0.5);
  Path path{m};
  while (!has_failed(path.point) && path.xx < 1)
    path.stretch(1e-4);
  CHECK(path.point.plastic_strain == Approx(limit).margin(1e-4));
  // and compression does not, beyond the cut-off
  Path squeezed{m};
  for (int k = 0; k < 3000; ++k)
    squeezed.step({-1e-4, -1e-4, 0, 0, 0});
  CHECK(squeezed.point.plastic_strain > 2 * limit);
  CHECK(squeezed.point.damage == 0);
}

TEST_CASE("a material that cannot be is refused by name and quantity", "[shell-material][errors]")
{
  const auto message = [](const ShellMaterial& m) -> std::string {
    try {
      m.check();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  for (const ShellMaterial& m : samples())
    CHECK(message(m).empty());
  ShellMaterial m = elastic();
  m.poisson = 0.5;
  CHECK(message(m) == "material test: Poisson's ratio is 0.5 and must be above -1 and below 0.5");
  m = elastic();
  m.density = -1;
  CHECK(message(m) == "material test: the density must be positive");
  m = elastic();
  m.young = NAN;
  CHECK(message(m) == "material test: Young's modulus must be positive");
  m = linear(0, 0);
  CHECK(message(m) == "material test: linear hardening: the yield stress must be positive");
  m = johnson_cook();
  m.heat.melting = 0;
  CHECK(message(m) == "material test: heat: softening needs the melting temperature");
}
