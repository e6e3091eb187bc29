// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of shells against what must hold whatever their mesh: patch tests, rigid motion, conservation, stability,
// frequencies, supports, spin, thickness, erosion, bad input.
#include "core/error.h"
#include "core/shells/belytschko_tsay.h"
#include "core/shells/c0_triangle.h"
#include "core/shells/shells.h"

#include "tests/core/element_samples.h"
#include "tests/core/shell_samples.h"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <omp.h>

#include <limits>
#include <numbers>

using namespace birdstrike;
using namespace birdstrike::samples;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 70e9, nu = 0.3, rho = 2700;

//! A flat square whose inner nodes are anywhere.
ShellMesh distorted_square(int n, bool triangles)
{
  Numbers next(7);
  return patch(
      n, n,
      [&](double u, double v) {
        const bool inside = u > 0 && u < 1 && v > 0 && v < 1;
        const double a = 0.3 / n * next(), b = 0.3 / n * next();
        return inside ? Vector3(u + a, v + b, 0) : Vector3(u, v, 0);
      },
      triangles);
}

//! A panel that is curved and twisted: its quads are warped.
ShellMesh twisted_panel(int n, bool triangles = false)
{
  return patch(
      n, n,
      [](double u, double v) {
        return Vector3(u, 0.8 * v + 0.1 * u * v, 0.3 * u * u - 0.2 * v * v + 0.4 * u * v);
      },
      triangles);
}

void give(Shells& shells, const std::function<Vector3(const Vector3&)>& velocity,
          const std::function<Vector3(const Vector3&)>& spin)
{
  for (std::size_t n = 0; n < shells.position.size(); ++n) {
    shells.velocity[n] = velocity(shells.position[n]);
    shells.spin[n] = spin(shells.position[n]);
  }
}

//! Stress of a point of an element in the axes of space.
Eigen::Matrix3d stress_in_space(const Shells& s, std::size_t element, std::size_t point)
{
  std::array<Vector3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
    corners[k] = s.position[static_cast<std::size_t>(s.mesh().elements[element][k])];
  const bool triangle = is_triangle(s.mesh().elements[element]);
  const Eigen::Matrix3d axes = (triangle ? triangle_geometry(corners) : quad_geometry(corners)).axes;
  const ShellPoint& p = s.points[s.first_point(element) + point];
  Eigen::Matrix3d local;
  local << p.xx, p.xy, p.zx, p.xy, p.yy, p.yz, p.zx, p.yz, 0;
  return axes * local * axes.transpose();
}

double largest_stress(const Shells& s)
{
  double most = 0;
  for (const ShellPoint& p : s.points)
    for (const double value : {p.xx, p.yy, p.xy, p.yz, p.zx})
      most = std::max(most, std::abs(value));
  return most;
}

Vector3 angular_momentum(const Shells& s)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t n = 0; n < s.position.size(); ++n)
    sum += s.mass()[n] * s.position[n].cross(s.velocity[n]) + s.inertia()[n] * s.spin[n];
  return sum;
}

bool is_inner(const Shells& s, std::size_t n)
{
  for (const auto& [name, nodes] : s.mesh().node_sets)
    for (const std::int32_t node : nodes)
      if (static_cast<std::size_t>(node) == n)
        return false;
  return true;
}

} // namespace

