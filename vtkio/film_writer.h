// SPDX-License-Identifier: BSD-3-Clause
// Pictures one after the other as a film, by the program ffmpeg.
#pragma once

#include <filesystem>
#include <memory>

class vtkImageData;

namespace birdstrike {

//! Whether the program ffmpeg is on the path.
bool have_ffmpeg();

//! H.264 in an .mp4 that all players show (yuv420p). The film is written under another name and gets its own when it
//! is whole; what was begun is removed if finish() is not reached, and if the program is told to end (SIGINT, SIGTERM,
//! SIGHUP) before. One film at a time.
class FilmWriter
{
public:
  //! \param width, height  [pixel], both even
  //! \param fps            pictures a second
  //! \throw InputError if sizes are odd or fps is not positive; OutputError if ffmpeg is not installed or does not start
  FilmWriter(std::filesystem::path film, int width, int height, double fps);
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  //! \param image  RGB, 8 bits each, of that size. \throw OutputError with what ffmpeg said if it has given up
  void add(vtkImageData& image);

  //! \throw OutputError with what ffmpeg said if it failed
  void finish();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace birdstrike
