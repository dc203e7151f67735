#include "partial_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace footprint_collision_predictor::tools {

PartialFile::PartialFile(const std::string& path) : path_(path), partial_path_(path + ".part") {
  // The bag library does not say why it cannot open a file; the system does.
  std::FILE* file = std::fopen(partial_path_.c_str(), "wb");
  if (file == nullptr) throw WriteError("cannot write " + path_ + ": " + std::strerror(errno));
  std::fclose(file);
}

PartialFile::~PartialFile() {
  if (!partial_path_.empty()) std::remove(partial_path_.c_str());
}

void PartialFile::finish() {
  if (std::rename(partial_path_.c_str(), path_.c_str()) != 0) {
    throw WriteError("cannot write " + path_ + ": " + std::strerror(errno));
  }
  partial_path_.clear();
}

}  // namespace footprint_collision_predictor::tools
