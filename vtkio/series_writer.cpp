// SPDX-License-Identifier: BSD-3-Clause
// A run's frames on disk, as a series that ParaView opens at any moment.
#include "vtkio/series_writer.h"

#include "core/error.h"
#include "filters/series/PackedFile.h"
#include "vtkio/atomic_file.h"
#include "vtkio/thin_grid.h"
#include "vtkio/write_vtk_xml.h"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

namespace birdstrike {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t always_listed = 1000; // frames

// Of one of our own frames, whole or half written: bird_0012.vtu, target_0003.vtu.tmp
bool is_frame(std::string_view name)
{
  for (const std::string_view start : {"bird_", "target_"})
    for (const std::string_view end : {".vtu", ".vtu.tmp"})
      if (name.size() > start.size() + end.size() && name.starts_with(start) && name.ends_with(end)) {
        const std::string_view number = name.substr(start.size(), name.size() - start.size() - end.size());
        if (number.find_first_not_of("0123456789") == std::string_view::npos)
          return true;
      }
  return false;
}

// An older run's frames would stay behind a shorter new series, so they go; the index goes first, so that no
// moment has an index without its frames.
void remove_old_series(const fs::path& folder)
{
  std::error_code error;
  for (const char* name : {"run.pvd", "run.bss"}) {
    fs::remove(folder / name, error);
    if (error)
      throw OutputError("cannot replace " + (folder / name).string() + ": " + error.message());
  }
  if (!fs::exists(folder / "frames", error))
    return;
  const auto check = [&] {
    if (error)
      throw OutputError("cannot clear the folder " + (folder / "frames").string() + ": " + error.message());
  };
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder / "frames", error))
    if (is_frame(entry.path().filename().string()))
      old.push_back(entry.path());
  check();
  for (const fs::path& file : old) {
    fs::remove(file, error);
    check();
  }
}

} // namespace

SeriesWriter::SeriesWriter(fs::path folder, SeriesOptions options)
    : folder_(std::move(folder)), options_(std::move(options))
{
  make_folder(options_.vtu ? folder_ / "frames" : folder_);
  remove_old_series(folder_);
  if (!options_.packed)
    return;
  try {
    packed_ = std::make_unique<PackedWriter>((folder_ / "run.bss").string(), options_.accuracy);
  } catch (const std::runtime_error& error) {
    throw OutputError(fmt::format("cannot write {}: {}", (folder_ / "run.bss").string(), error.what()));
  }
}

SeriesWriter::~SeriesWriter()
{
  try {
    finish();
  } catch (const std::exception&) { // somebody who wants to know calls finish()
  }
}

//! Waits for the frame in the background.
void SeriesWriter::settle() const
{
  if (pending_.valid())
    pending_.wait();
}

//! What went wrong in the background, once.
void SeriesWriter::rethrow()
{
  if (pending_.valid())
    pending_.get();
}

std::size_t SeriesWriter::frames() const
{
  settle();
  return frames_;
}

std::uintmax_t SeriesWriter::bytes() const
{
  settle();
  return bytes_;
}

void SeriesWriter::finish()
{
  rethrow();
  list_frames();
}

void SeriesWriter::list_frames()
{
  if (!options_.vtu || listed_ == frames_)
    return;
  write_text_atomically(folder_ / "run.pvd",
                        "<?xml version=\"1.0\"?>\n"
                        "<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" +
                            entries_ + "  </Collection>\n</VTKFile>\n");
  listed_ = frames_;
}

void SeriesWriter::discard()
{
  settle();
  pending_ = {};
  packed_.reset();
  remove_old_series(folder_);
  listed_ = frames_;
}

void SeriesWriter::write_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target)
{
  if (!std::isfinite(time))
    throw OutputError(fmt::format("cannot write a frame at time {}: it is not finite", time));
  rethrow();
  const auto thin_bird = thin_grid(bird, options_);
  const auto thin_target = target ? thin_grid(*target, options_) : nullptr;
  if (options_.background)
    try {
      pending_ = std::async(std::launch::async,
                            [this, time, thin_bird, thin_target] { write(time, *thin_bird, thin_target); });
      return;
    } catch (const std::system_error&) { // no thread to be had: at once, then
    }
  write(time, *thin_bird, thin_target);
}

void SeriesWriter::write(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target)
{
  if (options_.vtu)
    write_vtu_frame(time, bird, target);
  if (packed_)
    write_packed_frame(time, bird, target);
  ++frames_;
  // Only now, with all its files whole, does the frame count. Of very many, some are listed together: the whole index is
  // written each time.
  if (frames_ - listed_ > frames_ / (always_listed + 1))
    list_frames();
}

void SeriesWriter::write_vtu_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target)
{
  std::uintmax_t bytes = 0;
  const auto write = [&](vtkUnstructuredGrid& grid, const char* name) {
    const std::string piece = fmt::format("frames/{}_{:04}.vtu", name, frames_);
    write_atomically(folder_ / piece, [&](const fs::path& file) {
      return write_vtk_xml(*vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), grid, file,
                           options_.compression);
    });
    std::error_code unknown;
    if (const std::uintmax_t size = fs::file_size(folder_ / piece, unknown); !unknown)
      bytes += size;
    return piece;
  };
  const auto entry = [&](const char* name, int part, const std::string& piece) {
    return fmt::format("    <DataSet timestep=\"{:.17g}\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n", time,
                       part, name, piece);
  };
  std::string entries = entry("bird", 0, write(bird, "bird"));
  if (target) {
    if (!target_ || !same_state(*target_, *target)) {
      target_piece_ = write(*target, "target");
      target_ = target;
    }
    entries += entry("target", 1, target_piece_);
  }
  entries_ += entries;
  bytes_ += bytes;
}

void SeriesWriter::write_packed_frame(double time, vtkUnstructuredGrid& bird, vtkUnstructuredGrid* target)
{
  std::vector<NamedGrid> pieces{{"bird", &bird}};
  if (target)
    pieces.emplace_back("target", target);
  const std::uint64_t before = frames_ > 0 ? packed_->Bytes() : 0;
  try {
    packed_->Write(time, pieces);
  } catch (const std::runtime_error& error) {
    throw OutputError(fmt::format("cannot write {}: {}", (folder_ / "run.bss").string(), error.what()));
  }
  bytes_ += packed_->Bytes() - before;
}

} // namespace birdstrike
