// A folder for one test, removed with everything in it at the end.
#ifndef TILEMEND_TESTS_SUPPORT_TEMPORARY_FOLDER_H_
#define TILEMEND_TESTS_SUPPORT_TEMPORARY_FOLDER_H_

#include <gtest/gtest.h>

#include <cstdlib>  // mkdtemp, of POSIX
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "common/util/files.h"

namespace tilemend {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::path(testing::TempDir()) / "tilemend-XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) ADD_FAILURE() << "cannot create " << path_;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string operator/(std::string_view name) const { return path_ + "/" + std::string(name); }

  // Writes a file under the folder, with its parent folders; returns its path.
  std::string Write(std::string_view name, std::string_view content) const {
    std::string file = *this / name;
    const absl::Status status = WriteFileAtomically(file, content, Sync::kNo);
    EXPECT_TRUE(status.ok()) << status;
    return file;
  }

 private:
  std::string path_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TEMPORARY_FOLDER_H_
