// SPDX-License-Identifier: GPL-3.0-or-later
// The part that an object of a CAD file belongs to, by its name.
#pragma once

#include <string>
#include <vector>

namespace birdstrike {

//! Objects whose whole name fits a pattern belong to a part. Case does not matter; '*' stands for any letters, '?' for one.
struct PartPattern
{
  std::string pattern, part;
};

//! By the first of \p own that fits; else an object whose very name is one of \p parts is that part; else by the words that
//! it contains: wing_left and Wing.R are "wings", spine, keel and rib_3 are "bones", body is "torso".
//! \throw InputError naming the object and all known patterns when none fits
std::string part_of_object(const std::string& object_name, const std::vector<PartPattern>& own = {},
                           const std::vector<std::string>& parts = {});

} // namespace birdstrike
