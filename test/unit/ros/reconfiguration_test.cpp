// A live change is validated as a whole, and takes effect between evaluations.
#include "reconfiguration.hpp"

#include "pipeline_fixture.hpp"

namespace footprint_collision_predictor {
namespace {

using Warning = CollisionWarning;

TEST(Reconfiguration, TheDefaultsOfTheCfgAreThoseOfTheNode) {
  const PredictorConfig defaults = PredictorConfig::__getDefault__();
  const PredictorConfig own = configOf(Parameters());
  for (const auto& description : PredictorConfig::__getParamDescriptions__()) {
    boost::any a, b;
    description->getValue(defaults, a);
    description->getValue(own, b);
    if (description->type == "double")
      EXPECT_EQ(boost::any_cast<double>(a), boost::any_cast<double>(b)) << description->name;
    else
      EXPECT_EQ(boost::any_cast<int>(a), boost::any_cast<int>(b)) << description->name;
  }
}

TEST(Reconfiguration, EveryValueOfTheCfgArrives) {
  PredictorConfig config;
  config.horizon = 11;
  config.warn_time = 7;
  config.critical_time = 2;
  config.clear_after = 5;
  config.max_data_age = 0.75;
  config.transform_tolerance = 0.25;
  config.heartbeat_rate = 30;
  config.max_obstacles = 77;
  const PredictorConfig back = configOf(changed({}, config));
  for (const auto& description : PredictorConfig::__getParamDescriptions__()) {
    boost::any a, b;
    description->getValue(config, a);
    description->getValue(back, b);
    if (description->type == "double")
      EXPECT_EQ(boost::any_cast<double>(a), boost::any_cast<double>(b)) << description->name;
    else
      EXPECT_EQ(boost::any_cast<int>(a), boost::any_cast<int>(b)) << description->name;
  }
}

TEST(Reconfiguration, Fault41AContradictionIsRefusedByName) {
  PredictorConfig config = configOf(Parameters());
  config.warn_time = 6;
  try {
    changed({}, config);
    FAIL();
  } catch (const ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("~warn_time 6 is above ~horizon 5"),
              std::string::npos);
  }
}

class LiveChange : public PipelineFixture {
 protected:
  void change(double horizon) {
    parameters.horizon = horizon;
    pipeline().reconfigure(parameters);
  }
};

TEST_F(LiveChange, CountsFromTheNextMessage) {
  for (const double t : {99.7, 99.8, 99.9}) send(t, {});
  change(20);
  const Warning between = pipeline().repeat(at(99.95));
  EXPECT_EQ(between.horizon, 5) << "what was predicted reaches no further";
  EXPECT_EQ(between.level, Warning::CLEAR);
  const Warning next = send(100, {circleAhead(11, 1)});
  EXPECT_EQ(next.horizon, 20);
  EXPECT_NEAR(next.time_to_collision, 10, 1e-9);
}

TEST_F(LiveChange, CountsAtOnceWhenNothingIsPredicted) {
  pipeline().repeat(at(100));
  change(20);
  EXPECT_EQ(pipeline().repeat(at(100.05)).horizon, 20);
}

TEST_F(LiveChange, CountsAtOnceWhenAllIsTooOld) {
  send(100, {});
  change(20);
  EXPECT_EQ(pipeline().repeat(at(100.4)).horizon, 5);
  EXPECT_EQ(pipeline().repeat(at(101)).horizon, 20);
}

TEST_F(LiveChange, AShorterMaxDataAgeCountsForWhatCameBefore) {
  send(100, {});
  parameters.max_data_age = 0.2;
  pipeline().reconfigure(parameters);
  send(100.1, {});
  EXPECT_TRUE(pipeline().repeat(at(100.35)).reason & Warning::REASON_OBSTACLES_STALE);
}

}  // namespace
}  // namespace footprint_collision_predictor
