#include "coordinator/web/routes.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "coordinator/api/access.h"

namespace tilemend {
namespace {

TEST(RoutesTest, MatchesPathsAndGivesTheirParts) {
  const auto match = MatchRoute("GET", "/v1/jobs/12ab/cells/3,-4/before");
  ASSERT_TRUE(match);
  EXPECT_EQ(match->route->call, WebCall::kTileBefore);
  EXPECT_EQ(match->arguments.at("job"), "12ab");
  EXPECT_EQ(match->arguments.at("cell"), "3,-4");
  EXPECT_EQ(MatchRoute("HEAD", "/v1/jobs")->route->call, WebCall::kListJobs);
  EXPECT_EQ(MatchRoute("POST", "/v1/jobs/1/cancel")->route->call, WebCall::kCancelJob);
}

TEST(RoutesTest, MatchesNothingElse) {
  for (const char* path : {"", "/", "/v1", "/v1/", "/v1/jobs/", "/v1/jobs//cells", "/v1/jobs/1/cells/1,1/before/x",
                           "/v1/jobs/1/../../etc/passwd", "/v2/jobs", "/v1/jobs/1/delete"}) {
    EXPECT_FALSE(MatchRoute("GET", path)) << path;
  }
  EXPECT_FALSE(MatchRoute("GET", "/v1/jobs/1/cancel"));
  EXPECT_EQ(AllowedMethods("/v1/jobs/1/cancel"), "POST");
  EXPECT_EQ(AllowedMethods("/v1/jobs"), "GET, HEAD");
  EXPECT_EQ(AllowedMethods("/v1/nothing"), "");
}

TEST(RoutesTest, EveryRouteNamesAnRpcThatHasARole) {
  std::set<std::string> rpcs;
  for (const RpcNeed& need : RpcNeeds()) rpcs.insert(std::string(need.rpc));
  for (const Route& route : Routes()) {
    EXPECT_EQ(route.rpc.empty(), route.call == WebCall::kOpenApi) << route.pattern;
    EXPECT_TRUE(route.rpc.empty() || rpcs.contains(std::string(route.rpc))) << route.rpc;
    EXPECT_TRUE(MatchRoute(route.method, route.pattern)->route == &route) << route.pattern;
  }
}

}  // namespace
}  // namespace tilemend