TEST_CASE("Patch tests: a linear field leaves inner nodes in balance and the stress uniform", "[shells]")
{
  const double rate = 1e-9; // so that the change of geometry is below rounding
  for (const bool triangles : {false, true}) {
    CAPTURE(triangles);
    SECTION("membrane")
    {
      Shells s(distorted_square(4, triangles), {{elastic(E, nu, rho), 0.05, 3}});
      give(
          s,
          [&](const Vector3& p) {
            return Vector3(rate * (p[0] + 0.5 * p[1]), rate * (0.25 * p[0] - 2 * p[1]), 0);
          },
          [&](const Vector3&) { return Vector3(0, 0, rate * 0.5 * (0.25 - 0.5)); });
      s.drift(1);
      s.evaluate(1, 1);
      const double plane = E / (1 - nu * nu) * rate;
      for (std::size_t e = 0; e < s.mesh().elements.size(); ++e)
        for (std::size_t k = 0; k < 3; ++k) {
          const Eigen::Matrix3d stress = stress_in_space(s, e, k);
          CHECK(stress(0, 0) == Approx(plane * (1 - 2 * nu)).epsilon(1e-8));
          CHECK(stress(1, 1) == Approx(plane * (-2 + nu)).epsilon(1e-8));
          CHECK(stress(0, 1) == Approx(E / (2 * (1 + nu)) * rate * 0.75).epsilon(1e-8));
        }
      for (std::size_t n = 0; n < s.position.size(); ++n)
        if (is_inner(s, n))
          CHECK(s.force()[n].norm() < 1e-8 * plane * 0.05 * 0.25);
    }
    SECTION("transverse shear")
    {
      Shells s(distorted_square(4, triangles), {{elastic(E, nu, rho), 0.05, 3}});
      give(
          s, [&](const Vector3& p) { return Vector3(0, 0, rate * (2 * p[0] - p[1])); },
          [&](const Vector3&) { return Vector3(0, 0, 0); });
      s.drift(1);
      s.evaluate(1, 1);
      const double shear = E / (2 * (1 + nu)) * rate;
      for (std::size_t e = 0; e < s.mesh().elements.size(); ++e) {
        CHECK(stress_in_space(s, e, 1)(0, 2) == Approx(2 * shear).epsilon(1e-8));
        CHECK(stress_in_space(s, e, 1)(1, 2) == Approx(-shear).epsilon(1e-8));
      }
      for (std::size_t n = 0; n < s.position.size(); ++n)
        if (is_inner(s, n))
          CHECK(s.force()[n].norm() < 1e-8 * shear * 0.05 * 0.25);
    }
    SECTION("bending and twist")
    {
      // Without shear the triangles are exact on any mesh; the one-point quadrilateral is only on parallelograms.
      Shells s(triangles ? distorted_square(4, true)
                         : patch(4, 4, [](double u, double v) { return Vector3(u + 0.3 * v, v, 0); }),
               {{elastic(E, nu, rho), 0.05, 3}});
      const double kx = 1, ky = -0.5, kxy = 0.7;
      give(
          s,
          [&](const Vector3& p) {
            return Vector3(0, 0, 0.5 * rate * (kx * p[0] * p[0] + ky * p[1] * p[1] + kxy * p[0] * p[1]));
          },
          [&](const Vector3& p) {
            return Vector3(rate * (ky * p[1] + 0.5 * kxy * p[0]), -rate * (kx * p[0] + 0.5 * kxy * p[1]), 0);
          });
      s.drift(1);
      s.evaluate(1, 1);
      const double z = 0.5 * 0.05 * std::sqrt(0.6), plane = E / (1 - nu * nu) * rate;
      for (std::size_t e = 0; e < s.mesh().elements.size(); ++e) {
        const Eigen::Matrix3d outer = stress_in_space(s, e, 2), inner = stress_in_space(s, e, 0);
        CHECK(outer(0, 0) == Approx(-z * plane * (kx + nu * ky)).epsilon(1e-7));
        CHECK(outer(1, 1) == Approx(-z * plane * (ky + nu * kx)).epsilon(1e-7));
        CHECK(outer(0, 1) == Approx(-z * E / (2 * (1 + nu)) * rate * kxy).epsilon(1e-7));
        CHECK((outer + inner).norm() < 1e-6 * plane * z);
        CHECK(std::abs(outer(0, 2)) < 1e-6 * plane * z);
      }
      s.velocity.assign(s.velocity.size(), Vector3::Zero());
      s.spin = s.velocity;
      s.kick(1); // moments are seen in what they do to the spin
      const double moment = plane * 0.05 * 0.05 * 0.05 / 12 * 0.25;
      for (std::size_t n = 0; n < s.position.size(); ++n)
        if (is_inner(s, n)) {
          CHECK(s.force()[n].norm() < 1e-7 * plane * 0.05 * 0.05);
          CHECK(s.spin[n].norm() * s.inertia()[n] < 1e-7 * moment);
        }
    }
  }
}

