#include "common/rpc/grpc_status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "common/util/error_info.h"
#include "tests/common/rpc/example_status.h"

namespace tilemend {
namespace {

TEST(GrpcStatusTest, ComesBackWithItsErrorInfo) {
  const absl::Status back = FromGrpcStatus(ToGrpcStatus(Example()));
  EXPECT_EQ(back, Example());
  EXPECT_EQ(GetErrorInfo(back), GetErrorInfo(Example()));
}

TEST(GrpcStatusTest, FitsIntoTheTrailersOfACall) {
  std::string text, facts;
  for (int i = 0; i < 100'000; ++i) text += "\u00e9", facts += '\x01';
  const absl::Status status = WithErrorInfo(absl::InvalidArgumentError(text), {"INVALID_SPEC", {{"field", facts}}});
  const grpc::Status sent = ToGrpcStatus(status);
  EXPECT_LT(3 * sent.error_message().size() + 4 * sent.error_details().size() / 3, 7000U);
  const absl::Status back = FromGrpcStatus(sent);
  EXPECT_EQ(back.code(), status.code());
  EXPECT_EQ(ErrorReason(back), "INVALID_SPEC");
  EXPECT_THAT(std::string(back.message()), testing::HasSubstr(" ... "));
}

TEST(GrpcStatusTest, OkStaysOk) {
  EXPECT_TRUE(ToGrpcStatus(absl::OkStatus()).ok());
  EXPECT_TRUE(FromGrpcStatus(grpc::Status::OK).ok());
}

TEST(GrpcStatusTest, ACallThatOnlyTheServerHasCancelledMayBeTriedAgain) {
  EXPECT_TRUE(absl::IsUnavailable(FromServerStatus(grpc::Status::CANCELLED)));
  EXPECT_EQ(FromServerStatus(ToGrpcStatus(Example())), Example());
  EXPECT_TRUE(FromServerStatus(grpc::Status::OK).ok());
}

TEST(GrpcStatusTest, EveryCodeSurvives) {
  for (int code = 1; code <= 16; ++code) {
    const absl::Status status(static_cast<absl::StatusCode>(code), "text");
    EXPECT_EQ(FromGrpcStatus(ToGrpcStatus(status)), status);
  }
}

TEST(GrpcStatusTest, DetailsThatAreNotOursAreIgnored) {
  const absl::Status status = FromGrpcStatus(grpc::Status(grpc::StatusCode::ABORTED, "text", "\xff garbage"));
  EXPECT_EQ(status, absl::AbortedError("text"));
  // Ours, but of another error.
  const grpc::Status ours = ToGrpcStatus(Example());
  const grpc::Status mixed(grpc::StatusCode::ABORTED, "text", ours.error_details());
  EXPECT_EQ(FromGrpcStatus(mixed), absl::AbortedError("text"));
}

TEST(GrpcStatusTest, SaysPlainlyThatThereIsNoThread) {
  const absl::Status status =
      FromGrpcStatus(grpc::Status(grpc::StatusCode::RESOURCE_EXHAUSTED, "Server Threadpool Exhausted"));
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("the coordinator has no thread for the call"));
}

TEST(ReplyTest, GivesTheValueOrTheError) {
  std::string response = "before";
  EXPECT_TRUE(Reply<std::string>("value", &response).ok());
  EXPECT_EQ(response, "value");
  EXPECT_EQ(FromGrpcStatus(Reply<std::string>(Example(), &response)), Example());
  EXPECT_EQ(response, "value");
}

}  // namespace
}  // namespace tilemend
