// SPDX-License-Identifier: BSD-3-Clause
// A law given by a table of pressure over compression, for any curve without a closed form.
#pragma once

#include "core/material/law_point.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace birdstrike {

//! Monotone cubic Hermite interpolation of p(x), x = rho/rho0, on equal intervals from x = 1; the sound speed
//! is the slope of the interpolant itself, so c^2 = dp/drho holds exactly. Below x = 1 and beyond the last
//! node the curve goes on as a straight line. Source of the slope limits: F. N. Fritsch, R. E. Carlson, SIAM
//! J. Numer. Anal. 17 (1980) 238.
class Tabulated
{
public:
  //! \param rho0      reference density [kg/m3]
  //! \param x_max     end of the table, > 1 [-]
  //! \param pressure  p(x) [Pa], strictly rising, p(1) = 0
  //! \param name      for describe()
  //! \throw InputError if p does not rise from node to node or p(1) is not 0
  Tabulated(double rho0, double x_max, const std::function<double(double)>& pressure, std::string name);

  //! From rows of measured or published values, through each of which the curve goes. Between them it is the monotone
  //! Hermite interpolant of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300), resampled on intervals of
  //! an eighth of the closest two rows.
  //! \param density   N >= 4 values, strictly rising; the first is the reference density [kg/m3]
  //! \param pressure  N values, strictly rising, the first is 0 [Pa]
  //! \throw InputError naming the row (counted from 1) that breaks this, or rows too close for their range
  Tabulated(const std::vector<double>& density, const std::vector<double>& pressure, std::string name);

  double reference_density() const { return rho0_; }
  Tabulated rescaled(double density) const
  {
    Tabulated law = *this;
    law.rho0_ = density;
    return law;
  }

  LawPoint at(double rho) const
  {
    const double s = (rho / rho0_ - 1) * per_unit_; // in intervals
    const double last = static_cast<double>(nodes_->size() / 2 - 1);
    const double* n = nodes_->data();
    double p, slope; // slope per interval
    if (!(s > 0)) {  // a NaN, too, which must not become an index
      slope = n[1];
      p = slope * s;
    } else if (s >= last) {
      const double* end = n + 2 * static_cast<std::size_t>(last);
      slope = end[1];
      p = end[0] + slope * (s - last);
    } else {
      const auto k = static_cast<std::size_t>(s);
      n += 2 * k;
      const double t = s - static_cast<double>(k), d = n[2] - n[0];
      const double a = n[1] - d, b = d - n[3]; // p = p0 + t d + t (1-t) (a (1-t) + b t)
      p = n[0] + t * d + t * (1 - t) * (a * (1 - t) + b * t);
      slope = d + (1 - 2 * t) * (a * (1 - t) + b * t) + t * (1 - t) * (b - a);
    }
    return {p, std::sqrt(slope * per_unit_ / rho0_)};
  }
  //! Its range is that of the table.
  std::string describe() const;

private:
  void sample(std::size_t intervals, double x_max, const std::function<double(double)>& pressure);

  double rho0_;
  double per_unit_; //!< intervals per unit of x
  std::shared_ptr<const std::vector<double>>
      nodes_; //!< p and slope [Pa, Pa per interval] of each node in turn
  std::string name_;
};

} // namespace birdstrike
