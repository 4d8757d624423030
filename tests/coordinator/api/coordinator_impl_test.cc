// The client's calls, without workers and without gRPC.
#include "coordinator/api/coordinator_impl.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/heap.h"
#include "tests/coordinator/api/coordinator_impl_fixture.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tilemend {
namespace {

TEST_F(CoordinatorImplTest, TheSameRequestIdGivesTheSameJob) {
  v1::CreateJobRequest request = NewRequest();
  request.set_request_id("r");
  const auto first = impl_.CreateJob(request);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(impl_.CreateJob(request)->name(), first->name());
  request.mutable_spec()->set_uniform(true);
  EXPECT_EQ(ErrorReason(impl_.CreateJob(request).status()), "REQUEST_ID_REUSED");
}

TEST_F(CoordinatorImplTest, RefusesSpecsOutOfRange) {
  v1::CreateJobRequest request = NewRequest();
  request.mutable_spec()->set_gradation(0.5);
  const auto status = impl_.CreateJob(request).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(GetErrorInfo(status)->metadata.at("field"), "gradation");
  request = NewRequest();
  request.mutable_spec()->set_surface("flat");
  EXPECT_EQ(GetErrorInfo(impl_.CreateJob(request).status())->metadata.at("field"), "surface");
}

TEST_F(CoordinatorImplTest, RefusesASecondWriterToAFolder) {
  ASSERT_TRUE(impl_.CreateJob(NewRequest("o")).ok());
  EXPECT_EQ(ErrorReason(impl_.CreateJob(NewRequest("x/../o/")).status()), "OUTPUT_IN_USE");
}

TEST_F(CoordinatorImplTest, RefusesMoreJobsThanItsLimit) {
  for (const char* out : {"1", "2", "3"}) ASSERT_TRUE(impl_.CreateJob(NewRequest(out)).ok());
  EXPECT_EQ(ErrorReason(impl_.CreateJob(NewRequest("4")).status()), "TOO_MANY_JOBS");
}

TEST_F(CoordinatorImplTest, NamesWhatItDoesNotKnow) {
  v1::GetJobRequest get;
  get.set_name("jobs/none");
  EXPECT_EQ(ErrorReason(impl_.GetJob(get).status()), "JOB_NOT_FOUND");
  get.set_name("none");
  EXPECT_EQ(ErrorReason(impl_.GetJob(get).status()), "INVALID_NAME");
}

TEST_F(CoordinatorImplTest, ListsNewestFirstInPages) {
  std::vector<std::string> names;
  for (const char* out : {"1", "2", "3"}) names.push_back(impl_.CreateJob(NewRequest(out))->name());
  v1::ListJobsRequest request;
  request.set_page_size(2);
  const auto first = impl_.ListJobs(request);
  ASSERT_EQ(first->jobs_size(), 2);
  EXPECT_EQ(first->jobs(0).name(), names[2]);
  EXPECT_EQ(first->jobs(1).name(), names[1]);
  request.set_page_token(first->next_page_token());
  const auto second = impl_.ListJobs(request);
  ASSERT_EQ(second->jobs_size(), 1);
  EXPECT_EQ(second->jobs(0).name(), names[0]);
  EXPECT_EQ(second->next_page_token(), "");
  for (const char* token : {"nonsense", "-1", "0", " 2", "2 ", "+2", "02"}) {
    request.set_page_token(token);
    EXPECT_EQ(ErrorReason(impl_.ListJobs(request).status()), "INVALID_PAGE") << token;
  }
}

TEST_F(CoordinatorImplTest, CancelIsIdempotentAndFinal) {
  v1::CancelJobRequest request;
  request.set_name(impl_.CreateJob(NewRequest())->name());
  EXPECT_EQ(impl_.CancelJob(request)->state(), v1::CANCELLED);
  EXPECT_EQ(impl_.CancelJob(request)->state(), v1::CANCELLED);
}

TEST_F(CoordinatorImplTest, RetryStartsAnotherJobWithTheSameSpec) {
  const auto job = impl_.CreateJob(NewRequest());
  v1::RetryJobRequest retry;
  retry.set_name(job->name());
  EXPECT_EQ(ErrorReason(impl_.RetryJob(retry).status()), "JOB_NOT_OVER");
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  absl::StatusOr<v1::Job> again;
  do {
    again = impl_.RetryJob(retry);  // refused until the cancelled pipeline has let go of the folder
  } while (ErrorReason(again.status()) == "OUTPUT_IN_USE");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_NE(again->name(), job->name());
  EXPECT_EQ(again->spec().SerializeAsString(), job->spec().SerializeAsString());
}

TEST_F(CoordinatorImplTest, RetryMayOverwrite) {
  v1::CancelJobRequest cancel;
  cancel.set_name(impl_.CreateJob(NewRequest())->name());
  ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  v1::RetryJobRequest retry;
  retry.set_name(cancel.name());
  retry.set_overwrite(true);
  absl::StatusOr<v1::Job> again;
  do {
    again = impl_.RetryJob(retry);
  } while (ErrorReason(again.status()) == "OUTPUT_IN_USE");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->spec().overwrite());
}

