#include "worker/papers/front/front_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/mesh/rounding.h"
#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

constexpr Filler kFronts[] = {Filler::kAdvancingFrontNormal, Filler::kAdvancingFrontCurvature,
                              Filler::kAdvancingFrontPoisson, Filler::kSvmLaplacian};

Point3 Waves(const Point3& p) { return Point3(p.x(), p.y(), std::sin(0.3 * p.x()) + std::cos(0.4 * p.y())); }

class FrontFillTest : public testing::Test {
 protected:
  LocalPatch Fill(Filler filler, FillerOptions filling = {}) const {
    FillOptions options;
    options.filler = filler;
    options.filling = filling;
    std::vector<SpaceTriangle> surface;
    for (const Triangle& t : work_.band.triangles) {
      surface.push_back({work_.band.points[t[0]], work_.band.points[t[1]], work_.band.points[t[2]]});
    }
    return FillWithFront(hole_, options, [&] { return std::span<const SpaceTriangle>(surface); });
  }

  const CellHoles work_ = WorkOfSheet(Disc(0, 5, 5), Waves, 0.05);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

TEST_F(FrontFillTest, EachFillerClosesAHole) {
  for (const Filler filler : kFronts) {
    const LocalPatch patch = Fill(filler);
    SCOPED_TRACE(FillerName(filler));
    EXPECT_FALSE(patch.new_points.empty());
    ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, patch));
    for (const Point3& p : patch.new_points) {
      EXPECT_EQ(p, RoundedToLattice(p, work_.lattice_step));
      EXPECT_LT((p - Waves(Point3(p.x(), p.y(), 0))).norm(), 2);
    }
  }
}

TEST_F(FrontFillTest, EachOptionIsSeen) {
  const auto differs = [&](Filler filler, const FillerOptions& filling) {
    return Fill(filler).new_points != Fill(filler, filling).new_points;
  };
  FillerOptions merge, bend, halvings, steps, long_edge;
  merge.merge = 0.9;
  bend.bend = 3;
  halvings.halvings = 0;
  steps.centroid_steps = 0;
  long_edge.long_edge = 1;
  EXPECT_TRUE(differs(Filler::kAdvancingFrontPoisson, merge));
  EXPECT_TRUE(differs(Filler::kAdvancingFrontNormal, bend));
  EXPECT_TRUE(differs(Filler::kSvmLaplacian, long_edge));
  EXPECT_TRUE(differs(Filler::kAdvancingFrontCurvature, halvings));
  EXPECT_TRUE(differs(Filler::kAdvancingFrontCurvature, steps));
  FillerOptions printed;
  printed.steps = FrontSteps::kPrinted;
  for (const Filler filler : kFronts) EXPECT_TRUE(differs(filler, printed)) << FillerName(filler);
}

TEST_F(FrontFillTest, LongerRimsThanAllowedStayOpenWithThatReason) {
  FillerOptions filling;
  filling.longest_rim = static_cast<int32_t>(hole_.segments.size());
  for (const Filler filler : kFronts) EXPECT_TRUE(Fill(filler, filling).ok());
  --filling.longest_rim;
  for (const Filler filler : kFronts) EXPECT_EQ(Fill(filler, filling).failure, FillFailure::kTooLongForFront);
}

TEST_F(FrontFillTest, MoreWorkThanAllowedLeavesTheHoleOpenWithThatReason) {
  FillerOptions filling;
  filling.most_work = 0;
  for (const Filler filler : kFronts) EXPECT_EQ(Fill(filler, filling).failure, FillFailure::kTooMuchWork);
  EXPECT_NE(TextOf(FillFailure::kTooMuchWork, {3}).find("--filler-work"), std::string::npos);
}

TEST_F(FrontFillTest, WithoutLoopsThereIsNoFront) {
  LocalHole hole = MakeLocalHole(work_, band_, work_.holes[0]);
  hole.loops.clear();
  FillOptions options;
  options.filler = Filler::kAdvancingFrontNormal;
  EXPECT_EQ(FillWithFront(hole, options, {}).failure, FillFailure::kNotClosed);
}

}  // namespace
}  // namespace tilemend
