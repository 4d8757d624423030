#include "common/rpc/status_proto.h"

#include <gtest/gtest.h>

#include "common/util/error_info.h"
#include "common/util/text.h"
#include "tests/common/rpc/example_status.h"

namespace tilemend {
namespace {

TEST(StatusProtoTest, ComesBackWithItsErrorInfo) { EXPECT_EQ(StatusFromProto(StatusToProto(Example())), Example()); }

TEST(StatusProtoTest, OkStaysOk) {
  EXPECT_TRUE(StatusFromProto(v1::Status()).ok());
  EXPECT_EQ(StatusToProto(absl::OkStatus()).code(), 0);
}

TEST(StatusProtoTest, AnUnknownCodeIsKUnknown) {
  for (const int code : {17, 99, -1}) {
    v1::Status proto;
    proto.set_code(code);
    proto.set_message("text");
    EXPECT_EQ(StatusFromProto(proto), absl::UnknownError("text")) << code;
  }
}

TEST(StatusProtoTest, CarriesTheTypeThatOtherClientsKnow) {
  const v1::Status proto = StatusToProto(Example());
  ASSERT_EQ(proto.details_size(), 1);
  EXPECT_EQ(proto.details(0).type_url(), "type.googleapis.com/google.rpc.ErrorInfo");
  v1::ErrorInfo info;
  ASSERT_TRUE(info.ParseFromString(proto.details(0).value()));
  EXPECT_EQ(info.domain(), "tilemend");
}

TEST(StatusProtoTest, IgnoresDetailsOfOtherTypesAndDamagedOnes) {
  v1::Status proto = StatusToProto(Example());
  proto.mutable_details(0)->set_type_url("type.googleapis.com/google.rpc.Help");
  EXPECT_EQ(GetErrorInfo(StatusFromProto(proto)), std::nullopt);
  proto = StatusToProto(Example());
  proto.mutable_details(0)->set_value("\xff\xff");
  EXPECT_EQ(StatusFromProto(proto), absl::NotFoundError("jobs/x: no such job"));
}

TEST(StatusProtoTest, IsUtf8WhateverTheTextQuotes) {
  const absl::Status bad = WithErrorInfo(absl::AbortedError("Z\xfcrich\n"), {"BAD", {{"file", "\xff"}}});
  const v1::Status proto = StatusToProto(bad);
  EXPECT_EQ(proto.message(), "Z\\xfcrich\\x0a");
  EXPECT_EQ(GetErrorInfo(StatusFromProto(proto))->metadata.at("file"), "\\xff");
}

}  // namespace
}  // namespace tilemend
