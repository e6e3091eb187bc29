// SPDX-License-Identifier: BSD-3-Clause
// The state of a run at one time, as a packed series holds it, and the bytes of a frame.
#include "PackedFrame.h"

#include "PackedBytes.h"

#include <algorithm>
#include <cmath>

namespace {

using Place = PackedArray::Place;

void Require(bool holds, const std::string& message)
{
  if (!holds)
    throw std::runtime_error(message);
}

// Where the points will be if velocities change evenly over the step; empty where there is no velocity.
std::vector<double> ForetellPoints(const PackedPiece& piece, const std::vector<double>& points,
                                   const std::vector<double>& velocityBefore, double step)
{
  const PackedArray* velocity = piece.Find(Place::PointData, "velocity");
  if (!velocity || velocity->Values.size() != points.size() || velocityBefore.size() != points.size())
    return {};
  std::vector<double> moved(points.size());
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] = points[i] + 0.5 * step * (velocityBefore[i] + velocity->Values[i]);
  return moved;
}

std::vector<double> ValuesOf(const PackedPiece& piece, Place where, const std::string& name)
{
  const PackedArray* array = piece.Find(where, name);
  return array ? array->Values : std::vector<double>();
}

// A length against which errors of places are judged [m].
double LengthOf(const PackedState& state, const PackedArray& points)
{
  for (const PackedPiece& piece : state.Pieces) {
    const PackedArray* spacing = piece.Find(Place::FieldData, "spacing");
    if (spacing && spacing->Values.size() == 1 && spacing->Values.front() > 0)
      return spacing->Values.front();
  }
  const auto [low, high] = std::minmax_element(points.Values.begin(), points.Values.end());
  return points.Values.empty() ? 0 : 0.01 * (*high - *low);
}

double ToleranceOf(const PackedState& state, const PackedArray& array, double accuracy)
{
  if (array.Where == Place::FieldData)
    return 0;
  return accuracy * (array.Where == Place::Points ? LengthOf(state, array) : array.Scale);
}

void KeepScale(PackedArray& array, const std::vector<double>& values)
{
  double largest = 0, sum = 0;
  for (const double value : values)
    if (std::isfinite(value)) {
      largest = std::max(largest, std::abs(value));
      sum += std::abs(value);
    }
  const double scale = array.Where == Place::CellData
                           ? sum / static_cast<double>(std::max<std::size_t>(values.size(), 1))
                           : largest;
  array.Scale = std::max(array.Scale, scale);
}

void CheckPiece(const PackedPiece& now, const PackedPiece& before)
{
  Require(now.Name == before.Name && now.Arrays.size() == before.Arrays.size(),
          "the piece \"" + now.Name + "\" has other arrays than in the first frame");
  Require(now.Offsets == before.Offsets && now.Connectivity == before.Connectivity,
          "the piece \"" + now.Name + "\" has other cells than in the first frame");
  for (std::size_t k = 0; k < now.Arrays.size(); ++k)
    Require(now.Arrays[k].Name == before.Arrays[k].Name &&
                now.Arrays[k].Values.size() == before.Arrays[k].Values.size(),
            "the array \"" + now.Arrays[k].Name + "\" of \"" + now.Name +
                "\" has another number of values than in the first frame");
}

} // namespace

const PackedArray* PackedPiece::Find(Place where, const std::string& name) const
{
  for (const PackedArray& array : this->Arrays)
    if (array.Where == where && array.Name == name)
      return &array;
  return nullptr;
}

std::vector<unsigned char> WriteFirstFrame(const PackedState& first)
{
  PackedOutput out;
  out.Put(first.Time);
  out.Put(static_cast<std::uint32_t>(first.Pieces.size()));
  for (const PackedPiece& piece : first.Pieces) {
    out.Put(piece.Name);
    out.Put(piece.Types);
    out.Put(piece.Offsets);
    out.Put(piece.Connectivity);
    out.Put(static_cast<std::uint32_t>(piece.FieldStrings.size()));
    for (const auto& [name, texts] : piece.FieldStrings) {
      out.Put(name);
      out.Put(static_cast<std::uint32_t>(texts.size()));
      for (const std::string& text : texts)
        out.Put(text);
    }
    out.Put(static_cast<std::uint32_t>(piece.Arrays.size()));
    for (const PackedArray& array : piece.Arrays) {
      out.Put(array.Name);
      out.Put(array.Where);
      out.Put(array.Components);
      out.Put(array.Type);
      out.Put(static_cast<std::uint64_t>(array.Values.size()));
      WriteExactly(out, array);
    }
  }
  return out.Bytes;
}

