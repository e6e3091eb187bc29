// SPDX-License-Identifier: BSD-3-Clause
// Who is near: points sorted into cubic cells, of which only those with points exist.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using Vector3d = std::array<double, 3>;

inline double DistanceSquared(const Vector3d& a, const Vector3d& b)
{
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/**
 * Memory goes with the number of points, never with the space that they spread over. Points are met in an order
 * that depends on nothing but their rows, so that sums over them have the same bits in any thread.
 */
class CellList
{
public:
  //! \param points  finite; kept by reference
  //! \param reach   largest distance that ForEachNear is asked for [m], > 0
  CellList(const std::vector<Vector3d>& points, double reach);

  //! f(row) for every point that may lie within the reach of \p place, and for some others further away.
  template <class Function>
  void ForEachNear(const Vector3d& place, Function&& f) const
  {
    const Cell middle = this->CellOf(place);
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j) {
        // The three cells of a column follow each other.
        const Cell first{middle[0] + i, middle[1] + j, middle[2] - 1};
        const std::size_t column = this->FindColumn(first[0], first[1]);
        if (column == NoColumn)
          continue;
        auto cell = std::lower_bound(this->Heights.begin() + this->Columns[column].First,
                                     this->Heights.begin() + this->Columns[column].Last, first[2]);
        for (auto k = cell - this->Heights.begin();
             k < this->Columns[column].Last && this->Heights[static_cast<std::size_t>(k)] <= middle[2] + 1;
             ++k)
          for (std::size_t n = this->Starts[static_cast<std::size_t>(k)];
               n < this->Starts[static_cast<std::size_t>(k) + 1]; ++n)
            f(this->Rows[n]);
      }
  }

private:
  using Cell = std::array<std::int64_t, 3>;
  struct Column
  {
    std::int64_t X, Y;
    std::ptrdiff_t First, Last; // in Heights
  };
  static constexpr std::size_t NoColumn = static_cast<std::size_t>(-1);

  Cell CellOf(const Vector3d& place) const;
  std::size_t SlotOf(std::int64_t x, std::int64_t y) const;
  std::size_t FindColumn(std::int64_t x, std::int64_t y) const;

  Vector3d Low{};
  double Edge;
  std::vector<std::size_t> Rows;     // of the points, cell by cell
  std::vector<std::size_t> Starts;   // of each cell in Rows; one more at the end
  std::vector<std::int64_t> Heights; // third coordinate of each cell
  std::vector<Column> Columns;       // cells of equal first two coordinates
  std::vector<std::size_t> Slots;    // hash table of the columns, open addressing
};
