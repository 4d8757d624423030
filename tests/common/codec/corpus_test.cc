// Every file of a corpus of odd and malformed meshes: no crash, in bounds of time and memory, and whatever parses takes
// a patch. The corpus is not part of the project: the environment variable or CMake variable TILEMEND_SHARED_DATA names
// it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "common/codec/mesh_file.h"
#include "common/util/files.h"
#include "tests/fuzz/append_property.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

fs::path CorpusFolder() {
  const char* const variable = std::getenv("TILEMEND_SHARED_DATA");
  return fs::path(variable != nullptr ? variable : TILEMEND_SHARED_DATA) / "malformed";
}

std::vector<std::string> CorpusFiles() {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(CorpusFolder(), error), end; !error && it != end; it.increment(error)) {
    if (it->is_regular_file()) files.push_back(it->path().lexically_relative(CorpusFolder()).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(CorpusTest, IsThere) {
  if (!fs::is_directory(CorpusFolder())) {
    GTEST_SKIP() << "NO CORPUS AT " << CorpusFolder()
                 << ": the malformed files are not tested; set TILEMEND_SHARED_DATA";
  }
  EXPECT_FALSE(CorpusFiles().empty());
}

class CorpusFileTest : public ::testing::TestWithParam<std::string> {};

TEST_P(CorpusFileTest, IsReadOrRefusedWithinBounds) {
  const std::string path = CorpusFolder() / GetParam();
  const auto begin = std::chrono::steady_clock::now();
  const absl::StatusOr<MeshFile> file = ReadMeshFile(path);
  if (file.ok()) {
    const absl::StatusOr<std::string> bytes = ReadFile(path);
    ASSERT_TRUE(bytes.ok());
    EXPECT_EQ(AppendPropertyViolation(file->format, *bytes), "");
  } else {
    EXPECT_EQ(file.status().code(), absl::StatusCode::kInvalidArgument);
    EXPECT_NE(file.status().message().find(path), absl::string_view::npos) << file.status();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(seconds.count(), 2);
  rusage usage = {};
  ASSERT_EQ(::getrusage(RUSAGE_SELF, &usage), 0);
  EXPECT_LT(usage.ru_maxrss, 512 << 10);  // KiB
}

std::string NameOf(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CorpusFileTest);
INSTANTIATE_TEST_SUITE_P(Malformed, CorpusFileTest, ::testing::ValuesIn(CorpusFiles()), NameOf);

}  // namespace
}  // namespace tilemend
