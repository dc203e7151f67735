// Every wrong parameter is named with its value and what is allowed; nothing falls back to a
// default.
#include "parameters.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace footprint_collision_predictor {
namespace {

XmlRpc::XmlRpcValue values(const std::string& name, const XmlRpc::XmlRpcValue& value) {
  XmlRpc::XmlRpcValue all;
  all[name] = value;
  return all;
}

std::string complaintOf(const XmlRpc::XmlRpcValue& all) try {
  parametersFrom(all);
  return "accepted";
} catch (const ParameterError& error) {
  return error.what();
}

TEST(Parameters, NoneGivesTheDocumentedDefaults) {
  const Parameters p = parametersFrom(XmlRpc::XmlRpcValue());
  EXPECT_FALSE(p.footprint);
  EXPECT_EQ(p.base_frame, "base_link");
  EXPECT_EQ(p.fixed_frame, "odom");
  EXPECT_EQ(p.horizon, 5);
  EXPECT_EQ(p.thresholds.warn_time, 3);
  EXPECT_EQ(p.thresholds.critical_time, 1.5);
  EXPECT_EQ(p.max_data_age, 0.5);
  EXPECT_EQ(p.transform_tolerance, 0.1);
  EXPECT_EQ(p.heartbeat_rate, 20);
  EXPECT_EQ(p.clear_after, 3u);
}

TEST(Parameters, Fault39WrongValuesAreNamedWithWhatIsAllowed) {
  struct Case {
    const char* name;
    XmlRpc::XmlRpcValue value;
    const char* allowed;
  };
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Case cases[] = {{"horizon", "1e-3", "0.001 or 1.0e-3"},
                        {"horizon", 0.0, "0.001 to 3600"},
                        {"horizon", 3601.0, "0.001 to 3600"},
                        {"warn_time", kNaN, "0.001 to 3600"},
                        {"critical_time", -1.5, "0.001 to 3600"},
                        {"max_data_age", 0, "0.001 to 60"},
                        {"heartbeat_rate", 5, "10 to 1000"},
                        {"clear_after", 0, "1 to 1000"},
                        {"clear_after", 2.5, "whole number"},
                        {"base_frame", 3, "name of a tf frame"},
                        {"base_frame", "", "name of a tf frame"},
                        {"ego_motion", "still", "odom or static"},
                        {"obstacle_velocity", "x", "over_ground or relative"},
                        {"obstacle_detector_radius", true, "radius or true_radius"}};
  for (const Case& c : cases) {
    const std::string complaint = complaintOf(values(c.name, c.value));
    EXPECT_NE(complaint.find("~" + std::string(c.name) + " is "), std::string::npos) << complaint;
    EXPECT_NE(complaint.find(c.allowed), std::string::npos) << complaint;
  }
}

TEST(Parameters, Fault39ContradictionsAreNamed) {
  EXPECT_NE(
      complaintOf(values("critical_time", 3.5)).find("~critical_time 3.5 is above ~warn_time"),
      std::string::npos);
  EXPECT_NE(complaintOf(values("horizon", 2.0)).find("~warn_time 3 is above ~horizon 2"),
            std::string::npos);
  EXPECT_NE(complaintOf(values("transform_tolerance", 1.0)).find("~max_data_age"),
            std::string::npos);
}

TEST(Parameters, Fault40UnknownOnesGetASuggestion) {
  EXPECT_EQ(complaintOf(values("waring_time", 3.0)),
            "unknown parameter ~waring_time; did you mean ~warn_time?");
  EXPECT_EQ(complaintOf(values("xyzzy", 3.0)), "unknown parameter ~xyzzy");
  EXPECT_EQ(complaintOf(values("diagnostic_period", 0.5)), "accepted");
}

TEST(Parameters, AllComplaintsComeAtOnce) {
  XmlRpc::XmlRpcValue all = values("horizon", -1);
  all["clear_after"] = 0;
  const std::string complaint = complaintOf(all);
  EXPECT_NE(complaint.find("~horizon"), std::string::npos);
  EXPECT_NE(complaint.find("~clear_after"), std::string::npos);
}

TEST(Parameters, Fault42TheFootprintIsAListOrAString) {
  XmlRpc::XmlRpcValue list;
  const double corners[3][2] = {{1, 0}, {0, 1}, {-1, 0}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 2; ++k) list[i][k] = corners[i][k];
  for (const XmlRpc::XmlRpcValue& value :
       {list, XmlRpc::XmlRpcValue("[[1, 0], [0, 1.0], [-1., 0]]")}) {
    const Parameters p = parametersFrom(values("footprint", value));
    ASSERT_TRUE(p.footprint);
    ASSERT_EQ(p.footprint->size(), 3u);
    EXPECT_EQ(p.footprint->vertices()[2], core::Vec2(-1, 0));
  }
}

TEST(Parameters, Fault42AnythingElseShowsBothForms) {
  XmlRpc::XmlRpcValue short_pair;
  short_pair[0][0] = 1.0;
  for (const XmlRpc::XmlRpcValue& value :
       {XmlRpc::XmlRpcValue("[[1, 0], [0"), XmlRpc::XmlRpcValue("[[1, 0, 3]]"),
        XmlRpc::XmlRpcValue("circle"), XmlRpc::XmlRpcValue("[[a, b]]"), XmlRpc::XmlRpcValue(3),
        XmlRpc::XmlRpcValue(""), short_pair}) {
    const std::string complaint = complaintOf(values("footprint", value));
    EXPECT_NE(complaint.find("~footprint is refused"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("write a list"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("string \"[["), std::string::npos) << complaint;
  }
}

TEST(Parameters, AFootprintThatIsNoPolygonNamesTheRule) {
  const std::string complaint =
      complaintOf(values("footprint", "[[0, 0], [1, 1], [1, 0], [0, 1]]"));
  EXPECT_NE(complaint.find("segments 0 and 2 cross"), std::string::npos) << complaint;
}

}  // namespace
}  // namespace footprint_collision_predictor
