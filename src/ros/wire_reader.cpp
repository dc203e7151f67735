#include "wire_reader.hpp"

namespace footprint_collision_predictor {

std::string WireReader::string() {
  const std::size_t length = arrayLength(1);
  const std::uint8_t* begin = take(length);
  return {begin, begin + length};
}

void WireReader::refuseLength(std::size_t claimed) const {
  throw MalformedMessage("it claims " + std::to_string(claimed) + " elements at byte " +
                         std::to_string(position_) + " but only " + std::to_string(left()) +
                         " bytes follow");
}

void WireReader::finish() const {
  if (left() != 0)
    throw MalformedMessage(std::to_string(left()) + " bytes follow its end at byte " +
                           std::to_string(position_));
}

void WireReader::refuseEnd() const {
  throw MalformedMessage("it ends at byte " + std::to_string(bytes_.size()) +
                         ", in the middle of a field");
}

}  // namespace footprint_collision_predictor
