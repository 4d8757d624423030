#include "coordinator/jobs/delivery_check.h"

#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(IsOfDeliveryTest, FilesLieBesideTheFirstWithItsStem) {
  const std::string output = "Data/T/T.json";
  for (const char* path : {"Data/T/T.json", "Data/T/T_0.glb", "Data/T/T_12.jpg", "Data/T/T.mtl"}) {
    EXPECT_TRUE(IsOfDelivery(output, path)) << path;
  }
  for (const char* path : {"Data/T/U_0.glb", "Data/T/T_0.exe", "Data/T/T_/0.glb", "Data/T/T0.glb", "report.json",
                           "Data/T/T_0", "Data/T/T_../x.glb", ""}) {
    EXPECT_FALSE(IsOfDelivery(output, path)) << path;
  }
}

class DeliveryCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("a-0", "glb");
    folder_.Write("a-1", "json");
    input_.set_attempts(folder_.path());
    input_.set_output("T/T.json");
    input_.set_output_format("3dtiles");
    Add("T/T.json", "a-1", "json");
    Add("T/T_0.glb", "a-0", "glb");
  }
  void Add(const std::string& path, const std::string& attempt, const std::string& bytes) {
    v1::WrittenFile& file = *output_.add_files();
    file.set_path(path);
    file.set_attempt(attempt);
    file.set_bytes(static_cast<int64_t>(bytes.size()));
    file.set_digest(FileDigest(bytes));
  }
  absl::StatusCode Check(TileCheck how = TileCheck::kContent) { return CheckDelivery(input_, output_, how).code(); }

  const TemporaryFolder folder_;
  v1::AssembleInput input_;
  v1::AssembleOutput output_;
};

TEST_F(DeliveryCheckTest, TakesWhatWasAskedFor) { EXPECT_EQ(Check(), absl::StatusCode::kOk); }

TEST_F(DeliveryCheckTest, RefusesAnotherFirstFileAndFilesElsewhere) {
  output_.mutable_files()->SwapElements(0, 1);
  EXPECT_EQ(Check(), absl::StatusCode::kDataLoss);
  output_.mutable_files()->SwapElements(0, 1);
  Add("other/U.glb", "a-0", "glb");
  EXPECT_EQ(Check(TileCheck::kSize), absl::StatusCode::kDataLoss);
}

TEST_F(DeliveryCheckTest, RefusesAFileTwiceAndOtherBytes) {
  Add("T/T_0.glb", "a-0", "glb");
  EXPECT_EQ(Check(TileCheck::kSize), absl::StatusCode::kDataLoss);
  output_.mutable_files()->RemoveLast();
  folder_.Write("a-0", "bad");
  EXPECT_EQ(Check(TileCheck::kSize), absl::StatusCode::kOk);
  EXPECT_EQ(Check(TileCheck::kContent), absl::StatusCode::kDataLoss);
}

TEST_F(DeliveryCheckTest, RefusesNothing) {
  output_.clear_files();
  EXPECT_EQ(Check(), absl::StatusCode::kDataLoss);
}

}  // namespace
}  // namespace tilemend
