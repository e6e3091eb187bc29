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
  int width = 0,
      height = 0; //!< of the whole picture [pixel], in place of those of a panel; 0: as the panels make it
  std::vector<std::string> captions; //!< behind the letters of the panels; empty: their times
  std::vector<SnapshotOptions>
      looks; //!< of the panels, where view or cut differ between them; empty: all alike
  MontageOptions()
  {
    snapshot.width = 800;
    snapshot.height = 450;
    snapshot.axes = false;
  }
};

//! Letters and times run row by row; one legend stands below all panels, axes and scale bar, if asked for, in the
//! first one and wherever the camera stands elsewhere than before.
//! \param frames  2 to 26; with colour by an array and no range the range is that of all frames
//! \throw InputError or OutputError as Snapshot
void write_montage(const std::vector<Frame>& frames, const Bounds& bounds, const MontageOptions& options,
                   const std::filesystem::path& png);

//! The same as an image. \param checks  if not null: what is on each panel, as Snapshot::check tells it
vtkSmartPointer<vtkImageData> draw_montage(const std::vector<Frame>& frames, const Bounds& bounds,
                                           const MontageOptions& options,
                                           std::vector<PictureCheck>* checks = nullptr);

} // namespace birdstrike
