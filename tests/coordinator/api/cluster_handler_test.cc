#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class ClusterHandlerTest : public CoordinatorTest {
 protected:
  v1::ListWorkersResponse Workers(int32_t size = 0, const std::string& token = "") {
    v1::ListWorkersRequest request;
    request.set_page_size(size);
    request.set_page_token(token);
    const auto response = calls_.cluster.ListWorkers(request);
    EXPECT_TRUE(response.ok()) << response.status();
    return response.ok() ? *response : v1::ListWorkersResponse();
  }
};

TEST_F(ClusterHandlerTest, ListsWorkersPageByPage) {
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

TEST_F(ClusterHandlerTest, RefusesPagesBelowZero) {
  v1::ListWorkersRequest request;
  request.set_page_size(-1);
  EXPECT_EQ(ErrorReason(calls_.cluster.ListWorkers(request).status()), "INVALID_PAGE");
}

}  // namespace
}  // namespace tilemend
