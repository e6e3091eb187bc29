// SPDX-License-Identifier: BSD-3-Clause
// Pictures one after the other as a film: raw pixels go through a pipe into ffmpeg.
#include "vtkio/film_writer.h"

#include "core/error.h"
#include "vtkio/atomic_file.h"

#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace birdstrike {

namespace fs = std::filesystem;

bool have_ffmpeg()
{
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::string folder = rest.substr(0, rest.find(':'));
    rest.erase(0, folder.size() + 1);
    if (access((fs::path(folder.empty() ? "." : folder) / "ffmpeg").c_str(), X_OK) == 0)
      return true;
  }
  return false;
}

namespace {

//! A pipe whose reader is gone is an error to be told, not the end of the program.
class NoPipeSignal
{
public:
  NoPipeSignal()
  {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before_);
  }
  ~NoPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }

private:
  struct sigaction before_ = {};
};

fs::path beside(fs::path file, const char* end)
{
  file += end;
  return file;
}

//! While it lives, a signal that ends the program ends ffmpeg and removes the file first.
class TidyOnSignal
{
public:
  explicit TidyOnSignal(const fs::path& file)
  {
    // The handler may call little, and a string's memory is not its own.
    file_ = fs::absolute(file).string();
    path_ = file_.c_str();
    process_ = -1;
    struct sigaction tidy = {};
    tidy.sa_handler = end;
    for (std::size_t k = 0; k < signals.size(); ++k) {
      sigaction(signals[k], nullptr, &before_[k]);
      if (before_[k].sa_handler == SIG_DFL) // not where somebody ignores or handles it
        sigaction(signals[k], &tidy, nullptr);
    }
  }
  ~TidyOnSignal()
  {
    for (std::size_t k = 0; k < signals.size(); ++k)
      sigaction(signals[k], &before_[k], nullptr);
    path_ = nullptr;
  }
  //! It is ended as well.
  void watch(pid_t process) { process_ = process; }

  TidyOnSignal(const TidyOnSignal&) = delete;
  TidyOnSignal& operator=(const TidyOnSignal&) = delete;

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

  static void end(int signal)
  {
    if (path_) {
      if (process_ > 0)
        kill(process_, SIGKILL);
      unlink(path_);
    }
    struct sigaction plain = {};
    plain.sa_handler = SIG_DFL;
    sigaction(signal, &plain, nullptr);
    raise(signal); // ends the program, with the status that the signal asks for
  }

  static inline const char* volatile path_ = nullptr;
  static inline volatile pid_t process_ = -1;
  std::string file_;
  std::array<struct sigaction, signals.size()> before_{};
};

} // namespace

struct FilmWriter::State
{
  fs::path film, unfinished;
  int width, height;
  pid_t process = -1;
  int pipe = -1, messages = -1; //!< messages: of ffmpeg, a file without a name
  std::vector<unsigned char> rows;
  std::optional<TidyOnSignal> tidy;

  State() = default;
  ~State()
  {
    std::error_code ignored;
    if (!unfinished.empty()) // not there any more where the film has been made
      fs::remove(unfinished, ignored);
    if (messages >= 0)
      close(messages);
  }

  void start(double fps);
  //! Waits for ffmpeg; whether it ended well.
  bool end();
  [[noreturn]] void give_up(const std::string& reason);
  std::string last_message() const;
};

void FilmWriter::State::start(double fps)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw OutputError(fmt::format("cannot make the film {}: {}", film.string(), std::strerror(errno)));
  std::vector<std::string> words{"ffmpeg", "-y", "-nostdin", "-loglevel", "error", "-f", "rawvideo",
                                 "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", width, height),
                                 "-framerate", fmt::format("{}", fps), "-i", "pipe:0", "-an", "-c:v",
                                 "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart",
                                 "-f", "mp4",
                                 // a name that begins with '-' would be an option
                                 fs::absolute(unfinished).string()};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  if (messages >= 0)
    posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  const int error = posix_spawnp(&process, "ffmpeg", &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  close(ends[0]);
  pipe = ends[1];
  if (error != 0) {
    process = -1;
    give_up(std::strerror(error));
  }
  tidy->watch(process);
}

