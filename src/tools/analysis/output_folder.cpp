#include "output_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "frames_csv.hpp"

namespace footprint_collision_predictor::tools {
namespace {

using Content = std::function<void(std::ostream&)>;

/// Complete, but not yet under its name.
std::unique_ptr<PartialFile> written(const std::string& path, const Content& content) {
  auto file = std::make_unique<PartialFile>(path);
  std::ofstream out(file->partialPath(), std::ios::binary);
  content(out);
  out.close();
  if (!out) throw WriteError("cannot write " + path + ": writing failed (is the disk full?)");
  return file;
}

void copyRows(const std::string& from, std::size_t segments, const RowOrigin& origin,
              std::ostream& out) {
  std::ifstream in(from, std::ios::binary);
  for (std::string row; std::getline(in, row);)
    out << row << framesRowEnd(segmentsIn(row), segments, origin) << '\n';
}

}  // namespace

RowsFile::RowsFile(const std::string& path) : path_(path), out_(path, std::ios::binary) {
  if (!out_) throw WriteError("cannot write " + path + ": " + std::strerror(errno));
}

RowsFile::~RowsFile() { std::remove(path_.c_str()); }

void RowsFile::take(const Evaluation& evaluation) {
  out_ << framesRow(evaluation) << '\n';
  if (evaluation.answer.prediction)
    segments_ = std::max(segments_, evaluation.answer.prediction->segments.size());
}

void RowsFile::finish() {
  out_.close();
  if (!out_) throw WriteError("cannot write " + path_ + ": writing failed (is the disk full?)");
}

void LateFile::write(const std::string& path, const Content& content) try {
  file_ = written(path, content);
} catch (const WriteError& error) {
  problem_ = error.what();
}

void LateFile::finish() {
  if (!problem_.empty()) throw WriteError(problem_);
  if (file_) file_->finish();
}

OutputFolder::OutputFolder(const std::string& path, std::size_t reports)
    : path_(path), pages_(reports) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw WriteError("cannot make the folder " + path + ": " + error.message());
  for (std::size_t i = 0; i < reports; ++i)
    rows_.push_back(
        std::make_unique<RowsFile>(path + "/frames.csv." + std::to_string(i) + ".part"));
}

void OutputFolder::writeFrames(const std::vector<RowOrigin>& origins) {
  std::size_t segments = 0;
  for (const auto& rows : rows_) {
    rows->finish();
    segments = std::max(segments, rows->segments());
  }
  write("frames.csv", [&](std::ostream& out) {
    out << framesHeader(segments) << originHeader(origins.front()) << '\n';
    for (std::size_t i = 0; i < rows_.size(); ++i)
      copyRows(rows_[i]->path(), segments, origins.at(i), out);
  });
}

void OutputFolder::writePage(std::size_t report, const std::string& name, const Content& content) {
  std::error_code ignored;  // writing fails then, and says so
  std::filesystem::create_directories(std::filesystem::path(path_ + "/" + name).parent_path(),
                                      ignored);
  pages_.at(report).write(path_ + "/" + name, content);
}

void OutputFolder::finishPages() {
  for (LateFile& page : pages_) page.finish();
}

void OutputFolder::write(const std::string& name, const Content& content) const {
  written(path_ + "/" + name, content)->finish();
}

void OutputFolder::write(const std::string& name, const std::string& text) const {
  write(name, [&](std::ostream& out) { out << text; });
}

}  // namespace footprint_collision_predictor::tools
