// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets beside closed shells: which are dropped, which become solids.
#pragma once

#include "geometry/repair/ladder.h"

#include <optional>

namespace birdstrike {

struct SheetWork
{
  std::vector<SurfacePart> solids; //!< closed and outward, made of sheets
  SurfacePart used;                //!< the sheets that they were made of
  std::vector<std::string> actions, notes;
};

//! Drop sheets that lie inside or on the body, and small strays; make solids of the others: one body if they surround
//! one together, else each with a thickness.
//! \param body        closed shells, outward, as one part
//! \param total_area  of the whole part, which tells what is small [m2]
SheetWork place_sheets(std::vector<SurfacePart> sheets, const SurfacePart& body, double total_area,
                       const RepairSizes& sizes);

struct Wrapped
{
  SurfacePart skin;
  double alpha, offset; //!< [m]
  double refused = 0;   //!< finer alpha that was wanted but would have taken too long [m]; 0: none
};

//! Wrap a soup as a solid, with alpha from two spacings on, doubled until the skin holds more than a layer along both sides
//! of the soup; then take the offset back. Nothing if it holds no more up to a quarter of the soup's size.
std::optional<Wrapped> wrap_as_solid(const SurfacePart& soup, const RepairSizes& sizes);

//! Wrap a soup as a sheet of the thickness asked for.
Wrapped wrap_as_sheet(const SurfacePart& soup, const RepairSizes& sizes);

std::string describe(const Wrapped& wrapped); //!< "alpha 6 mm, offset 300 um", and what was refused

void append(SurfacePart& part, const SurfacePart& other);

} // namespace birdstrike
