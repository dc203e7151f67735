// The building blocks of messages, read field by field in the order of their definitions.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TwistWithCovariance.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/Header.h>

#include "frame_names.hpp"
#include "wire_reader.hpp"

namespace footprint_collision_predictor {

constexpr std::size_t kPointBytes = 24;      // three float64
constexpr std::size_t kPoint32Bytes = 12;    // three float32
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
  Triple triple;
  triple.x = in.number<double>();
  triple.y = in.number<double>();
  triple.z = in.number<double>();
  return triple;
}

template <typename Triple>
Triple readTriple32(WireReader& in) {
  Triple triple;
  triple.x = in.number<float>();
  triple.y = in.number<float>();
  triple.z = in.number<float>();
  return triple;
}

inline geometry_msgs::Quaternion readQuaternion(WireReader& in) {
  geometry_msgs::Quaternion q;
  q.x = in.number<double>();
  q.y = in.number<double>();
  q.z = in.number<double>();
  q.w = in.number<double>();
  return q;
}

inline geometry_msgs::TwistWithCovariance readTwistWithCovariance(WireReader& in) {
  geometry_msgs::TwistWithCovariance twist;
  twist.twist.linear = readTriple<geometry_msgs::Vector3>(in);
  twist.twist.angular = readTriple<geometry_msgs::Vector3>(in);
  for (double& element : twist.covariance) element = in.number<double>();
  return twist;
}

}  // namespace footprint_collision_predictor
