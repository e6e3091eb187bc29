// SPDX-License-Identifier: BSD-3-Clause
// Numbers and texts into a row of bytes and back; little-endian, as every machine that VTK 9 is built for.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

static_assert(std::endian::native == std::endian::little, "packed series are little-endian");

class PackedOutput
{
public:
  template <class Number>
  void Put(Number value)
  {
    static_assert(std::is_trivially_copyable_v<Number>);
    this->PutBlock(&value, sizeof value);
  }
  void Put(const std::string& text)
  {
    this->Put(static_cast<std::uint32_t>(text.size()));
    this->PutBlock(text.data(), text.size());
  }
  template <class Number>
  void Put(const std::vector<Number>& values)
  {
    this->Put(static_cast<std::uint64_t>(values.size()));
    this->PutBlock(values.data(), values.size() * sizeof(Number));
  }
  void PutBlock(const void* data, std::size_t size)
  {
    if (size == 0)
      return;
    const std::size_t end = this->Bytes.size();
    this->Bytes.resize(end + size);
    std::memcpy(this->Bytes.data() + end, data, size);
  }

  std::vector<unsigned char> Bytes;
};

//! Reads what PackedOutput wrote. Never past the end: throws std::runtime_error instead.
class PackedInput
{
public:
  explicit PackedInput(const std::vector<unsigned char>& bytes) : Bytes(bytes) {}

  template <class Number>
  Number Get()
  {
    Number value;
    std::memcpy(&value, this->GetBlock(sizeof value), sizeof value);
    return value;
  }
  std::string GetText()
  {
    const auto size = this->Get<std::uint32_t>();
    const unsigned char* text = this->GetBlock(size);
    return std::string(reinterpret_cast<const char*>(text), size);
  }
  template <class Number>
  std::vector<Number> GetVector()
  {
    const auto count = this->Get<std::uint64_t>();
    if (count > (this->Bytes.size() - this->At) / sizeof(Number))
      throw std::runtime_error("a list is longer than what is left of its frame");
    std::vector<Number> values(count);
    if (count > 0)
      std::memcpy(values.data(), this->GetBlock(count * sizeof(Number)), count * sizeof(Number));
    return values;
  }
  const unsigned char* GetBlock(std::size_t size)
  {
    if (size > this->Bytes.size() - this->At)
      throw std::runtime_error("a frame ends before its data do");
    const unsigned char* block = this->Bytes.data() + this->At;
    this->At += size;
    return block;
  }

private:
  const std::vector<unsigned char>& Bytes;
  std::size_t At = 0;
};
