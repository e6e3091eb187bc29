// SPDX-License-Identifier: BSD-3-Clause
// Several frames in one picture, lettered a), b), c) ..., as figures 8.8 and 8.9 of the dissertation are.
#pragma once

#include "vtkio/snapshot.h"

#include <filesystem>
#include <vector>

namespace birdstrike {

struct MontageOptions
{
  int columns = 2; //!< 2 x 4 upright or 4 x 2 lying, for eight frames
  SnapshotOptions
      snapshot; //!< of every panel; width and height are those of a panel, title that of the picture
  MontageOptions()
  {
    snapshot.width = 800;
    snapshot.height = 450;
  }
};

//! Letters and times run row by row; one legend stands below all panels.
//! \param frames  2 to 26; with colour by an array and no range the range is that of all frames
//! \throw InputError or OutputError as Snapshot
void write_montage(const std::vector<Frame>& frames, const Bounds& bounds, const MontageOptions& options,
                   const std::filesystem::path& png);

} // namespace birdstrike
