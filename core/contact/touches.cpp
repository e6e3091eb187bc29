// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/touches.h"

namespace birdstrike {

namespace {

//! How foot i stands before foot j.
struct Order
{
  double facing;           // C_ij [-]
  double part;             // h_ji^2 / (h_ij^2 + h_ji^2) [-]
  double slope_i, slope_j; // of its logarithm over d_i and d_j [1/m]
};

Order order(const Touch& i, const Touch& j)
{
  const double least2 = 1e-16 * i.reach * i.reach; // a height that counts as none, squared
  const double facing = i.normal.dot(j.normal);
  const Vector3 between = j.foot - i.foot;
  const double above = std::max(0.0, i.normal.dot(between)), below = std::max(0.0, -j.normal.dot(between));
  const double own = below * below + least2, both = own + above * above + least2;
  const double over_below = 2 * below * (1 / own - 1 / both), over_above = -2 * above / both;
  return {facing, own / both, over_above - facing * over_below, over_below - facing * over_above};
}

} // namespace

std::span<Touch> leave_standing(std::span<Touch> touches)
{
  std::sort(touches.begin(), touches.end(),
            [](const Touch& a, const Touch& b) { return a.distance < b.distance; });
  std::size_t kept = 0;
  for (std::size_t j = 0; j < touches.size(); ++j) {
    const Touch& touch = touches[j];
    const bool stands = std::all_of(
        touches.begin(), touches.begin() + static_cast<std::ptrdiff_t>(kept),
        [&](const Touch& i) { return i.normal.dot(touch.foot - i.foot) > least_height * i.reach; });
    if (stands) {
      if (kept != j)
        touches[kept] = touch;
      ++kept;
    }
  }
  return touches.first(kept);
}

void share_out(std::span<Touch> touches)
{
  const std::size_t n = touches.size();
  if (n == 1) {
    touches[0].share = 1;
    touches[0].force = touches[0].spring.force;
  }
  if (n < 2)
    return;
  std::array<double, most_touches> score, total;
  for (std::size_t i = 0; i < n; ++i) {
    score[i] = touches[i].reach - touches[i].distance;
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        score[i] *= order(touches[i], touches[j]).part;
  }
  for (std::size_t i = 0; i < n; ++i) {
    Touch& touch = touches[i];
    total[i] = score[i];
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        total[i] += std::max(0.0, touch.normal.dot(touches[j].normal)) * score[j];
    touch.share = total[i] > 0 ? score[i] / total[i] : 0;
    touch.force = touch.share * touch.spring.force;
  }
  for (std::size_t i = 0; i < n; ++i) {
    Touch& touch = touches[i];
    if (!(score[i] > 0))
      continue;
    double slope =
        touch.spring.energy * touch.share * (1 - touch.share); // of U over the logarithm of the score [J]
    for (std::size_t k = 0; k < n; ++k)
      if (k != i && total[k] > 0)
        slope -= touches[k].spring.energy * touches[k].share *
                 std::max(0.0, touch.normal.dot(touches[k].normal)) * score[i] / total[k];
    touch.force += slope / (touch.reach - touch.distance);
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) {
        const Order o = order(touch, touches[j]);
        touch.force -= slope * o.slope_i;
        touches[j].force -= slope * o.slope_j;
      }
  }
}

} // namespace birdstrike
