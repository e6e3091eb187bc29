// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as weighted points, and how mirror-symmetric they are.
#include "geometry/import/symmetry.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace birdstrike {

SurfaceSamples sample_surface(const SurfaceMesh& mesh)
{
  SurfaceSamples samples;
  double area = 0;
  const auto add = [&](const Vector3& point, double weight) {
    samples.points.push_back(point);
    samples.weights.push_back(weight);
    samples.centre += weight * point;
    area += weight;
  };
  for (const SurfacePart& part : mesh)
    for (const auto& t : part.triangles) {
      const Vector3 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
      const double s = 0.5 * (b - a).cross(c - a).norm();
      // Exact to the third degree: corners, middles of sides, centre (Zienkiewicz, Finite Element Method, table of
      // triangle rules).
      for (const Vector3& corner : {a, b, c})
        add(corner, s / 20);
      for (const Vector3& middle : {Vector3(0.5 * (a + b)), Vector3(0.5 * (b + c)), Vector3(0.5 * (c + a))})
        add(middle, s * 2 / 15);
      add((a + b + c) / 3, s * 9 / 20);
    }
  if (area > 0) {
    samples.centre /= area;
    for (double& weight : samples.weights)
      weight /= area;
  }
  return samples;
}

double asymmetry(const SurfaceSamples& samples, const Eigen::Matrix3d& frame, int axis)
{
  const Vector3 n = frame.col(axis), e = frame.col((axis + 1) % 3), f = frame.col((axis + 2) % 3);
  double nn = 0, ee = 0, ff = 0;                             // spreads
  double ne = 0, nf = 0, nnn = 0, nee = 0, nff = 0, nef = 0; // odd in n
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3 r = samples.points[i] - samples.centre;
    const double w = samples.weights[i], x = r.dot(n), y = r.dot(e), z = r.dot(f);
    nn += w * x * x, ee += w * y * y, ff += w * z * z;
    ne += w * x * y, nf += w * x * z;
    nnn += w * x * x * x, nee += w * x * y * y, nff += w * x * z * z, nef += w * x * y * z;
  }
  const double a = std::sqrt(nn), b = std::sqrt(ee), c = std::sqrt(ff);
  const auto share = [](double moment, double size) { return size > 0 ? std::abs(moment) / size : 0.0; };
  return std::max({share(ne, a * b), share(nf, a * c), share(nnn, a * a * a), share(nee, a * b * b),
                   share(nff, a * c * c), share(nef, a * b * c)});
}

Eigen::Matrix3d principal_axes(const SurfaceSamples& samples)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3 r = samples.points[i] - samples.centre;
    spread += samples.weights[i] * r * r.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  if (solver.info() != Eigen::Success)
    return Eigen::Matrix3d::Identity();
  return solver.eigenvectors().rowwise().reverse();
}

} // namespace birdstrike
