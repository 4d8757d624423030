#include "coordinator/check/patch_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>

#include "tests/support/outline_hole.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// A square hole, 4 metres wide, whose rim runs 0, 1, 2, 3.
CellHoles Asked() {
  CellHoles asked;
  for (const Point3& p : {Point3(0, 0, 5), Point3(4, 0, 5), Point3(4, 4, 5), Point3(0, 4, 5)}) {
    RimVertex v;
    v.index = static_cast<int32_t>(asked.vertices.size());
    v.position = p;
    asked.vertices.push_back(v);
  }
  asked.holes = {{7, false, {{0, 1, false}, {1, 2, false}, {2, 3, false}, {3, 0, false}}}};
  return asked;
}

// A fan around one new vertex.
std::vector<HolePatch> Fan() {
  HolePatch patch;
  patch.hole = 7;
  patch.way = FillWay::kGround;
  patch.new_points = {{2, 2, 5}};
  patch.triangles = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}};
  return {patch};
}

QualityTally TallyOf(const std::vector<HolePatch>& patches) {
  QualityTally tally;
  for (const HolePatch& patch : patches) {
    for (size_t i = 0; i < patch.triangles.size(); ++i) tally.Add(0.8, false);
  }
  return tally;
}

// What Check says of the fan after a change, "" if nothing.
std::string Fault(const std::function<void(HolePatch&)>& change) {
  auto patches = Fan();
  change(patches[0]);
  return std::string(CheckPatches(Asked(), patches, TallyOf(patches)).message());
}

TEST(PatchCheckTest, TakesAPatchThatClosesItsHole) {
  EXPECT_EQ(Fault([](HolePatch&) {}), "");
  EXPECT_EQ(Fault([](HolePatch& p) { p.new_points.push_back({1, 1, 5}); }), "") << "a vertex that nothing uses";
  EXPECT_EQ(Fault([](HolePatch& p) { p = {7, "its rim is crossed"}; }), "");
}

TEST(PatchCheckTest, EveryHoleHasOneAnswer) {
  EXPECT_THAT(Fault([](HolePatch& p) { p.hole = 8; }), HasSubstr("hole 7: no patch"));
  EXPECT_THAT(std::string(CheckPatches(Asked(), {}, {}).message()), HasSubstr("no patch"));
  auto two = Fan();
  two.push_back(two[0]);
  EXPECT_THAT(std::string(CheckPatches(Asked(), two, TallyOf(two)).message()), HasSubstr("two patches"));
  two[1].hole = 8;
  EXPECT_THAT(std::string(CheckPatches(Asked(), two, TallyOf(two)).message()), HasSubstr("not asked for"));
}

TEST(PatchCheckTest, RefusesAPatchThatDoesNotCloseItsHole) {
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles.clear(); }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles.pop_back(); }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles.push_back(p.triangles[0]); }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles.assign(300, Triangle(p.triangles[0])); }), "");
  EXPECT_NE(Fault([](HolePatch& p) { std::swap(p.triangles[0][0], p.triangles[0][1]); }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles[0] = {0, 0, -1}; }), "");
  EXPECT_NE(Fault([](HolePatch& p) {
              for (Triangle& t : p.triangles) std::swap(t[0], t[1]);
            }),
            "");
  // A closed body beside a sound patch has every edge twice, once each way: it is not seen.
  EXPECT_NE(Fault([](HolePatch& p) { p.triangles.push_back({0, 2, 1}); }), "") << "on the other side of the rim";
}

TEST(PatchCheckTest, APatchMayEndBesideItsTilesOwnOutline) {
  const auto fault = [](const Point3& beside, bool own_outline) {
    CellHoles asked = HoleAtOutline();
    asked.holes[0].own_outline = own_outline;
    HolePatch patch;
    patch.hole = 7;
    patch.way = FillWay::kGround;
    patch.new_points = {{2, 2, 5}, beside};
    patch.triangles = {{0, -2, -1}, {-2, 2, -1}, {2, 3, -1}, {3, 4, -1}, {4, 0, -1}};
    return std::string(CheckPatches(asked, {patch}, TallyOf({patch})).message());
  };
  EXPECT_EQ(fault({2, 0.1, 5}, true), "");
  EXPECT_NE(fault({2, 0.5, 5}, true), "") << "too far from it";
  EXPECT_NE(fault({2, 0.1, 5}, false), "") << "another tile has the vertex between";
}

