#include <algorithm>

#include "batch.hpp"
#include "benchmarks.hpp"
#include "instruction_sets.hpp"
#include "measurement.hpp"

namespace footprint_collision_predictor::bench {
namespace {

using core::ObstacleBatch;
using SegmentContacts = std::vector<std::optional<core::SegmentContact>>;

/// A scene cut into lists of one size, as many as make up the usual number of inputs: short lists
/// differ from call to call too.
class Lists {
 public:
  Lists(SharedScene scene, std::size_t size) : scene_(std::move(scene)), size_(size) {
    auto from = scene_->obstacles.begin();
    for (std::size_t i = 0; i < std::max<std::size_t>(1, kInputs / size); ++i) {
      const auto to = from + static_cast<std::ptrdiff_t>(size);
      if (size < scene_->obstacles.size()) obstacles_.emplace_back(from, to);
      batches_.emplace_back(obstacles(i));
      from = to;
    }
  }

  const Scene& scene() const { return *scene_; }
  /// Of each list.
  std::size_t size() const { return size_; }
  std::size_t count() const { return batches_.size(); }
  const std::vector<Obstacle>& obstacles(std::size_t i) const {
    return obstacles_.empty() ? scene_->obstacles : obstacles_[i];
  }
  core::BatchQuery query(std::size_t i, core::InstructionSet set) const {
    return query(batches_[i], set);
  }
  core::BatchQuery query(const ObstacleBatch& batch, core::InstructionSet set) const {
    return {scene_->footprint, scene_->twist, batch, kHorizon, set};
  }

 private:
  SharedScene scene_;
  std::size_t size_;
  std::vector<std::vector<Obstacle>> obstacles_;  // none where one list is all of the scene
  std::vector<ObstacleBatch> batches_;
};

using SharedLists = std::shared_ptr<const Lists>;

double timeOf(const std::optional<core::SegmentContact>& contact) {
  return contact ? contact->contact.time : kNever;
}

/// The true answers for one size of lists; needed only while methods are added.
class ManyGroup {
 public:
  ManyGroup(SharedLists lists, const SceneTruths& truths) : lists_(std::move(lists)) {
    const std::size_t segments = lists_->scene().footprint.size(), size = lists_->size();
    for (std::size_t j = 0; j < lists_->count(); ++j) {
      const Range obstacles{j * size, (j + 1) * size};
      Truth of_footprint;
      for (const Truth& of_segment : truths.ofSegments(obstacles)) {
        const std::size_t i = segments_.size() % segments;
        segments_.push_back({&lists_->scene(), {i, i + 1}, obstacles});
        segment_truths_.push_back(of_segment);
        of_footprint = first(of_footprint, of_segment);
      }
      footprints_.push_back({&lists_->scene(), {0, segments}, obstacles});
      footprint_truths_.push_back(of_footprint);
    }
  }

  /// \param answer `const SegmentContacts&` for list i
  template <typename Answer>
  void addForSegments(const std::string& method, const Answer& answer) const {
    const std::size_t segments = lists_->scene().footprint.size();
    SegmentContacts contacts;  // of one list, for all of its segments
    const auto one = [&](std::size_t i) {
      if (i % segments == 0) contacts = answer(i / segments);
      return timeOf(contacts[i % segments]);
    };
    add(method, judge(segments_, segment_truths_, kGuarantee, one), answer);
  }

  /// \param answer double(std::size_t): first contact of list i, or kNever
  template <typename Answer>
  void addForFootprint(const std::string& method, const Answer& answer) const {
    add(method, judge(footprints_, footprint_truths_, kGuarantee, answer), answer);
  }

 private:
  template <typename Answer>
  void add(const std::string& method, const Score& score, const Answer& answer) const {
    const std::string name =
        "many/" + lists_->scene().name() + "/" + method + "_" + std::to_string(lists_->size());
    addMeasurement(name, lists_->count(), lists_->size(), score, kGuarantee, answer);
  }

  SharedLists lists_;
  std::vector<Question> footprints_, segments_;
  std::vector<Truth> footprint_truths_, segment_truths_;
};

void addSet(const ManyGroup& group, const SharedLists& lists, const NamedSet& set) {
  const auto kept = std::make_shared<SegmentContacts>();  // as a caller would, to spare allocation
  group.addForSegments("batch_" + set.name, [=](std::size_t i) -> const SegmentContacts& {
    core::firstContacts(lists->query(i, set.set), kept.get());
    return *kept;
  });
  group.addForFootprint("lean_" + set.name, [=](std::size_t i) {
    const auto contact = core::firstContact(lists->query(i, set.set));
    return contact ? contact->contact.time : kNever;
  });
}

void addWhole(const ManyGroup& group, const SharedLists& lists) {
  const auto contacts = std::make_shared<SegmentContacts>();
  const auto batch = std::make_shared<ObstacleBatch>();
  group.addForSegments("filled", [=](std::size_t i) -> const SegmentContacts& {
    batch->clear();
    for (const Obstacle& obstacle : lists->obstacles(i)) batch->add(obstacle);
    const Scene& scene = lists->scene();
    core::firstContacts(scene.footprint, scene.twist, *batch, kHorizon, contacts.get());
    return *contacts;
  });
  group.addForSegments("predict", [=](std::size_t i) {
    const Scene& scene = lists->scene();
    return core::predict(scene.footprint, scene.twist, lists->obstacles(i), kHorizon).segments;
  });
}

}  // namespace

void addManyBenchmarks(const SharedScene& scene, const SceneTruths& truths) {
  for (std::size_t size = 10; size <= scene->obstacles.size(); size *= 10) {
    const auto lists = std::make_shared<const Lists>(scene, size);
    const ManyGroup group(lists, truths);
    for (const NamedSet& set : supportedSets()) addSet(group, lists, set);
    addWhole(group, lists);
  }
}

}  // namespace footprint_collision_predictor::bench
