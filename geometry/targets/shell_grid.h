// SPDX-License-Identifier: GPL-3.0-or-later
// Rows and columns of quads, the stuff that generated targets are made of.
#pragma once

#include "core/shells/mesh.h"

#include <functional>

namespace birdstrike {

//! Rows of mesh.points: corner (i, j) of a grid of columns x rows quads.
struct ShellGrid
{
  int columns, rows; //!< numbers of elements
  std::vector<std::int32_t> corner;

  std::int32_t at(int i, int j) const { return corner[static_cast<std::size_t>(j) * (columns + 1) + i]; }
  std::vector<std::int32_t> column(int i) const; //!< corners of a line of constant i, ascending j
  std::vector<std::int32_t> row(int j) const;    //!< corners of a line of constant j, ascending i
  std::vector<std::int32_t> edges() const;       //!< all corners on the rim, each once, ascending
};

//! Most elements of a generated target: what can still be drawn and stored.
constexpr double most_target_elements = 4e6;

//! \throw InputError naming \p key unless every number of elements is at least \p least and their product is
//! no more than most_target_elements
void require_elements(const std::string& key, std::initializer_list<int> numbers, int least = 1);
//! \throw InputError naming \p key and the value unless it is finite and positive
void require_positive(const std::string& key, double value, const std::string& unit = "m");
//! \throw InputError naming \p key and the value unless low <= value <= high
void require_between(const std::string& key, double value, double low, double high, const std::string& unit);

//! Add corners and quads of a grid to the mesh. Going along i and then along j turns clockwise seen from the
//! outer side, as +y and then +z do for the bird, which looks along +x.
//! \param place  of corner (i, j) [m] \param part  row in mesh.parts of element (i, j)
//! \param first_column  corners that are there already (row j of them is column 0, rows + 1 in all), or none
ShellGrid add_grid(ShellMesh& mesh, int columns, int rows, const std::function<Vector3(int, int)>& place,
                   const std::function<int(int, int)>& part,
                   const std::vector<std::int32_t>& first_column = {});

//! Ascending, each once.
std::vector<std::int32_t> united(std::initializer_list<std::vector<std::int32_t>> sets);

} // namespace birdstrike
