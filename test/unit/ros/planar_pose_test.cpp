// Transforms that cannot be used, and tilted ones.
#include "planar_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace footprint_collision_predictor {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDegree = 3.14159265358979323846 / 180;

geometry_msgs::Transform rolled(double degrees) {
  geometry_msgs::Transform transform;
  transform.translation.x = 1;
  transform.translation.y = 2;
  transform.translation.z = 3;
  transform.rotation.x = std::sin(degrees * kDegree / 2);
  transform.rotation.w = std::cos(degrees * kDegree / 2);
  return transform;
}

geometry_msgs::Transform pitched(double degrees) {
  geometry_msgs::Transform transform = rolled(degrees);
  std::swap(transform.rotation.x, transform.rotation.y);
  return transform;
}

TEST(PlanarPose, Fault26NumbersThatAreNotFiniteAreRefused) {
  for (const double bad : {kInfinity, -kInfinity, std::nan("")}) {
    for (double geometry_msgs::Vector3::*field :
         {&geometry_msgs::Vector3::x, &geometry_msgs::Vector3::y, &geometry_msgs::Vector3::z}) {
      geometry_msgs::Transform transform = rolled(0);
      transform.translation.*field = bad;
      EXPECT_THROW(project(transform), std::domain_error);
    }
    geometry_msgs::Transform transform = rolled(0);
    transform.rotation.w = bad;
    EXPECT_THROW(project(transform), std::domain_error);
  }
}

TEST(PlanarPose, Fault26AnInfiniteTranslationInTfIsNamed) {
  tf2::BufferCore tf;
  geometry_msgs::TransformStamped stamped;
  stamped.header.frame_id = "map";
  stamped.child_frame_id = "base_link";
  stamped.transform = rolled(0);
  stamped.transform.translation.y = kInfinity;
  ASSERT_TRUE(tf.setTransform(stamped, "test", true)) << "tf2 accepts it";
  try {
    lookUpPose(tf, "map", "base_link", ros::Time(100));
    FAIL();
  } catch (const TransformError& error) {
    const std::string text = error.what();
    for (const char* word : {"\"map\"", "\"base_link\"", "not finite"})
      EXPECT_NE(text.find(word), std::string::npos) << text;
  }
}

TEST(PlanarPose, Fault27RollAndPitchAreProjected) {
  const PlanarPose roll = project(rolled(29));
  EXPECT_NEAR(roll.position.x(), 1, 1e-15);
  EXPECT_NEAR(roll.position.y(), 2, 1e-15);
  EXPECT_NEAR(roll.x_axis.x(), 1, 1e-15) << "rolling turns about the x axis";
  const PlanarPose pitch = project(pitched(-29));
  EXPECT_NEAR(pitch.x_axis.x(), 1, 1e-15) << "shortened, but of unit length again";
  EXPECT_NEAR(pitch.x_axis.y(), 0, 1e-15);
}

TEST(PlanarPose, Fault27MoreThan30DegreesAreRefused) {
  for (const double degrees : {29.9, -29.9}) {
    EXPECT_NO_THROW(project(rolled(degrees)));
    EXPECT_NO_THROW(project(pitched(degrees)));
  }
  for (const double degrees : {30.1, -30.1, 90.0, 180.0}) {
    EXPECT_THROW(project(rolled(degrees)), std::domain_error);
    EXPECT_THROW(project(pitched(degrees)), std::domain_error);
  }
}

}  // namespace
}  // namespace footprint_collision_predictor
