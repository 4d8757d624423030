#include "common/util/object_store.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/roots.h"
#include "tests/support/map_store.h"

namespace tilemend {
namespace {

class ObjectStoreTest : public testing::Test {
 protected:
  void SetUp() override {
    auto store = std::make_unique<MapStore>();
    store_ = store.get();
    UseObjects(std::move(store));
    store_->objects = {{"s3://b/in/t.obj", "mesh"}, {"s3://b/in/images/a.png", "png"}};
  }
  void TearDown() override {
    KeepFilesTo(nullptr);
    UseObjects(nullptr);
  }

  MapStore* store_ = nullptr;
};

TEST_F(ObjectStoreTest, IsReadAsFiles) {
  EXPECT_EQ(*ReadFile("s3://b/in/t.obj"), "mesh");
  EXPECT_EQ(ReadFileEnds("s3://b/in/t.obj", 2)->last, "sh");
  std::string pieces;
  ASSERT_TRUE(
      ReadInPieces("s3://b/in/t.obj", 3, [&](std::string_view piece) { pieces += std::string(piece) + "|"; }).ok());
  EXPECT_EQ(pieces, "mes|h|");
  EXPECT_TRUE(absl::IsNotFound(ReadFile("s3://b/in/u.obj").status()));
}

TEST_F(ObjectStoreTest, HasFoldersWhereKeysBeginSo) {
  EXPECT_EQ(KindOf("s3://b/in"), PathKind::kFolder);
  EXPECT_EQ(KindOf("s3://b/in/t.obj"), PathKind::kFile);
  EXPECT_EQ(KindOf("s3://b/i"), PathKind::kNothing);
  EXPECT_EQ(*ListFolder("s3://b/in"), (std::vector<std::string>{"images", "t.obj"}));
  const auto kinds = ListKinds("s3://b/in");
  ASSERT_TRUE(kinds.ok());
  EXPECT_EQ(kinds->at(0).kind, PathKind::kFolder);
  EXPECT_EQ(kinds->at(1).kind, PathKind::kFile);
}

TEST_F(ObjectStoreTest, TellsUnreachableFromMissing) {
  store_->unreachable = true;
  EXPECT_TRUE(absl::IsUnavailable(LookAt("s3://b/in").status()));
  EXPECT_TRUE(absl::IsUnavailable(ListKinds("s3://b/in").status()));
}

TEST_F(ObjectStoreTest, CopiesWithinTheStore) {
  ASSERT_TRUE(CarryFile("s3://b/in/t.obj", "s3://b/out/t.obj", Carry::kLink).ok());
  EXPECT_EQ(store_->objects["s3://b/out/t.obj"], "mesh");
  EXPECT_EQ(store_->copies, 1);
  EXPECT_FALSE(CarryFile("s3://b/in/t.obj", "s3://b/in/t.obj", Carry::kCopy).ok());
}

TEST_F(ObjectStoreTest, CarriesFromAndToFolders) {
  const std::string file = testing::TempDir() + "/object_store_test.obj";
  ASSERT_TRUE(CarryFile("s3://b/in/t.obj", file, Carry::kCopy).ok());
  EXPECT_EQ(*ReadFile(file), "mesh");
  ASSERT_TRUE(CarryFile(file, "s3://b/out/u.obj", Carry::kCopy).ok());
  EXPECT_EQ(store_->objects["s3://b/out/u.obj"], "mesh");
}

TEST_F(ObjectStoreTest, MovesAnObject) {
  ASSERT_TRUE(MoveFile("s3://b/in/t.obj", "s3://b/out/t.obj").ok());
  EXPECT_FALSE(store_->objects.contains("s3://b/in/t.obj"));
  EXPECT_EQ(store_->objects["s3://b/out/t.obj"], "mesh");
  EXPECT_TRUE(absl::IsNotFound(MoveFile("s3://b/in/t.obj", "s3://b/out/t.obj")));
}

// A worker that wakes after its output is complete writes nothing.
TEST_F(ObjectStoreTest, WritesNewObjectsOnlyIntoFoldersThatAreThere) {
  EXPECT_TRUE(WriteNewFile("s3://b/in/new", "x").ok());
  EXPECT_TRUE(absl::IsNotFound(WriteNewFile("s3://b/gone/new", "x")));
  EXPECT_TRUE(absl::IsNotFound(CarryToNewFile("s3://b/in/t.obj", "s3://b/gone/new", Carry::kCopy).status()));
  EXPECT_FALSE(store_->objects.contains("s3://b/gone/new"));
}

TEST_F(ObjectStoreTest, RemovesAllBelowAFolder) {
  store_->objects["s3://b/input"] = "stays";
  ASSERT_TRUE(RemoveTree("s3://b/in").ok());
  EXPECT_EQ(store_->objects.size(), 1U);
}

TEST_F(ObjectStoreTest, KeepsToRoots) {
  KeepFilesTo(*Roots::Open({"/tmp", "s3://b/in"}));
  EXPECT_TRUE(ReadFile("s3://b/in/t.obj").ok());
  EXPECT_EQ(ErrorReason(WriteFileAtomically("s3://b/out/t.obj", "x")), "OUTSIDE_ROOTS");
  EXPECT_EQ(ErrorReason(CarryFile("s3://b/in/t.obj", "s3://b/out/t.obj", Carry::kCopy)), "OUTSIDE_ROOTS");
  EXPECT_EQ(ErrorReason(ListFolder("s3://b").status()), "OUTSIDE_ROOTS");
}

TEST_F(ObjectStoreTest, IsRefusedWhereAProgramHasNone) {
  UseObjects(nullptr);
  EXPECT_TRUE(absl::IsUnimplemented(ReadFile("s3://b/in/t.obj").status()));
}

}  // namespace
}  // namespace tilemend
