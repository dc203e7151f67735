// The folder that the results go to.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../partial_file.hpp"
#include "replay.hpp"
#include "row_origin.hpp"

namespace footprint_collision_predictor::tools {

/// The rows of one report as they come, kept in a file until it is known what those of the others
/// are like. Writing fails late: finish() tells.
class RowsFile {
 public:
  /// \throws WriteError
  explicit RowsFile(const std::string& path);
  ~RowsFile();
  RowsFile(const RowsFile&) = delete;
  RowsFile& operator=(const RowsFile&) = delete;

  void take(const Evaluation& evaluation);
  /// \throws WriteError when any row could not be written
  void finish();
  const std::string& path() const { return path_; }
  /// The most that a row has.
  std::size_t segments() const { return segments_; }

 private:
  std::string path_;
  std::ofstream out_;
  std::size_t segments_ = 0;
};

/// A file that is written at once when its content is there, by any thread, and appears with the
/// others at the end. Writing fails late: finish() tells.
class LateFile {
 public:
  void write(const std::string& path, const std::function<void(std::ostream&)>& content);
  /// \throws WriteError when it could not be written
  void finish();

 private:
  std::unique_ptr<PartialFile> file_;
  std::string problem_;
};

/// Results appear under their names only when they are complete; what was there before stays until
/// then.
class OutputFolder {
 public:
  /// Makes the folder, and a file for the rows of each report. \throws WriteError
  OutputFolder(const std::string& path, std::size_t reports);

  RowsFile& rows(std::size_t report) { return *rows_.at(report); }

  /// Joins the rows of all reports to frames.csv. \throws WriteError
  /// \param origins what the rows of each end with
  void writeFrames(const std::vector<RowOrigin>& origins);
  /// One report's page, which is kept back until finishPages().
  void writePage(std::size_t report, const std::string& name,
                 const std::function<void(std::ostream&)>& content);
  /// \throws WriteError
  void finishPages();
  /// \throws WriteError
  void write(const std::string& name, const std::function<void(std::ostream&)>& content) const;
  void write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
  std::vector<LateFile> pages_;                  // by the index of the report
  std::vector<std::unique_ptr<RowsFile>> rows_;  // likewise
};

}  // namespace footprint_collision_predictor::tools
