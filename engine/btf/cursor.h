#pragma once
// Little-endian numbers out of and into the bytes of a file.
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

static_assert(std::endian::native == std::endian::little, "values are mapped and copied as they lie in files");

// Walks through a file. The first error stays: reads go on with zeros and empty spans, and the caller asks status()
// before it believes what was read. Nothing is copied or allocated.
class Cursor {
 public:
  Cursor(std::span<const std::byte> bytes, std::string_view file) : bytes_(bytes), file_(file) {}

  // `what` names the value in messages: "width".
  template <class T>
  T number(std::string_view what) {
    T value{};
    const auto bytes = take(sizeof(T), what);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  // A number from `low` to `high`; `low` and an error when it lies outside.
  uint32_t count(std::string_view what, uint32_t low, uint32_t high) {
    const uint64_t start = at_;
    const auto value = number<uint32_t>(what);
    if (error_) return low;
    if (value >= low && value <= high) return value;
    refuse(start, what, fmt::format("{} to {}", low, high), std::to_string(value));
    return low;
  }

  // The next `size` bytes; none and an error when the file ends before.
  std::span<const std::byte> take(uint64_t size, std::string_view what) {
    if (error_) return {};
    if (size > bytes_.size() - at_) {
      refuse(at_, what, fmt::format("{} bytes", size), fmt::format("{} to the end of the file", bytes_.size() - at_));
      return {};
    }
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }

  std::string_view text(uint64_t size, std::string_view what) {
    const auto bytes = take(size, what);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  void refuse(uint64_t place, std::string_view what, std::string_view expected, std::string_view found) {
    if (!error_)
      error_ = fail(ErrorKind::bad_input, file_, fmt::format("byte {}, {}", place, what), expected, found).value();
  }

  uint64_t at() const { return at_; }
  uint64_t left() const { return bytes_.size() - at_; }
  std::span<const std::byte> bytes() const { return bytes_; }
  const std::string& file() const { return file_; }
  Status status() const {
    if (error_) return tl::unexpected(*error_);
    return {};
  }

 private:
  std::span<const std::byte> bytes_;
  std::string file_;
  uint64_t at_ = 0;
  std::optional<Error> error_;
};

// The other way round.
class ByteWriter {
 public:
  template <class T>
  void number(T value) {
    const size_t at = bytes_.size();
    bytes_.resize(at + sizeof(value));
    std::memcpy(&bytes_[at], &value, sizeof(value));
  }
  void raw(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  void text(std::string_view text) { raw(std::as_bytes(std::span(text.data(), text.size()))); }
  // Cut or filled with zeros to `size` bytes, the last one always zero.
  void text(std::string_view text, size_t size) {
    const std::string_view kept = text.substr(0, size - 1);
    this->text(kept);
    bytes_.resize(bytes_.size() + size - kept.size());
  }
  std::vector<std::byte>& bytes() { return bytes_; }
  size_t size() const { return bytes_.size(); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace vamp