TEST_F(CoordinatorImplTest, RetryOfACompleteOutputNeedsOverwrite) {
  cluster_.AddWorker("w");
  v1::CreateJobRequest request = NewRequest();
  const std::string name = impl_.CreateJob(request)->name();
  ASSERT_EQ(cluster_.WaitFor(name).state(), v1::DONE);
  v1::RetryJobRequest retry;
  retry.set_name(name);
  const absl::Status status = impl_.RetryJob(retry).status();
  EXPECT_TRUE(absl::IsAlreadyExists(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OUTPUT_EXISTS");
  EXPECT_EQ(impl_.ListJobs({})->jobs_size(), 1);
  retry.set_overwrite(true);
  retry.set_request_id("again");
  const std::string again = impl_.RetryJob(retry)->name();
  EXPECT_EQ(impl_.RetryJob(retry)->name(), again) << "a request that was taken is answered as it was";
  ASSERT_EQ(cluster_.WaitFor(again).state(), v1::DONE);
  std::filesystem::remove_all(request.spec().out());
  retry.clear_request_id();
  retry.set_overwrite(false);
  EXPECT_TRUE(impl_.RetryJob(retry).ok()) << "the output was taken away";
}

TEST(CoordinatorOptionsTest, RefusesALeaseShorterThanTwoCalls) {
  TempFolder folder;
  CoordinatorOptions options;
  options.work_folder = folder / "work";
  options.lease = absl::Seconds(2);
  EXPECT_TRUE(absl::IsInvalidArgument(
      CoordinatorImpl::Create(options, ToyPipelineFactory(), *MetricsRegistry::Null()).status()));
}

TEST_F(CoordinatorImplTest, RefusesPathsThatAreNotBelowItsRoots) {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "data");
  std::filesystem::create_directory_symlink("/etc", folder / "data/link");
  CoordinatorOptions options;
  options.work_folder = folder / "work";
  options.background_ticks = false;
  auto roots = Roots::Open({folder / "data"});
  ASSERT_TRUE(roots.ok()) << roots.status();
  options.roots = *roots;
  const auto impl = CoordinatorImpl::Create(std::move(options), ToyPipelineFactory(), *MetricsRegistry::Null());
  ASSERT_TRUE(impl.ok()) << impl.status();
  const std::string inside = folder / "data/x";
  for (const auto& [field, path] :
       {std::pair("scene", folder / "other"), std::pair("scene", inside + "/../../other"),
        std::pair("out", folder / "data/link/out"), std::pair("out", std::string("/tmp/o")),
        std::pair("water", std::string("/etc/passwd")), std::pair("area", folder / "data/link/passwd")}) {
    v1::CreateJobRequest request;
    request.mutable_spec()->set_scene(std::string(field) == "scene" ? path : inside);
    request.mutable_spec()->set_out(std::string(field) == "out" ? path : inside);
    if (std::string(field) == "water") request.mutable_spec()->set_water(path);
    if (std::string(field) == "area") request.mutable_spec()->set_area(path);
    const auto info = GetErrorInfo((*impl)->CreateJob(request).status());
    ASSERT_TRUE(info.has_value()) << field << " " << path;
    EXPECT_EQ(info->reason, "OUTSIDE_ROOTS") << path;
    EXPECT_EQ(info->metadata.at("field"), field) << path;
  }
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(CoordinatorImplTest, GivesMemoryBackWhenAJobIsOver) {
  KeepHeap(1);  // or what is at the heap's end goes back by itself
  const auto job = impl_.CreateJob(NewRequest());
  ASSERT_TRUE(job.ok()) << job.status();
  constexpr size_t kBytes = size_t{16} << 20;
  void* volatile block = std::malloc(kBytes);
  std::free(block);
  impl_.Tick();
  ASSERT_GE(mallinfo2().keepcost, kBytes / 2) << "while it runs, memory is kept for it";
  v1::CancelJobRequest request;
  request.set_name(job->name());
  ASSERT_TRUE(impl_.CancelJob(request).ok());
  for (int i = 0; i < 10'000 && mallinfo2().keepcost >= kBytes / 2; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // its thread ends
    impl_.Tick();
  }
  EXPECT_LT(mallinfo2().keepcost, kBytes / 2);
}
#endif

}  // namespace
}  // namespace tilemend
