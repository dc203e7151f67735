// Output that appears under its name only when it is complete.
#pragma once

#include <stdexcept>
#include <string>

namespace footprint_collision_predictor::tools {

/// Thrown when a file cannot be written; what() names it and says why.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Hands out a name beside `path` to write to; finish() moves that file to `path`, and without it
/// (an error, an exception) it is removed.
class PartialFile {
 public:
  /// \throws WriteError when nothing can be written there; what() says why.
  explicit PartialFile(const std::string& path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  const std::string& partialPath() const { return partial_path_; }
  /// \throws WriteError
  void finish();

 private:
  std::string path_;
  std::string partial_path_;
};

}  // namespace footprint_collision_predictor::tools
