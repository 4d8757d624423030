#include "common/util/build_id.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tilemend {
namespace {

namespace fs = std::filesystem;

TEST(BuildIdTest, HasSixteenDigits) { EXPECT_THAT(BuildId(), ::testing::MatchesRegex("[0-9a-f]+")); }

// Sources of their own, and what is written for them.
class BuildIdScriptTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    Write("a.cc", "one");
    Write("b.cc", "two");
    Write("files", "a.cc\nb.cc\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  std::string Made(const std::string& tools = "compiler 1") {
    const std::string out = folder_ / "out.cc";
    const std::string command = std::string(TILEMEND_CMAKE) + " -DFOLDER=" + folder_.string() +
                                " -DFILES=" + (folder_ / "files").string() + " -DTOOLS='" + tools +
                                "' -DOUTPUT=" + out + " -P " + TILEMEND_BUILD_ID_SCRIPT;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::stringstream text;
    text << std::ifstream(out).rdbuf();
    return text.str();
  }

  const fs::path folder_ = fs::temp_directory_path() / ("build_id_test-" + std::to_string(getpid()));
};

TEST_F(BuildIdScriptTest, IsTheSameForTheSameSources) {
  const std::string made = Made();
  EXPECT_THAT(made, ::testing::ContainsRegex("return \"[0-9a-f]{16}\";"));
  EXPECT_EQ(Made(), made);
}

TEST_F(BuildIdScriptTest, ChangesWithASourceItsNameAndTheCompiler) {
  const std::string made = Made();
  EXPECT_NE(Made("compiler 2"), made);
  Write("b.cc", "two and a half");
  const std::string changed = Made();
  EXPECT_NE(changed, made);
  fs::rename(folder_ / "b.cc", folder_ / "c.cc");
  Write("files", "a.cc\nc.cc\n");
  EXPECT_NE(Made(), changed);
}

}  // namespace
}  // namespace tilemend
