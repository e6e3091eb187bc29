// SPDX-License-Identifier: BSD-3-Clause
// Sets that grow together.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

class UnionFind
{
public:
  explicit UnionFind(std::size_t count) : Parent(count)
  {
    std::iota(Parent.begin(), Parent.end(), std::size_t(0));
  }

  //! The lowest member of the set.
  std::size_t Find(std::size_t a)
  {
    while (this->Parent[a] != a) {
      this->Parent[a] = this->Parent[this->Parent[a]];
      a = this->Parent[a];
    }
    return a;
  }

  void Join(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    if (a < b)
      this->Parent[b] = a;
    else
      this->Parent[a] = b;
  }

private:
  std::vector<std::size_t> Parent;
};
