// SPDX-License-Identifier: BSD-3-Clause
// The few kinds of failure. Only main turns them into an exit status.
#pragma once

#include <stdexcept>
#include <string>

namespace birdstrike {

//! What the user gave is wrong: a key, a file, a mesh, a parameter. Exit status 2.
struct InputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

//! The calculation itself cannot go on: a NaN, a lost particle, a vanishing time step. Exit status 1.
struct RunError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

//! The disk refused: a folder or a file that cannot be written. Exit status 1.
struct OutputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

//! Throw InputError with \p message unless \p condition holds.
inline void require(bool condition, const std::string& message)
{
  if (!condition)
    throw InputError(message);
}

} // namespace birdstrike