TEST_CASE("Three turns and a long way without stress", "[shells]")
{
  for (const bool triangles : {false, true}) {
    Shells s(twisted_panel(3, triangles), {{elastic(E, nu, rho), 0.02, 2}});
    const std::vector<Vector3> start = s.position;
    const Vector3 axis = Vector3(1, -2, 0.5).normalized(), centre(0.3, 2, -1), way(40, -3, 7);
    const int steps = 6000;
    const double dt = 1e-6, angle = 6 * pi / steps;
    const auto at = [&](std::size_t n, int step) -> Vector3 {
      return centre + Eigen::AngleAxisd(step * angle, axis) * (start[n] - centre) +
             double(step) / steps * way;
    };
    for (int step = 0; step < steps; ++step) {
      for (std::size_t n = 0; n < start.size(); ++n) {
        s.velocity[n] = (at(n, step + 1) - s.position[n]) / dt;
        s.spin[n] = 2 * std::tan(0.5 * angle) / dt * axis; // of the chords
      }
      s.drift(dt);
      s.evaluate(dt, step * dt);
    }
    CHECK(largest_stress(s) < 1e-10 * E);
    CHECK(std::abs(s.energy().internal) + std::abs(s.energy().hourglass) < 1e-12);
  }
}

TEST_CASE("A stressed body that turns takes its stress along", "[shells]")
{
  for (const bool triangles : {false, true}) {
    Shells s(twisted_panel(2, triangles), {{elastic(E, nu, rho), 0.02, 2}});
    give(
        s, [](const Vector3& p) { return Vector3(1e-4 * p[0], -2e-4 * p[1], 5e-5 * p[0]); },
        [](const Vector3&) { return Vector3(0, 0, 0); });
    s.drift(1);
    s.evaluate(1, 0);
    std::vector<Eigen::Matrix3d> before;
    for (std::size_t e = 0; e < s.mesh().elements.size(); ++e)
      before.push_back(stress_in_space(s, e, 1));
    const double energy = s.energy().internal;
    const std::vector<Vector3> start = s.position;
    const Vector3 axis = Vector3(1, -2, 0.5).normalized();
    const int steps = 2000;
    const double angle = 1.9 / steps, dt = 1e-6;
    for (int step = 0; step < steps; ++step) {
      for (std::size_t n = 0; n < start.size(); ++n) {
        s.velocity[n] = (Eigen::AngleAxisd((step + 1) * angle, axis) * start[n] - s.position[n]) / dt;
        s.spin[n] = 2 * std::tan(0.5 * angle) / dt * axis;
      }
      s.drift(dt);
      s.evaluate(dt, 0);
    }
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.9, axis).toRotationMatrix();
    for (std::size_t e = 0; e < before.size(); ++e)
      CHECK((stress_in_space(s, e, 1) - turn * before[e] * turn.transpose()).norm() <
            1e-9 * before[e].norm());
    CHECK(s.energy().internal == Approx(energy).epsilon(1e-9));
  }
}

TEST_CASE("Simple shear follows the exact solution of the Jaumann rate", "[shells]")
{
  // tau = G sin(gamma), xx = -yy = G (1 - cos(gamma)) whichever side the element's axes follow.
  for (const int first : {0, 1, 2, 3})
    for (const bool triangles : {false, true}) {
      ShellMesh mesh = patch(
          1, 1, [](double u, double v) { return Vector3(u, v, 0); }, triangles);
      if (!triangles)
        std::rotate(mesh.elements[0].begin(), mesh.elements[0].begin() + first, mesh.elements[0].end());
      Shells s(mesh, {{elastic(E, nu, rho), 0.02, 2}});
      const int steps = 2000;
      const double gamma = 1.5, dt = 1e-6, rate = gamma / steps / dt;
      for (int step = 0; step < steps; ++step) {
        give(
            s, [&](const Vector3& p) { return Vector3(rate * p[1], 0, 0); },
            [&](const Vector3&) { return Vector3(0, 0, -0.5 * rate); });
        s.drift(dt);
        s.evaluate(dt, 0);
      }
      const double G = E / (2 * (1 + nu));
      for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Eigen::Matrix3d stress = stress_in_space(s, e, 0);
        CHECK(stress(0, 1) == Approx(G * std::sin(gamma)).epsilon(1e-6));
        CHECK(stress(0, 0) == Approx(G * (1 - std::cos(gamma))).epsilon(1e-6));
        CHECK(stress(1, 1) == Approx(-G * (1 - std::cos(gamma))).epsilon(1e-6));
      }
    }
}

