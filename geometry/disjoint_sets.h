// SPDX-License-Identifier: GPL-3.0-or-later
// Union and find over rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace birdstrike {

struct DisjointSets
{
  std::vector<int> parent;
  explicit DisjointSets(std::size_t count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }
  int find(int i)
  {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  }
  void unite(int i, int j)
  {
    i = find(i), j = find(j);
    parent[std::max(i, j)] = std::min(i, j);
  }

  //! Set of every row, counted from 0 in order of the sets' first rows; \p count gets the number of sets.
  std::vector<int> labels(int& count)
  {
    std::vector<int> label(parent.size());
    std::unordered_map<int, int> seen;
    for (int i = 0; i < int(parent.size()); ++i)
      label[i] = seen.try_emplace(find(i), int(seen.size())).first->second;
    count = int(seen.size());
    return label;
  }
};

} // namespace birdstrike
