// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a series over time, with some of their fields, to be packed into a page.
#pragma once

#include "vtkio/packed_text.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace birdstrike {

struct TrackedField
{
  const char* array; //!< of points or cells; of vectors the length is meant
  const char* title;
  const char* unit; //!< to show it in
  double factor;    //!< from SI to that unit
};

class Tracks
{
public:
  //! \param first   grid of the first frame: those of \p fields that it has are followed
  //! \param points  which points
  Tracks(vtkUnstructuredGrid& first, std::vector<std::size_t> points, std::span<const TrackedField> fields);

  //! \throw InputError if a frame has not the points, cells and arrays of the first one
  void check(vtkUnstructuredGrid& grid) const;
  void append(vtkUnstructuredGrid& grid); //!< one that check has passed

  //! Adds low, high (the box), moves, position, fields [{name, title, unit, of, low, high, beyond, values}] and, where
  //! cells have gone, gone. Fields that are the same everywhere and always are left out.
  void add_to(nlohmann::ordered_json& json) const;

private:
  struct Field
  {
    TrackedField what;
    bool of_cells;
    std::vector<float> values; //!< frame after frame, in the unit to show
  };
  std::size_t all_points_, cells_;
  std::vector<std::size_t> points_;
  std::vector<float> position_; //!< frame after frame, x y z [m]
  std::vector<std::uint8_t> gone_;
  std::vector<Field> fields_;
};

} // namespace birdstrike
