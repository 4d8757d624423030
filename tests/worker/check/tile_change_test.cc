#include "worker/check/tile_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LookedMesh Squares() {
  LookedMesh tile;
  tile.mesh = PictureMesh({"###", "#.#", "###"});
  tile.looks.assign(tile.mesh.triangles.size(), 7);
  return tile;
}

TEST(TileChangeTest, WhatIsAppendedWasAddedAndNothingIsMissing) {
  const LookedMesh before = Squares();
  LookedMesh after = before;
  after.mesh.triangles.push_back({0, 1, 2});
  after.looks.push_back(0);
  const TileChange change = CompareTiles(before, after);
  EXPECT_THAT(change.missing, IsEmpty());
  EXPECT_EQ(change.added_count, 1);
  EXPECT_TRUE(change.added.back());
}

TEST(TileChangeTest, TheOrderOfTrianglesDoesNotCount) {
  const LookedMesh before = Squares();
  LookedMesh after = before;
  std::reverse(after.mesh.triangles.begin(), after.mesh.triangles.end());
  const TileChange change = CompareTiles(before, after);
  EXPECT_THAT(change.missing, IsEmpty());
  EXPECT_EQ(change.added_count, 0);
}

TEST(TileChangeTest, ATriangleThatIsGoneIsNamed) {
  const LookedMesh before = Squares();
  LookedMesh after = before;
  after.mesh.triangles.erase(after.mesh.triangles.begin() + 3);
  after.looks.pop_back();
  EXPECT_THAT(CompareTiles(before, after).missing, ElementsAre(3));
}

TEST(TileChangeTest, WithoutLooksOnlyPositionsAreCompared) {
  LookedMesh before = Squares(), after = before;
  after.mesh.triangles.erase(after.mesh.triangles.begin() + 3);
  after.mesh.triangles.push_back({0, 1, 2});
  before.looks.clear();
  after.looks.clear();
  const TileChange change = CompareTiles(before, after);
  EXPECT_THAT(change.missing, ElementsAre(3));
  EXPECT_EQ(change.added_count, 1);
  EXPECT_TRUE(change.added.back());
}

TEST(TileChangeTest, ATileWithoutLooksHasTheLookZero) {
  LookedMesh bare = Squares();
  bare.looks.clear();
  LookedMesh looked = Squares();
  looked.looks.assign(looked.looks.size(), 0);
  looked.looks[5] = 7;
  EXPECT_THAT(CompareTiles(bare, looked).missing, ElementsAre(5));
  EXPECT_EQ(CompareTiles(bare, looked).added_count, 1);
  EXPECT_THAT(CompareTiles(looked, bare).missing, ElementsAre(5));
}

TEST(TileChangeTest, OneBitOfACoordinateOrOfTheLookIsAChange) {
  const LookedMesh before = Squares();
  LookedMesh moved = before;
  moved.mesh.points[0].z() = 1e-300;
  const size_t at_vertex = CompareTiles(before, moved).missing.size();
  EXPECT_GT(at_vertex, 0U);
  EXPECT_EQ(CompareTiles(before, moved).added_count, static_cast<int64_t>(at_vertex));
  LookedMesh looked = before;
  looked.looks[5] = 8;
  EXPECT_THAT(CompareTiles(before, looked).missing, ElementsAre(5));
}

TEST(TileChangeTest, ATriangleThatWasThereTwiceMustBeThereTwice) {
  LookedMesh before = Squares();
  before.mesh.triangles.push_back(before.mesh.triangles[0]);
  before.looks.push_back(7);
  EXPECT_THAT(CompareTiles(before, Squares()).missing.size(), 1U);
}

}  // namespace
}  // namespace tilemend
