// SPDX-License-Identifier: GPL-3.0-or-later
// A TOML table of which every key has to be known: it is asked for them one by one, then for what is left.
#pragma once

#include "cases/toml_entries.h"

#include <string>
#include <vector>

namespace birdstrike {

class StrictTable
{
public:
  //! \param name  of the table in messages, "sweep"; empty for the file itself
  StrictTable(const toml::table& table, std::string file, std::string name, int line);

  std::string place(const std::string& key = "") const;                             //!< "study.toml:12"
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const; //!< throws InputError

  //! The value of a key, or null. It counts as known from then on.
  const toml::node* find(const std::string& key);
  std::string text(const std::string& key); //!< "" if it is not there
  std::string needed(const std::string& key,
                     const std::string& what);            //!< \throw InputError if it is not there
  bool flag(const std::string& key);                      //!< false if it is not there
  std::vector<std::string> texts(const std::string& key); //!< a list; one text counts as a list of one
  std::vector<StrictTable> tables(const std::string& key);

  void
  finish() const; //!< \throw InputError if a key is left that nobody asked for, with the nearest known one

  const toml::table& table() const { return *table_; }
  const std::string& file() const { return file_; }

private:
  std::string full(const std::string& key) const { return name_.empty() ? key : name_ + "." + key; }

  const toml::table* table_;
  std::string file_, name_;
  int line_;
  std::vector<std::string> known_;
};

} // namespace birdstrike
