// SPDX-License-Identifier: GPL-3.0-or-later
// Work that crashes, hangs or eats memory harms nobody; scenes survive the way through a pipe or are refused.
#include "geometry/import/isolate.h"
#include "geometry/import/scene_bytes.h"
#include "geometry/shapes.h"
#include "temporary_folder.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace birdstrike;
using Catch::Contains;
using test::input_error;

namespace {

std::string after(const IsolationLimits& limits, const std::function<std::string()>& work)
{
  return input_error([&] { run_isolated("mesh file 'x'", limits, work); });
}

} // namespace

TEST_CASE("an answer of any size comes back", "[geometry][import][dirty]")
{
  for (const std::size_t size : {std::size_t(0), std::size_t(1), std::size_t(5'000'000)}) {
    const std::string answer = run_isolated("x", {}, [&] {
      std::puts("a library that talks");
      return std::string(size, 'a');
    });
    CHECK(answer == std::string(size, 'a'));
  }
}

TEST_CASE("crash, hang, hunger and exceptions become messages", "[geometry][import][dirty]")
{
  CHECK_THAT(after({}, [] { return std::raise(SIGKILL) ? std::string() : std::string(); }),
             Contains("mesh file 'x'") && Contains("the reader crashed on this file") &&
                 Contains("export it again"));
  CHECK_THAT(after({}, []() -> std::string { _exit(3); }), Contains("the reader crashed"));
  CHECK_THAT(after({}, []() -> std::string { throw InputError("mesh file 'x' is odd"); }),
             Contains("mesh file 'x' is odd"));
  CHECK_THAT(after({}, []() -> std::string { throw std::bad_alloc(); }), Contains("more memory than it may"));
  CHECK_THAT(after({}, []() -> std::string { throw 5; }), Contains("cannot be read"));
  const auto start = std::chrono::steady_clock::now();
  CHECK_THAT(after({.seconds = 0.3},
                   []() -> std::string {
                     for (;;)
                       std::this_thread::sleep_for(std::chrono::seconds(1));
                   }),
             Contains("busy for more than"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  CHECK_THAT(after({.seconds = 30, .memory = 200 << 20},
                   []() -> std::string {
                     std::vector<std::unique_ptr<char[]>> all;
                     for (;;) {
                       all.push_back(std::make_unique<char[]>(10 << 20));
                       std::memset(all.back().get(), 1, 10 << 20);
                       std::this_thread::sleep_for(std::chrono::milliseconds(10));
                     }
                   }),
             Contains("more memory than it may"));
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1); // no child is left
}

TEST_CASE("a scene travels as bytes, and damaged bytes are refused", "[geometry][import][dirty]")
{
  RawScene scene;
  scene.parts = {make_box({1, 2, 3}), make_shape("sphere", {1, 1}, {8, 4})};
  scene.unit = 0.0254;
  scene.unit_source = "its header";
  scene.up = "+y";
  scene.named = scene.finished = true;
  const std::string bytes = encode_scene(scene);
  const RawScene read = decode_scene(bytes);
  CHECK(read.unit == scene.unit);
  CHECK(read.unit_source == scene.unit_source);
  CHECK(read.up == "+y");
  CHECK((read.named && read.finished));
  REQUIRE(read.parts.size() == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(read.parts[i].name == scene.parts[i].name);
    CHECK(read.parts[i].points == scene.parts[i].points);
    CHECK(read.parts[i].triangles == scene.parts[i].triangles);
  }
  for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 8)
    CHECK_THROWS_AS(decode_scene(bytes.substr(0, length)), InputError);
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string flipped = bytes;
    flipped[at] = char(flipped[at] ^ 0x10);
    CHECK_THROWS_AS(decode_scene(flipped), InputError);
  }
  RawScene wrong = scene;
  wrong.parts[0].triangles[0][0] = 8;
  CHECK_THROWS_AS(decode_scene(encode_scene(wrong)), InputError);
  wrong.parts[0].triangles[0][0] = -1;
  CHECK_THROWS_AS(decode_scene(encode_scene(wrong)), InputError);
  wrong = scene;
  wrong.parts[1].points[3].y() = NAN;
  CHECK_THROWS_AS(decode_scene(encode_scene(wrong)), InputError);
}
