// SPDX-License-Identifier: BSD-3-Clause
// A run's frames on disk, as a series that ParaView opens at any moment, also after the run was killed.
#pragma once

#include "vtkio/series_options.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <string>

class PackedWriter;
class vtkUnstructuredGrid;

namespace birdstrike {

//! Writes folder/frames/bird_0000.vtu, target_0000.vtu, ... and folder/run.pvd, which lists only complete
//! frames: at once, or beyond a thousand of them every so many, and all at the end. Every file is written under a temporary name and then renamed. While a target does not change, frames share
//! the file of the first that shows it so. Or, or besides, folder/run.bss, which only grows: a frame that a kill cuts
//! short is passed over by its reader.
class SeriesWriter
{
public:
  //! Makes folder and folder/frames, and removes the series that an earlier run left there.
  //! \throw OutputError naming the file and the reason
  explicit SeriesWriter(std::filesystem::path folder, SeriesOptions options = {});
  ~SeriesWriter();

  //! Add a state to the series. In the background, it is written when the next call returns that waits: write_frame,
  //! finish, discard, frames or bytes; the grids must be left as they are until then, and an error comes with the next
  //! write_frame or finish.
  //! \param time    physical time [s]; later than the one before
  //! \param bird    from particles_to_vtk
  //! \param target  from plate_to_vtk; null without a target
  //! \throw OutputError naming the file and the reason
  void write_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target = nullptr);

  //! List all frames in run.pvd. The destructor does so, too, and keeps to itself if it cannot.
  //! \throw OutputError naming the file and the reason
  void finish();

  //! Take back all that was written; nothing may be added any more.
  //! \throw OutputError naming the file and the reason
  void discard();

  std::size_t frames() const;   //!< written so far
  std::uintmax_t bytes() const; //!< size of all frames written so far
  //! What opens the series: run.pvd, or run.bss where there is no other.
  std::filesystem::path path() const { return folder_ / (options_.vtu ? "run.pvd" : "run.bss"); }

private:
  void write(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target);
  void list_frames();
  void settle() const;
  void rethrow();
  void write_vtu_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target);
  void write_packed_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target);

  std::filesystem::path folder_;
  SeriesOptions options_;
  std::unique_ptr<PackedWriter> packed_;
  vtkSmartPointer<vtkUnstructuredGrid> target_; //!< as it was written last,
  std::string target_piece_;                    //!< and where
  std::string entries_;                         //!< the DataSet elements of run.pvd so far
  std::size_t frames_ = 0, listed_ = 0;         //!< the second in run.pvd
  std::uintmax_t bytes_ = 0;
  std::future<void> pending_; //!< the frame that is written in the background; last, so that it ends first
};

} // namespace birdstrike
