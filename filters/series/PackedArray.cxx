// SPDX-License-Identifier: BSD-3-Clause
// One array of a packed series: its values as they come back, and how the next ones are told by what changes.
#include "PackedArray.h"

#include "PackedBytes.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double LargestStep = 1 << 30; // in quanta

bool IsWhole(int type) { return type != VTK_DOUBLE && type != VTK_FLOAT; }

// Calls work with a number of the type that VTK gives that name; rarer ones are written as the widest.
template <class Work>
void WithNumber(int type, Work work)
{
  switch (type) {
  case VTK_DOUBLE:
    return work(double());
  case VTK_FLOAT:
    return work(float());
  case VTK_UNSIGNED_CHAR:
    return work(std::uint8_t());
  case VTK_INT:
    return work(std::int32_t());
  default:
    return work(std::int64_t());
  }
}

template <class Number>
void PutAs(PackedOutput& out, const std::vector<double>& values)
{
  std::vector<Number> own(values.size());
  std::transform(values.begin(), values.end(), own.begin(),
                 [](double value) { return static_cast<Number>(value); });
  out.PutBlock(own.data(), own.size() * sizeof(Number));
}

template <class Number>
void GetAs(PackedInput& in, std::vector<double>& values)
{
  const unsigned char* block = in.GetBlock(values.size() * sizeof(Number));
  for (double& value : values) {
    Number own;
    std::memcpy(&own, block, sizeof own);
    block += sizeof own;
    value = static_cast<double>(own);
  }
}

// Differences are small and of either sign: 0, -1, 1, -2, 2 ... -> 0, 1, 2, 3, 4 ...
std::uint32_t Fold(std::int64_t step)
{
  return static_cast<std::uint32_t>(step >= 0 ? 2 * step : -2 * step - 1);
}
std::int64_t Unfold(std::uint32_t folded)
{
  return folded % 2 == 0 ? static_cast<std::int64_t>(folded / 2) : -static_cast<std::int64_t>(folded / 2) - 1;
}

// Component after component, and of each the lowest bytes, then the next: rows of zeros that zlib makes short.
void PutSteps(PackedOutput& out, const std::vector<std::uint32_t>& steps, std::size_t components)
{
  const std::uint32_t largest = steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end());
  std::uint8_t planes = 0;
  while (planes < 4 && (largest >> (8 * planes)) != 0)
    ++planes;
  out.Put(planes);
  std::vector<unsigned char> plane(steps.size() / components);
  for (std::size_t c = 0; c < components; ++c)
    for (int k = 0; k < planes; ++k) {
      for (std::size_t i = 0; i < plane.size(); ++i)
        plane[i] = static_cast<unsigned char>(steps[components * i + c] >> (8 * k));
      out.PutBlock(plane.data(), plane.size());
    }
}

std::vector<std::uint32_t> GetSteps(PackedInput& in, std::size_t count, std::size_t components)
{
  const auto planes = in.Get<std::uint8_t>();
  if (planes > 4)
    throw std::runtime_error("an array has more than four bytes a value");
  std::vector<std::uint32_t> steps(count, 0);
  const std::size_t tuples = count / components;
  for (std::size_t c = 0; c < components; ++c)
    for (int k = 0; k < planes; ++k) {
      const unsigned char* plane = in.GetBlock(tuples);
      for (std::size_t i = 0; i < tuples; ++i)
        steps[components * i + c] |= static_cast<std::uint32_t>(plane[i]) << (8 * k);
    }
  return steps;
}

// The largest power of two that rounding to its multiples keeps within the tolerance: sums of it are exact.
double QuantumFor(double tolerance)
{
  return tolerance > std::numeric_limits<double>::min() ? std::exp2(std::floor(std::log2(2 * tolerance))) : 0;
}

// What a reader has of a value in the end.
double InOwnType(double value, int type) { return type == VTK_FLOAT ? static_cast<float>(value) : value; }