TEST_CASE("A free structure keeps momentum and angular momentum, warped or not", "[shells]")
{
  for (const bool triangles : {false, true})
    for (const bool warping : {false, true}) {
      CAPTURE(triangles, warping);
      ShellSettings settings;
      settings.warping = warping;
      Shells s(twisted_panel(4, triangles), {{elastic(E, nu, rho), 0.02, 2}}, {}, {}, settings);
      Numbers next(3);
      give(
          s, [&](const Vector3&) { return Vector3(20 * next.vector()); },
          [&](const Vector3&) { return Vector3(50 * next.vector()); });
      const Vector3 p = s.momentum(), l = angular_momentum(s);
      run(s, 500 * s.stable_step());
      CHECK(largest_stress(s) > 1e-3 * E); // it was no gentle ride
      CHECK((s.momentum() - p).norm() < 1e-12 * p.norm());
      CHECK((angular_momentum(s) - l).norm() < 1e-10 * l.norm());
    }
}

TEST_CASE("Energy balance closes as the step shrinks", "[shells]")
{
  for (const bool triangles : {false, true}) {
    std::vector<double> errors;
    for (const double share : {1.0, 0.5, 0.25}) {
      ShellLoads loads;
      loads.surfaces.push_back({2e6});
      ShellSettings settings;
      settings.damping = 100;
      settings.stiff_damping = 1e-7;
      ShellMesh mesh = twisted_panel(6, triangles);
      Shells s(mesh, {{elastic(E, nu, rho), 0.02, 3}}, {clamped(nodes_of(mesh, {"u0"}))}, loads, settings);
      double worst = 0, most = 0;
      run(
          s, 0.004,
          [&](double) {
            const ShellEnergy e = s.energy();
            worst = std::max(worst, std::abs(e.total() - e.external));
            most = std::max(most, e.total());
          },
          share);
      errors.push_back(worst / most);
    }
    CAPTURE(triangles, errors);
    CHECK(errors[0] < 0.005);
    CHECK(errors[1] < 0.55 * errors[0]);
    CHECK(errors[2] < 0.55 * errors[1]);
  }
}

namespace {

//! Highest frequency of the assembled structure [1/s], from the force of each motion in turn.
double highest_frequency(const Shells& fresh)
{
  const Eigen::Index nodes = static_cast<Eigen::Index>(fresh.position.size()), n = 6 * nodes;
  Eigen::MatrixXd k(n, n);
  const double dt = 1e-9;
  const auto weight = [&](Eigen::Index row) {
    const auto node = static_cast<std::size_t>(row / 6);
    return std::sqrt(row % 6 < 3 ? fresh.mass()[node] : fresh.inertia()[node]);
  };
  for (Eigen::Index column = 0; column < n; ++column) {
    Shells s = fresh;
    const auto node = static_cast<std::size_t>(column / 6);
    (column % 6 < 3 ? s.velocity[node][column % 6] : s.spin[node][column % 6 - 3]) = 1;
    s.drift(dt);
    s.evaluate(dt, 0);
    s.velocity.assign(s.velocity.size(), Vector3::Zero());
    s.spin = s.velocity;
    s.kick(1);
    for (Eigen::Index row = 0; row < n; ++row)
      k(row, column) = -(row % 6 < 3 ? s.velocity[static_cast<std::size_t>(row / 6)][row % 6]
                                     : s.spin[static_cast<std::size_t>(row / 6)][row % 6 - 3]) *
                       weight(row) / weight(column) / dt;
  }
  CHECK((k - k.transpose()).norm() < 1e-5 * k.norm()); // every force has its counterpart
  return std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues()[n - 1]);
}

} // namespace

TEST_CASE("The stable step never exceeds that of the assembled structure, nor falls far below", "[shells]")
{
  for (const bool triangles : {false, true})
    for (const double thickness : {0.002, 0.05, 0.5})
      for (const int shape : {0, 1, 2, 3}) {
        ShellMesh mesh;
        if (shape == 0)
          mesh = patch(
              3, 3, [](double u, double v) { return Vector3(u, v, 0); }, triangles);
        else if (shape == 1)
          mesh = distorted_square(3, triangles);
        else if (shape == 2)
          mesh = twisted_panel(3, triangles);
        else
          mesh = patch(
              3, 3, [](double u, double v) { return Vector3(4 * u + v, 0.3 * v, 0); }, triangles);
        for (const double poisson : {0.0, 0.3, 0.45}) {
          CAPTURE(triangles, thickness, shape, poisson);
          ShellSettings settings;
          settings.courant = 1;
          const Shells s(mesh, {{elastic(E, poisson, rho), thickness, 2}}, {}, {}, settings);
          const double exact = 2 / highest_frequency(s);
          CHECK(s.stable_step() <= exact);
          CHECK(s.stable_step() > 0.3 * exact);
        }
      }
}

