// Every file of a corpus of broken and odd meshes through the real commands: no crash, an exit code that means
// something, little time and memory. The corpus is not part of the project: TILEMEND_SHARED_DATA in CMake says where it
// is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;

std::vector<std::string> Corpus() {
  std::vector<std::string> files;
  std::error_code error;
  const std::string root = std::string(TILEMEND_SHARED_DATA) + "/malformed";
  for (const auto& entry : fs::recursive_directory_iterator(root, error)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(root).string());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) std::cerr << "NOT TESTED: no files in " << root << "; set TILEMEND_SHARED_DATA\n";
  return files;
}

class MalformedTest : public ::testing::TestWithParam<std::string> {
 protected:
  void ExpectSound(const Ended& ended) {
    EXPECT_THAT(ended.code, AnyOf(0, 4, 100)) << ended.err;
    ExpectFrugal(ended);
    if (ended.code == 4) {
      EXPECT_THAT(ended.err, HasSubstr(in_ + ": "));
    }
  }

  const std::string in_ = std::string(TILEMEND_SHARED_DATA) + "/malformed/" + GetParam();
  TemporaryFolder folder_;
};

TEST_P(MalformedTest, InspectSaysWhatItIs) {
  ExpectSound(Process(folder_.path(), TILEMEND_CLIENT, {"inspect", in_}).Wait());
}

TEST_P(MalformedTest, FillGivesAReadableMeshOrNone) {
  const std::string out = folder_ / ("out" + fs::path(in_).extension().string());
  const Ended ended = Process(folder_.path(), TILEMEND_CLIENT, {"fill", in_, "--out", out}).Wait();
  ExpectSound(ended);
  EXPECT_EQ(fs::exists(out), ended.code != 4);
  if (ended.code == 4) return;
  const auto before = ReadMeshFile(in_), after = ReadMeshFile(out);
  ASSERT_TRUE(before.ok() && after.ok()) << before.status() << after.status();
  ASSERT_GE(after->mesh.points.size(), before->mesh.points.size());
  ASSERT_GE(after->mesh.triangles.size(), before->mesh.triangles.size());
  EXPECT_TRUE(std::equal(before->mesh.points.begin(), before->mesh.points.end(), after->mesh.points.begin()));
  EXPECT_TRUE(std::equal(before->mesh.triangles.begin(), before->mesh.triangles.end(), after->mesh.triangles.begin()));
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MalformedTest);
INSTANTIATE_TEST_SUITE_P(Corpus, MalformedTest, ::testing::ValuesIn(Corpus()), [](const auto& file) {
  std::string name = file.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(MalformedCorpusTest, IsThere) {
  if (Corpus().empty()) GTEST_SKIP() << "no malformed files in " << TILEMEND_SHARED_DATA;
}

}  // namespace
}  // namespace tilemend
