#include "worker/check/fill_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FillPiecesTest, PiecesShareNoEdge) {
  const Triangle a = {0, 1, 2}, b = {0, 2, 3}, at_a_vertex = {3, 4, 5};
  EXPECT_THAT(PiecesByEdges({a, at_a_vertex, b}), ElementsAre(ElementsAre(a, b), ElementsAre(at_a_vertex)));
}

TEST(FillPiecesTest, NoTrianglesHaveNoPieces) { EXPECT_THAT(PiecesByEdges({}), IsEmpty()); }

}  // namespace
}  // namespace tilemend
