// SPDX-License-Identifier: BSD-3-Clause
// What of a run goes into its series, and how small.
#pragma once

#include <string>
#include <vector>

namespace birdstrike {

//! Of a VTK XML file. ParaView 5.11 reads them all; lzma is the smallest and takes ten times as long as zlib, lz4 the
//! fastest.
enum class Compression
{
  none,
  lz4,
  zlib,
  lzma
};

struct SeriesOptions
{
  bool vtu = true;     //!< run.pvd with a .vtu file a piece and frame: opens everywhere
  bool packed = false; //!< run.bss, one file for the whole run, a tenth of the size: see filters/series
  bool single_precision = false;               //!< places and fields as 32-bit numbers
  Compression compression = Compression::zlib; //!< of .vtu files
  double accuracy = 1e-4;  //!< of packed frames, as WriteFrame in filters/series/PackedFrame.h has it [-]
  bool background = false; //!< frames are written by a thread of their own while the caller goes on
  std::vector<std::string>
      fields; //!< names of core/fields.h that are wanted, besides those of thin_grid.h; empty: all
};

} // namespace birdstrike
