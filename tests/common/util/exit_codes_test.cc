#include "common/util/exit_codes.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(ExitCodeOfTest, TellsWhatToDoAboutAnError) {
  EXPECT_EQ(ExitCodeOf(absl::OkStatus()), kExitDone);
  EXPECT_EQ(ExitCodeOf(absl::NotFoundError("")), kExitNotFound);
  EXPECT_EQ(ExitCodeOf(absl::CancelledError("")), kExitCancelled);
  for (const absl::Status& bad :
       {absl::InvalidArgumentError(""), absl::OutOfRangeError(""), absl::AlreadyExistsError("")}) {
    EXPECT_EQ(ExitCodeOf(bad), kExitInvalidInput) << bad;
  }
  for (const absl::Status& passing : {absl::UnavailableError(""), absl::DeadlineExceededError(""),
                                      absl::ResourceExhaustedError(""), absl::AbortedError("")}) {
    EXPECT_EQ(ExitCodeOf(passing), kExitRetryable) << passing;
  }
  for (const absl::Status& broken : {absl::InternalError(""), absl::DataLossError(""), absl::UnknownError(""),
                                     absl::PermissionDeniedError(""), absl::FailedPreconditionError("")}) {
    EXPECT_EQ(ExitCodeOf(broken), kExitFailed) << broken;
  }
}

TEST(ExitCodeOfTest, IsDoneForNoError) {
  for (int code = 1; code <= 16; ++code) {
    EXPECT_NE(ExitCodeOf(absl::Status(static_cast<absl::StatusCode>(code), "")), kExitDone) << code;
  }
}

}  // namespace
}  // namespace tilemend
