#include "worker/materials/write_materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "common/store/digest.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(WriteMaterialsTest, AddsThemToACopy) {
  const TemporaryFolder folder;
  const std::string from = folder.Write("in/T.mtl", "newmtl a\n");
  ASSERT_TRUE(WriteMaterials(from, folder / "out/T.mtl", {{"b", {1, 2, 3}}}).ok());
  EXPECT_THAT(ReadFile(folder / "out/T.mtl").value(), StartsWith("newmtl a\nnewmtl b\n"));
  EXPECT_EQ(ReadFile(from).value(), "newmtl a\n");
  ASSERT_TRUE(WriteMaterials("", folder / "out/new.mtl", {{"b", {1, 2, 3}}}).ok());
  EXPECT_THAT(ReadFile(folder / "out/new.mtl").value(), StartsWith("newmtl b\n"));
}

TEST(WriteMaterialsTest, AddsThemToNoOtherFileThanWasSurveyed) {
  const TemporaryFolder folder;
  const std::string from = folder.Write("T.mtl", "newmtl a\n");
  EXPECT_TRUE(MaterialsAfter(from, {}, FileDigest("newmtl a\n")).ok());
  const absl::Status changed = MaterialsAfter(from, {}, FileDigest("newmtl b\n")).status();
  EXPECT_TRUE(absl::IsAborted(changed));
  EXPECT_THAT(std::string(changed.message()), StartsWith(from));
}

TEST(CarryFilesTest, LinksImagesButNeverMaterialFiles) {
  const TemporaryFolder folder;
  for (const char* name : {"in/a/T.MTL", "in/a/T.jpg"}) folder.Write(name, name);
  for (const bool link : {false, true}) {
    const auto warnings = CarryFiles(folder / "in", folder / "out", {"a/T.MTL", "a/T.jpg"}, link);
    ASSERT_TRUE(warnings.ok()) << warnings.status();
    EXPECT_THAT(*warnings, IsEmpty());
    EXPECT_EQ(ReadFile(folder / "out/a/T.jpg").value(), "in/a/T.jpg");
    EXPECT_EQ(std::filesystem::hard_link_count(folder / "in/a/T.MTL"), 1U);
    EXPECT_EQ(std::filesystem::hard_link_count(folder / "in/a/T.jpg"), link ? 2U : 1U);
  }
}

TEST(CarryFilesTest, WarnsOfWhatIsGone) {
  const TemporaryFolder folder;
  folder.Write("in/b.jpg", "b");
  const auto warnings = CarryFiles(folder / "in", folder / "out", {"a.jpg", "b.jpg"}, false);
  ASSERT_TRUE(warnings.ok()) << warnings.status();
  EXPECT_THAT(*warnings, ElementsAre(HasSubstr("in/a.jpg: cannot open")));
  EXPECT_EQ(ReadFile(folder / "out/b.jpg").value(), "b") << "the others are carried";
}

}  // namespace
}  // namespace tilemend