namespace {

//! Period of a structure that swings from rest in its first mode, from the first two passages through zero.
double period(Shells& s, std::size_t node, double end)
{
  const double start = s.position[node].z();
  std::vector<double> zeros;
  double before = s.position[node].z() - start, then = 0;
  run(s, end, [&](double time) {
    const double now = s.position[node].z() - start;
    if (before != 0 && before * now < 0)
      zeros.push_back(then + (time - then) * before / (before - now));
    before = now;
    then = time;
  });
  return zeros.size() < 2 ? 0 : 2 * (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
}

} // namespace

TEST_CASE("First frequencies of a simply supported plate and of a cantilever", "[shells]")
{
  for (const bool triangles : {false, true}) {
    CAPTURE(triangles);
    const int n = triangles ? 12 : 10;
    {
      const double t = 0.01, D = E * t * t * t / 12 / (1 - nu * nu);
      const ShellMesh mesh = patch(
          n, n, [](double u, double v) { return Vector3(u, v, 0); }, triangles);
      Support edge;
      edge.nodes = nodes_of(mesh, {"u0", "u1", "v0", "v1"});
      edge.moves = {false, false, true};
      Support turn_u{nodes_of(mesh, {"u0", "u1"}), {}, {true, false, false}},
          turn_v{nodes_of(mesh, {"v0", "v1"}), {}, {false, true, false}};
      Shells s(mesh, {{elastic(E, nu, rho), t, 2}}, {edge, turn_u, turn_v});
      give(
          s, [](const Vector3& p) { return Vector3(0, 0, 1e-3 * std::sin(pi * p[0]) * std::sin(pi * p[1])); },
          [](const Vector3& p) {
            return Vector3(1e-3 * pi * std::sin(pi * p[0]) * std::cos(pi * p[1]),
                           -1e-3 * pi * std::cos(pi * p[0]) * std::sin(pi * p[1]), 0);
          });
      const double exact = 2 * pi / (2 * pi * pi * std::sqrt(D / (rho * t)));
      CHECK(period(s, node_at(mesh, {0.5, 0.5, 0}), 1.6 * exact) == Approx(exact).epsilon(0.015));
    }
    {
      // Euler's beam: 1.8751^2 sqrt(E I / (rho A)) / L^2, without Poisson's effect.
      const double t = 0.01;
      const ShellMesh mesh = patch(
          n, 2, [](double u, double v) { return Vector3(u, 0.1 * v, 0); }, triangles);
      ShellLoads loads;
      for (const std::int32_t node : mesh.node_sets.at("u1"))
        loads.nodes.push_back({node, {0, 0, 1}, [](double time) { return time > 0 ? 0.0 : 1.0; }});
      Shells s(mesh, {{elastic(E, 0, rho), t, 2}}, {clamped(nodes_of(mesh, {"u0"}))});
      const double k = 1.875104, ratio = 0.734096;
      const auto shape = [&](double x) {
        return std::cosh(k * x) - std::cos(k * x) - ratio * (std::sinh(k * x) - std::sin(k * x));
      };
      const auto slope = [&](double x) {
        return k * (std::sinh(k * x) + std::sin(k * x) - ratio * (std::cosh(k * x) - std::cos(k * x)));
      };
      give(
          s, [&](const Vector3& p) { return Vector3(0, 0, 1e-3 * shape(p[0])); },
          [&](const Vector3& p) { return Vector3(0, -1e-3 * slope(p[0]), 0); });
      const double exact = 2 * pi / (k * k * std::sqrt(E * t * t / 12 / rho));
      CHECK(period(s, node_at(mesh, {1, 0.05, 0}), 1.1 * exact) == Approx(exact).epsilon(0.015));
    }
  }
}

TEST_CASE("Hinges, clamps and planes of symmetry hold what they should", "[shells]")
{
  // A strip under pressure: 5 q L^4 / (384 E I) on hinges, a fifth of it clamped, and the same from half a strip.
  const double t = 0.02, q = 10, L = 1;
  const auto deflection = [&](bool clamp, bool half) {
    const int n = half ? 12 : 24;
    const ShellMesh mesh =
        patch(n, 2, [&](double u, double v) { return Vector3(half ? 0.5 * L * u : L * u, 0.1 * v, 0); });
    std::vector<Support> supports;
    const auto ends = half ? nodes_of(mesh, {"u0"}) : nodes_of(mesh, {"u0", "u1"});
    supports.push_back(clamp ? clamped(ends) : simply_supported(ends));
    if (half)
      supports.push_back(symmetric(mesh.node_sets.at("u1"), 0));
    ShellLoads loads;
    loads.surfaces.push_back({q});
    Shells s(mesh, {{elastic(E, 0, rho), t, 2}}, supports, loads);
    s.relax(0, 1e-6);
    return -s.position[node_at(mesh, {0.5, 0.05, 0})].z();
  };
  const double hinged = 5 * q * L * L * L * L / (384 * E * t * t * t / 12);
  CHECK(deflection(false, false) == Approx(hinged).epsilon(0.01));
  CHECK(deflection(true, false) == Approx(hinged / 5).epsilon(0.01));
  CHECK(deflection(false, true) == Approx(deflection(false, false)).epsilon(1e-4));
}

TEST_CASE("A spinning rod starts in the exact centrifugal stress and keeps it", "[shells]")
{
  const double w = 300, L = 0.5, root = 0.1;
  for (const bool triangles : {false, true}) {
    CAPTURE(triangles);
    const ShellMesh mesh = patch(
        20, 2, [&](double u, double v) { return Vector3(root + L * u, 0.05 * (v - 0.5), 0); }, triangles);
    Support hub = clamped(mesh.node_sets.at("u0"));
    ShellSettings settings;
    settings.spin = SteadySpin{Vector3::Zero(), {0, 0, w}};
    Shells s(mesh, {{elastic(E, 0, rho), 0.004, 2}}, {hub}, {}, settings);
    s.relax(0, 1e-5);
    const auto check = [&] {
      const double end = root + L;
      for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        Vector3 middle = Vector3::Zero();
        const int n = is_triangle(mesh.elements[e]) ? 3 : 4;
        for (int k = 0; k < n; ++k)
          middle += mesh.points[static_cast<std::size_t>(mesh.elements[e][static_cast<std::size_t>(k)])] / n;
        if (middle.x() > 0.8 * end)
          continue;
        const Eigen::Matrix3d stress = stress_in_space(s, e, 0);
        const double exact = 0.5 * rho * w * w * (end * end - middle.x() * middle.x());
        CHECK(stress.trace() == Approx(exact).epsilon(triangles ? 0.03 : 0.01));
      }
    };
    check();
    const double internal = s.energy().internal, kinetic = s.energy().kinetic;
    double swing = 0, time = 0;
    const std::size_t tip = node_at(mesh, {root + L, 0, 0});
    const double radius = s.position[tip].norm();
    run(s, 0.25 * 2 * pi / w, [&](double t) {
      swing = std::max(swing, std::abs(s.position[tip].norm() - radius));
      time = t;
    });
    CHECK(swing < 1e-3 * (radius - root - L));
    CHECK(s.energy().internal == Approx(internal).epsilon(0.002));
    CHECK(s.energy().kinetic == Approx(kinetic).epsilon(1e-4));
    const Vector3 exact = Eigen::AngleAxisd(w * time, Vector3::UnitZ()) * Vector3(radius, 0, 0);
    CHECK((s.position[tip] - exact).norm() < 1e-3 * radius);
  }
}

