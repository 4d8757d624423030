// The scaler as KEDA calls it: over gRPC, and byte by byte as KEDA's contract says.
#include "coordinator/api/scaler.h"

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/rpc/grpc_status.h"
#include "common/util/error_info.h"
#include "externalscaler/externalscaler.grpc.pb.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_watch.h"

namespace tilemend {
namespace {

namespace keda = externalscaler;

keda::ScaledObjectRef ObjectWith(const std::string& slots) {
  keda::ScaledObjectRef object;
  object.set_name("tilemend-worker");
  object.set_namespace_("tilemend");
  (*object.mutable_scalermetadata())["scalerAddress"] = "tilemend-coordinator:7070";
  if (!slots.empty()) (*object.mutable_scalermetadata())["slots"] = slots;
  return object;
}

TEST(ScalerTest, AWorkersShareIsItsSlots) {
  EXPECT_EQ(ScalerSpec(ObjectWith("8"))->metricspecs(0).targetsize(), 8);
  EXPECT_EQ(ScalerSpec(ObjectWith("8"))->metricspecs(0).targetsizefloat(), 8);
  EXPECT_EQ(ScalerSpec(ObjectWith(""))->metricspecs(0).targetsize(), 1);
}

TEST(ScalerTest, RefusesSlotsThatAreNoNumber) {
  for (const char* slots : {"0", "-1", "many", "1025", "2.5"}) {
    const absl::Status status = ScalerSpec(ObjectWith(slots)).status();
    EXPECT_EQ(ErrorReason(status), "INVALID_SCALER") << slots;
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << slots;
  }
}

TEST(ScalerTest, KnowsOneMetric) {
  keda::GetMetricsRequest request;
  request.set_metricname(kScalerMetric);
  EXPECT_EQ(ScalerMetrics(request, {1, 30})->metricvalues(0).metricvaluefloat(), 30);
  request.set_metricname("queue-length");
  EXPECT_EQ(ErrorReason(ScalerMetrics(request, {1, 30}).status()), "INVALID_SCALER");
}

// Field 1 of the answer is a metric with field 1 a name, 2 a whole number, 3 a double.
TEST(ScalerTest, SpeaksTheBytesOfTheContract) {
  keda::GetMetricsRequest request;
  const std::string asked = {0x12, 0x0e, 't', 'i', 'l', 'e', 'm', 'e', 'n', 'd', '-', 't', 'a', 's', 'k', 's'};
  ASSERT_TRUE(request.ParseFromString(asked));
  const std::string metric = std::string({0x0a, 0x0e}) + kScalerMetric + std::string({0x10, 0x02, 0x19}) +
                             std::string({0, 0, 0, 0, 0, 0, 0, 0x40});
  const std::string answer = std::string({0x0a, static_cast<char>(metric.size())}) + metric;
  EXPECT_EQ(ScalerMetrics(request, {1, 2})->SerializeAsString(), answer);
  keda::ScaledObjectRef object;
  const std::string slots = {0x1a, 0x0a, 0x0a, 0x05, 's', 'l', 'o', 't', 's', 0x12, 0x01, '2'};
  ASSERT_TRUE(object.ParseFromString(slots));
  EXPECT_EQ(ScalerSpec(object)->SerializeAsString(), answer);
}

class ScalerOverGrpcTest : public CoordinatorTest {
 protected:
  void SetUp() override {
    if (!kHasGrpc) GTEST_SKIP() << "needs gRPC";
    keda_ = keda::ExternalScaler::NewStub(cluster_.rpc().InProcessChannel());
  }
  bool IsActive() {
    grpc::ClientContext context;
    keda::IsActiveResponse response;
    EXPECT_TRUE(keda_->IsActive(&context, ObjectWith("2"), &response).ok());
    return response.result();
  }
  // As KEDA and Kubernetes work it out.
  int64_t WorkersWanted(const std::string& slots) {
    grpc::ClientContext first, second;
    keda::GetMetricSpecResponse spec;
    EXPECT_TRUE(keda_->GetMetricSpec(&first, ObjectWith(slots), &spec).ok());
    keda::GetMetricsRequest request;
    *request.mutable_scaledobjectref() = ObjectWith(slots);
    request.set_metricname(spec.metricspecs(0).metricname());
    keda::GetMetricsResponse metrics;
    EXPECT_TRUE(keda_->GetMetrics(&second, request, &metrics).ok());
    return std::llround(std::ceil(metrics.metricvalues(0).metricvaluefloat() / spec.metricspecs(0).targetsizefloat()));
  }
  void Cancel(const v1::Job& job) {
    v1::CancelJobRequest request;
    request.set_name(job.name());
    EXPECT_TRUE(calls_.jobs.CancelJob(request).ok());
  }
  // A job with one task at each of `cells` cells, all with workers or waiting.
  v1::Job JobWithTasks(int64_t cells) {
    v1::Job job = cluster_.Submit(absl::StrCat("toy://", cells, "x1"));
    v1::WatchJobRequest watch;
    watch.set_name(job.name());
    const auto until_they_are_there = [&](const v1::Job& now) { return now.progress().tasks() < cells; };
    EXPECT_TRUE(absl::IsCancelled(WatchAndWait(calls_.watch, watch, until_they_are_there)));
    return job;
  }

  std::unique_ptr<keda::ExternalScaler::Stub> keda_;
};

TEST_F(ScalerOverGrpcTest, WantsAsManyWorkersAsTheTasksFill) {
  EXPECT_EQ(WorkersWanted("2"), 0);
  EXPECT_FALSE(IsActive());
  const v1::Job job = JobWithTasks(5);
  EXPECT_TRUE(IsActive());
  EXPECT_EQ(WorkersWanted("2"), 3);
  EXPECT_EQ(WorkersWanted("8"), 1);
  AwaitTask();
  EXPECT_EQ(WorkersWanted("2"), 3);  // a task that runs still needs its worker
  Cancel(job);
  EXPECT_EQ(WorkersWanted("2"), 0);
  EXPECT_FALSE(IsActive());
}

TEST_F(ScalerOverGrpcTest, StreamsWhetherThereIsAnythingToDo) {
  grpc::ClientContext context;
  const auto reader = keda_->StreamIsActive(&context, ObjectWith("2"));
  keda::IsActiveResponse response;
  ASSERT_TRUE(reader->Read(&response));
  EXPECT_FALSE(response.result());
  const v1::Job job = cluster_.Submit("toy://2x1");
  ASSERT_TRUE(reader->Read(&response));
  EXPECT_TRUE(response.result());
  Cancel(job);
  ASSERT_TRUE(reader->Read(&response));
  EXPECT_FALSE(response.result());
  context.TryCancel();
  EXPECT_FALSE(reader->Read(&response));
  EXPECT_EQ(reader->Finish().error_code(), grpc::CANCELLED);
}

TEST_F(ScalerOverGrpcTest, ErrorsHaveTheirReason) {
  grpc::ClientContext context;
  keda::GetMetricSpecResponse spec;
  const absl::Status status = FromGrpcStatus(keda_->GetMetricSpec(&context, ObjectWith("none"), &spec));
  EXPECT_EQ(ErrorReason(status), "INVALID_SCALER");
}

}  // namespace
}  // namespace tilemend
