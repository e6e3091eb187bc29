// SPDX-License-Identifier: BSD-3-Clause
// A single-pole low pass, as behind a pressure transducer.
#include "LowPass.h"

#include <algorithm>
#include <cmath>

std::vector<double> LowPass(const std::vector<double>& times, const std::vector<double>& values,
                            double riseTime)
{
  if (!(riseTime > 0))
    return values;
  const double tau = riseTime / std::log(9.0);
  const auto is_none = [](double value) { return std::isnan(value); };
  std::vector<double> signal = values;
  const auto known = std::find_if_not(signal.begin(), signal.end(), is_none);
  std::fill(signal.begin(), known, known == signal.end() ? 0.0 : *known);
  std::replace_if(signal.begin(), signal.end(), is_none, 0.0);
  std::vector<double> filtered;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k == 0) {
      filtered.push_back(signal[0]);
      continue;
    }
    const double duration = times[k] - times[k - 1];
    if (!(duration > 0)) {
      filtered.push_back(filtered.back());
      continue;
    }
    // For x = a + b t the state decays towards the line that trails x by tau.
    const double gone = -std::expm1(-duration / tau);
    const double slope = (signal[k] - signal[k - 1]) / duration;
    filtered.push_back(filtered.back() + (signal[k - 1] - filtered.back()) * gone +
                       slope * (duration - tau * gone));
  }
  return filtered;
}