TEST(PatchCheckTest, RefusesVerticesFarFromTheHole) {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  for (const Point3& p : {Point3(1e9, 2, 5), Point3(2, 2, 1e9), Point3(kNoNumber, 2, 5), Point3(2, 2, -30)}) {
    EXPECT_THAT(Fault([&](HolePatch& patch) { patch.new_points[0] = p; }), HasSubstr("far from the hole"));
  }
  EXPECT_EQ(Fault([](HolePatch& patch) { patch.new_points[0] = {2, 2, 8}; }), "");
  CellHoles asked = Asked();
  asked.holes[0].level = -30;
  auto patches = Fan();
  patches[0].new_points[0] = {2, 2, -30};
  EXPECT_TRUE(CheckPatches(asked, patches, TallyOf(patches)).ok()) << "water lies where its level is";
  asked = Asked();
  asked.vertices[1].ground = -30;
  EXPECT_TRUE(CheckPatches(asked, patches, TallyOf(patches)).ok()) << "ground lies under the object at the rim";
}

TEST(PatchCheckTest, RefusesTrianglesThatAreFlatOrFaceDown) {
  EXPECT_THAT(Fault([](HolePatch& p) { p.new_points[0] = {0, 0, 5}; }), HasSubstr("without area"));
  EXPECT_THAT(Fault([](HolePatch& p) { p.new_points[0] = {2, 0, 5}; }), HasSubstr("without area"));
  const auto fold = [](HolePatch& p) { p.new_points[0] = {2, -2, 5}; };
  EXPECT_THAT(Fault(fold), HasSubstr("faces down"));
  EXPECT_EQ(Fault([&](HolePatch& p) { fold(p), p.way = FillWay::kSpace; }), "") << "no heights over the ground";
  EXPECT_EQ(Fault([](HolePatch& p) { p.new_points[0] = {2, -0.001, 5}; }), "") << "the rim is rounded";
}

TEST(PatchCheckTest, AnswersDoNotContradictThemselves) {
  EXPECT_NE(Fault([](HolePatch& p) { p.failure = "no"; }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p.way = FillWay::kNone; }), "");
  EXPECT_NE(Fault([](HolePatch& p) { p = {7, std::string(1 << 20, 'x')}; }), "");
  QualityTally tally = TallyOf(Fan());
  tally.poor_forced = 1;
  EXPECT_NE(CheckPatches(Asked(), Fan(), tally), absl::OkStatus());
  tally = TallyOf(Fan());
  ++tally.triangles;
  EXPECT_NE(CheckPatches(Asked(), Fan(), tally), absl::OkStatus());
  tally = TallyOf(Fan());
  tally.least = std::nan("");
  EXPECT_NE(CheckPatches(Asked(), Fan(), tally), absl::OkStatus());
}

// Whatever is done to the corners: what is taken has each rim segment once, and each other edge twice.
TEST(PatchCheckTest, TakesNothingThatIsOpen) {
  std::mt19937 random(1);
  int taken = 0;
  for (int round = 0; round < 20'000; ++round) {
    auto patches = Fan();
    HolePatch& patch = patches[0];
    patch.new_points.push_back({1, 2, 5});
    for (int changes = static_cast<int>(random() % 4); changes > 0; --changes) {
      const size_t t = random() % patch.triangles.size();
      if (random() % 4 == 0) {
        patch.triangles.push_back(patch.triangles[t]);
      } else {
        patch.triangles[t][random() % 3] = static_cast<int32_t>(random() % 6) - 2;
      }
    }
    if (!CheckPatches(Asked(), patches, TallyOf(patches)).ok()) continue;
    ++taken;
    std::map<std::pair<int32_t, int32_t>, int> uses;
    for (const Triangle& t : patch.triangles) {
      for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (const auto& [edge, n] : uses) {
      ASSERT_EQ(n, 1);
      const bool rim = edge.first >= 0 && edge.second == (edge.first + 1) % 4;
      ASSERT_EQ(uses.count({edge.second, edge.first}), rim ? 0U : 1U);
    }
    for (int v = 0; v < 4; ++v) ASSERT_EQ(uses.count({v, (v + 1) % 4}), 1U);
  }
  EXPECT_GT(taken, 1000);
  EXPECT_LT(taken, 19'000);
}

}  // namespace
}  // namespace tilemend
