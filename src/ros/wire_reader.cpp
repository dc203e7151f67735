#include "wire_reader.hpp"

namespace footprint_collision_predictor {

std::string WireReader::string() {
  const std::size_t length = arrayLength(1);
  const std::uint8_t* begin = take(length);
  return {begin, begin + length};
}

std::size_t WireReader::arrayLength(std::size_t bytes_per_element) {
  const std::size_t claimed = number<std::uint32_t>();
  if (claimed > left() / bytes_per_element)
    throw MalformedMessage("it claims " + std::to_string(claimed) + " elements at byte " +
                           std::to_string(position_) + " but only " + std::to_string(left()) +
                           " bytes follow");
  return claimed;
}

void WireReader::finish() const {
  if (left() != 0)
    throw MalformedMessage(std::to_string(left()) + " bytes follow its end at byte " +
                           std::to_string(position_));
}

const std::uint8_t* WireReader::take(std::size_t count) {
  if (count > left())
    throw MalformedMessage("it ends at byte " + std::to_string(bytes_.size()) +
                           ", in the middle of a field");
  const std::uint8_t* begin = bytes_.data() + position_;
  position_ += count;
  return begin;
}

}  // namespace footprint_collision_predictor
