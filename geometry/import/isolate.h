// SPDX-License-Identifier: GPL-3.0-or-later
// Work that may crash, hang or eat all memory, done in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace birdstrike {

//! Memory is watched by the parent, and kept by the system except under AddressSanitizer, whose shadow needs
//! terabytes of address space.
struct IsolationLimits
{
  double seconds = 60;    //!< wall clock, until the child is ended [s]
  std::size_t memory = 0; //!< what the child may add to what it starts with [bytes]; 0: no limit
};

//! Run \p work in a forked copy of this process and hand back what it returns. Its standard output and error
//! lead nowhere. \p work must not start or wait for threads.
//! \param subject  begins every message, as "mesh file 'x.stl'"
//! \throw InputError  with the text of an exception that \p work throws; or saying that the reader crashed, took
//! too long or too much memory. No process and no file is left over either way
//! \throw RunError if the system has no process or pipe left
std::string run_isolated(const std::string& subject, const IsolationLimits& limits,
                         const std::function<std::string()>& work);

} // namespace birdstrike
