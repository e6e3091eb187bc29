// SPDX-License-Identifier: GPL-3.0-or-later
// Division of a length into elements that are smallest in its middle.
#include "geometry/targets/graded_line.h"

#include <cmath>
#include <cstddef>

namespace birdstrike {

std::vector<double> graded_line(double length, int elements, double ratio)
{
  // Steps of the factor from the middle interval, or the two middle ones, to the last.
  const int steps = (elements - 1) / 2;
  const double factor = steps > 0 ? std::pow(ratio, 1.0 / steps) : 1;
  std::vector<double> right; // distances from the middle
  double at = 0, size = 1;
  if (elements % 2) {
    at = 0.5;
    size = factor;
  } else
    right.push_back(0);
  if (elements % 2)
    right.push_back(at);
  for (std::size_t k = right.size(); static_cast<int>(k) <= elements / 2; ++k) {
    right.push_back(at += size);
    size *= factor;
  }
  const double scale = 0.5 * length / right.back();
  std::vector<double> ends;
  for (std::size_t k = right.size(); k-- > (elements % 2 ? 0u : 1u);)
    ends.push_back(k + 1 == right.size() ? -0.5 * length : -scale * right[k]);
  for (std::size_t k = 0; k < right.size(); ++k)
    ends.push_back(k + 1 == right.size() ? 0.5 * length : scale * right[k]);
  return ends;
}

} // namespace birdstrike
