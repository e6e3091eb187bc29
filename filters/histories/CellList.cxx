// SPDX-License-Identifier: BSD-3-Clause
// Who is near: points sorted into cubic cells, of which only those with points exist.
#include "CellList.h"

#include <numeric>

CellList::CellList(const std::vector<Vector3d>& points, double reach) : Edge(reach)
{
  if (!points.empty())
    this->Low = points.front();
  for (const Vector3d& point : points)
    for (std::size_t k = 0; k < 3; ++k)
      this->Low[k] = std::min(this->Low[k], point[k]);

  std::vector<Cell> cells(points.size());
  std::transform(points.begin(), points.end(), cells.begin(),
                 [this](const Vector3d& p) { return this->CellOf(p); });
  this->Rows.resize(points.size());
  std::iota(this->Rows.begin(), this->Rows.end(), std::size_t(0));
  std::sort(this->Rows.begin(), this->Rows.end(),
            [&](std::size_t a, std::size_t b) { return cells[a] != cells[b] ? cells[a] < cells[b] : a < b; });

  for (std::size_t n = 0; n < this->Rows.size(); ++n) {
    const Cell& cell = cells[this->Rows[n]];
    if (n > 0 && cell == cells[this->Rows[n - 1]])
      continue;
    if (this->Columns.empty() || this->Columns.back().X != cell[0] || this->Columns.back().Y != cell[1]) {
      const auto first = static_cast<std::ptrdiff_t>(this->Heights.size());
      this->Columns.push_back({cell[0], cell[1], first, first});
    }
    this->Starts.push_back(n);
    this->Heights.push_back(cell[2]);
    this->Columns.back().Last = static_cast<std::ptrdiff_t>(this->Heights.size());
  }
  this->Starts.push_back(this->Rows.size());

  std::size_t size = 16;
  while (size < 3 * this->Columns.size())
    size *= 2;
  this->Slots.assign(size, NoColumn);
  for (std::size_t c = 0; c < this->Columns.size(); ++c) {
    std::size_t slot = this->SlotOf(this->Columns[c].X, this->Columns[c].Y);
    while (this->Slots[slot] != NoColumn)
      slot = (slot + 1) & (size - 1);
    this->Slots[slot] = c;
  }
}

CellList::Cell CellList::CellOf(const Vector3d& place) const
{
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k)
    cell[k] = static_cast<std::int64_t>(
        std::clamp(std::floor((place[k] - this->Low[k]) / this->Edge), -9e18, 9e18));
  return cell;
}

std::size_t CellList::SlotOf(std::int64_t x, std::int64_t y) const
{
  std::uint64_t hash = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 29)) + static_cast<std::uint64_t>(y) * 0xbf58476d1ce4e5b9u;
  hash ^= hash >> 32;
  return hash & (this->Slots.size() - 1);
}

std::size_t CellList::FindColumn(std::int64_t x, std::int64_t y) const
{
  for (std::size_t slot = this->SlotOf(x, y);; slot = (slot + 1) & (this->Slots.size() - 1)) {
    const std::size_t column = this->Slots[slot];
    if (column == NoColumn || (this->Columns[column].X == x && this->Columns[column].Y == y))
      return column;
  }
}
