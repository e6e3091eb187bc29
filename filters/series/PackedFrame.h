// SPDX-License-Identifier: BSD-3-Clause
// The state of a run at one time, as a packed series holds it, and the bytes of a frame.
#pragma once

#include "BirdStrikeSeriesModule.h"
#include "PackedArray.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

//! An unstructured grid: the bird, or the target.
struct PackedPiece
{
  std::string Name;
  std::vector<unsigned char> Types;                             //!< of each cell, VTK's numbers
  std::vector<std::int64_t> Offsets, Connectivity;              //!< of the cells
  std::vector<PackedArray> Arrays;                              //!< velocity before the points that it moves
  std::map<std::string, std::vector<std::string>> FieldStrings; //!< names of parts

  const PackedArray* Find(PackedArray::Place where, const std::string& name) const;
};

struct PackedState
{
  double Time = 0; //!< [s]
  std::vector<PackedPiece> Pieces;
};

/**
 * Bytes of a run's first frame: everything, exactly.
 */
std::vector<unsigned char> WriteFirstFrame(const PackedState& first);

/**
 * Bytes of a later frame.
 * \param now       what is to be written: the same pieces and arrays as in \p state, with as many values
 * \param state     how the frame before comes back, or for a \p key frame the first one; on return, how this one does
 * \param accuracy  largest error of a value, as a share of the largest magnitude that its array had so far; in cells of
 *                  the largest mean magnitude, so that sums over the cells, as of impulses, are as exact; of the
 *                  points, as a share of the particles' spacing (field array "spacing"), or without one of 1 % of the
 *                  size of the piece
 * \throw std::runtime_error if pieces or arrays have changed
 */
std::vector<unsigned char> WriteFrame(const PackedState& now, PackedState& state, double accuracy, bool key);

//! Undo WriteFirstFrame. \throw std::runtime_error if the bytes are not such a frame
PackedState ReadFirstFrame(const std::vector<unsigned char>& bytes);

//! Undo WriteFrame. \param state  as there \throw std::runtime_error if the bytes are not such a frame
void ReadFrame(const std::vector<unsigned char>& bytes, PackedState& state);
