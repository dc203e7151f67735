// What can be wrong with a message as such: its type, its bytes, its stamp, its frame, its numbers.
#pragma once

#include <nav_msgs/Odometry.h>
#include <std_msgs/Header.h>

#include <optional>
#include <string>

#include "findings.hpp"
#include "message_decoding.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {

// [s] How far ahead of the clock a stamp may be.
constexpr double kLargestLead = 0.05;

/// An input and the reasons that a refusal of it sets.
struct InputReasons {
  std::string topic;
  std::uint32_t invalid;
  std::uint32_t wrong_type;
};

Findings refusal(const InputReasons& input, std::uint32_t reason, const std::string& why);

/// What the decoder returns; or nothing, and a finding with what it threw.
template <typename Decode>
auto decodedOrRefused(const Decode& decode, const InputReasons& input, Findings& findings)
    -> std::optional<decltype(decode())> {
  try {
    return decode();
  } catch (const UnknownType& error) {
    findings = refusal(input, input.wrong_type, error.what());
  } catch (const LimitExceeded& error) {
    findings = refusal(input, input.invalid | CollisionWarning::REASON_LIMIT, error.what());
  } catch (const MalformedMessage& error) {
    findings = refusal(input, input.invalid, error.what());
  }
  return std::nullopt;
}

/// How far [s] a stamp was ahead of the clock when its message came, as is known by now: a
/// simulated clock that merely reached this process late has caught up since.
double leadOf(const ros::Time& stamp, const Moment& arrived, const Moment& now);

/// Of an obstacles message: a frame, and a stamp near the clock.
Findings headerFindings(const std_msgs::Header& header, const Moment& arrived, const Moment& now,
                        double max_data_age, const std::string& topic);

/// Of an odometry message: finite numbers, and a stamp that is not zero nor farther ahead of the
/// clock than `largest_lead` [s].
Findings odometryFindings(const nav_msgs::Odometry& odometry, const Moment& now,
                          double largest_lead, const std::string& topic);

/// "the newest message on ... is ... old"
std::string staleText(const std::string& topic, double age, double max_data_age);

/// "the newest transform between ... and ... is ... old"
std::string oldTransformsText(const std::string& fixed_frame, const std::string& frame, double age,
                              double max_data_age);

/// "a message on ... older than the newest was ignored"
std::string ignoredText(const std::string& topic, std::size_t so_far);

}  // namespace footprint_collision_predictor
