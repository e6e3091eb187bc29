// SPDX-License-Identifier: BSD-3-Clause
// One array of a packed series: its values as they come back, and how the next ones are told by what changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class PackedInput;
class PackedOutput;

struct PackedArray
{
  enum class Place : std::uint8_t
  {
    Points, //!< the coordinates
    PointData,
    CellData,
    FieldData
  };

  std::string Name;
  Place Where = Place::PointData;
  std::uint8_t Components = 1;
  std::int32_t Type = 11;     //!< of VTK, as VTK_DOUBLE
  std::vector<double> Values; //!< tuple after tuple
  double Scale =
      0; //!< largest magnitude of a value so far, of cells' values their mean; only the writer keeps it

  std::size_t Tuples() const { return this->Components > 0 ? this->Values.size() / this->Components : 0; }
};

//! How an array was written.
enum class PackedMode : std::uint8_t
{
  Same,    //!< nothing: the values of the state before
  Exact,   //!< all values, in the array's own type
  Changes, //!< whole numbers of quanta to add to the values foretold
  Rows     //!< values as whole numbers of quanta, told by the differences from tuple to tuple
};

/**
 * Write an array's new values, and take over in \p state what reading them will give.
 * \param state       values of the frame before, or of the first frame for a key frame
 * \param values      the new ones, as many
 * \param foretold    what a reader expects without being told, as many values; empty: those of \p state
 * \param tolerance   largest error of a value that comes back; 0: none
 * \param rows        by Rows, not by Changes: the frame has to be read without those before it
 * Integers, values that are not finite and those too large for the tolerance are written exactly.
 */
void WriteArray(PackedOutput& out, PackedArray& state, const std::vector<double>& values,
                const std::vector<double>& foretold, double tolerance, bool rows);

//! All values, exactly.
void WriteExactly(PackedOutput& out, const PackedArray& array);

//! Undo either. \throw std::runtime_error if the data cannot be
void ReadArray(PackedInput& in, PackedArray& state, const std::vector<double>& foretold);
