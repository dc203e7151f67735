// What rosparam makes of the same text: its values and types.
#include "analysis/yaml_parameters.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace footprint_collision_predictor::tools {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue read(const std::string& text) {
  char path[] = "/tmp/yaml_parameters_test_XXXXXX";
  close(mkstemp(path));
  std::ofstream(path) << text;
  struct Remove {
    const char* path;
    ~Remove() { std::remove(path); }
  } remove{path};
  return readParameters(path);
}

XmlRpcValue::Type typeOf(const std::string& text) { return read("p: " + text)["p"].getType(); }

TEST(YamlParametersTest, Types) {
  EXPECT_EQ(typeOf("3"), XmlRpcValue::TypeInt);
  EXPECT_EQ(typeOf("-3"), XmlRpcValue::TypeInt);
  EXPECT_EQ(typeOf("3.0"), XmlRpcValue::TypeDouble);
  EXPECT_EQ(typeOf("3."), XmlRpcValue::TypeDouble);
  EXPECT_EQ(typeOf(".5"), XmlRpcValue::TypeDouble);
  EXPECT_EQ(typeOf("1.0e-3"), XmlRpcValue::TypeDouble);
  EXPECT_EQ(typeOf("1e-3"), XmlRpcValue::TypeString);
  EXPECT_EQ(typeOf("'3'"), XmlRpcValue::TypeString);
  EXPECT_EQ(typeOf("\"3\""), XmlRpcValue::TypeString);
  EXPECT_EQ(typeOf("odom"), XmlRpcValue::TypeString);
  EXPECT_EQ(typeOf("true"), XmlRpcValue::TypeBoolean);
  EXPECT_EQ(typeOf("Off"), XmlRpcValue::TypeBoolean);
  EXPECT_EQ(typeOf("[[1, 2.5], [3, 4]]"), XmlRpcValue::TypeArray);
}

TEST(YamlParametersTest, Values) {
  XmlRpcValue values = read("a: 3\nb: 0.25  # a comment\nc: [[1, 2.5]]\nd: {e: text}\n");
  EXPECT_EQ(static_cast<int>(values["a"]), 3);
  EXPECT_EQ(static_cast<double>(values["b"]), 0.25);
  EXPECT_EQ(static_cast<int>(values["c"][0][0]), 1);
  EXPECT_EQ(static_cast<double>(values["c"][0][1]), 2.5);
  EXPECT_EQ(static_cast<std::string>(values["d"]["e"]), "text");
}

TEST(YamlParametersTest, WhatIsNoListOfParametersIsRefused) {
  EXPECT_THROW(read("just words"), ParameterFileError);
  EXPECT_THROW(read("a: [1, 2"), ParameterFileError);
  EXPECT_THROW(read("a: 99999999999"), ParameterFileError);
  EXPECT_THROW(readParameters("/no/such/file.yaml"), ParameterFileError);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
