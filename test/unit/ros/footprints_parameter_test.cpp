// The list of footprints: what is wrong is named with its index and key.
#include <gtest/gtest.h>

#include "parameters.hpp"

namespace footprint_collision_predictor {
namespace {

using Value = XmlRpc::XmlRpcValue;

constexpr char kSquare[] = "[[1, 1], [-1, 1], [-1, -1], [1, -1]]";

Value body(const std::string& name, const std::string& frame) {
  Value value;
  value["name"] = name;
  value["frame_id"] = frame;
  value["polygon"] = kSquare;
  return value;
}

/// A base and a trailer.
Value robot() {
  Value values;
  values["footprints"][0] = body("base", "base_link");
  values["footprints"][1] = body("trailer", "trailer_link");
  return values;
}

std::string complaintOf(const Value& values) try {
  parametersFrom(values);
  return "accepted";
} catch (const ParameterError& error) {
  return error.what();
}

/// \param change of the trailer
template <typename Change>
std::string complaintAfter(const Change& change) {
  Value values = robot();
  change(values["footprints"][1]);
  return complaintOf(values);
}

Value without(const Value& value, const std::string& key) {
  Value rest;
  for (const auto& [name, content] : value)
    if (name != key) rest[name] = content;
  return rest;
}

#define EXPECT_SAYS(complaint, words)                                      \
  do {                                                                     \
    const std::string said = complaint;                                    \
    EXPECT_NE(said.find(words), std::string::npos) << "it says: " << said; \
  } while (false)

TEST(FootprintsParameter, TheBaseMovesByOdometryAndTheOthersByTf) {
  const std::vector<Body> bodies = bodiesOf(parametersFrom(robot()));
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].name, "base");
  EXPECT_EQ(bodies[0].frame, "base_link");
  EXPECT_EQ(bodies[0].motion, BodyMotion::kOdom);
  EXPECT_EQ(bodies[1].frame, "trailer_link");
  EXPECT_EQ(bodies[1].motion, BodyMotion::kTf);
  ASSERT_TRUE(bodies[1].footprint);
  EXPECT_EQ(bodies[1].footprint->size(), 4u);
}

TEST(FootprintsParameter, MotionsCanBeChosen) {
  Value values = robot();
  values["footprints"][1]["motion"] = "odom";
  EXPECT_EQ(parametersFrom(values).footprints[1].motion, BodyMotion::kOdom);
  values["ego_motion"] = "static";
  EXPECT_SAYS(complaintOf(values), "~footprints[1].motion is odom, but ~ego_motion is static");
  values["footprints"][1]["motion"] = "static";
  const Parameters p = parametersFrom(values);
  EXPECT_EQ(p.footprints[0].motion, BodyMotion::kStatic) << "by ~ego_motion";
  EXPECT_EQ(p.footprints[1].motion, BodyMotion::kStatic);
}

TEST(FootprintsParameter, ATopicInsteadOfAPolygon) {
  Value values = robot();
  values["footprints"][1] = without(values["footprints"][1], "polygon");
  values["footprints"][1]["topic"] = "/trailer/footprint";
  values["footprints"][1]["frame_id"] = "/trailer_link";
  const Body trailer = parametersFrom(values).footprints[1];
  EXPECT_FALSE(trailer.footprint);
  EXPECT_EQ(trailer.topic, "/trailer/footprint");
  EXPECT_EQ(trailer.frame, "trailer_link") << "without the slash that tf2 refuses";
}

TEST(FootprintsParameter, WithoutItThereIsOneAsEver) {
  Value values;
  values["footprint"] = kSquare;
  values["base_frame"] = "base";
  const std::vector<Body> bodies = bodiesOf(parametersFrom(values));
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].name, "footprint");
  EXPECT_EQ(bodies[0].frame, "base");
  EXPECT_EQ(bodies[0].topic, "footprint");
  EXPECT_EQ(bodies[0].motion, BodyMotion::kOdom);
  EXPECT_TRUE(bodies[0].footprint);
}

