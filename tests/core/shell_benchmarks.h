// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmarks of shells with published or exact answers, for any mesh. Inch and pound where their source has them.
#pragma once

#include "core/shells/shells.h"

#include <string>
#include <vector>

namespace birdstrike::samples {

//! How a benchmark is run.
struct BenchmarkChoice
{
  int n = 8;              //!< elements along a side
  bool triangles = false; //!< twice as many triangles instead
  bool warping = true;
  double load =
      0; //!< share of the published load; 0: the one it is meant for. Small where the answer is of linear theory
  double tolerance = 1e-3; //!< of relax()
};

struct BenchmarkAnswer
{
  double value;           //!< of the quantity that the source gives, in its units
  double hourglass_share; //!< hourglass over internal energy, at the end or where internal energy is largest
  long steps;
};

//! A curve over time that the benchmark gives at one place.
struct BenchmarkCurve
{
  std::vector<double> time, value;
  double hourglass_share; //!< where internal energy is largest
  long steps;

  double at(double time) const; //!< straight between samples
  //! Largest value (sign 1) or lowest (sign -1) between two times, and when.
  struct Extremum
  {
    double value, time;
  };
  Extremum extremum(double from, double to, int sign) const;
};

// Statics, by relax().

//! Vertical displacement of the middle of the free edge, downwards; 0.3024.
BenchmarkAnswer scordelis_lo(const BenchmarkChoice& choice);
//! Displacement under the load of the hemisphere with a hole of 18 degrees; 0.093 to 0.094.
BenchmarkAnswer pinched_hemisphere(const BenchmarkChoice& choice);
//! Displacement under the load of the cylinder with end diaphragms; 1.82488e-5.
BenchmarkAnswer pinched_cylinder(const BenchmarkChoice& choice);
//! Displacement of the middle of the free edge of the hyperbolic paraboloid, t/L = 0.01; -9.3355e-5.
BenchmarkAnswer clamped_hypar(const BenchmarkChoice& choice);
//! Deflection of the middle of the square plate of large deflection, edges free to draw in; 1.8687.
BenchmarkAnswer large_deflection_plate(const BenchmarkChoice& choice);
//! Tip deflection of a strip under an end force, over F L^3 / (3 E I); 1.
BenchmarkAnswer cantilever(const BenchmarkChoice& choice);

// Dynamics.

//! Middle deflection [mm] of NAFEMS 21T; peak 4.524 mm at 10.86 ms.
BenchmarkCurve nafems_21t(const BenchmarkChoice& choice);
//! Middle deflection [in] of the 10 x 10 x 0.5 in plate under a step of 300 psi.
BenchmarkCurve step_plate(const BenchmarkChoice& choice);
//! The same by Kirchhoff's theory, the sum of its modes. \param time [s]
double step_plate_exact(double time);
//! Apex deflection [in] of the clamped spherical cap under a step of 600 psi; up positive.
BenchmarkCurve spherical_cap(const BenchmarkChoice& choice);

} // namespace birdstrike::samples
