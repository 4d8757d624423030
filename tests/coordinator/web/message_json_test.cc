#include "coordinator/web/message_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// One failed job with a reason must not take the list from everybody.
TEST(MessageJsonTest, HasTheReasonOfAFailedJob) {
  v1::ListJobsResponse jobs;
  v1::Job& job = *jobs.add_jobs();
  job.set_name("jobs/a");
  *job.mutable_error() =
      StatusToProto(WithErrorInfo(absl::AbortedError("it changed"), {"OUTPUT_CHANGED", {{"file", "a.obj"}}}));
  const auto text = MessageJson(jobs);
  ASSERT_TRUE(text.ok()) << text.status();
  const Json error = Json::parse(*text)["jobs"][0]["error"];
  EXPECT_EQ(error["message"], "it changed");
  EXPECT_EQ(error["details"][0]["@type"], "type.googleapis.com/google.rpc.ErrorInfo");
  EXPECT_EQ(error["details"][0]["reason"], "OUTPUT_CHANGED");
  EXPECT_EQ(error["details"][0]["metadata"]["file"], "a.obj");
}

TEST(MessageJsonTest, HasFieldsThatAreNotSet) { EXPECT_EQ(Json::parse(MessageJson(v1::Job()).value())["name"], ""); }

TEST(MessageJsonTest, ADetailOfAnotherTypeIsAnError) {
  v1::Job job;
  google::protobuf::Any& detail = *job.mutable_error()->add_details();
  detail.set_type_url("type.googleapis.com/none.Of.Ours");
  detail.set_value("a");
  EXPECT_TRUE(absl::IsInternal(MessageJson(job).status()));
}

}  // namespace
}  // namespace tilemend