TEST_CASE("A spinning ring has the stress rho (omega R)^2", "[shells]")
{
  const double w = 200, R = 0.5;
  const int n = 24;
  ShellMesh mesh = patch(n, 2, [&](double u, double v) {
    return Vector3(R * std::cos(2 * pi * u), R * std::sin(2 * pi * u), 0.1 * v);
  });
  for (ShellElement& e : mesh.elements) // close it
    for (std::int32_t& node : e)
      if (node % (n + 1) == n)
        node -= n;
  std::vector<std::int32_t> row(mesh.points.size());
  std::vector<Vector3> kept;
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    if (k % (n + 1) != n) {
      row[k] = static_cast<std::int32_t>(kept.size());
      kept.push_back(mesh.points[k]);
    }
  mesh.points = kept;
  mesh.node_sets.clear();
  for (ShellElement& e : mesh.elements)
    for (std::int32_t& node : e)
      node = row[static_cast<std::size_t>(node)];
  ShellSettings settings;
  settings.spin = SteadySpin{Vector3::Zero(), {0, 0, w}};
  Shells s(mesh, {{elastic(E, 0.3, rho), 0.004, 2}}, {}, {}, settings);
  s.relax(0, 1e-4);
  double worst = 0;
  const auto look = [&] {
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      worst = std::max(
          worst, std::abs((s.points[2 * e].xx + s.points[2 * e + 1].xx) / (2 * rho * w * w * R * R) - 1));
  };
  look();
  run(s, 0.2 * 2 * pi / w, [&](double) { look(); });
  CHECK(worst < 0.015); // of the polygon: cos^2(pi / n) and lumped mass
}

