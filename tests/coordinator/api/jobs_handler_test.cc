// The client's calls, without workers and without gRPC.
#include "coordinator/api/jobs_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using JobsHandlerTest = CoordinatorTest;

TEST_F(JobsHandlerTest, RefusesSpecsOutOfRange) {
  v1::CreateJobRequest request = NewRequest();
  request.mutable_spec()->set_gradation(0.5);
  const auto status = calls_.jobs.CreateJob(request).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(GetErrorInfo(status)->metadata.at("field"), "gradation");
  request = NewRequest();
  request.mutable_spec()->set_surface("flat");
  EXPECT_EQ(GetErrorInfo(calls_.jobs.CreateJob(request).status())->metadata.at("field"), "surface");
}

TEST_F(JobsHandlerTest, FilesThatAreNotThereAreNamedBeforeTheJobBegins) {
  v1::CreateJobRequest request = NewRequest();
  request.mutable_spec()->set_clear("/nowhere/lakes.geojson");
  const auto status = calls_.jobs.CreateJob(request).status();
  EXPECT_TRUE(absl::IsNotFound(status));
  EXPECT_THAT(status.message(), testing::HasSubstr("clear: /nowhere/lakes.geojson: no such file"));
  EXPECT_EQ(GetErrorInfo(status)->metadata.at("field"), "clear");
}

TEST_F(JobsHandlerTest, ListsNewestFirstInPages) {
  std::vector<std::string> names;
  for (const char* out : {"1", "2", "3"}) names.push_back(calls_.jobs.CreateJob(NewRequest(out))->name());
  v1::ListJobsRequest request;
  request.set_page_size(2);
  const auto first = calls_.jobs.ListJobs(request);
  ASSERT_EQ(first->jobs_size(), 2);
  EXPECT_EQ(first->jobs(0).name(), names[2]);
  EXPECT_EQ(first->jobs(1).name(), names[1]);
  request.set_page_token(first->next_page_token());
  const auto second = calls_.jobs.ListJobs(request);
  ASSERT_EQ(second->jobs_size(), 1);
  EXPECT_EQ(second->jobs(0).name(), names[0]);
  EXPECT_EQ(second->next_page_token(), "");
  for (const char* token : {"nonsense", "-1", "0", " 2", "2 ", "+2", "02"}) {
    request.set_page_token(token);
    EXPECT_EQ(ErrorReason(calls_.jobs.ListJobs(request).status()), "INVALID_PAGE") << token;
  }
}

TEST_F(JobsHandlerTest, CancelIsIdempotentAndFinal) {
  v1::CancelJobRequest request;
  request.set_name(calls_.jobs.CreateJob(NewRequest())->name());
  EXPECT_EQ(calls_.jobs.CancelJob(request)->state(), v1::CANCELLED);
  EXPECT_EQ(calls_.jobs.CancelJob(request)->state(), v1::CANCELLED);
}

TEST_F(JobsHandlerTest, RetryStartsAnotherJobWithTheSameSpec) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  v1::RetryJobRequest retry;
  retry.set_name(job->name());
  EXPECT_EQ(ErrorReason(calls_.jobs.RetryJob(retry).status()), "JOB_NOT_OVER");
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  absl::StatusOr<v1::Job> again;
  do {
    again = calls_.jobs.RetryJob(retry);  // refused until the cancelled pipeline has let go of the folder
  } while (ErrorReason(again.status()) == "OUTPUT_IN_USE");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_NE(again->name(), job->name());
  EXPECT_EQ(again->spec().SerializeAsString(), job->spec().SerializeAsString());
}

TEST_F(JobsHandlerTest, RetryMayOverwrite) {
  v1::CancelJobRequest cancel;
  cancel.set_name(calls_.jobs.CreateJob(NewRequest())->name());
  ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  v1::RetryJobRequest retry;
  retry.set_name(cancel.name());
  retry.set_overwrite(true);
  absl::StatusOr<v1::Job> again;
  do {
    again = calls_.jobs.RetryJob(retry);
  } while (ErrorReason(again.status()) == "OUTPUT_IN_USE");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_TRUE(again->spec().overwrite());
}

