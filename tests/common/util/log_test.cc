#include "common/util/log.h"

#include <gtest/gtest.h>
#include <sys/types.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

namespace tilemend {
namespace {

const absl::Time kTime = absl::FromUnixMillis(1'700'000'000'123);

TEST(LogLineTest, WritesTextForPeople) {
  EXPECT_EQ(LogLine(LogFormat::kText, kTime, LogLevel::kWarning, "worker lost",
                    {{"worker", "host-7-ab"}, {"tasks", 3}, {"why", "silent for 30 s"}, {"none", ""}}),
            "2023-11-14T22:13:20.123Z warning worker lost worker=host-7-ab tasks=3 why=\"silent for 30 s\"\n");
}

TEST(LogLineTest, WritesJsonForPrograms) {
  EXPECT_EQ(LogLine(LogFormat::kJson, kTime, LogLevel::kInfo, "job finished", {{"job", "4f"}, {"seconds", 1.5}}),
            "{\"time\":\"2023-11-14T22:13:20.123Z\",\"level\":\"info\",\"event\":\"job finished\",\"job\":\"4f\","
            "\"seconds\":1.5}\n");
}

TEST(LogLineTest, NeverBreaksALineNorAQuote) {
  const std::string hostile = "a\"b\\c\nd\x1b[31m\xff";
  EXPECT_EQ(LogLine(LogFormat::kText, kTime, LogLevel::kInfo, "e", {{"k", hostile}}),
            "2023-11-14T22:13:20.123Z info e k=\"a\\\"b\\\\c\\\\x0ad\\\\x1b[31m\\\\xff\"\n");
  EXPECT_EQ(LogLine(LogFormat::kJson, kTime, LogLevel::kInfo, "e", {{"k", hostile}}),
            "{\"time\":\"2023-11-14T22:13:20.123Z\",\"level\":\"info\",\"event\":\"e\","
            "\"k\":\"a\\\"b\\\\c\\\\x0ad\\\\x1b[31m\\\\xff\"}\n");
}

TEST(LogLineTest, ShowsTheEndsOfWhatIsLong) {
  const std::string path = "/begin" + std::string(4 << 20, 'a') + "end";
  for (const LogFormat format : {LogFormat::kText, LogFormat::kJson}) {
    const std::string line = LogLine(format, kTime, LogLevel::kInfo, "e", {{"k", path}});
    EXPECT_LT(line.size(), 4200U);
    EXPECT_NE(line.find("\"/beginaaa"), std::string::npos);
    EXPECT_NE(line.find("aaa ... aaa"), std::string::npos);
    EXPECT_NE(line.find("aaaend\""), std::string::npos);
  }
}

TEST(LogLineTest, LeavesOutNumbersThatJsonDoesNotHave) {
  EXPECT_EQ(LogLine(LogFormat::kText, kTime, LogLevel::kInfo, "e", {{"k", std::nan("")}}),
            "2023-11-14T22:13:20.123Z info e\n");
}

TEST(StreamLogTest, SaysWithEveryLineWhichProgramWroteIt) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  StreamLog log(file.get(), LogFormat::kJson, {{"program", "p"}}, [] { return kTime; });
  log.Error("stopped");
  std::rewind(file.get());
  std::array<char, 200> line{};
  ASSERT_NE(std::fgets(line.data(), line.size(), file.get()), nullptr);
  EXPECT_STREQ(line.data(),
               "{\"time\":\"2023-11-14T22:13:20.123Z\",\"level\":\"error\",\"event\":\"stopped\",\"program\":\"p\"}\n");
}

// A line that a full disk takes in part, then two that it does not take, then two that it takes.
TEST(StreamLogTest, SaysHowManyLinesWereLost) {
  struct Disk {
    std::string text;
    size_t room = 30;
  } disk;
  const auto write = [](void* to, const char* bytes, size_t size) -> ssize_t {
    auto& full = *static_cast<Disk*>(to);
    const size_t taken = std::min(size, full.room);
    full.text.append(bytes, taken);
    full.room -= taken;
    errno = ENOSPC;
    return static_cast<ssize_t>(taken);
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      ::fopencookie(&disk, "w", {nullptr, write, nullptr, nullptr}), std::fclose);
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  StreamLog log(file.get(), LogFormat::kText, {}, [] { return kTime; });
  int told = 0;
  log.OnLoss([&] { ++told; });
  for (const char* lost : {"first", "second", "third"}) log.Info(lost);
  EXPECT_EQ(told, 1);
  disk.room = 1000;
  log.Info("fourth");
  log.Info("fifth");
  const std::string time = "2023-11-14T22:13:20.123Z ";
  EXPECT_EQ(disk.text,
            time + "info \n" + time + "error lines lost lines=3\n" + time + "info fourth\n" + time + "info fifth\n");
  EXPECT_EQ(told, 1);
}

TEST(LogFormatNamedTest, IsJsonWhereNoTerminalReads) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  EXPECT_EQ(*LogFormatNamed("auto", file.get()), LogFormat::kJson);
  EXPECT_EQ(*LogFormatNamed("text", file.get()), LogFormat::kText);
  EXPECT_EQ(*LogFormatNamed("json", stderr), LogFormat::kJson);
  EXPECT_EQ(LogFormatNamed("xml", stderr).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace tilemend