TEST_CASE("Thickness follows the stretch", "[shells]")
{
  ShellMesh mesh = patch(2, 2, [](double u, double v) { return Vector3(u, v, 0); });
  const double stretch = 0.4, dt = 1e-5;
  const auto pull = [&](Shells& s) {
    const int steps = 4000;
    for (int k = 0; k < steps; ++k) {
      const double rate = stretch / (1 + stretch * k / steps) / steps / dt;
      give(
          s, [&](const Vector3& p) { return Vector3(rate * p[0], 0, 0); },
          [](const Vector3&) { return Vector3(0, 0, 0); });
      s.drift(dt);
      s.evaluate(dt, 0);
    }
  };
  SECTION("elastic, plane strain: -nu / (1 - nu) ln")
  {
    Shells s(mesh, {{elastic(E, nu, rho), 0.02, 2}});
    pull(s);
    for (const double t : s.thickness)
      CHECK(t == Approx(0.02 * std::pow(1 + stretch, -nu / (1 - nu))).epsilon(1e-4));
  }
  SECTION("plastic flow keeps the volume")
  {
    ShellMaterial metal = elastic(E, nu, rho);
    metal.hardening = LinearHardening{70e6, 0};
    Shells s(mesh, {{metal, 0.02, 2}});
    pull(s);
    for (const double t : s.thickness) // but for the elastic part, (1 - 2 nu) mean stress / E
      CHECK(t == Approx(0.02 / (1 + stretch)).epsilon(1e-3));
    const ShellEnergy e = s.energy();
    CHECK(e.plastic == Approx(e.internal).epsilon(0.01));
    CHECK(e.plastic < e.internal);
    // Work of perfect plasticity in plane strain: 2 / sqrt(3) sigma_y ln(stretch) of the volume.
    CHECK(e.internal == Approx(2 / std::sqrt(3.0) * 70e6 * std::log(1 + stretch) * 0.02).epsilon(0.01));
  }
}

TEST_CASE("Eroded elements leave their energy and mass in the books", "[shells]")
{
  ShellMaterial brittle = elastic(E, nu, rho);
  brittle.hardening = LinearHardening{100e6, 1e9};
  brittle.failure = PlasticStrainLimit{0.02};
  for (const bool triangles : {false, true}) {
    const ShellMesh mesh = patch(
        8, 8, [](double u, double v) { return Vector3(u, v, 0); }, triangles);
    Shells s(mesh, {{brittle, 0.01, 3}}, {clamped(nodes_of(mesh, {"u0", "u1", "v0", "v1"}))});
    give(
        s,
        [](const Vector3& p) { return Vector3(0, 0, std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.3 ? 150.0 : 0); },
        [](const Vector3&) { return Vector3(0, 0, 0); });
    const double mass = s.total_mass(), start = s.energy().total();
    double worst = 0, eroded = 0;
    bool falls = false;
    run(s, 0.004, [&](double) {
      const ShellEnergy e = s.energy();
      worst = std::max(worst, std::abs(e.total() - start));
      falls = falls || e.eroded < eroded;
      eroded = e.eroded;
    });
    CAPTURE(triangles, s.eroded());
    CHECK(s.eroded() > 0);
    CHECK(s.eroded() < mesh.elements.size());
    CHECK(eroded > 0);
    CHECK_FALSE(falls);
    CHECK(worst < 0.01 * start);
    CHECK(s.total_mass() == mass);
    CHECK(std::isfinite(s.stable_step()));
  }
}

