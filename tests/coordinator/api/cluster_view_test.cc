#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_impl_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class ClusterViewTest : public CoordinatorImplTest {
 protected:
  v1::ListWorkersResponse Workers(int32_t size = 0, const std::string& token = "") {
    v1::ListWorkersRequest request;
    request.set_page_size(size);
    request.set_page_token(token);
    const auto response = impl_.ListWorkers(request);
    EXPECT_TRUE(response.ok()) << response.status();
    return response.ok() ? *response : v1::ListWorkersResponse();
  }
};

TEST_F(ClusterViewTest, ListsWorkersPageByPage) {
  for (const char* worker : {"a", "b", "c"}) {
    v1::SyncRequest request = NewSync(worker, 4);
    request.set_wait_ms(0);
    request.set_release("0.1.0");
    Sync(request);
  }
  const v1::ListWorkersResponse first = Workers(2);
  ASSERT_EQ(first.workers_size(), 2);
  EXPECT_EQ(first.workers(0).id(), "a");
  EXPECT_EQ(first.workers(0).state(), v1::WORKING);
  EXPECT_EQ(first.workers(0).threads(), 4);
  EXPECT_EQ(first.workers(0).release(), "0.1.0");
  const v1::ListWorkersResponse rest = Workers(2, first.next_page_token());
  ASSERT_EQ(rest.workers_size(), 1);
  EXPECT_EQ(rest.workers(0).id(), "c");
  EXPECT_EQ(rest.next_page_token(), "");
}

TEST_F(ClusterViewTest, SaysThatAJobWaitsForWorkers) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  v1::WatchJobRequest watch;
  watch.set_name(job.name());
  std::string waiting;
  const auto until_it_waits = [&waiting](const v1::Job& now) { return (waiting = now.waiting()).empty(); };
  EXPECT_TRUE(absl::IsCancelled(impl_.WatchJob(watch, until_it_waits, [] { return true; })));
  EXPECT_EQ(waiting, "no worker is connected");
  AwaitTask();
  EXPECT_EQ(cluster_.Get(job.name()).waiting(), "");
}

TEST_F(ClusterViewTest, TellsWhenAJobStartedAndItsTrace) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  EXPECT_FALSE(job.has_start_time());
  EXPECT_EQ(job.trace().size(), 32U);
  cluster_.clock().Advance(absl::Seconds(5));
  const v1::Task task = AwaitTask();
  EXPECT_EQ(task.trace(), job.trace());
  const v1::Job started = cluster_.Get(job.name());
  EXPECT_EQ(started.start_time().seconds() - started.create_time().seconds(), 5);
}

TEST_F(ClusterViewTest, ListsJobsOfSomeStates) {
  const v1::Job running = cluster_.Submit("toy://2x1");
  const v1::Job cancelled = cluster_.Submit("toy://2x1");
  v1::CancelJobRequest cancel;
  cancel.set_name(cancelled.name());
  ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  v1::ListJobsRequest request;
  request.add_states(v1::CANCELLED);
  const auto response = impl_.ListJobs(request);
  ASSERT_TRUE(response.ok()) << response.status();
  ASSERT_EQ(response->jobs_size(), 1);
  EXPECT_EQ(response->jobs(0).name(), cancelled.name());
}

TEST_F(ClusterViewTest, EndsAPageBeforeItIsTooLongForAMessage) {
  const std::string deep = "/" + std::string(4000, 'x');
  for (int i = 0; i < 400; ++i) {
    v1::CreateJobRequest request = NewRequest(absl::StrCat("o", i));
    request.mutable_spec()->set_water(deep);
    request.mutable_spec()->set_area(deep);
    auto job = impl_.CreateJob(request);
    while (absl::IsResourceExhausted(job.status())) job = impl_.CreateJob(request);  // until a cancelled one has ended
    ASSERT_TRUE(job.ok()) << job.status();
    v1::CancelJobRequest cancel;
    cancel.set_name(job->name());
    ASSERT_TRUE(impl_.CancelJob(cancel).ok());
  }
  v1::ListJobsRequest request;
  request.set_page_size(1000);
  int jobs = 0, pages = 0;
  do {
    const auto page = impl_.ListJobs(request);
    ASSERT_TRUE(page.ok());
    EXPECT_LT(page->ByteSizeLong(), static_cast<size_t>(kMaxMessageBytes));
    jobs += page->jobs_size();
    ++pages;
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  EXPECT_EQ(jobs, 400);
  EXPECT_EQ(pages, 2);
}

TEST_F(ClusterViewTest, RefusesPagesBelowZero) {
  v1::ListWorkersRequest request;
  request.set_page_size(-1);
  EXPECT_EQ(ErrorReason(impl_.ListWorkers(request).status()), "INVALID_PAGE");
}

}  // namespace
}  // namespace tilemend
