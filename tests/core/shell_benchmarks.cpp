// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/shell_benchmarks.h"

#include "tests/core/shell_samples.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace birdstrike::samples {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double inch = 0.0254, psi = 6894.757293168361;

ShellSettings settings_of(const BenchmarkChoice& choice)
{
  ShellSettings settings;
  settings.warping = choice.warping;
  return settings;
}

double load_of(const BenchmarkChoice& choice, double usual) { return choice.load > 0 ? choice.load : usual; }

double hourglass_share(const ShellEnergy& e) { return e.hourglass / e.internal; }

BenchmarkCurve record(Shells& shells, double end, const std::function<double()>& value)
{
  BenchmarkCurve curve{{0}, {value()}, 0, 0};
  double most = 0;
  run(shells, end, [&](double time) {
    curve.time.push_back(time);
    curve.value.push_back(value());
    ++curve.steps;
    const ShellEnergy e = shells.energy();
    if (e.internal > most) {
      most = e.internal;
      curve.hourglass_share = hourglass_share(e);
    }
  });
  return curve;
}

//! A quarter of a disc of radius 1 out of three blocks of n x n quads each: places in the quarter plane x, y >= 0; node
//! sets "x0", "y0" (the planes of symmetry) and "rim".
ShellMesh quarter_disc(int n, bool triangles, const std::function<Vector3(double, double)>& place)
{
  ShellMesh mesh;
  mesh.parts = {{"cap", 0}};
  std::vector<Eigen::Vector2d> flat;
  const auto node = [&](const Eigen::Vector2d& p) {
    for (std::size_t k = 0; k < flat.size(); ++k)
      if ((flat[k] - p).norm() < 1e-9)
        return static_cast<std::int32_t>(k);
    flat.push_back(p);
    return static_cast<std::int32_t>(flat.size() - 1);
  };
  const double side = 0.55, corner = 0.45; // of the inner block, bulged so that no angle is far from right
  const auto inner = [&](double u, double v) -> Eigen::Vector2d {
    return {u * (side + v * (corner - side)), v * (side + u * (corner - side))};
  };
  const auto place_in = [&](int b, double u, double v) -> Eigen::Vector2d {
    if (b == 0)
      return inner(u, v);
    const double angle = b == 1 ? pi / 4 * v : pi / 2 - pi / 4 * v; // block 2 mirrors block 1
    const Eigen::Vector2d rim(std::cos(angle), std::sin(angle)), in = b == 1 ? inner(1, v) : inner(v, 1);
    return in + u * (rim - in);
  };
  for (int b = 0; b < 3; ++b)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        std::array<std::int32_t, 4> c;
        for (std::size_t k = 0; k < 4; ++k)
          c[k] = node(place_in(b, double(i + (k == 1 || k == 2)) / n, double(j + (k >= 2)) / n));
        if (b == 2)
          std::swap(c[1], c[3]);
        if (!triangles) {
          mesh.elements.push_back(c);
        } else {
          mesh.elements.push_back({c[0], c[1], c[2], c[2]});
          mesh.elements.push_back({c[0], c[2], c[3], c[3]});
        }
      }
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const auto row = static_cast<std::int32_t>(k);
    mesh.points.push_back(place(flat[k].x(), flat[k].y()));
    if (std::abs(flat[k].x()) < 1e-9)
      mesh.node_sets["x0"].push_back(row);
    if (std::abs(flat[k].y()) < 1e-9)
      mesh.node_sets["y0"].push_back(row);
    if (flat[k].norm() > 1 - 1e-9)
      mesh.node_sets["rim"].push_back(row);
  }
  return mesh;
}

//! Edges that hold z and turn only about themselves, of a flat quarter plate whose outer edges are u1 and v1.
std::vector<Support> quarter_simply_supported(const ShellMesh& mesh)
{
  const Support edge{nodes_of(mesh, {"u1", "v1"}), {false, false, true}, {}};
  const Support u{mesh.node_sets.at("u1"), {}, {true, false, false}},
      v{mesh.node_sets.at("v1"), {}, {false, true, false}};
  return {edge, u, v, symmetric(mesh.node_sets.at("u0"), 0), symmetric(mesh.node_sets.at("v0"), 1)};
}

} // namespace

double BenchmarkCurve::at(double when) const
{
  const auto next = std::lower_bound(time.begin(), time.end(), when);
  if (next == time.begin())
    return value.front();
  if (next == time.end())
    return value.back();
  const auto k = static_cast<std::size_t>(next - time.begin());
  return value[k - 1] + (when - time[k - 1]) / (time[k] - time[k - 1]) * (value[k] - value[k - 1]);
}

BenchmarkCurve::Extremum BenchmarkCurve::extremum(double from, double to, int sign) const
{
  Extremum best{-1e300 * sign, 0};
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= from && time[k] <= to && sign * (value[k] - best.value) > 0)
      best = {value[k], time[k]};
  return best;
}

