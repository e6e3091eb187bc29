// SPDX-License-Identifier: BSD-3-Clause
// Mean of vectors over the end of a series, and how far they swing about it.
#include "TrailingMean.h"

#include <algorithm>
#include <cmath>
#include <limits>

void TrailingMean::Start(const std::vector<double>& times, double share)
{
  *this = TrailingMean();
  const std::size_t count = times.size();
  // Written times are rounded: a step on the window's edge belongs to it.
  const double reach = share * (times.back() - times.front()) * (1 + 1e-9);
  this->First = count - 1;
  while (this->First > 0 && times.back() - times[this->First - 1] <= reach)
    --this->First;

  double sum = 0;
  for (std::size_t k = this->First; k < count; ++k) {
    const double before = times[std::max(k, this->First + 1) - 1], after = times[std::min(k + 1, count - 1)];
    this->Weights.push_back((after - before) / 2);
    sum += this->Weights.back();
  }
  for (double& weight : this->Weights)
    weight = sum > 0 ? weight / sum : 1.0 / static_cast<double>(this->Weights.size());
}

void TrailingMean::Add(std::size_t step, const std::vector<Vector>& values)
{
  if (step < this->First || step - this->First >= this->Weights.size())
    return;
  if (this->Added == 0) {
    constexpr double none = std::numeric_limits<double>::infinity();
    this->Sums.assign(values.size(), {0, 0, 0});
    this->Lows.assign(values.size(), {none, none, none});
    this->Highs.assign(values.size(), {-none, -none, -none});
  }
  ++this->Added;
  this->Fine = this->Fine && values.size() == this->Sums.size();
  if (!this->Fine)
    return;
  const double weight = this->Weights[step - this->First];
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      this->Sums[i][k] += weight * values[i][k];
      this->Lows[i][k] = std::min(this->Lows[i][k], values[i][k]);
      this->Highs[i][k] = std::max(this->Highs[i][k], values[i][k]);
    }
}

TrailingMean::Vector TrailingMean::Mean(std::size_t i) const { return this->Sums[i]; }

double TrailingMean::Amplitude(std::size_t i) const
{
  if (this->Added < 2)
    return std::numeric_limits<double>::quiet_NaN();
  Vector swing{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double mean = this->Sums[i][k];
    if (std::isnan(mean))
      return mean;
    swing[k] = std::max(this->Highs[i][k] - mean, mean - this->Lows[i][k]);
  }
  return std::hypot(swing[0], swing[1], swing[2]);
}
