#include "common/util/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace tilemend {
namespace {

// Prints `text` to what `open_output` makes standard output, and ends with the code of FlushOutput's status.
template <typename OpenOutput>
[[noreturn]] void PrintTo(OpenOutput open_output, const std::string& text) {
  std::signal(SIGPIPE, SIG_IGN);
  const int fd = open_output();
  dup2(fd, STDOUT_FILENO);
  close(fd);
  std::fputs(text.c_str(), stdout);
  std::_Exit(static_cast<int>(FlushOutput().code()));
}

int FullDisk() { return open("/dev/full", O_WRONLY); }

int PipeWithoutReader() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) std::abort();
  close(ends[0]);
  return ends[1];
}

const std::string& Much() {
  static const std::string kMuch(1'000'000, 'a');  // more than is kept before it is written
  return kMuch;
}

TEST(StandardStreamsDeathTest, AFullDiskIsAnError) {
  EXPECT_EXIT(PrintTo(FullDisk, "a"), testing::ExitedWithCode(static_cast<int>(absl::StatusCode::kResourceExhausted)),
              "");
  EXPECT_EXIT(
      PrintTo(FullDisk, Much()), [](int status) { return WIFEXITED(status) && WEXITSTATUS(status) != 0; }, "");
}

TEST(StandardStreamsDeathTest, AReaderThatHasGoneIsNone) {
  EXPECT_EXIT(PrintTo(PipeWithoutReader, "a"), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(PrintTo(PipeWithoutReader, Much()), testing::ExitedWithCode(0), "");
}

// Whether a file that is opened after it was closed gets the number of standard output.
[[noreturn]] void OpenAFileWithoutOutput() {
  close(STDOUT_FILENO);
  OpenStandardStreams();
  struct stat null {
  }, output{};
  const bool is_null =
      stat("/dev/null", &null) == 0 && fstat(STDOUT_FILENO, &output) == 0 && output.st_rdev == null.st_rdev;
  std::_Exit(is_null && open("/dev/zero", O_RDONLY) > STDERR_FILENO ? 0 : 1);
}

TEST(StandardStreamsDeathTest, NoFileTakesThePlaceOfAClosedStream) {
  EXPECT_EXIT(OpenAFileWithoutOutput(), testing::ExitedWithCode(0), "");
}

TEST(ColumnsOfHelpTest, AreAHundredWithoutATerminal) {
  const int null = open("/dev/null", O_WRONLY);
  EXPECT_EQ(ColumnsOfHelp(null), 100U);
  close(null);
}

}  // namespace
}  // namespace tilemend
