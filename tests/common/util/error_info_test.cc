#include "common/util/error_info.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

const ErrorInfo kInfo = {"LATE_RESULT", {{"task", "7"}, {"empty", ""}}};

TEST(ErrorInfoTest, ComesBackWithTheStatusAsItWas) {
  const absl::Status status = WithErrorInfo(absl::NotFoundError("no such task"), kInfo);
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(status.message(), "no such task");
  EXPECT_EQ(GetErrorInfo(status), kInfo);
  EXPECT_EQ(ErrorReason(status), "LATE_RESULT");
}

TEST(ErrorInfoTest, IsNotThereUnlessAttached) {
  EXPECT_EQ(GetErrorInfo(absl::NotFoundError("x")), std::nullopt);
  EXPECT_EQ(ErrorReason(absl::NotFoundError("x")), "");
  EXPECT_EQ(ErrorReason(absl::OkStatus()), "");
  EXPECT_EQ(WithErrorInfo(absl::OkStatus(), kInfo), absl::OkStatus());
}

TEST(ErrorInfoTest, TheLastOneStands) {
  const absl::Status once = WithErrorInfo(absl::AbortedError("x"), kInfo);
  EXPECT_EQ(GetErrorInfo(WithErrorInfo(once, {"OTHER", {}})), (ErrorInfo{"OTHER", {}}));
}

TEST(ErrorInfoTest, ATextEndsAtAZeroByte) {
  const absl::Status status = WithErrorInfo(absl::AbortedError("x"), {std::string("A\0B", 3), {{"k", "v"}}});
  EXPECT_EQ(GetErrorInfo(status), (ErrorInfo{"A", {{"k", "v"}}}));
}

}  // namespace
}  // namespace tilemend
