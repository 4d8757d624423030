#include "coordinator/store/scratch_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "tests/support/mesh_builders.h"
#include "tests/support/temporary_folder.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

SurveyRecord SomeRecord() {
  SurveyRecord record = SurveyTile(PictureMesh({"#####", "#####", "#####"}), true);
  record.colours.resize(record.vertices.size());
  record.colours[2] = Rgb{1, 2, 3};
  return record;
}

TEST(ScratchFileTest, GivesBackWhatWasPutAside) {
  const auto file = ScratchFile::Create("");
  ASSERT_TRUE(file.ok()) << file.status();
  const auto a = (*file)->Put("one"), empty = (*file)->Put(""), b = (*file)->Put("and two");
  EXPECT_EQ((*file)->Get(*b).value(), "and two");
  EXPECT_EQ((*file)->Get(*empty).value(), "");
  EXPECT_EQ((*file)->Get(*a).value(), "one");
}

TEST(ScratchFileTest, LeavesNoNameInItsFolder) {
  const TemporaryFolder folder;
  const auto file = ScratchFile::Create(folder.path());
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ScratchFileTest, NeedsAFolder) {
  const auto file = ScratchFile::Create("/no/such/folder");
  EXPECT_EQ(file.status().code(), absl::StatusCode::kNotFound);
}

TEST(ScratchFileTest, ARecordIsReadBackAsItWas) {
  auto file = ScratchFile::Create("");
  ASSERT_TRUE(file.ok()) << file.status();
  const SurveyRecord record = SomeRecord();
  ASSERT_FALSE(record.band.triangles.empty());
  const auto kept = (*file)->Keep(record);
  ASSERT_TRUE(kept.ok()) << kept.status();
  file->reset();  // the handle keeps the file
  EXPECT_EQ((*kept)->vertex_count, record.vertex_count);
  const auto again = kept->WithBand();
  EXPECT_EQ(again->hi, record.hi);
  ASSERT_EQ(again->vertices.size(), record.vertices.size());
  for (size_t v = 0; v < record.vertices.size(); ++v) {
    EXPECT_EQ(again->vertices[v].position, record.vertices[v].position);
    EXPECT_EQ(again->vertices[v].index, record.vertices[v].index);
  }
  ASSERT_EQ(again->edges.size(), record.edges.size());
  EXPECT_EQ(again->edges.back().to, record.edges.back().to);
  EXPECT_EQ(again->colours, record.colours);
  EXPECT_EQ(again->band.points, record.band.points);
  EXPECT_EQ(again->band.triangles, record.band.triangles);
}

TEST(ScratchFileTest, AnOutlineIsReadWithoutTheBand) {
  const auto file = ScratchFile::Create("");
  ASSERT_TRUE(file.ok()) << file.status();
  const auto kept = (*file)->Keep(SomeRecord());
  ASSERT_TRUE(kept.ok()) << kept.status();
  EXPECT_EQ(kept->Outline()->edges.size(), SomeRecord().edges.size());
  EXPECT_TRUE(kept->Outline()->band.points.empty());
}

}  // namespace
}  // namespace tilemend
