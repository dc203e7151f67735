#include "expectation.hpp"

#include <cmath>
#include <cstdio>

#include "exit_status.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kTolerance = 1e-6;  // [s]

std::string seconds(const std::optional<double>& t) {
  if (!t) return "       none";
  char text[40];
  std::snprintf(text, sizeof text, "%9.6f s", *t);
  return text;
}

std::string row(const char* what, const std::optional<double>& expected,
                const std::optional<double>& seen) {
  char text[160];
  std::snprintf(text, sizeof text, "  %-28s %s   seen %s", what, seconds(expected).c_str(),
                seconds(seen).c_str());
  return text;
}

/// Between two messages the level may rise as soon as the threshold is crossed, so a little before
/// the message that must raise it; never after.
bool risesInTime(double seen, double latest, double contact, double threshold) {
  return seen <= latest + kTolerance && seen >= contact - threshold - kTolerance;
}

}  // namespace

std::optional<double> Expectation::timeOf(const ros::Time& stamp) const {
  if (stamp.sec < answers_.start) return std::nullopt;
  return static_cast<double>(stamp.sec - answers_.start) + static_cast<double>(stamp.nsec) * 1e-9;
}

void Expectation::take(const CollisionWarning& warning) {
  const auto t = timeOf(warning.header.stamp);
  if (!t) return;
  newest_ = std::max(newest_, *t);
  if (warning.level != CollisionWarning::UNKNOWN) known_ = true;
  const bool critical = warning.level == CollisionWarning::CRITICAL;
  if (!warn_ && (critical || warning.level == CollisionWarning::WARN)) warn_ = Seen{*t, warning};
  if (!critical_ && critical) critical_ = Seen{*t, warning};
}

bool Expectation::nothingCame() const { return answers_.first_warn ? !warn_ : !known_; }

std::vector<std::string> Expectation::disagreements() const {
  std::vector<std::string> wrong;
  const auto check = [&](bool agrees, const char* text) {
    if (!agrees) wrong.emplace_back(text);
  };
  check(isOver(), "the warnings ended before the scenario");
  check(warn_.has_value() == answers_.first_warn.has_value(), "a warning that came or is missing");
  check(critical_.has_value() == answers_.first_critical.has_value(),
        "a CRITICAL that came or is missing");
  if (!warn_ || !answers_.first_warn) return wrong;
  const auto& first = warn_->warning;
  const double contact = warn_->t + first.time_to_collision;
  check(std::abs(contact - *answers_.contact) <= kTolerance, "the moment of contact");
  check(!answers_.footprint || first.footprint == *answers_.footprint, "the footprint");
  check(first.segment == *answers_.segment, "the segment");
  check(first.obstacle_id == *answers_.obstacle_id, "the obstacle");
  check(risesInTime(warn_->t, *answers_.first_warn, *answers_.contact, answers_.warn_time),
        "the moment of the first WARN");
  if (!critical_ || !answers_.first_critical) return wrong;
  check(risesInTime(critical_->t, *answers_.first_critical, *answers_.contact,
                    answers_.critical_time),
        "the moment of the first CRITICAL");
  return wrong;
}

int Expectation::exitStatus() const {
  if (nothingCame()) return kNoWarning;
  return disagreements().empty() ? kSuccess : kDisagrees;
}

std::string Expectation::summary() const {
  const auto timeOfSeen = [](const std::optional<Seen>& s) {
    return s ? std::optional<double>(s->t) : std::nullopt;
  };
  std::optional<double> contact;
  if (warn_) contact = warn_->t + warn_->warning.time_to_collision;
  std::string text = row("first WARN, expected by", answers_.first_warn, timeOfSeen(warn_)) + "\n" +
                     row("first CRITICAL, by", answers_.first_critical, timeOfSeen(critical_)) +
                     "\n" + row("predicted contact, exactly", answers_.contact, contact);
  if (contact && answers_.contact) {
    char difference[64];
    std::snprintf(difference, sizeof difference, "   difference %.9f s",
                  std::abs(*contact - *answers_.contact));
    text += difference;
  }
  if (nothingCame()) {
    return text +
           "\nNO WARNING CAME: is predictor_node running, and are its inputs remapped to "
           "the replayed topics?\n";
  }
  const auto wrong = disagreements();
  if (wrong.empty()) return text + "\nAgrees with the exact answer within 1e-6 s.\n";
  text += "\nDISAGREES in";
  for (std::size_t i = 0; i < wrong.size(); ++i) text += (i == 0 ? ": " : "; ") + wrong[i];
  return text + "\n";
}

}  // namespace footprint_collision_predictor::tools
