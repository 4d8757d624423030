// A small progressive JPEG with very many scans held a worker for minutes, past a cancelled job and a signal to stop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <string>

#include "common/image/image.h"
#include "tests/support/image_builders.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

constexpr int32_t kSide = 2048;
constexpr int kScans = 20'000;
constexpr char kScanMarker[] = "\xff\xda";

// A progressive image whose last scan comes `scans` times more; `between` goes before each.
std::string RepeatedScans(int32_t side, int scans, const std::string& between = "") {
  const std::string image = JpegImage(
      side, side,
      [](int32_t, int32_t) {
        return Rgb{90, 120, 60};
      },
      TJFLAG_PROGRESSIVE);
  const size_t last = image.rfind(kScanMarker), end = image.size() - 2;
  std::string repeated = image.substr(0, end);
  for (int i = 0; i < scans; ++i) repeated += between + image.substr(last, end - last);
  return repeated + image.substr(end);
}

void ExpectRefusedSoon(const std::string& bytes) {
  const auto start = std::chrono::steady_clock::now();
  const absl::Status status = DecodeImage(bytes, "bomb.jpg").status();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << bytes.size() / 1024 << " KB: " << status << " after " << took.count() << " s\n";
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("bomb.jpg"));
  EXPECT_LT(took.count(), 10);
}

TEST(JpegWithManyScansTest, IsRefusedBeforeItIsDecoded) { ExpectRefusedSoon(RepeatedScans(kSide, kScans)); }

// Bytes between the scans, and a marker without a length, hide none of them.
TEST(JpegWithManyScansTest, CannotHideItsScans) { ExpectRefusedSoon(RepeatedScans(kSide, kScans, "garbage\xff\x01")); }

TEST(JpegWithManyScansTest, AnImageThatIsCutOffAnywhereEndsTheSearch) {
  const std::string image = RepeatedScans(16, 0);
  for (size_t size = 0; size <= image.size(); ++size)
    DecodeImage(image.substr(0, size), "cut.jpg").status().IgnoreError();
}

}  // namespace
}  // namespace tilemend
