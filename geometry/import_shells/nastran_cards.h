// SPDX-License-Identifier: GPL-3.0-or-later
// Nastran bulk data as cards, whatever the form of their fields.
#pragma once

#include "geometry/import_shells/text_lines.h"

#include <functional>
#include <string>
#include <vector>

namespace birdstrike::nastran {

//! One card with its continuation lines: small fields (8 columns), large ones (16, name with *), or free ones
//! (commas); continuation lines with + or *, or unmarked (blank first field).
struct Card
{
  std::string name;                //!< upper case, without *
  std::vector<std::string> fields; //!< behind the name; field k stands in row k + 1 of the reference guide
  std::size_t line = 0;
  std::size_t last_line = 0;

  //! Empty where the card ends before.
  const std::string& operator[](std::size_t field) const
  {
    static const std::string none;
    return field < fields.size() ? fields[field] : none;
  }
};

//! Calls take(card) for each card from row \p first of \p lines up to ENDDATA.
//! \return the number of lines behind ENDDATA
//! \throw InputError naming \p file and the line: a continuation without its card
std::size_t for_cards(const TextLines& lines, std::size_t first, const std::string& file,
                      const std::function<void(const Card&)>& take);

} // namespace birdstrike::nastran
