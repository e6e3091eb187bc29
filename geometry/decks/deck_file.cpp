// SPDX-License-Identifier: GPL-3.0-or-later
// A text file that is either whole or not there, written piece by piece.
#include "geometry/decks/deck_file.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>

namespace birdstrike {

std::string printable(std::string_view text)
{
  std::string line;
  for (const char c : text)
    line += c >= ' ' && c < 127 ? c : c == '\n' || c == '\t' || c == '\r' ? ' ' : '_';
  return line;
}

DeckFile::DeckFile(std::filesystem::path file, std::string comment)
    : file_(std::move(file)), temporary_(file_), comment_(std::move(comment))
{
  temporary_ += ".tmp";
  errno = 0;
  out_.open(temporary_, std::ios::binary);
  if (!out_)
    fail(errno != 0 ? std::strerror(errno) : "the disk refused");
}

DeckFile::~DeckFile()
{
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void DeckFile::line(std::string_view text) { out_.write(text.data(), std::ssize(text)).put('\n'); }

void DeckFile::comment(std::string_view text) { line(comment_ + printable(text)); }

void DeckFile::comments(const std::vector<std::string>& lines)
{
  for (const std::string& text : lines)
    comment(text);
}

void DeckFile::commit()
{
  errno = 0;
  out_.close();
  if (!out_)
    fail(errno != 0 ? std::strerror(errno) : "the disk refused");
  std::error_code error;
  std::filesystem::rename(temporary_, file_, error);
  if (error)
    fail(error.message());
}

void DeckFile::fail(const std::string& reason) const
{
  throw OutputError("deck file '" + file_.string() + "' cannot be written: " + reason +
                    "; check the folder and the free space");
}

} // namespace birdstrike
