// The core includes no ROS header. They lie in the system include path, so the compiler is content.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace footprint_collision_predictor {
namespace {

namespace fs = std::filesystem;

/// ROS, tf2, message packages, and this package's own messages (X.h; the core has only X.hpp).
bool isForbidden(const std::string& line) {
  static const std::regex kForbidden(
      R"(^\s*#\s*include\s*[<"](.*/)?(ros/|tf2|[a-z0-9_]+_msgs/|footprint_collision_predictor/\w+\.h[>"]))");
  return std::regex_search(line, kForbidden);
}

std::vector<fs::path> filesIn(const std::string& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(PACKAGE_DIR) / directory))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

void expectNoRos(const fs::path& file) {
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    EXPECT_FALSE(isForbidden(line)) << file << ":" << number << ": " << line;
  }
  EXPECT_GT(number, 0) << file;
}

TEST(CoreHasNoRos, NeitherInHeadersNorInSources) {
  const std::vector<fs::path> headers = filesIn("include/footprint_collision_predictor");
  const std::vector<fs::path> sources = filesIn("src/core");
  EXPECT_GE(headers.size(), 6u);
  EXPECT_GE(sources.size(), 6u);
  for (const fs::path& file : headers) expectNoRos(file);
  for (const fs::path& file : sources) expectNoRos(file);
}

TEST(CoreHasNoRos, TheRuleKnowsWhatItRefuses) {
  EXPECT_TRUE(isForbidden("#include <ros/ros.h>"));
  EXPECT_TRUE(isForbidden("  # include \"ros/time.h\""));
  EXPECT_TRUE(isForbidden("#include <tf2/LinearMath/Vector3.h>"));
  EXPECT_TRUE(isForbidden("#include <tf2_ros/buffer.h>"));
  EXPECT_TRUE(isForbidden("#include <geometry_msgs/Point.h>"));
  EXPECT_TRUE(isForbidden("#include <footprint_collision_predictor/Obstacle.h>"));
  EXPECT_TRUE(isForbidden("#include \"footprint_collision_predictor/ros/warning_watchdog.hpp\""));
  EXPECT_FALSE(isForbidden("#include <Eigen/Core>"));
  EXPECT_FALSE(isForbidden("#include \"footprint_collision_predictor/polygon.hpp\""));
  EXPECT_FALSE(isForbidden("// no ros/ros.h here"));
}

}  // namespace
}  // namespace footprint_collision_predictor
