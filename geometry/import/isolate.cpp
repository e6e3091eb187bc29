// SPDX-License-Identifier: GPL-3.0-or-later
// Work that may crash, hang or eat all memory, done in a process of its own: the answer comes back through a pipe
// as one letter, the length, and the bytes.
#include "geometry/import/isolate.h"

#include "core/error.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define BIRDSTRIKE_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BIRDSTRIKE_ADDRESS_SANITIZER 1
#endif
#endif

namespace birdstrike {

namespace {

#ifdef BIRDSTRIKE_ADDRESS_SANITIZER
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

constexpr char good = 'g', refused = 'r', no_memory = 'm';
constexpr std::size_t header_size = 1 + sizeof(std::uint64_t);

void limit(int resource, rlim_t value)
{
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0)
    return;
  now.rlim_cur = std::min(value, now.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

struct Memory
{
  unsigned long long space = 0, resident = 0; // [bytes]
};
Memory memory_of(const std::string& process)
{
  Memory memory;
  std::ifstream("/proc/" + process + "/statm") >> memory.space >> memory.resident;
  const auto page = static_cast<unsigned long long>(sysconf(_SC_PAGESIZE));
  return {page * memory.space, page * memory.resident};
}

bool write_all(int pipe, const char* bytes, std::size_t count)
{
  while (count > 0) {
    const ssize_t done = ::write(pipe, bytes, count);
    if (done < 0 && errno == EINTR)
      continue;
    if (done <= 0)
      return false;
    bytes += done;
    count -= std::size_t(done);
  }
  return true;
}

//! Test frameworks and sanitizers catch signals; in here a signal must end the process.
void take_default_signals()
{
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGALRM, SIGPIPE, SIGXCPU})
    std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void be_the_child(int pipe, const IsolationLimits& limits,
                               const std::function<std::string()>& work, pid_t parent)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) // it went before the line above
    _exit(1);
  take_default_signals();
  if (const int nowhere = ::open("/dev/null", O_RDWR); nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    if (!sanitized) // whose reports stay visible
      dup2(nowhere, STDERR_FILENO);
  }
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, rlim_t(std::ceil(limits.seconds)) + 5);
  if (limits.memory > 0 && !sanitized)
    limit(RLIMIT_AS, memory_of("self").space + limits.memory);

  char kind = good;
  std::string answer;
  try {
    answer = work();
  } catch (const std::bad_alloc&) {
    kind = no_memory;
  } catch (const std::exception& error) {
    kind = refused;
    try {
      answer = error.what();
    } catch (...) {
      kind = no_memory;
    }
  } catch (...) {
    kind = refused;
  }
  char header[header_size] = {kind};
  const std::uint64_t length = answer.size();
  std::memcpy(header + 1, &length, sizeof length);
  const bool sent = write_all(pipe, header, sizeof header) && write_all(pipe, answer.data(), answer.size());
  _exit(sent ? 0 : 1);
}

//! A child that is ended and buried whatever happens.
class Child
{
public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    if (id_ > 0) {
      kill(id_, SIGKILL);
      wait();
    }
  }
  //! Status as waitpid gives it, or -1 where somebody else buried the child.
  int wait()
  {
    int status = -1;
    while (waitpid(id_, &status, 0) < 0)
      if (errno != EINTR) {
        status = -1;
        break;
      }
    id_ = -1;
    return status;
  }

private:
  pid_t id_;
};

struct Pipe
{
  int ends[2] = {-1, -1};
  ~Pipe()
  {
    shut(0);
    shut(1);
  }
  void shut(int end)
  {
    if (ends[end] >= 0)
      ::close(ends[end]);
    ends[end] = -1;
  }
};

using Clock = std::chrono::steady_clock;

enum class Ending
{
  answer,
  time,
  memory
};

//! Whatever arrives before the whole answer is there or the pipe is closed, the time is over, or the child, watched
//! from outside as well, holds more memory than \p most.
Ending receive(int pipe, pid_t child, Clock::time_point end, unsigned long long most, std::string& bytes)
{
  std::size_t wanted = header_size;
  char block[1 << 16];
  while (bytes.size() < wanted) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0)
      return Ending::time;
    pollfd ready{pipe, POLLIN, 0};
    const int count = poll(&ready, 1, int(std::min<long long>(left, 200)));
    if (count < 0 && errno != EINTR)
      return Ending::answer;
    if (count <= 0) {
      if (memory_of(std::to_string(child)).resident > most)
        return Ending::memory;
      continue;
    }
    const ssize_t got = ::read(pipe, block, sizeof block);
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return Ending::answer;
    bytes.append(block, std::size_t(got));
    if (wanted == header_size && bytes.size() >= header_size) {
      std::uint64_t length = 0;
      std::memcpy(&length, bytes.data() + 1, sizeof length);
      wanted = header_size + std::size_t(length);
    }
  }
  return Ending::answer;
}

bool is_whole(const std::string& bytes)
{
  std::uint64_t length = 0;
  if (bytes.size() < header_size)
    return false;
  std::memcpy(&length, bytes.data() + 1, sizeof length);
  return bytes.size() - header_size == length;
}

} // namespace

std::string run_isolated(const std::string& subject, const IsolationLimits& limits,
                         const std::function<std::string()>& work)
{
  Pipe pipe;
  if (pipe2(pipe.ends, O_CLOEXEC) != 0)
    throw RunError(subject + " cannot be read: the system gives no pipe (" + std::strerror(errno) + ")");
  const pid_t parent = getpid(), id = fork();
  if (id < 0)
    throw RunError(subject + " cannot be read: the system gives no process (" + std::strerror(errno) + ")");
  if (id == 0) {
    pipe.shut(0);
    be_the_child(pipe.ends[1], limits, work, parent);
  }
  Child child(id);
  pipe.shut(1);

  std::string bytes;
  const auto end = Clock::now() + std::chrono::milliseconds(std::int64_t(1000 * limits.seconds));
  const auto most = limits.memory > 0 ? memory_of("self").resident + limits.memory : ~0ull;
  const Ending ending = receive(pipe.ends[0], id, end, most, bytes);
  if (ending == Ending::time)
    throw InputError(subject + " keeps the reader busy for more than " +
                     std::to_string(std::int64_t(limits.seconds)) +
                     " s; it is damaged or far too large: export it again, coarser if need be");
  const std::string too_much =
      subject + " makes the reader take more memory than it may; it is damaged or far too large: export it "
                "again, coarser if need be";
  require(ending != Ending::memory, too_much);
  if (is_whole(bytes)) {
    switch (bytes[0]) {
    case good:
      bytes.erase(0, header_size);
      return bytes;
    case refused:
      throw InputError(bytes.size() > header_size ? bytes.substr(header_size)
                                                  : subject + " cannot be read; export it again");
    case no_memory:
      throw InputError(too_much);
    }
  }
  const int status = child.wait();
  if (status >= 0 && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw InputError(subject + " keeps the reader busy for too long; it is damaged: export it again");
  throw InputError(subject + ": the reader crashed on this file" +
                   (status >= 0 && WIFSIGNALED(status) ? " (" + std::string(strsignal(WTERMSIG(status))) + ")"
                                                       : std::string()) +
                   "; it is damaged: export it again");
}

} // namespace birdstrike
