// SPDX-License-Identifier: BSD-3-Clause
// Pieces of debris: what they weigh and how they fly.
#include "Fragment.h"

#include <numeric>

Fragments SumFragments(const std::vector<FragmentItem>& items, const std::vector<std::size_t>& root,
                       bool massive, std::int64_t minimum)
{
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number(items.size(), none); // of the fragment of a root
  std::vector<Fragment> all;
  std::vector<double> weights;
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::size_t& f = number[root[i]];
    if (f == none) {
      f = all.size();
      all.emplace_back();
      weights.push_back(0);
    }
    const FragmentItem& item = items[i];
    const double weight = massive ? item.Mass : 1;
    Fragment& fragment = all[f];
    ++fragment.Count;
    fragment.Mass += item.Mass;
    fragment.KineticEnergy += item.Energy;
    weights[f] += weight;
    for (std::size_t k = 0; k < 3; ++k) {
      fragment.Centre[k] += weight * item.Centre[k];
      fragment.Velocity[k] += weight * item.Velocity[k];
      fragment.Momentum[k] += item.Mass * item.Velocity[k];
    }
  }
  for (std::size_t f = 0; f < all.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) { // without any mass there is no centre: NaN
      all[f].Centre[k] /= weights[f];
      all[f].Velocity[k] /= weights[f];
    }
    all[f].KineticEnergyOfCentre = 0.5 * all[f].Mass * DistanceSquared(all[f].Velocity, {});
  }

  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto mass = [&](std::size_t f) { return all[f].Mass >= 0 ? all[f].Mass : -1; }; // NaN last
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (mass(a) != mass(b))
      return mass(a) > mass(b);
    return all[a].Count != all[b].Count ? all[a].Count > all[b].Count : a < b;
  });
  Fragments result;
  std::vector<std::int64_t> place(all.size(), -1);
  for (const std::size_t f : order)
    if (all[f].Count >= minimum) {
      place[f] = static_cast<std::int64_t>(result.Rows.size());
      result.Rows.push_back(all[f]);
    }
  for (std::size_t i = 0; i < items.size(); ++i)
    result.Of.push_back(place[number[root[i]]]);
  return result;
}
