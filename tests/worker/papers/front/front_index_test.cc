#include "worker/papers/front/front_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace tilemend {
namespace {

Eigen::AlignedBox3d BoxAround(const Point3& p, double reach) {
  return {p - Point3::Constant(reach), p + Point3::Constant(reach)};
}

// A closed walk through random places, with edges of very different lengths.
class FrontIndexTest : public testing::Test {
 protected:
  static constexpr int32_t kCount = 400;

  FrontIndexTest() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-1, 1);
    Point3 at(1e6, -2e6, 5);
    for (int32_t i = 0; i < kCount; ++i) {
      const double length = std::ldexp(1.0, i % 9 - 6);
      at += length * Point3(part(random), part(random), part(random));
      points_.push_back(at);
    }
    std::vector<int32_t> all(kCount);
    std::iota(all.begin(), all.end(), 0);
    loops_.emplace(std::vector<std::vector<int32_t>>{all});
    index_.emplace(*loops_);
    for (int32_t node = 0; node < kCount; ++node) Add(node);
  }

  void Add(int32_t node) { index_->Add(node, At(node), At((*loops_)[node].after), 1); }
  const Point3& At(int32_t node) const { return points_[(*loops_)[node].vertex]; }

  // No edge whose box meets the box may be missing.
  void ExpectAllIn(const Eigen::AlignedBox3d& box) {
    const std::vector<int32_t> near = index_->Near(box);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (const int32_t node : loops_->Alive()) {
      Eigen::AlignedBox3d edge(At(node));
      edge.extend(At((*loops_)[node].after));
      if (edge.intersects(box)) {
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), node)) << node;
      }
    }
    for (const int32_t node : near) EXPECT_TRUE((*loops_)[node].alive);
  }

  std::vector<Point3> points_;
  std::optional<FrontLoops> loops_;
  std::optional<FrontIndex> index_;
};

TEST_F(FrontIndexTest, FindsEveryEdgeNearABoxOfAnySize) {
  for (const double reach : {0.0, 0.01, 1.0, 30.0, 1e9}) {
    for (int32_t i = 0; i < kCount; i += 7) ExpectAllIn(BoxAround(points_[i], reach));
  }
}

TEST_F(FrontIndexTest, DropsEdgesThatAreGoneAndFindsThoseInTheirPlace) {
  for (int32_t node = 0; node < kCount; node += 2) {
    const int32_t before = (*loops_)[node].before;
    loops_->CutOff(node);
    Add(before);
  }
  for (int32_t i = 0; i < kCount; i += 7) ExpectAllIn(BoxAround(points_[i], 1));
}

TEST_F(FrontIndexTest, LooksAtWhatIsNearAlone) {
  const int64_t before = index_->looked_at();
  const auto near = std::ssize(index_->Near(BoxAround(points_[0], 0.01)));
  EXPECT_LT(near, kCount / 2);
  EXPECT_GE(index_->looked_at() - before, near);
  EXPECT_LT(index_->looked_at() - before, kCount / 2);
}

TEST_F(FrontIndexTest, EdgesWithoutLengthAreFound) {
  const std::vector<Point3> points(3, Point3(7, 7, 7));
  const FrontLoops loops(std::vector<std::vector<int32_t>>{{0, 1, 2}});
  FrontIndex index(loops);
  for (const int32_t node : {0, 1, 2}) index.Add(node, points[0], points[0], 1e-30);
  EXPECT_EQ(index.Near(BoxAround(points[0], 0)).size(), 3u);
}

}  // namespace
}  // namespace tilemend