PackedState ReadFirstFrame(const std::vector<unsigned char>& bytes)
{
  PackedInput in(bytes);
  PackedState first;
  first.Time = in.Get<double>();
  const auto pieces = in.Get<std::uint32_t>();
  for (std::uint32_t p = 0; p < pieces; ++p) {
    PackedPiece& piece = first.Pieces.emplace_back();
    piece.Name = in.GetText();
    piece.Types = in.GetVector<unsigned char>();
    piece.Offsets = in.GetVector<std::int64_t>();
    piece.Connectivity = in.GetVector<std::int64_t>();
    const auto texts = in.Get<std::uint32_t>();
    for (std::uint32_t t = 0; t < texts; ++t) {
      std::vector<std::string>& list = piece.FieldStrings[in.GetText()];
      const auto count = in.Get<std::uint32_t>();
      for (std::uint32_t k = 0; k < count; ++k)
        list.push_back(in.GetText());
    }
    const auto arrays = in.Get<std::uint32_t>();
    for (std::uint32_t a = 0; a < arrays; ++a) {
      PackedArray& array = piece.Arrays.emplace_back();
      array.Name = in.GetText();
      array.Where = in.Get<Place>();
      array.Components = in.Get<std::uint8_t>();
      array.Type = in.Get<std::int32_t>();
      const auto count = in.Get<std::uint64_t>();
      // Every value takes at least one byte here: a count beyond that is damage, and must not ask for memory.
      Require(array.Components > 0 && count <= bytes.size() && count % array.Components == 0,
              "the array \"" + array.Name + "\" has an impossible size");
      array.Values.resize(count);
      ReadArray(in, array, {});
    }
  }
  return first;
}

std::vector<unsigned char> WriteFrame(const PackedState& now, PackedState& state, double accuracy, bool key)
{
  Require(now.Pieces.size() == state.Pieces.size(),
          "there are " + std::to_string(now.Pieces.size()) + " pieces, and were " +
              std::to_string(state.Pieces.size()) + " in the first frame");
  PackedOutput out;
  out.Put(now.Time);
  out.Put(static_cast<std::uint8_t>(key));
  const double step = now.Time - state.Time;
  for (std::size_t p = 0; p < now.Pieces.size(); ++p) {
    PackedPiece& piece = state.Pieces[p];
    CheckPiece(now.Pieces[p], piece);
    const std::vector<double> velocityBefore = ValuesOf(piece, Place::PointData, "velocity");
    for (std::size_t k = 0; k < piece.Arrays.size(); ++k) {
      PackedArray& array = piece.Arrays[k];
      const std::vector<double>& values = now.Pieces[p].Arrays[k].Values;
      KeepScale(array, values);
      const std::vector<double> foretold = array.Where == Place::Points && !key
                                               ? ForetellPoints(piece, array.Values, velocityBefore, step)
                                               : std::vector<double>();
      WriteArray(out, array, values, foretold, ToleranceOf(state, array, accuracy), key);
    }
  }
  state.Time = now.Time;
  return out.Bytes;
}

void ReadFrame(const std::vector<unsigned char>& bytes, PackedState& state)
{
  PackedInput in(bytes);
  const auto time = in.Get<double>();
  const bool key = in.Get<std::uint8_t>() != 0;
  for (PackedPiece& piece : state.Pieces) {
    const std::vector<double> velocityBefore = ValuesOf(piece, Place::PointData, "velocity");
    for (PackedArray& array : piece.Arrays)
      ReadArray(in, array,
                array.Where == Place::Points && !key
                    ? ForetellPoints(piece, array.Values, velocityBefore, time - state.Time)
                    : std::vector<double>());
  }
  state.Time = time;
}
