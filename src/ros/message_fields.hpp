// The building blocks of messages, read field by field in the order of their definitions.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/Header.h>

#include "frame_names.hpp"
#include "wire_reader.hpp"

namespace footprint_collision_predictor {

constexpr std::size_t kPointBytes = 24;    // three float64
constexpr std::size_t kPoint32Bytes = 12;  // three float32
constexpr std::size_t kCovarianceBytes = 36 * 8;
constexpr std::size_t kShortestHeader = 16;  // seq, stamp, and the length of an empty frame_id

inline std_msgs::Header readHeader(WireReader& in) {
  std_msgs::Header header;
  header.seq = in.number<std::uint32_t>();
  header.stamp.sec = in.number<std::uint32_t>();
  header.stamp.nsec = in.number<std::uint32_t>();
  if (header.stamp.nsec >= 1000000000)
    throw MalformedMessage("its stamp has " + std::to_string(header.stamp.nsec) + " nanoseconds");
  header.frame_id = withoutLeadingSlash(in.string());
  return header;
}

/// Point or Vector3.
template <typename Triple>
Triple readTriple(WireReader& in) {
  const auto [x, y, z] = in.numbers<double, 3>();
  Triple triple;
  triple.x = x;
  triple.y = y;
  triple.z = z;
  return triple;
}

template <typename Triple>
Triple readTriple32(WireReader& in) {
  const auto [x, y, z] = in.numbers<float, 3>();
  Triple triple;
  triple.x = x;
  triple.y = y;
  triple.z = z;
  return triple;
}

inline geometry_msgs::Quaternion readQuaternion(WireReader& in) {
  const auto [x, y, z, w] = in.numbers<double, 4>();
  geometry_msgs::Quaternion q;
  q.x = x;
  q.y = y;
  q.z = z;
  q.w = w;
  return q;
}

/// Of a TwistWithCovariance; the covariance is passed over.
inline geometry_msgs::Twist readTwist(WireReader& in) {
  geometry_msgs::Twist twist;
  twist.linear = readTriple<geometry_msgs::Vector3>(in);
  twist.angular = readTriple<geometry_msgs::Vector3>(in);
  in.skip(kCovarianceBytes);
  return twist;
}

}  // namespace footprint_collision_predictor
