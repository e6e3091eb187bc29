// SPDX-License-Identifier: BSD-3-Clause
// How much of the space at a place is filled, after the particles around it.
#pragma once

#include "CellList.h"

#include <vector>

/**
 * The colour function sum V W of the cubic spline (dissertation 4.4, equation 4.13) over particles of smoothing
 * length h; 1 deep inside, 0 where no kernel reaches.
 *
 * The volumes are counted: V = v / sum v W with v = h^3, the sum being that at the particle itself. In bulk this
 * is m / rho; at a free surface, where half of the neighbours are missing, it is larger, as is m / rho of a solver
 * that counts its density (4.5). Then, at a flat free surface, the colour function is exactly ln 2, whatever the
 * kernel: with F the share of the kernel within the body, it is the integral of -dF / F from F = 1 to 1/2. That is
 * why ln 2 is the level of the skin. A lone particle has 1 at its place, and at ln 2 keeps a ball of about its own
 * volume, so that no debris vanishes. (With V = m / rho of the undisturbed material the level were 1/2, but thin
 * sheets and lone particles had no skin at all; and where a wall was mirrored counted densities differ.)
 */
class SphField
{
public:
  static constexpr double Support = 2; //!< in smoothing lengths

  //! \param points  finite, in an order that does not depend on that of the file
  //! \param h       smoothing length of each [m], finite, > 0
  SphField(std::vector<Vector3d> points, std::vector<double> h);

  const std::vector<Vector3d>& GetPoints() const { return this->Points; }
  const std::vector<double>& GetSmoothing() const { return this->H; }

  //! Whether no other kernel reaches the particle.
  bool IsAlone(std::size_t particle) const { return this->Scale[particle] == 1; }

  //! V W of a particle at a squared distance from it [-].
  double Share(std::size_t particle, double squared) const
  {
    const double q = std::sqrt(squared) * this->Inverse[particle];
    const double a = q < 2 ? 2 - q : 0, b = q < 1 ? 1 - q : 0;
    return this->Scale[particle] * (0.25 * a * a * a - b * b * b);
  }

  //! (1/r) d(V W)/dr [1/m2]: the gradient is this times (place - particle).
  double Slope(std::size_t particle, double squared) const
  {
    const double q = std::sqrt(squared) * this->Inverse[particle];
    const double factor = this->Scale[particle] * this->Inverse[particle] * this->Inverse[particle];
    if (q >= 2)
      return 0;
    return factor * (q < 1 ? -3 + 2.25 * q : -0.75 * (2 - q) * (2 - q) / q);
  }

  //! f(particle, squared distance) for all whose kernel may reach the place.
  template <class Function>
  void ForEachNear(const Vector3d& place, Function&& f) const
  {
    this->Cells.ForEachNear(place, [&](std::size_t i) {
      const double squared = DistanceSquared(place, this->Points[i]);
      if (squared < this->Reach[i])
        f(i, squared);
    });
  }

  //! The particle nearest to a place that is within two of the largest smoothing lengths of one.
  std::size_t Nearest(const Vector3d& place) const
  {
    std::size_t nearest = 0;
    double least = -1;
    this->Cells.ForEachNear(place, [&](std::size_t i) {
      const double squared = DistanceSquared(place, this->Points[i]);
      if (least < 0 || squared < least || (squared == least && i < nearest)) {
        least = squared;
        nearest = i;
      }
    });
    return nearest;
  }

private:
  std::vector<Vector3d> Points;
  std::vector<double> H, Inverse, Reach; // Reach: squared support
  std::vector<double> Scale;             // V / (pi h^3)
  double Largest;
  CellList Cells;
};
