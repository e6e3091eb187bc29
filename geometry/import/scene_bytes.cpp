// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as bytes: a mark, the fields in order, the sum of all bytes.
#include "geometry/import/scene_bytes.h"

#include "core/error.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace birdstrike {

namespace {

constexpr std::uint64_t mark = 0x656E6563536D7269; // any number that noise does not begin with

//! FNV-1a of 64 bits, eight bytes at a time.
std::uint64_t sum_of(std::string_view bytes)
{
  std::uint64_t sum = 14695981039346656037u;
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    sum = (sum ^ word) * 1099511628211u;
  }
  return sum;
}

void put_raw(std::string& bytes, const void* data, std::size_t size)
{
  bytes.append(static_cast<const char*>(data), size);
}
void put(std::string& bytes, std::uint64_t value) { put_raw(bytes, &value, sizeof value); }
void put(std::string& bytes, double value) { put_raw(bytes, &value, sizeof value); }
void put(std::string& bytes, const std::string& text)
{
  put(bytes, std::uint64_t(text.size()));
  bytes += text;
}

class Reader
{
public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  void take(void* to, std::size_t size)
  {
    require(size <= rest_.size(), "what the mesh reader sent ends too early");
    if (size > 0)
      std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  template <class T>
  T take()
  {
    T value{};
    take(&value, sizeof value);
    return value;
  }
  //! How many things of \p size bytes follow; never more than there are bytes.
  std::size_t take_count(std::size_t size)
  {
    const auto count = take<std::uint64_t>();
    require(count <= rest_.size() / size, "what the mesh reader sent ends too early");
    return std::size_t(count);
  }
  std::string take_text()
  {
    std::string text(take_count(1), '\0');
    take(text.data(), text.size());
    return text;
  }
  bool at_end() const { return rest_.empty(); }

private:
  std::string_view rest_;
};

SurfacePart take_part(Reader& reader)
{
  SurfacePart part;
  part.name = reader.take_text();
  part.points.resize(reader.take_count(3 * sizeof(double)));
  for (Vector3& p : part.points) {
    reader.take(p.data(), 3 * sizeof(double));
    require(p.allFinite(), "part '" + part.name + "' has a coordinate that is not a finite number");
  }
  const std::size_t triangles = reader.take_count(3 * sizeof(int));
  require(triangles <= largest_part && part.points.size() <= 3 * largest_part,
          "part '" + part.name + "' has more than 700 million triangles; export it coarser");
  part.triangles.resize(triangles);
  reader.take(part.triangles.data(), triangles * 3 * sizeof(int));
  for (const auto& triangle : part.triangles)
    for (int corner : triangle)
      require(corner >= 0 && std::size_t(corner) < part.points.size(),
              "part '" + part.name + "' has a triangle with a corner that is not there");
  return part;
}

} // namespace

std::string encode_scene(const RawScene& scene)
{
  std::string bytes;
  put(bytes, mark);
  put(bytes, scene.unit);
  put(bytes, scene.unit_source);
  put(bytes, scene.up);
  put(bytes, std::uint64_t(scene.named));
  put(bytes, std::uint64_t(scene.finished));
  put(bytes, std::uint64_t(scene.parts.size()));
  static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(std::array<int, 3>) == 3 * sizeof(int));
  for (const SurfacePart& part : scene.parts) {
    put(bytes, part.name);
    put(bytes, std::uint64_t(part.points.size()));
    put_raw(bytes, part.points.data(), part.points.size() * sizeof(Vector3));
    put(bytes, std::uint64_t(part.triangles.size()));
    put_raw(bytes, part.triangles.data(), part.triangles.size() * 3 * sizeof(int));
  }
  return signed_bytes(std::move(bytes));
}

std::string signed_bytes(std::string bytes)
{
  put(bytes, sum_of(bytes));
  return bytes;
}

RawScene decode_scene(std::string_view bytes)
{
  require(bytes.size() >= 16, "what the mesh reader sent ends too early");
  std::uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + bytes.size() - 8, 8);
  bytes.remove_suffix(8);
  require(sum == sum_of(bytes), "what the mesh reader sent does not add up");

  Reader reader(bytes);
  require(reader.take<std::uint64_t>() == mark, "what the mesh reader sent is no scene");
  RawScene scene;
  scene.unit = reader.take<double>();
  require(std::isfinite(scene.unit) && scene.unit >= 0,
          "the length unit in the file is not a positive number");
  scene.unit_source = reader.take_text();
  scene.up = reader.take_text();
  scene.named = reader.take<std::uint64_t>() != 0;
  scene.finished = reader.take<std::uint64_t>() != 0;
  const std::size_t parts = reader.take_count(3 * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < parts; ++i)
    scene.parts.push_back(take_part(reader));
  require(reader.at_end(), "what the mesh reader sent goes on after its end");
  return scene;
}

} // namespace birdstrike
