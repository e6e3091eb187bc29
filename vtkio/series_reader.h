// SPDX-License-Identifier: BSD-3-Clause
// Reads back what SeriesWriter wrote: the list of frames, and a frame.
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class PackedFile;
class vtkUnstructuredGrid;

namespace birdstrike {

//! One file of a time step.
struct SeriesPiece
{
  std::string name;           //!< "bird", "target"; "part_<k>" where the .pvd gives no name
  std::filesystem::path file; //!< the .pvd's folder already put in front
};

struct SeriesStep
{
  double time; //!< [s]
  std::vector<SeriesPiece> pieces;
};

struct SeriesIndex
{
  std::filesystem::path pvd;          //!< or the packed series
  std::vector<SeriesStep> steps;      //!< by rising time
  std::shared_ptr<PackedFile> packed; //!< null for a .pvd
  std::string warning{};              //!< what is wrong with it and does not matter to the steps; else empty

  //! The step whose time is nearest, the earlier one of two; steps must not be empty.
  std::size_t nearest(double time) const;
};

//! \param series  a .pvd, a packed series (.bss), or a run's folder with either
//! \throw InputError if it is missing, is neither, or lists nothing
SeriesIndex read_series_index(const std::filesystem::path& series);

//! The grids of a step, by their names. \throw InputError naming the file if a piece is missing, truncated or of
//! another kind
std::vector<std::pair<std::string, vtkSmartPointer<vtkUnstructuredGrid>>>
read_pieces(const SeriesIndex& index, std::size_t step);

//! A state read back from disk.
struct Frame
{
  double time = 0;                             //!< [s]
  vtkSmartPointer<vtkUnstructuredGrid> bird;   //!< null if the step has no such piece
  vtkSmartPointer<vtkUnstructuredGrid> target; //!< null if the step has no such piece
};

//! \throw InputError naming the file if a piece is missing, truncated or of another kind
Frame read_frame(const SeriesIndex& index, std::size_t step);

//! \throw InputError naming the file if it is missing, truncated or of another kind
vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::filesystem::path& vtu);

} // namespace birdstrike
