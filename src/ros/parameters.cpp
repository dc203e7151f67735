#include "parameters.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "footprint_collision_predictor/motion.hpp"
#include "footprint_parameter.hpp"
#include "frame_names.hpp"
#include "suggestion.hpp"

namespace footprint_collision_predictor {
namespace {

using Value = XmlRpc::XmlRpcValue;

std::string shown(const Value& value) {
  std::ostringstream text;
  value.write(text);
  return text.str();
}

/// Reads the values one by one and collects every complaint, so that all are told at once.
class Reader {
 public:
  explicit Reader(const Value& values) {
    if (values.getType() != Value::TypeStruct) return;
    for (auto it = values.begin(); it != values.end(); ++it) values_.emplace(it->first, it->second);
  }

  void number(const std::string& name, double lowest, double highest, double& target) {
    const Value* value = find(name);
    if (!value) return;
    std::ostringstream allowed;
    allowed << "a number from " << lowest << " to " << highest;
    const std::optional<double> read = asNumber(*value);
    if (!read) {
      const bool text = value->getType() == Value::TypeString;
      complain(name, *value,
               allowed.str() + (text ? " (YAML reads 1e-3 as text: write 0.001 or 1.0e-3)" : ""));
    } else if (!(*read >= lowest && *read <= highest)) {
      complain(name, *value, allowed.str());
    } else {
      target = *read;
    }
  }

  void count(const std::string& name, int lowest, int highest, std::size_t& target) {
    const Value* value = find(name);
    if (!value) return;
    const bool integer = value->getType() == Value::TypeInt;
    const int read = integer ? static_cast<const int&>(*value) : 0;
    if (integer && read >= lowest && read <= highest) {
      target = static_cast<std::size_t>(read);
    } else {
      complain(name, *value,
               "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    }
  }

  template <typename Choice>
  void choice(const std::string& name, const std::map<std::string, Choice>& choices,
              Choice& target) {
    const Value* value = find(name);
    if (!value) return;
    const auto found = value->getType() == Value::TypeString
                           ? choices.find(static_cast<const std::string&>(*value))
                           : choices.end();
    if (found != choices.end()) {
      target = found->second;
      return;
    }
    std::string allowed;
    for (const auto& entry : choices) allowed += (allowed.empty() ? "" : " or ") + entry.first;
    complain(name, *value, allowed);
  }

  void frame(const std::string& name, std::string& target) {
    const Value* value = find(name);
    if (!value) return;
    if (value->getType() == Value::TypeString)
      target = withoutLeadingSlash(static_cast<const std::string&>(*value));
    if (value->getType() != Value::TypeString || target.empty())
      complain(name, *value, "the name of a tf frame");
  }

  void footprint(std::size_t max_vertices, std::optional<core::Polygon>& target) try {
    const Value* value = find("footprint");
    if (!value) return;
    const std::vector<core::Vec2> vertices = footprintVertices(*value);
    if (vertices.size() > max_vertices)
      throw std::invalid_argument("it has " + std::to_string(vertices.size()) +
                                  " vertices, more than ~max_vertices " +
                                  std::to_string(max_vertices));
    target.emplace(vertices);
  } catch (const std::invalid_argument& error) {
    complaints_.push_back("~footprint is refused: " + std::string(error.what()));
  }

  void require(bool holds, const std::string& complaint) {
    if (!holds) complaints_.push_back(complaint);
  }

  void refuseUnknown() {
    for (const auto& entry : values_) {
      if (std::find(known_.begin(), known_.end(), entry.first) != known_.end()) continue;
      const std::string meant = nearestName(entry.first, known_);
      complaints_.push_back("unknown parameter ~" + entry.first +
                            (meant.empty() ? "" : "; did you mean ~" + meant + "?"));
    }
  }

  void throwIfAny() const {
    if (complaints_.empty()) return;
    std::string all;
    for (const std::string& complaint : complaints_) all += (all.empty() ? "" : "\n") + complaint;
    throw ParameterError(all);
  }

 private:
  const Value* find(const std::string& name) {
    known_.push_back(name);
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }

  static std::optional<double> asNumber(const Value& value) {
    if (value.getType() == Value::TypeInt) return static_cast<const int&>(value);
    if (value.getType() == Value::TypeDouble) return static_cast<const double&>(value);
    return std::nullopt;
  }

  void complain(const std::string& name, const Value& value, const std::string& allowed) {
    complaints_.push_back("~" + name + " is " + shown(value) + "; allowed is " + allowed);
  }

  std::map<std::string, Value> values_;
  std::vector<std::string> known_;
  std::vector<std::string> complaints_;
};

std::string text(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

void requireConsistent(const Parameters& p, Reader& reader) {
  reader.require(p.thresholds.critical_time <= p.thresholds.warn_time,
                 "~critical_time " + text(p.thresholds.critical_time) + " is above ~warn_time " +
                     text(p.thresholds.warn_time) +
                     "; allowed is 0 < critical_time <= warn_time <= horizon");
  reader.require(p.thresholds.warn_time <= p.horizon,
                 "~warn_time " + text(p.thresholds.warn_time) + " is above ~horizon " +
                     text(p.horizon) + "; allowed is 0 < critical_time <= warn_time <= horizon");
  reader.require(p.transform_tolerance <= p.max_data_age,
                 "~transform_tolerance " + text(p.transform_tolerance) +
                     " is above ~max_data_age " + text(p.max_data_age) +
                     "; a message would be too old when its transform comes");
}

}  // namespace

Parameters parametersFrom(const XmlRpc::XmlRpcValue& values) {
  constexpr double kShortest = 1e-3;  // [s] any positive time is meant in seconds, not below
  Parameters p;
  Reader reader(values);
  reader.number("horizon", kShortest, core::kMaxHorizon, p.horizon);
  reader.number("warn_time", kShortest, core::kMaxHorizon, p.thresholds.warn_time);
  reader.number("critical_time", kShortest, core::kMaxHorizon, p.thresholds.critical_time);
  reader.number("max_data_age", kShortest, 60, p.max_data_age);
  reader.number("transform_tolerance", 0, 60, p.transform_tolerance);
  reader.number("heartbeat_rate", 10, 1000, p.heartbeat_rate);
  reader.count("clear_after", 1, 1000, p.clear_after);
  reader.count("max_obstacles", 1, 1000000, p.max_obstacles);
  reader.count("max_vertices", 3, 100000, p.max_vertices);
  reader.frame("base_frame", p.base_frame);
  reader.frame("fixed_frame", p.fixed_frame);
  reader.choice<EgoMotion>(
      "ego_motion", {{"odom", EgoMotion::kOdom}, {"static", EgoMotion::kStatic}}, p.ego_motion);
  reader.choice<ObstacleVelocity>(
      "obstacle_velocity",
      {{"over_ground", ObstacleVelocity::kOverGround}, {"relative", ObstacleVelocity::kRelative}},
      p.obstacle_velocity);
  reader.choice<ObstacleDetectorRadius>("obstacle_detector_radius",
                                        {{"true_radius", ObstacleDetectorRadius::kTrueRadius},
                                         {"radius", ObstacleDetectorRadius::kRadius}},
                                        p.obstacle_detector_radius);
  double diagnostic_period = 1;  // is read by diagnostic_updater, which throws for a wrong one
  reader.number("diagnostic_period", 0.01, 60, diagnostic_period);
  reader.footprint(p.max_vertices, p.footprint);
  reader.refuseUnknown();
  requireConsistent(p, reader);
  reader.throwIfAny();
  return p;
}

}  // namespace footprint_collision_predictor
