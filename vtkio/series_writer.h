// SPDX-License-Identifier: BSD-3-Clause
// A run's frames on disk, as a series that ParaView opens at any moment, also after the run was killed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

class vtkUnstructuredGrid;

namespace birdstrike {

//! Writes folder/frames/bird_0000.vtu, target_0000.vtu, ... and folder/run.pvd, which lists only complete
//! frames. Every file is written under a temporary name and then renamed.
class SeriesWriter
{
public:
  //! Makes folder and folder/frames, and removes the series that an earlier run left there.
  //! \throw OutputError naming the file and the reason
  explicit SeriesWriter(std::filesystem::path folder);

  //! Add a state to the series.
  //! \param time    physical time [s]; later than the one before
  //! \param bird    from particles_to_vtk
  //! \param target  from plate_to_vtk; null without a target
  //! \throw OutputError naming the file and the reason
  void write_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target = nullptr);

  std::size_t frames() const { return frames_; }  //!< written so far
  std::uintmax_t bytes() const { return bytes_; } //!< size of all frames written so far
  std::filesystem::path pvd() const { return folder_ / "run.pvd"; }

private:
  std::filesystem::path folder_;
  std::string entries_; //!< the DataSet elements of run.pvd so far
  std::size_t frames_ = 0;
  std::uintmax_t bytes_ = 0;
};

} // namespace birdstrike