bool FilmWriter::State::end()
{
  if (pipe >= 0)
    close(pipe);
  pipe = -1;
  if (process < 0)
    return false;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR)
    ;
  process = -1;
  tidy->watch(-1);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string FilmWriter::State::last_message() const
{
  std::string text(4096, '\0');
  const ssize_t size = messages >= 0 ? pread(messages, text.data(), text.size(), 0) : 0;
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
    text.pop_back();
  return text;
}

void FilmWriter::State::give_up(const std::string& reason)
{
  end();
  const std::string said = last_message();
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  throw OutputError(
      fmt::format("cannot make the film {}: ffmpeg failed: {}; is there room on the disk, and does "
                  "\"ffmpeg -encoders\" list libx264?",
                  film.string(), said.empty() ? reason : said));
}

FilmWriter::FilmWriter(fs::path film, int width, int height, double fps) : state_(std::make_unique<State>())
{
  require(width > 0 && height > 0 && width % 2 == 0 && height % 2 == 0,
          fmt::format("a film of {} x {} pixels cannot be made: both sides must be even", width, height));
  require(fps > 0 && fps <= 1000,
          fmt::format("a film of {} pictures a second cannot be made: more than 0, at "
                      "most 1000",
                      fps));
  if (!have_ffmpeg())
    throw OutputError(
        fmt::format("cannot make the film {}: the program ffmpeg is not installed; on Debian: apt "
                    "install ffmpeg",
                    film.string()));
  if (film.has_parent_path())
    make_folder(film.parent_path());
  State& s = *state_;
  s.film = std::move(film);
  s.unfinished = beside(s.film, ".tmp");
  s.width = width;
  s.height = height;
  s.tidy.emplace(s.unfinished);
  // Whether the place can be written is said before anything is drawn.
  errno = 0;
  if (!std::ofstream(s.unfinished).put('\n').flush())
    throw OutputError(fmt::format("cannot write the film {}: {}", s.film.string(), std::strerror(errno)));
  s.messages = memfd_create("ffmpeg", MFD_CLOEXEC);
  s.start(fps);
}

FilmWriter::~FilmWriter()
{
  if (state_->process < 0)
    return;
  kill(state_->process, SIGTERM); // our own child, that waits for pictures which will not come
  state_->end();
}

void FilmWriter::add(vtkImageData& image)
{
  State& s = *state_;
  int size[3];
  image.GetDimensions(size);
  require(size[0] == s.width && size[1] == s.height && image.GetNumberOfScalarComponents() == 3,
          fmt::format("the film {} has {} x {} pixels, a picture for it {} x {}", s.film.string(), s.width,
                      s.height, size[0], size[1]));
  // VTK counts rows from below.
  const std::size_t row = 3 * static_cast<std::size_t>(s.width);
  s.rows.resize(row * static_cast<std::size_t>(s.height));
  for (int y = 0; y < s.height; ++y)
    std::memcpy(s.rows.data() + row * static_cast<std::size_t>(s.height - 1 - y),
                image.GetScalarPointer(0, y, 0), row);
  const NoPipeSignal quiet;
  for (std::size_t done = 0; done < s.rows.size();) {
    const ssize_t written = write(s.pipe, s.rows.data() + done, s.rows.size() - done);
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      s.give_up(std::strerror(errno));
    done += static_cast<std::size_t>(written);
  }
}

void FilmWriter::finish()
{
  State& s = *state_;
  if (!s.end())
    s.give_up("it ended with an error");
  std::error_code error;
  fs::rename(s.unfinished, s.film, error);
  if (error)
    s.give_up(error.message());
}

} // namespace birdstrike
