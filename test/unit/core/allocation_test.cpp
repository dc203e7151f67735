// In steady state nothing is allocated: every operator new of this program is counted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "scene.hpp"

namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* counted(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto boundary = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(boundary, (size + boundary - 1) / boundary * boundary))
    return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted(size, alignment);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace footprint_collision_predictor::test {
namespace {

using core::ObstacleBatch;
using core::Polygon;

class Evaluation {
 public:
  /// How often it allocates to go through a scene.
  std::size_t run(const Scene& scene, const Polygon& footprint) {
    const std::size_t before = allocations;
    batch_.clear();
    for (const core::Obstacle& o : scene.obstacles) batch_.add(o);
    firstContacts(footprint, scene.twist, batch_, scene.horizon, &contacts_);
    const auto first = firstContact(footprint, scene.twist, batch_, scene.horizon);
    hits_ += first.has_value();
    return allocations - before;
  }

  std::size_t hits() const { return hits_; }

 private:
  ObstacleBatch batch_;
  std::vector<std::optional<core::SegmentContact>> contacts_;
  std::size_t hits_ = 0;
};

TEST(Allocation, IsCounted) {
  const std::size_t before = allocations;
  const std::vector<double> vector(3);
  EXPECT_EQ(allocations, before + 1);
}

TEST(Allocation, IsNotNeededTheSecondTime) {
  std::size_t hits = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(1, i);
    const Scene scene = anyScene(random);
    const Polygon footprint(scene.footprint);
    Evaluation evaluation;
    EXPECT_GT(evaluation.run(scene, footprint), 0u);
    EXPECT_EQ(evaluation.run(scene, footprint), 0u) << "Random(1, " << i << ")";
    hits += evaluation.hits();
  }
  EXPECT_GT(hits, 50u);
}

TEST(Allocation, IsNotNeededForFewerThanBefore) {
  Random random(1, 3);
  Scene scene = anyScene(random);
  const Polygon footprint(scene.footprint);
  Evaluation evaluation;
  evaluation.run(scene, footprint);
  while (scene.obstacles.size() > 1) {
    scene.obstacles.erase(scene.obstacles.begin());
    EXPECT_EQ(evaluation.run(scene, footprint), 0u) << scene.obstacles.size();
  }
}

TEST(Allocation, IsNotNeededForOneCircle) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(2, i);
    const Scene scene = anyScene(random);
    const Polygon footprint(scene.footprint);
    if (!scene.obstacles[0].outline().empty()) continue;
    const std::size_t before = allocations;
    const auto contact = firstContact(footprint, scene.twist, scene.obstacles[0], scene.horizon);
    EXPECT_EQ(allocations, before) << "Random(2, " << i << "), " << contact.has_value();
  }
}

}  // namespace
}  // namespace footprint_collision_predictor::test
