// One bag from its file to what there is to say about it; a bag of a robot of several bodies as
// often as it has bodies, which do not depend on each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "event.hpp"
#include "film.hpp"
#include "options.hpp"
#include "output_folder.hpp"
#include "parameters.hpp"
#include "progress.hpp"
#include "statistics.hpp"
#include "topic_choice.hpp"

namespace footprint_collision_predictor::tools {

struct BagReport {
  std::string bag;        ///< as it was named on the command line
  std::string footprint;  ///< name of the body; empty where the robot has only one
  std::string page;       ///< pageName()
  int status = 0;         ///< kDone, kUsage or kBagUnreadable
  std::string problem;    ///< when it could not be read, or not to its end
  bool partial = false;   ///< not all of the window has been analysed
  Window window{};
  TopicChoice topics;
  std::size_t refused_transforms = 0;
  Statistics statistics;
  std::vector<Event> events;
};

class BagAnalysis {
 public:
  BagAnalysis(const Options& options, const Parameters& parameters)
      : options_(options), parameters_(parameters), bodies_(bodiesOf(parameters)) {}

  /// Bags times bodies.
  std::size_t count() const { return options_.bags.size() * bodies_.size(); }
  /// \param index below count(), like all below: all bodies of the first bag come first
  const Body& bodyAt(std::size_t index) const { return bodies_[index % bodies_.size()]; }

  /// Never throws for a bag that cannot be used: the report says so.
  /// \param output where the rows go; null: nowhere
  BagReport analyze(std::size_t index, OutputFolder* output, Progress& progress) const;

  /// What would be analysed, without doing it.
  BagReport look(std::size_t index) const;

 private:
  BagReport begun(std::size_t index) const;
  void run(std::size_t index, OutputFolder* output, Film* film, Progress& progress,
           BagReport& report) const;
  Window windowOf(const Window& span, const std::string& bag) const;

  const Options& options_;
  const Parameters& parameters_;
  const std::vector<Body> bodies_;
};

}  // namespace footprint_collision_predictor::tools
