// SPDX-License-Identifier: BSD-3-Clause
#include "core/contact/search.h"

#include <cmath>

namespace birdstrike {

namespace {

struct Box
{
  Vector3 low, high;
};

Box box_of(const ContactSurface& surface, std::size_t element, double wider)
{
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const std::int32_t node : surface.mesh.elements[element]) {
    low = low.cwiseMin(surface.position[static_cast<std::size_t>(node)]);
    high = high.cwiseMax(surface.position[static_cast<std::size_t>(node)]);
  }
  return {low.array() - wider, high.array() + wider};
}

} // namespace

void ElementBins::update(const ContactSurface& surface)
{
  if (!holds(surface))
    build(surface);
}

bool ElementBins::holds(const ContactSurface& surface) const
{
  if (built_at_.size() != surface.position.size())
    return false;
  for (std::size_t i = 0; i < built_at_.size(); ++i)
    if (used_[i] && !((surface.position[i] - built_at_[i]).squaredNorm() <= skin_ * skin_))
      return false;
  return true;
}

void ElementBins::build(const ContactSurface& surface)
{
  const std::size_t elements = surface.mesh.elements.size();
  const auto wider = [&](std::size_t e) { return near_ + skin_ + 0.5 * surface.thickness[e]; };
  used_.assign(surface.position.size(), 0);
  balls_.resize(elements);
  Vector3 low = Vector3::Constant(1e300), high = -low;
  double size = 0;
  std::size_t whole = 0;
  for (std::size_t e = 0; e < elements; ++e) {
    if (surface.gone[e])
      continue;
    const Box box = box_of(surface, e, wider(e));
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
    balls_[e].middle = 0.5 * (box.low + box.high);
    double radius2 = 0;
    for (const std::int32_t node : surface.mesh.elements[e])
      radius2 = std::max(radius2,
                         (surface.position[static_cast<std::size_t>(node)] - balls_[e].middle).squaredNorm());
    balls_[e].radius = std::sqrt(radius2) + skin_;
    size += (box.high - box.low).maxCoeff();
    ++whole;
    for (const std::int32_t node : surface.mesh.elements[e])
      used_[static_cast<std::size_t>(node)] = 1;
  }
  built_at_.assign(surface.position.begin(), surface.position.end());
  ++builds_;
  if (whole == 0 || !(high - low).allFinite()) { // whoever checks the shells reports what is not finite
    low_ = high_ = Vector3::Zero();
    return;
  }

  // Half a mean box is a width that keeps both the lists and the copies in them short; a wide and empty space gets fewer.
  const double most = 1000 + 32.0 * static_cast<double>(whole);
  double width = 0.5 * size / static_cast<double>(whole);
  const auto cells = [&] { return ((high - low) / width).array().ceil().max(1.0).prod(); };
  while (cells() > most)
    width *= 1.1;
  low_ = low;
  high_ = high;
  per_width_ = 1 / width;
  for (int k = 0; k < 3; ++k)
    count_[k] = static_cast<std::size_t>(std::max(1.0, std::ceil((high[k] - low[k]) / width)));

  const auto for_each_cell = [&](std::size_t e, const auto& f) {
    const Box box = box_of(surface, e, wider(e));
    std::array<std::size_t, 3> first, last;
    for (int k = 0; k < 3; ++k) {
      first[k] = std::min(static_cast<std::size_t>((box.low[k] - low_[k]) * per_width_), count_[k] - 1);
      last[k] = std::min(static_cast<std::size_t>((box.high[k] - low_[k]) * per_width_), count_[k] - 1);
    }
    for (std::size_t i = first[0]; i <= last[0]; ++i)
      for (std::size_t j = first[1]; j <= last[1]; ++j)
        for (std::size_t k = first[2]; k <= last[2]; ++k)
          f((i * count_[1] + j) * count_[2] + k);
  };
  const std::size_t total = count_[0] * count_[1] * count_[2];
  begin_.assign(total + 2, 0); // begin_[c + 2] counts, then begin_[c + 1] runs
  for (std::size_t e = 0; e < elements; ++e)
    if (!surface.gone[e])
      for_each_cell(e, [&](std::size_t c) { ++begin_[c + 2]; });
  for (std::size_t c = 2; c < begin_.size(); ++c)
    begin_[c] += begin_[c - 1];
  elements_.resize(begin_.back());
  for (std::size_t e = 0; e < elements; ++e)
    if (!surface.gone[e])
      for_each_cell(e, [&](std::size_t c) { elements_[begin_[c + 1]++] = static_cast<std::int32_t>(e); });
}

} // namespace birdstrike