TEST_CASE("One thread and two give the same bits", "[shells]")
{
  ShellMaterial metal = elastic(E, nu, rho);
  metal.hardening = LinearHardening{100e6, 1e9};
  metal.failure = PlasticStrainLimit{0.05};
  ShellLoads loads;
  loads.surfaces.push_back({1e6});
  const ShellMesh mesh = twisted_panel(33);
  const auto after = [&](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Shells s(mesh, {{metal, 0.01, 3}}, {clamped(mesh.node_sets.at("u0"))}, loads);
    run(s, 200 * s.stable_step());
    omp_set_num_threads(before);
    return s;
  };
  const Shells one = after(1), two = after(2);
  CHECK(one.energy().plastic > 0);
  CHECK(one.position == two.position);
  CHECK(one.spin == two.spin);
  CHECK(one.energy().total() == two.energy().total());
  CHECK(one.energy().external == two.energy().external);
}

TEST_CASE("Bad structures are refused by name", "[shells]")
{
  using Catch::Contains;
  ShellMesh mesh = patch(2, 2, [](double u, double v) { return Vector3(u, v, 0); });
  ShellSection section{elastic(E, nu, rho), 0.01, 5};
  const auto message = [&](const ShellMesh& m, const ShellSection& s, std::vector<Support> supports = {}) {
    try {
      const Shells shells(m, {s}, std::move(supports));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(message(mesh, section) == "accepted");
  SECTION("no element")
  {
    mesh.elements.clear();
    CHECK_THAT(message(mesh, section), Contains("no shell element"));
  }
  SECTION("thickness")
  {
    for (const double t : {0.0, -0.01, std::numeric_limits<double>::quiet_NaN()}) {
      section.thickness = t;
      CHECK_THAT(message(mesh, section), Contains("part plate") && Contains("thickness"));
    }
  }
  SECTION("points through the thickness")
  {
    for (const int points : {1, 11}) {
      section.points = points;
      CHECK_THAT(message(mesh, section), Contains("2 to 10 points") && Contains(std::to_string(points)));
    }
  }
  SECTION("material")
  {
    section.material.poisson = 0.5;
    CHECK_THAT(message(mesh, section), Contains("part plate") && Contains("Poisson"));
    section.material = elastic(-1, nu, rho);
    CHECK_THAT(message(mesh, section), Contains("Young"));
    section.material = elastic(E, nu, 0);
    CHECK_THAT(message(mesh, section), Contains("density"));
  }
  SECTION("a corner that is not there")
  {
    mesh.elements[3][2] = 99;
    CHECK_THAT(message(mesh, section), Contains("element 3") && Contains("99"));
  }
  SECTION("a free node")
  {
    mesh.points.push_back({5, 5, 0});
    CHECK_THAT(message(mesh, section), Contains("node 9") && Contains("no element"));
  }
  SECTION("no area")
  {
    mesh.elements[2] = {0, 1, 1, 1};
    CHECK_THAT(message(mesh, section), Contains("element 2"));
  }
  SECTION("turned over itself")
  {
    std::swap(mesh.elements[1][0], mesh.elements[1][1]);
    CHECK_THAT(message(mesh, section), Contains("element 1"));
  }
  SECTION("concave")
  {
    mesh.points[4] = {0.1, 0.1, 0}; // the middle node, beyond the diagonal of element 0
    CHECK_THAT(message(mesh, section), Contains("element 0") && Contains("concave"));
  }
  SECTION("a place that is no number")
  {
    mesh.points[4].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(message(mesh, section), Contains("element 0"));
  }
  SECTION("a support on no node")
  {
    CHECK_THAT(message(mesh, section, {clamped({})}), Contains("support") && Contains("no node"));
    CHECK_THAT(message(mesh, section, {clamped({77})}), Contains("support") && Contains("77"));
  }
}

TEST_CASE("a velocity that is no number stops the run, also where elements could erode", "[shells][errors]")
{
  ShellMaterial material = samples::elastic(70e9, 0.3, 2700);
  material.failure = PlasticStrainLimit{0.2};
  const ShellMesh mesh = samples::patch(3, 3, [](double u, double v) -> Vector3 { return {u, v, 0}; });
  Shells shells(mesh, {{material, 0.01, 3}});
  shells.velocity[5][2] = std::nan("");
  const double dt = shells.stable_step();
  shells.drift(dt);
  CHECK_THROWS_WITH(shells.evaluate(dt, dt), Catch::Contains("target") && Catch::Contains("t = "));
}