TEST(FootprintsParameter, Fault39WhatIsMissingOrTooMuchIsNamed) {
  for (const char* key : {"name", "frame_id"})
    EXPECT_SAYS(complaintAfter([&](Value& trailer) { trailer = without(trailer, key); }),
                "~footprints[1]." + std::string(key) + " is missing; allowed is");
  EXPECT_SAYS(complaintAfter([](Value& trailer) { trailer = without(trailer, "polygon"); }),
              "~footprints[1] has neither polygon nor topic; allowed is one of them");
  EXPECT_SAYS(complaintAfter([](Value& trailer) { trailer["topic"] = "shape"; }),
              "~footprints[1] has both polygon and topic; allowed is one of them");
}

TEST(FootprintsParameter, Fault39WrongValuesAreNamedWithWhatIsAllowed) {
  const auto with = [](const std::string& key, const Value& value) {
    return complaintAfter([&](Value& trailer) { trailer[key] = value; });
  };
  EXPECT_SAYS(with("motion", "map"),
              "~footprints[1].motion is map; allowed is odom or static or tf");
  EXPECT_SAYS(with("name", "my trailer"),
              "~footprints[1].name is my trailer; allowed is a name of");
  EXPECT_SAYS(with("name", 3), "~footprints[1].name is 3; allowed is");
  EXPECT_SAYS(with("name", ""), "~footprints[1].name is ; allowed is");
  EXPECT_SAYS(with("name", "base"), "~footprints[1].name is base, as that of ~footprints[0]");
  EXPECT_SAYS(with("frame_id", 3.5), "~footprints[1].frame_id is 3.5; allowed is the name of a tf");
  EXPECT_SAYS(with("frame_id", "/"), "~footprints[1].frame_id is /; allowed is the name of a tf");
  EXPECT_SAYS(with("polygon", "[[0, 0], [1, 1], [1, 0], [0, 1]]"),
              "~footprints[1].polygon is refused: ");
  for (const char* topic : {"", "my topic", "~private"})
    EXPECT_SAYS(with("topic", topic),
                "~footprints[1].topic is " + std::string(topic) + "; allowed");
}

TEST(FootprintsParameter, Fault40UnknownKeysGetASuggestion) {
  EXPECT_SAYS(complaintAfter([](Value& trailer) { trailer["frame"] = "x"; }),
              "unknown parameter ~footprints[1].frame; did you mean ~footprints[1].frame_id?");
  EXPECT_SAYS(complaintAfter([](Value& trailer) { trailer["polygn"] = kSquare; }),
              "unknown parameter ~footprints[1].polygn; did you mean ~footprints[1].polygon?");
  Value values;
  values["footprnts"] = robot()["footprints"];
  EXPECT_SAYS(complaintOf(values), "unknown parameter ~footprnts; did you mean ~footprint");
}

TEST(FootprintsParameter, Fault42AnythingButAListShowsTheForm) {
  Value empty;
  empty.setSize(0);
  Value alone;
  alone[0] = "base";
  for (const Value& value : {Value("base"), Value(3), empty, alone, body("base", "base_link")}) {
    Value values;
    values["footprints"] = value;
    const std::string complaint = complaintOf(values);
    EXPECT_SAYS(complaint, "~footprints");
    EXPECT_SAYS(complaint, "allowed is a list with {name: trailer, frame_id: trailer, polygon: [[");
  }
}

TEST(FootprintsParameter, NotBesideASingleOne) {
  Value values = robot();
  values["footprint"] = kSquare;
  EXPECT_SAYS(complaintOf(values), "~footprint and ~footprints are both set; allowed is one");
}

TEST(FootprintsParameter, AllComplaintsComeAtOnce) {
  const std::string complaint = complaintAfter([](Value& trailer) {
    trailer["name"] = 1;
    trailer["motion"] = 2;
    trailer["size"] = 3;
  });
  for (const char* key : {"~footprints[1].name", "~footprints[1].motion", "~footprints[1].size"})
    EXPECT_SAYS(complaint, key);
}

}  // namespace
}  // namespace footprint_collision_predictor