BenchmarkAnswer scordelis_lo(const BenchmarkChoice& choice)
{
  // A quarter: u from the crown to the free edge, v from the middle to the diaphragm.
  const double R = 25, L = 50, half_angle = 40 * pi / 180, share = load_of(choice, 0.01);
  const ShellMesh mesh = patch(
      choice.n, choice.n,
      [&](double u, double v) {
        const double a = half_angle * u;
        return Vector3(R * std::sin(a), 0.5 * L * v, R * std::cos(a));
      },
      choice.triangles);
  ShellLoads loads;
  SurfaceLoad weight;
  weight.traction = {0, 0, -90 * share};
  loads.surfaces.push_back(weight);
  const Support diaphragm{mesh.node_sets.at("v1"), {true, false, true}, {}};
  Shells s(mesh, {{elastic(4.32e8, 0, 1), 0.25, 2}},
           {diaphragm, symmetric(mesh.node_sets.at("v0"), 1), symmetric(mesh.node_sets.at("u0"), 0)}, loads,
           settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  const auto free = static_cast<std::size_t>(mesh.node_sets.at("v0").back());
  return {(mesh.points[free].z() - s.position[free].z()) / share, hourglass_share(s.energy()), steps};
}

BenchmarkAnswer pinched_hemisphere(const BenchmarkChoice& choice)
{
  // A quarter: loads 2 on the whole at each point halve on planes of symmetry.
  const double R = 10, share = load_of(choice, 0.01);
  const ShellMesh mesh = patch(
      choice.n, choice.n,
      [&](double u, double v) {
        const double a = pi / 2 * u, b = 72 * pi / 180 * v;
        return Vector3(R * std::cos(a) * std::cos(b), R * std::sin(a) * std::cos(b), R * std::sin(b));
      },
      choice.triangles);
  const auto pulled = static_cast<std::int32_t>(node_at(mesh, {R, 0, 0})),
             pushed = static_cast<std::int32_t>(node_at(mesh, {0, R, 0}));
  ShellLoads loads;
  loads.nodes = {{pulled, {share, 0, 0}}, {pushed, {0, -share, 0}}};
  const Support height{{pulled}, {false, false, true}, {}};
  Shells s(mesh, {{elastic(6.825e7, 0.3, 1), 0.04, 2}},
           {symmetric(mesh.node_sets.at("u0"), 1), symmetric(mesh.node_sets.at("u1"), 0), height}, loads,
           settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  const double out = s.position[static_cast<std::size_t>(pulled)].x() - R,
               in = R - s.position[static_cast<std::size_t>(pushed)].y();
  return {0.5 * (out + in) / share, hourglass_share(s.energy()), steps};
}

BenchmarkAnswer pinched_cylinder(const BenchmarkChoice& choice)
{
  // An eighth: u around from the load, v from the middle to the diaphragm.
  const double R = 300, L = 600, share = load_of(choice, 1);
  const ShellMesh mesh = patch(
      choice.n, choice.n,
      [&](double u, double v) {
        const double a = pi / 2 * u;
        return Vector3(R * std::sin(a), 0.5 * L * v, R * std::cos(a));
      },
      choice.triangles);
  const auto loaded = static_cast<std::int32_t>(node_at(mesh, {0, 0, R}));
  ShellLoads loads;
  loads.nodes = {{loaded, {0, 0, -0.25 * share}}};
  const Support diaphragm{mesh.node_sets.at("v1"), {true, false, true}, {}};
  Shells s(mesh, {{elastic(3e6, 0.3, 1), 3, 2}},
           {diaphragm, symmetric(mesh.node_sets.at("v0"), 1), symmetric(mesh.node_sets.at("u0"), 0),
            symmetric(mesh.node_sets.at("u1"), 2)},
           loads, settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  return {(R - s.position[static_cast<std::size_t>(loaded)].z()) / share, hourglass_share(s.energy()), steps};
}

BenchmarkAnswer clamped_hypar(const BenchmarkChoice& choice)
{
  // z = x^2 - y^2 over |x|, |y| < 1/2, clamped at x = -1/2, under its weight of 8000 N/m3; half of it by symmetry.
  const double t = 0.01, share = load_of(choice, 1);
  const int along = choice.n, across = std::max(1, choice.n / 2);
  const ShellMesh mesh = patch(
      along, across,
      [](double u, double v) {
        const double x = u - 0.5, y = 0.5 * v;
        return Vector3(x, y, x * x - y * y);
      },
      choice.triangles);
  ShellLoads loads;
  SurfaceLoad weight;
  weight.traction = {0, 0, -8000 * t * share};
  loads.surfaces.push_back(weight);
  Shells s(mesh, {{elastic(2e11, 0.3, 8000), t, 2}},
           {clamped(mesh.node_sets.at("u0")), symmetric(mesh.node_sets.at("v0"), 1)}, loads,
           settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  const std::size_t free = node_at(mesh, {0.5, 0, 0.25});
  return {(s.position[free].z() - mesh.points[free].z()) / share, hourglass_share(s.energy()), steps};
}

BenchmarkAnswer large_deflection_plate(const BenchmarkChoice& choice)
{
  const double E = 1.3024653e6, share = load_of(choice, 1);
  const ShellMesh mesh = patch(
      choice.n, choice.n, [](double u, double v) { return Vector3(5 * u, 5 * v, 0); }, choice.triangles);
  ShellLoads loads;
  loads.surfaces.push_back({100 * E * 1e-4 * share});
  Shells s(mesh, {{elastic(E, 0.3, 1), 1, 2}}, quarter_simply_supported(mesh), loads, settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  return {-s.position[node_at(mesh, {0, 0, 0})].z() / share, hourglass_share(s.energy()), steps};
}

BenchmarkAnswer cantilever(const BenchmarkChoice& choice)
{
  const double E = 210e9, L = 0.19, width = 0.01, t = 0.01, force = 100 * load_of(choice, 0.01);
  const ShellMesh mesh = patch(
      choice.n, 2, [&](double u, double v) { return Vector3(L * u, width * v, 0); }, choice.triangles);
  ShellLoads loads;
  for (const std::int32_t node : mesh.node_sets.at("u1")) // shares of the edge
    loads.nodes.push_back(
        {node,
         {0, 0,
          force * (std::abs(mesh.points[static_cast<std::size_t>(node)].y() - 0.5 * width) < 1e-9 ? 0.5
                                                                                                  : 0.25)}});
  Shells s(mesh, {{elastic(E, 0, 7800), t, 2}}, {clamped(mesh.node_sets.at("u0"))}, loads,
           settings_of(choice));
  const long steps = s.relax(0, choice.tolerance);
  const double exact = force * L * L * L / (3 * E * width * t * t * t / 12);
  return {s.position[node_at(mesh, {L, 0.5 * width, 0})].z() / exact, hourglass_share(s.energy()), steps};
}

BenchmarkCurve nafems_21t(const BenchmarkChoice& choice)
{
  const double share = load_of(choice, 0.01);
  const ShellMesh mesh = patch(
      choice.n, choice.n, [](double u, double v) { return Vector3(5 * u, 5 * v, 0); }, choice.triangles);
  ShellLoads loads;
  loads.surfaces.push_back({1e6 * share});
  ShellSettings settings = settings_of(choice);
  settings.damping = 5.772;
  settings.stiff_damping = 6.929e-5;
  Shells s(mesh, {{elastic(2e11, 0.3, 8000), 1, 3}}, quarter_simply_supported(mesh), loads, settings);
  return record(s, 0.02, [&s, share] { return -1e3 * s.position[0].z() / share; });
}

BenchmarkCurve step_plate(const BenchmarkChoice& choice)
{
  const double share = load_of(choice, 0.01);
  const ShellMesh mesh = patch(
      choice.n, choice.n, [](double u, double v) { return Vector3(5 * inch * u, 5 * inch * v, 0); },
      choice.triangles);
  ShellLoads loads;
  loads.surfaces.push_back({300 * psi * share});
  const double density = 2.588e-4 * psi / inch / inch; // lbf s2 / in4
  Shells s(mesh, {{elastic(68.94e9, 0.3, density), 0.5 * inch, 3}}, quarter_simply_supported(mesh), loads,
           settings_of(choice));
  return record(s, 1.2e-3, [&s, share] { return -s.position[0].z() / inch / share; });
}

double step_plate_exact(double time)
{
  const double a = 10 * inch, h = 0.5 * inch, density = 2.588e-4 * psi / inch / inch, q = 300 * psi;
  const double D = 68.94e9 * h * h * h / 12 / (1 - 0.09);
  double sum = 0;
  for (int m = 1; m < 40; m += 2)
    for (int n = 1; n < 40; n += 2) {
      const double k = pi * pi * (m * m + n * n) / (a * a), w2 = D * k * k / (density * h);
      const int sign = (m / 2 + n / 2) % 2 == 0 ? 1 : -1;
      sum += sign * 16 * q / (pi * pi * m * n * density * h * w2) * (1 - std::cos(std::sqrt(w2) * time));
    }
  return sum / inch;
}

BenchmarkCurve spherical_cap(const BenchmarkChoice& choice)
{
  const double R = 22.27 * inch, half_angle = 26.67 * pi / 180, share = load_of(choice, 1);
  const ShellMesh mesh = quarter_disc(choice.n, choice.triangles, [&](double x, double y) {
    const double r = std::hypot(x, y), a = half_angle * r, f = r > 0 ? std::sin(a) / r : 0;
    return Vector3(R * f * x, R * f * y, R * std::cos(a));
  });
  ShellLoads loads;
  loads.surfaces.push_back({600 * psi * share});
  const double density = 2.45e-4 * psi / inch / inch;
  Shells s(mesh, {{elastic(10.5e6 * psi, 0.3, density), 0.41 * inch, 3}},
           {clamped(mesh.node_sets.at("rim")), symmetric(mesh.node_sets.at("x0"), 0),
            symmetric(mesh.node_sets.at("y0"), 1)},
           loads, settings_of(choice));
  const std::size_t apex = node_at(mesh, {0, 0, R});
  return record(s, 1e-3, [&s, apex, R, share] { return (s.position[apex].z() - R) / inch / share; });
}

} // namespace birdstrike::samples
