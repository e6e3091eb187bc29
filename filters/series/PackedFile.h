// SPDX-License-Identifier: BSD-3-Clause
/**
 * A packed series on disk: a whole run in one file that only grows, so that it opens at any moment, also after the run
 * was killed.
 *
 * Layout, little-endian: 16 bytes "BIRDSTRIKE PACK2"; then frame after frame: uint64 bytes before packing, uint64
 * bytes packed, double time [s], uint64 1 for a key frame, else 0, uint64 FNV-1a checksum of these four; then the packed
 * bytes (zlib, which has a checksum of its own). The first frame holds everything exactly. A later one holds, array by array, what has changed since the frame before (a key frame: since
 * the first) beyond a tolerance; points are foretold by velocities. A frame that is cut short is absent.
 */
#pragma once

#include "PackedFrame.h"

#include "vtkSmartPointer.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

class vtkUnstructuredGrid;

using NamedGrid = std::pair<std::string, vtkSmartPointer<vtkUnstructuredGrid>>;

class BIRDSTRIKESERIES_EXPORT PackedWriter
{
public:
  //! \param accuracy  largest error, see WriteFrame; 0: none \throw std::runtime_error with the system's reason
  PackedWriter(std::string file, double accuracy);
  ~PackedWriter();
  PackedWriter(const PackedWriter&) = delete;
  PackedWriter& operator=(const PackedWriter&) = delete;

  //! Append a state; all of it is on its way to the disk when this returns.
  //! \param pieces  the same ones, with the same cells and arrays, as in the first frame
  //! \throw std::runtime_error with the reason
  void Write(double time, const std::vector<NamedGrid>& pieces);

  std::uint64_t Bytes() const { return this->Size; } //!< of the file so far

private:
  std::string Name;
  double Accuracy;
  std::FILE* File = nullptr;
  std::uint64_t Size = 0;
  std::size_t Frames = 0;
  PackedState First, Last;
};

class BIRDSTRIKESERIES_EXPORT PackedFile
{
public:
  //! Read the times and the first frame. \throw std::runtime_error if it is no such file or has no whole frame
  explicit PackedFile(std::string file);

  const std::vector<double>& Times() const { return this->FrameTimes; } //!< [s], rising

  //! What the file has after its last whole frame, a frame that was cut short, or damage and all behind it, in words
  //! for a warning; empty if there is nothing.
  const std::string& Complaint() const { return this->Rest; }

  //! Fast for the frame after the one read last; others need those since the key frame before.
  //! \throw std::runtime_error if the file is damaged there
  std::vector<NamedGrid> Read(std::size_t frame);

private:
  struct Entry
  {
    std::uint64_t Offset, RawSize, Size;
    bool Key;
  };
  std::vector<unsigned char> Unpack(std::size_t frame);

  std::string Name;
  std::ifstream In;
  std::vector<Entry> Entries;
  std::vector<double> FrameTimes;
  std::string Rest; // Complaint
  PackedState First, State;
  std::size_t At = 0; //!< the frame that State is
};
