// Reads a serialised ROS 1 message without trusting it: an array length is checked against the
// bytes that are left before any memory is taken for it. (The stock deserialiser resizes first.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace footprint_collision_predictor {

/// Thrown for bytes that are not the message they claim to be.
class MalformedMessage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class WireReader {
 public:
  explicit WireReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  /// ROS 1 is little-endian on the wire, as is every machine it runs on.
  template <typename Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>);
    Number value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }

  /// Several in a row.
  template <typename Number, std::size_t count>
  std::array<Number, count> numbers() {
    static_assert(std::is_arithmetic_v<Number>);
    std::array<Number, count> values;
    std::memcpy(values.data(), take(sizeof values), sizeof values);
    return values;
  }

  void skip(std::size_t bytes) { take(bytes); }

  std::string string();

  /// Length of an array whose elements take at least this many bytes each.
  std::size_t arrayLength(std::size_t bytes_per_element) {
    const std::size_t claimed = number<std::uint32_t>();
    if (claimed > left() / bytes_per_element) refuseLength(claimed);
    return claimed;
  }

  /// \throws MalformedMessage when bytes are left over
  void finish() const;

 private:
  const std::uint8_t* take(std::size_t count) {
    if (count > left()) refuseEnd();
    const std::uint8_t* begin = bytes_.data() + position_;
    position_ += count;
    return begin;
  }
  [[noreturn]] void refuseEnd() const;
  [[noreturn]] void refuseLength(std::size_t claimed) const;
  std::size_t left() const { return bytes_.size() - position_; }

  const std::vector<std::uint8_t>& bytes_;
  std::size_t position_ = 0;
};

}  // namespace footprint_collision_predictor
