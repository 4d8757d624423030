#include <gtest/gtest.h>

#include "common/rpc/grpc_status.h"
#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

absl::Status Example() {
  return WithErrorInfo(absl::NotFoundError("jobs/x: no such job"), {"JOB_NOT_FOUND", {{"job", "x"}, {"empty", ""}}});
}

TEST(StatusTest, ComesBackFromGrpcWithItsErrorInfo) {
  const absl::Status back = FromGrpcStatus(ToGrpcStatus(Example()));
  EXPECT_EQ(back, Example());
  EXPECT_EQ(GetErrorInfo(back), GetErrorInfo(Example()));
}

TEST(StatusTest, ComesBackFromTheMessageWithItsErrorInfo) {
  EXPECT_EQ(StatusFromProto(StatusToProto(Example())), Example());
}

TEST(StatusTest, OkStaysOk) {
  EXPECT_TRUE(ToGrpcStatus(absl::OkStatus()).ok());
  EXPECT_TRUE(FromGrpcStatus(grpc::Status::OK).ok());
  EXPECT_TRUE(StatusFromProto(v1::Status()).ok());
}

TEST(StatusTest, EveryCodeSurvives) {
  for (int code = 1; code <= 16; ++code) {
    const absl::Status status(static_cast<absl::StatusCode>(code), "text");
    EXPECT_EQ(FromGrpcStatus(ToGrpcStatus(status)), status);
  }
}

TEST(StatusTest, DetailsThatAreNotOursAreIgnored) {
  const absl::Status status = FromGrpcStatus(grpc::Status(grpc::StatusCode::ABORTED, "text", "\xff garbage"));
  EXPECT_EQ(status, absl::AbortedError("text"));
  v1::Status proto;
  proto.set_code(99);
  EXPECT_EQ(StatusFromProto(proto).code(), absl::StatusCode::kUnknown);
}

TEST(StatusTest, CarriesTheTypeThatOtherClientsKnow) {
  const v1::Status proto = StatusToProto(Example());
  ASSERT_EQ(proto.details_size(), 1);
  EXPECT_EQ(proto.details(0).type_url(), "type.googleapis.com/google.rpc.ErrorInfo");
  v1::ErrorInfo info;
  ASSERT_TRUE(info.ParseFromString(proto.details(0).value()));
  EXPECT_EQ(info.domain(), "tilemend");
}

}  // namespace
}  // namespace tilemend
