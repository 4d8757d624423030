#include "common/util/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

const std::vector<FlagSpec> kSpecs = AllAsSettings({{"tls-ca", "FILE", "", ""}, {"insecure", "", "", ""}});

Environment With(std::map<std::string, std::string> variables) {
  return [variables = std::move(variables)](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  };
}

TEST(ReadSettingsTest, TakesTheEnvironmentBeforeTheFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "c", "# ours\n\ntls-ca = /file/ca\ninsecure=true\nthreads = 4\n").ok());
  EXPECT_THAT(*ReadSettings(kSpecs, "", With({{"TILEMEND_CONFIG", folder / "c"}})),
              UnorderedElementsAre(Pair("tls-ca", "/file/ca"), Pair("insecure", "")));
  EXPECT_THAT(
      *ReadSettings(kSpecs, folder / "c", With({{"TILEMEND_TLS_CA", "/env/ca"}, {"TILEMEND_INSECURE", "false"}})),
      UnorderedElementsAre(Pair("tls-ca", "/env/ca")));
}

TEST(ReadSettingsTest, LeavesFlagsAloneThatAreNoSettings) {
  const std::vector<FlagSpec> specs = {{"out", "DIR", "", ""}};
  EXPECT_TRUE(ReadSettings(specs, "", With({{"TILEMEND_OUT", "/o"}}))->empty());
}

TEST(ReadSettingsTest, NeedsOnlyTheFileThatIsNamed) {
  EXPECT_TRUE(ReadSettings(kSpecs, "/nowhere/c", With({})).ok());
  EXPECT_TRUE(absl::IsNotFound(ReadSettings(kSpecs, "", With({{"TILEMEND_CONFIG", "/nowhere/c"}})).status()));
}

TEST(ReadSettingsTest, SaysWhichLineItCannotRead) {
  const TemporaryFolder folder;
  for (const char* text : {"\ntls-ca\n", "\ninsecure = perhaps\n", "\ntls-cas = /file/ca\n", "\n= /file/ca\n",
                           "\n\x01\xff = x\n", "\n--tls-ca = /file/ca\n"}) {
    ASSERT_TRUE(WriteFileAtomically(folder / "c", text).ok());
    const absl::Status status = ReadSettings(kSpecs, folder / "c", With({})).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr("c:2: "));
  }
}

TEST(ReadSettingsTest, TakesFilesOfOtherSystems) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("c", "\xEF\xBB\xBFtls-ca = /file/ca\r\ninsecure = true\r\n");
  EXPECT_THAT(*ReadSettings(kSpecs, file, With({})),
              UnorderedElementsAre(Pair("tls-ca", "/file/ca"), Pair("insecure", "")));
}

TEST(ReadSettingsTest, StandsBehindTheCommandLine) {
  const auto flags = Flags::Parse(kSpecs, {"--tls-ca", "/flag"}, {{"tls-ca", "/env"}, {"insecure", ""}});
  ASSERT_TRUE(flags.ok());
  EXPECT_EQ(flags->Text("tls-ca"), "/flag");
  EXPECT_TRUE(flags->Switch("insecure"));
}

TEST(UsualFileTest, IsInTheHomeOfWhoCalls) {
  EXPECT_EQ(UsualFile(With({{"HOME", "/home/ann"}})), "/home/ann/.config/tilemend.conf");
  EXPECT_EQ(UsualFile(With({{"HOME", "/home/ann"}, {"XDG_CONFIG_HOME", "/x"}})), "/x/tilemend.conf");
  EXPECT_EQ(UsualFile(With({})), "");
}

}  // namespace
}  // namespace tilemend