// The steps from one value to the next, in quanta, and the values that they give; false if they are too large, or
// if rounding takes a value further off than the tolerance.
bool FindSteps(const PackedArray& state, const std::vector<double>& values, const std::vector<double>& base,
               double tolerance, double quantum, bool rows, std::vector<std::uint32_t>& steps,
               std::vector<double>& back)
{
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (rows) {
      const double whole = std::round(values[i] / quantum);
      const double before = i < state.Components ? 0 : back[i - state.Components] / quantum;
      if (!(std::abs(whole) < LargestStep)) // NaN, too
        return false;
      steps[i] = Fold(static_cast<std::int64_t>(whole) - static_cast<std::int64_t>(before));
      back[i] = whole * quantum;
    } else {
      const double change = (values[i] - base[i]) / quantum;
      if (!(std::abs(change) < LargestStep))
        return false;
      const double whole =
          std::abs(change) <= 0.5 ? 0 : std::round(change); // what is near enough costs nothing
      steps[i] = Fold(static_cast<std::int64_t>(whole));
      back[i] = base[i] + whole * quantum;
    }
    if (!(std::abs(InOwnType(back[i], state.Type) - values[i]) <= tolerance))
      return false;
  }
  return true;
}

} // namespace

void WriteExactly(PackedOutput& out, const PackedArray& array)
{
  out.Put(PackedMode::Exact);
  WithNumber(array.Type, [&](auto number) { PutAs<decltype(number)>(out, array.Values); });
}

void WriteArray(PackedOutput& out, PackedArray& state, const std::vector<double>& values,
                const std::vector<double>& foretold, double tolerance, bool rows)
{
  // To the bit: 0 and -0 differ, a NaN is the same as itself.
  if (values.size() == state.Values.size() &&
      std::memcmp(values.data(), state.Values.data(), values.size() * sizeof(double)) == 0)
  {
    out.Put(PackedMode::Same);
    return;
  }
  const std::vector<double>& base = foretold.empty() || rows ? state.Values : foretold;
  double quantum = IsWhole(state.Type) ? 0 : QuantumFor(tolerance);
  std::vector<std::uint32_t> steps(values.size());
  std::vector<double> back(values.size());
  bool fits = quantum > 0 && FindSteps(state, values, base, tolerance, quantum, rows, steps, back);
  if (quantum > 0 && !fits) { // finer steps leave room for the rounding to the array's own type
    quantum /= 2;
    fits = FindSteps(state, values, base, tolerance, quantum, rows, steps, back);
  }
  if (!fits) {
    state.Values = values;
    WriteExactly(out, state);
    return;
  }
  out.Put(rows ? PackedMode::Rows : PackedMode::Changes);
  out.Put(quantum);
  PutSteps(out, steps, state.Components);
  state.Values = std::move(back);
}

void ReadArray(PackedInput& in, PackedArray& state, const std::vector<double>& foretold)
{
  switch (in.Get<PackedMode>()) {
  case PackedMode::Same:
    return;
  case PackedMode::Exact:
    return WithNumber(state.Type, [&](auto number) { GetAs<decltype(number)>(in, state.Values); });
  case PackedMode::Changes: {
    const auto quantum = in.Get<double>();
    const auto steps = GetSteps(in, state.Values.size(), state.Components);
    const bool moved = foretold.size() == state.Values.size();
    for (std::size_t i = 0; i < steps.size(); ++i)
      state.Values[i] =
          (moved ? foretold[i] : state.Values[i]) + static_cast<double>(Unfold(steps[i])) * quantum;
    return;
  }
  case PackedMode::Rows: {
    const auto quantum = in.Get<double>();
    const auto steps = GetSteps(in, state.Values.size(), state.Components);
    std::vector<std::int64_t> whole(state.Components, 0);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      std::int64_t& value = whole[i % state.Components];
      value += Unfold(steps[i]);
      state.Values[i] = static_cast<double>(value) * quantum;
    }
    return;
  }
  }
  throw std::runtime_error("an array is written in a way that this version does not know");
}