TEST_F(JobsHandlerTest, RetryOfACompleteOutputNeedsOverwrite) {
  cluster_.AddWorker("w");
  v1::CreateJobRequest request = NewRequest();
  const std::string name = calls_.jobs.CreateJob(request)->name();
  ASSERT_EQ(cluster_.WaitFor(name).state(), v1::DONE);
  v1::RetryJobRequest retry;
  retry.set_name(name);
  const absl::Status status = calls_.jobs.RetryJob(retry).status();
  EXPECT_TRUE(absl::IsAlreadyExists(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OUTPUT_EXISTS");
  EXPECT_EQ(calls_.jobs.ListJobs({})->jobs_size(), 1);
  retry.set_overwrite(true);
  retry.set_request_id("again");
  const std::string again = calls_.jobs.RetryJob(retry)->name();
  EXPECT_EQ(calls_.jobs.RetryJob(retry)->name(), again) << "a request that was taken is answered as it was";
  ASSERT_EQ(cluster_.WaitFor(again).state(), v1::DONE);
  std::filesystem::remove_all(request.spec().out());
  retry.clear_request_id();
  retry.set_overwrite(false);
  EXPECT_TRUE(calls_.jobs.RetryJob(retry).ok()) << "the output was taken away";
}

TEST_F(JobsHandlerTest, CellsNameTheJobThatWroteToTheOutputLater) {
  cluster_.AddWorker("w");
  v1::CreateJobRequest request = NewRequest();
  const auto run = [&](v1::JobState state) {
    const std::string name = calls_.jobs.CreateJob(request)->name();
    EXPECT_EQ(cluster_.WaitFor(name).state(), state);
    return name;
  };
  const auto later = [&](const std::string& name) { return calls_.jobs.GetCells(name)->later_job; };
  const std::string first = run(v1::DONE);
  request.mutable_spec()->set_overwrite(true);
  request.mutable_spec()->set_dry_run(true);
  run(v1::DONE);
  EXPECT_EQ(later(first), "") << "a rehearsal writes nothing";
  request.mutable_spec()->set_dry_run(false);
  request.mutable_spec()->set_out(request.spec().out() + "/");
  const std::string second = run(v1::DONE);
  EXPECT_EQ(later(first), second);
  EXPECT_TRUE(calls_.jobs.GetCells(first)->later_is_complete);
  EXPECT_EQ(later(second), "");
  request.mutable_spec()->set_scene("toy://2x1?plan_error=1");
  const std::string third = run(v1::FAILED);
  EXPECT_EQ(later(first), second);
  EXPECT_EQ(later(second), third);
  EXPECT_FALSE(calls_.jobs.GetCells(second)->later_is_complete);
  EXPECT_EQ(later(third), "");
}

TEST_F(JobsHandlerTest, AJobOntoACompleteOutputIsRefusedAtOnce) {
  v1::CreateJobRequest request = NewRequest();
  const std::string out = request.spec().out();
  std::filesystem::create_directories(out);
  std::ofstream(out + "/report.json") << "{}";
  const absl::Status status = calls_.jobs.CreateJob(request).status();
  EXPECT_TRUE(absl::IsAlreadyExists(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OUTPUT_EXISTS");
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("give --overwrite"));
  EXPECT_EQ(calls_.jobs.ListJobs({})->jobs_size(), 0);
  std::ofstream(out + "/.tilemend-job") << "";
  EXPECT_TRUE(calls_.jobs.CreateJob(request).ok()) << "an output that a job was writing over is not complete";
}

TEST_F(JobsHandlerTest, ACompleteOutputMayBeOverwrittenOrLeftToARehearsal) {
  v1::CreateJobRequest request = NewRequest();
  std::filesystem::create_directories(request.spec().out());
  std::ofstream(request.spec().out() + "/report.json") << "{}";
  v1::CreateJobRequest rehearsal = request;
  rehearsal.mutable_spec()->set_dry_run(true);
  EXPECT_TRUE(calls_.jobs.CreateJob(rehearsal).ok());
  request.mutable_spec()->set_overwrite(true);
  const absl::Status status = calls_.jobs.CreateJob(request).status();
  EXPECT_NE(ErrorReason(status), "OUTPUT_EXISTS") << status;
}

// The job itself looks whether they are on this output.
TEST_F(JobsHandlerTest, DecisionsMayBeAppliedToACompleteOutput) {
  v1::CreateJobRequest request = NewRequest();
  std::filesystem::create_directories(request.spec().out());
  std::ofstream(request.spec().out() + "/report.json") << "{}";
  request.mutable_spec()->set_decisions(cluster_.folder() / "marks.geojson");
  std::ofstream(request.spec().decisions()) << "{}";
  const absl::Status status = calls_.jobs.CreateJob(request).status();
  EXPECT_TRUE(status.ok()) << status;
}

TEST_F(JobsHandlerTest, RefusesPathsThatAreNotBelowItsRoots) {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "data");
  std::filesystem::create_directory_symlink("/etc", folder / "data/link");
  CoordinatorOptions options;
  options.work_folder = folder / "work";
  options.background_ticks = false;
  auto roots = Roots::Open({folder / "data"});
  ASSERT_TRUE(roots.ok()) << roots.status();
  options.roots = *roots;
  const auto coordinator = Coordinator::Create(std::move(options), ToyPipelineFactory(), *MetricsRegistry::Null());
  ASSERT_TRUE(coordinator.ok()) << coordinator.status();
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
    const auto info = GetErrorInfo((*coordinator)->calls().jobs.CreateJob(request).status());
    ASSERT_TRUE(info.has_value()) << field << " " << path;
    EXPECT_EQ(info->reason, "OUTSIDE_ROOTS") << path;
    EXPECT_EQ(info->metadata.at("field"), field) << path;
  }
}

TEST_F(JobsHandlerTest, ListsJobsOfSomeStates) {
  const v1::Job running = cluster_.Submit("toy://2x1");
  const v1::Job cancelled = cluster_.Submit("toy://2x1");
  v1::CancelJobRequest cancel;
  cancel.set_name(cancelled.name());
  ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  v1::ListJobsRequest request;
  request.add_states(v1::CANCELLED);
  const auto response = calls_.jobs.ListJobs(request);
  ASSERT_TRUE(response.ok()) << response.status();
  ASSERT_EQ(response->jobs_size(), 1);
  EXPECT_EQ(response->jobs(0).name(), cancelled.name());
}

TEST_F(JobsHandlerTest, EndsAPageBeforeItIsTooLongForAMessage) {
  const std::string deep = "/" + std::string(4000, 'x');
  for (int i = 0; i < 400; ++i) {
    v1::CreateJobRequest request = NewRequest(absl::StrCat("o", i));
    request.mutable_spec()->set_water(deep);
    request.mutable_spec()->set_area(deep);
    auto job = calls_.jobs.CreateJob(request);
    while (absl::IsResourceExhausted(job.status()))
      job = calls_.jobs.CreateJob(request);  // until a cancelled one has ended
    ASSERT_TRUE(job.ok()) << job.status();
    v1::CancelJobRequest cancel;
    cancel.set_name(job->name());
    ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  }
  v1::ListJobsRequest request;
  request.set_page_size(1000);
  int jobs = 0, pages = 0;
  do {
    const auto page = calls_.jobs.ListJobs(request);
    ASSERT_TRUE(page.ok());
    EXPECT_LT(page->ByteSizeLong(), static_cast<size_t>(kMaxMessageBytes));
    jobs += page->jobs_size();
    ++pages;
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  EXPECT_EQ(jobs, 400);
  EXPECT_EQ(pages, 2);
}

}  // namespace
}  // namespace tilemend
