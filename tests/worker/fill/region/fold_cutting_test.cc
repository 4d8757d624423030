#include "worker/fill/region/fold_cutting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

bool Any(int32_t, int32_t) { return true; }

std::vector<RegionSegment> LoopOver(const std::vector<LatticePoint>& points) {
  std::vector<RegionSegment> segments;
  const auto n = static_cast<int32_t>(points.size());
  for (int32_t i = 0; i < n; ++i) segments.push_back({i, (i + 1) % n});
  return segments;
}

// A square whose south side turns back across itself.
const std::vector<LatticePoint> kFolded = {{0, 0},     {300, 0},  {600, 0},     {500, -60}, {560, 90},
                                           {640, -50}, {1000, 0}, {1000, 1000}, {0, 1000}};

void ExpectWhole(const CutBoundary& cut, const std::vector<RegionSegment>& segments) {
  ASSERT_EQ(cut.original.size(), cut.segments.size());
  size_t kept = 0, chords = 0;
  for (size_t s = 0; s < cut.segments.size(); ++s) {
    if (cut.original[s] < 0) {
      ++chords;
      continue;
    }
    ++kept;
    EXPECT_EQ(cut.segments[s].from, segments[cut.original[s]].from);
    EXPECT_EQ(cut.segments[s].to, segments[cut.original[s]].to);
  }
  EXPECT_EQ(chords, cut.runs.size());
  size_t in_runs = 0;
  for (const std::vector<int32_t>& run : cut.runs) in_runs += run.size() - 1;
  EXPECT_EQ(kept + in_runs, segments.size()) << "every segment is in a run or stays";
}

TEST(FoldCuttingTest, LeavesASimpleBoundaryAlone) {
  const std::vector<LatticePoint> points = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const CutBoundary cut = CutFolds(points, LoopOver(points), Any);
  EXPECT_TRUE(cut.simple);
  EXPECT_TRUE(cut.runs.empty());
  EXPECT_EQ(cut.segments.size(), 4u);
}

TEST(FoldCuttingTest, CutsOffAFold) {
  const std::vector<RegionSegment> segments = LoopOver(kFolded);
  const CutBoundary cut = CutFolds(kFolded, segments, Any);
  EXPECT_TRUE(cut.simple);
  EXPECT_FALSE(cut.runs.empty());
  EXPECT_TRUE(TriangulateRegion(kFolded, cut.segments).conflicts.empty());
  ExpectWhole(cut, segments);
}

TEST(FoldCuttingTest, CutsWhereverTheLoopBegins) {
  for (size_t start = 0; start < kFolded.size(); ++start) {
    std::vector<LatticePoint> points = kFolded;
    std::rotate(points.begin(), points.begin() + static_cast<ptrdiff_t>(start), points.end());
    const std::vector<RegionSegment> segments = LoopOver(points);
    const CutBoundary cut = CutFolds(points, segments, Any);
    EXPECT_TRUE(cut.simple) << start;
    ExpectWhole(cut, segments);
  }
}

TEST(FoldCuttingTest, MakesNoChordThatIsNotAllowed) {
  const std::vector<RegionSegment> segments = LoopOver(kFolded);
  const CutBoundary free = CutFolds(kFolded, segments, Any);
  ASSERT_FALSE(free.runs.empty());
  const int32_t a = free.runs[0].front(), b = free.runs[0].back();
  const CutBoundary cut =
      CutFolds(kFolded, segments, [&](int32_t from, int32_t to) { return std::minmax(from, to) != std::minmax(a, b); });
  ASSERT_FALSE(cut.runs.empty());
  ExpectWhole(cut, segments);
  for (const std::vector<int32_t>& run : cut.runs) {
    EXPECT_FALSE(std::minmax(run.front(), run.back()) == std::minmax(a, b));
  }
  EXPECT_EQ(cut.simple, TriangulateRegion(kFolded, cut.segments).conflicts.empty());
}

// A short loop is then closed in space as a whole.
TEST(FoldCuttingTest, CutsOffTheWholeLoopWhereNoChordIsAllowed) {
  const CutBoundary cut = CutFolds(kFolded, LoopOver(kFolded), [](int32_t, int32_t) { return false; });
  EXPECT_TRUE(cut.segments.empty());
  ASSERT_EQ(cut.runs.size(), 1u);
  EXPECT_EQ(cut.runs[0].size(), kFolded.size());
}

}  // namespace
}  // namespace tilemend
