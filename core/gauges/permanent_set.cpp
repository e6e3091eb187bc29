// SPDX-License-Identifier: BSD-3-Clause
// What stays of a target's deflection once it has come to rest.
#include "core/gauges/permanent_set.h"

namespace birdstrike {

void PermanentSet::record(const MeshTarget& target, double time)
{
  if (time < from_ || !target.shells())
    return;
  const bool first = nodes_.empty();
  if (first) {
    nodes_.resize(target.mesh().points.size());
    first_ = time;
  }
  const double half = first ? 0 : (time - last_) / 2; // trapezoidal rule
  last_ = time;
  const MeshTarget::TurnBack back = target.turn_back(time);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    const Vector3 u = target.displacement(n, back);
    node.sum += half * (node.now + u);
    node.low = first ? u : Vector3(node.low.cwiseMin(u));
    node.high = first ? u : Vector3(node.high.cwiseMax(u));
    node.now = u;
  }
}

PermanentSet::Largest PermanentSet::largest(const MeshTarget& target) const
{
  Largest largest;
  if (nodes_.empty())
    return largest;
  for (std::size_t e = 0; e < target.mesh().elements.size(); ++e) {
    if (target.is_gone(e))
      continue;
    for (const std::int32_t corner : target.mesh().elements[e]) {
      const Node& node = nodes_[static_cast<std::size_t>(corner)];
      const Vector3 mean = last_ > first_ ? Vector3(node.sum / (last_ - first_)) : node.now;
      if (mean.norm() > largest.set)
        largest = {mean.norm(), (node.high - mean).cwiseMax(mean - node.low).norm()};
    }
  }
  return largest;
}

} // namespace birdstrike
