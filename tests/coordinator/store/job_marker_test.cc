#include "coordinator/store/job_marker.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/records/output_names.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "tests/support/map_store.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

// In a folder, and in a store.
class JobMarkerTest : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override { UseObjects(std::make_unique<MapStore>()); }
  void TearDown() override { UseObjects(nullptr); }

  TemporaryFolder temporary_;
  std::string folder_ = GetParam() ? "s3://b/out" : temporary_.path();
};

TEST_P(JobMarkerTest, IsHeldByOneJob) {
  auto first = JobMarker::Take(folder_);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(ErrorReason(JobMarker::Take(folder_).status()), "OUTPUT_IN_USE");
  first->reset();
  EXPECT_TRUE(JobMarker::Take(folder_).ok());
}

TEST_P(JobMarkerTest, KnowsAnUnfinishedOutput) {
  {
    const auto marker = JobMarker::Take(folder_);
    ASSERT_TRUE(marker.ok());
    EXPECT_FALSE((*marker)->had_key());
    ASSERT_TRUE((*marker)->Write("key").ok());
  }
  EXPECT_EQ(ReadFile(folder_ + "/" + kJobMarker).value_or(""), "key");
  EXPECT_TRUE((*JobMarker::Take(folder_))->had_key());
}

TEST_P(JobMarkerTest, IsTakenAway) {
  const auto marker = JobMarker::Take(folder_);
  ASSERT_TRUE(marker.ok());
  ASSERT_TRUE((*marker)->Write("key").ok());
  (*marker)->Remove();
  EXPECT_EQ(KindOf(folder_ + "/" + kJobMarker), PathKind::kNothing);
}

INSTANTIATE_TEST_SUITE_P(FolderAndStore, JobMarkerTest, testing::Bool());

}  // namespace
}  // namespace tilemend
