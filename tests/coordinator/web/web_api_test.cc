// The JSON mirror without a network: who may see and do what, and what comes back.
#include "coordinator/web/web_api.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "absl/synchronization/notification.h"
#include "common/store/digest.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/list_log.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

class WebApiTest : public CoordinatorTest {
 protected:
  std::string Tokens() const {
    std::string text;
    for (const auto& [name, role] : {std::pair("ann", "submit"), std::pair("bob", "submit"), std::pair("eve", "watch"),
                                     std::pair("root", "admin"), std::pair("wrk", "worker")}) {
      text += absl::StrCat(name, " ", role, " ", Sha256Hex(name), "\n");
    }
    return folder_.Write("tokens", text);
  }
  HttpAnswer Get(const std::string& path, const std::string& token = "eve", const std::string& tag = "") {
    HttpRequest request{.method = "GET", .path = path};
    if (!token.empty()) request.headers["authorization"] = "Bearer " + token;
    if (!tag.empty()) request.headers["if-none-match"] = tag;
    return api_.Answer(request);
  }
  HttpAnswer Post(const std::string& path, const std::string& token, const std::string& body = "{}") {
    HttpRequest request{.method = "POST", .path = path};
    request.headers = {{"authorization", "Bearer " + token}, {"content-type", "application/json"}};
    request.body = body;
    return api_.Answer(request);
  }
  static std::string TagOf(const HttpAnswer& answer) {
    for (const auto& [name, value] : answer.headers) {
      if (name == "ETag") return value;
    }
    return "";
  }
  // "/v1/jobs/ID" of a new job of ann.
  std::string NewJob() {
    const auto job = guarded_.CreateJob({{"", {}, "ann"}, "a"}, NewRequest(absl::StrCat("o", ++jobs_)));
    EXPECT_TRUE(job.ok()) << job.status();
    return absl::StrCat("/v1/", job.ok() ? job->name() : "");
  }

  TemporaryFolder folder_;
  PrometheusRegistry registry_;
  ListLog log_;
  Entrance entrance_{std::make_shared<Gate>(*Access::Closed(Tokens(), *Log::Null()), registry_, log_)};
  GuardedCalls guarded_{calls_, entrance_};
  JobLogTail tail_{log_};
  WebApi api_{guarded_, &tail_, "0.0.0.0:7070"};
  int jobs_ = 0;
};

TEST_F(WebApiTest, NoPathButTheDocumentIsForAnybody) {
  for (const Route& route : Routes()) {
    const std::string path(route.pattern);
    const HttpAnswer answer = route.method == "GET" ? Get(path, "") : Post(path, "guess");
    EXPECT_EQ(answer.status, route.call == WebCall::kOpenApi ? 200 : 401) << path;
    if (route.call == WebCall::kOpenApi) continue;
    EXPECT_EQ(Json::parse(answer.body)["error"]["reason"], "UNAUTHENTICATED") << path;
    EXPECT_EQ((route.method == "GET" ? Get(path, "wrk") : Post(path, "wrk")).status, 403) << path;
  }
}

TEST_F(WebApiTest, WhoMayWatchSeesAndChangesNothing) {
  const std::string job = NewJob();
  EXPECT_EQ(Get(job).status, 200);
  EXPECT_EQ(Json::parse(Get(job).body)["owner"], "ann");
  EXPECT_EQ(Json::parse(Get("/v1/jobs").body)["jobs"].size(), 1);
  for (const char* verb : {"/cancel", "/pause", "/resume", "/priority", "/retry"}) {
    EXPECT_EQ(Post(job + verb, "eve").status, 403) << verb;
    EXPECT_EQ(Post(job + verb, "bob").status, 403) << verb;
  }
  EXPECT_EQ(Json::parse(Get("/v1/me").body),
            Json::parse(R"({"name": "eve", "maySteer": false, "isAdmin": false, "listen": "0.0.0.0:7070"})"));
  EXPECT_EQ(Json::parse(Get("/v1/me", "ann").body)["maySteer"], true);
  EXPECT_EQ(Json::parse(Get("/v1/me", "root").body)["isAdmin"], true);
}

TEST_F(WebApiTest, TheOwnerSteersItsJob) {
  const std::string job = NewJob();
  EXPECT_EQ(Json::parse(Post(job + "/pause", "ann").body)["paused"], true);
  EXPECT_EQ(Json::parse(Post(job + "/resume", "ann").body)["paused"], false);
  EXPECT_EQ(Json::parse(Post(job + "/priority", "ann", R"({"priority": 7})").body)["priority"], 7);
  EXPECT_EQ(Post(job + "/priority", "ann", R"({"priority": 700})").status, 400);
  EXPECT_EQ(Json::parse(Post(job + "/cancel", "ann").body)["state"], "CANCELLED");
  EXPECT_EQ(Post(job + "/pause", "ann").status, 400);  // it is over
  EXPECT_THAT(log_.lines(), Contains(HasSubstr("audit rpc=tilemend.v1.Jobs/CancelJob who=ann address=http:")));
}

TEST_F(WebApiTest, TheNameInTheBodyDoesNotCount) {
  const std::string mine = NewJob(), other = NewJob();
  const std::string name = other.substr(4);
  EXPECT_EQ(Post(mine + "/pause", "ann", Json{{"name", name}}.dump()).status, 200);
  EXPECT_EQ(Json::parse(Get(other).body)["paused"], false);
  EXPECT_EQ(Json::parse(Get(mine).body)["paused"], true);
}

TEST_F(WebApiTest, ABodyThatIsNoRequestIsRefused) {
  const std::string job = NewJob();
  for (const char* body : {"{", "[]", R"({"no such field": 1})", R"({"priority": "x"})"}) {
    EXPECT_EQ(Post(job + "/priority", "ann", body).status, 400) << body;
  }
  HttpRequest form{.method = "POST", .path = job + "/cancel"};
  form.headers = {{"authorization", "Bearer ann"}, {"content-type", "application/x-www-form-urlencoded"}};
  EXPECT_EQ(api_.Answer(form).status, 400);
  EXPECT_EQ(Json::parse(Get(job).body)["state"], "RUNNING");
}

TEST_F(WebApiTest, WhatHasNotChangedIsNotSentAgain) {
  const std::string job = NewJob();
  AwaitTask();  // until then the job changes by itself
  for (const std::string& path : {job, job + "/cells", std::string("/v1/jobs"), std::string("/v1/workers")}) {
    const HttpAnswer first = Get(path);
    ASSERT_EQ(first.status, 200) << path;
    EXPECT_EQ(Get(path, "eve", TagOf(first)).status, 304) << path;
    EXPECT_EQ(Get(path, "eve", "\"another\"").status, 200) << path;
    EXPECT_EQ(Get(path, "", TagOf(first)).status, 401) << path;
  }
  const std::string tag = TagOf(Get(job));
  Post(job + "/pause", "ann");
  EXPECT_EQ(Get(job, "eve", tag).status, 200);
}

// What a watch of `job` after `cursor` gives.
HttpAnswer WatchOf(WebApi& api, const std::string& job, const std::string& cursor, bool has_waited = false) {
  HttpRequest request{.method = "GET", .path = job + "/watch", .query = {{"cursor", cursor}}, .has_waited = has_waited};
  request.headers["authorization"] = "Bearer eve";
  return api.Answer(request);
}

TEST_F(WebApiTest, AWatchWaitsUntilTheJobChanges) {
  const std::string job = NewJob();
  AwaitTask();  // until then the job changes by itself
  const std::string cursor = Json::parse(Get(job + "/watch").body)["cursor"];
  EXPECT_EQ(Json::parse(Get(job + "/watch").body), Json::parse(Get(job).body));
  const HttpAnswer answer = WatchOf(api_, job, cursor);
  ASSERT_NE(answer.wait, nullptr);
  absl::Notification woken;
  const auto wait = answer.wait([&] { woken.Notify(); });
  EXPECT_FALSE(woken.HasBeenNotified());
  Post(job + "/pause", "ann");
  EXPECT_TRUE(woken.WaitForNotificationWithTimeout(absl::Seconds(10)));
  const HttpAnswer next = WatchOf(api_, job, cursor, true);
  EXPECT_EQ(next.wait, nullptr);
  EXPECT_EQ(Json::parse(next.body)["paused"], true);
  EXPECT_EQ(WatchOf(api_, job, cursor).wait, nullptr) << "the news is there";
}

TEST_F(WebApiTest, AWatchOfAJobThatIsOverDoesNotWait) {
  const std::string job = NewJob();
  Post(job + "/cancel", "ann");
  const HttpAnswer answer = WatchOf(api_, job, "18446744073709551615");
  EXPECT_EQ(answer.wait, nullptr);
  EXPECT_EQ(Json::parse(answer.body)["state"], "CANCELLED");
  EXPECT_EQ(WatchOf(api_, job, "x").status, 400);
  EXPECT_EQ(WatchOf(api_, "/v1/jobs/none", "1").status, 404);
}

TEST_F(WebApiTest, AWatchIsWokenWhenTheCoordinatorEnds) {
  const std::string job = NewJob();
  AwaitTask();
  const HttpAnswer answer = WatchOf(api_, job, "18446744073709551615");
  ASSERT_NE(answer.wait, nullptr);
  absl::Notification woken;
  const auto wait = answer.wait([&] { woken.Notify(); });
  coordinator_.StopWaiting();
  EXPECT_TRUE(woken.WaitForNotificationWithTimeout(absl::Seconds(10)));
}

TEST_F(WebApiTest, AWatchThatMakesRoomIsToldToAskLater) {
  const std::string job = NewJob();
  AwaitTask();
  HttpRequest request{.method = "GET",
                      .path = job + "/watch",
                      .query = {{"cursor", "18446744073709551615"}},
                      .has_waited = true,
                      .made_room = true};
  request.headers["authorization"] = "Bearer eve";
  EXPECT_EQ(api_.Answer(request).status, 429);
  request.query.find("cursor")->second = "0";
  EXPECT_EQ(api_.Answer(request).status, 200) << "there is news";
}

TEST_F(WebApiTest, NoPathLeadsOut) {
  const std::string job = NewJob();
  for (const char* path :
       {"/v1/../etc/passwd", "/v1/jobs/..", "/v1/jobs/../cells", "/v1/jobs/%2e%2e", "/v1/jobs/a b"}) {
    EXPECT_GE(Get(path).status, 400) << path;
  }
  for (const char* cell : {"..", "../../etc/passwd", "0,0,0", "0", "a,b", "1e9,0", "99999999999,0", "0,0\0"}) {
    EXPECT_EQ(Get(absl::StrCat(job, "/cells/", cell, "/before")).status / 100, 4) << cell;
  }
  EXPECT_EQ(Get("/v1/nothing").status, 404);
  const HttpAnswer refused = Post("/v1/workers", "root");
  EXPECT_EQ(refused.status, 405);
  EXPECT_THAT(refused.headers, testing::Contains(testing::Pair("Allow", "GET, HEAD")));
  EXPECT_THAT(refused.body, testing::Not(HasSubstr("no such path")));
}

TEST_F(WebApiTest, ListsComeInPages) {
  NewJob();
  NewJob();
  HttpRequest request{.method = "GET", .path = "/v1/jobs"};
  request.headers["authorization"] = "Bearer eve";
  request.query["pageSize"] = "1";
  const Json first = Json::parse(api_.Answer(request).body);
  EXPECT_EQ(first["jobs"].size(), 1);
  request.query["pageToken"] = first["nextPageToken"].get<std::string>();
  EXPECT_NE(Json::parse(api_.Answer(request).body)["jobs"][0]["name"], first["jobs"][0]["name"]);
  request.query["pageSize"] = "many";
  EXPECT_EQ(api_.Answer(request).status, 400);
}

TEST_F(WebApiTest, ShowsTheCellsOfARunningJob) {
  const std::string job = NewJob();
  AwaitTask();
  const Json map = Json::parse(Get(job + "/cells").body);
  EXPECT_EQ(map["cells"], "..");
  EXPECT_EQ(map["held"].size(), 1);
  EXPECT_EQ(map["hasTiles"], false);
  EXPECT_EQ(Get(job + "/holes").status, 404);
  EXPECT_EQ(Get(job + "/review").status, 404);
  EXPECT_EQ(Get(job + "/cells/0,0/after").status, 404);
}

// Who downloads decisions from the page of an earlier job would undo those of the later one.
TEST_F(WebApiTest, AnEarlierJobDoesNotShowTheOutputOfALaterOne) {
  cluster_.AddWorker("w");
  const std::string job = NewJob();
  ASSERT_EQ(cluster_.WaitFor(job.substr(4)).state(), v1::DONE);
  HttpAnswer holes;
  do {
    holes = Get(job + "/holes");
  } while (holes.status == 503);
  EXPECT_EQ(holes.status, 200) << holes.body;
  const std::string later =
      Json::parse(Post(job + "/retry", "ann", R"({"overwrite": true})").body)["name"].get<std::string>();
  ASSERT_EQ(cluster_.WaitFor(later).state(), v1::DONE);
  for (const char* what : {"/holes", "/review", "/cells/0,0/after"}) {
    const HttpAnswer answer = Get(job + what);
    EXPECT_EQ(answer.status, 409) << what;
    const Json error = Json::parse(answer.body)["error"];
    EXPECT_EQ(error["reason"], "OUTPUT_REPLACED") << what;
    EXPECT_EQ(absl::StrCat("jobs/", error["metadata"]["job"].get<std::string>()), later) << what;
    EXPECT_THAT(error["message"].get<std::string>(), HasSubstr("written again by " + later)) << what;
  }
  EXPECT_NE(Get(job + "/cells/0,0/before").status, 409);
  EXPECT_EQ(Get(job).status, 200);
}

TEST_F(WebApiTest, ShowsTheLogLinesOfAJob) {
  const std::string job = NewJob();
  EXPECT_EQ(Json::parse(Get(job + "/log").body)["lines"], Json::array());
  tail_.Warn("attempt lost", {{"job", job.substr(std::string("/v1/jobs/").size())}, {"worker", "w"}});
  const Json lines = Json::parse(Get(job + "/log").body)["lines"];
  ASSERT_EQ(lines.size(), 1);
  EXPECT_THAT(lines[0].get<std::string>(), HasSubstr("attempt lost"));
  EXPECT_EQ(Get("/v1/jobs/none/log").status, 404);
}

TEST_F(WebApiTest, ErrorsOfCallsHaveTheirHttpStatus) {
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kOk), 200);
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kAborted), 409);
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kResourceExhausted), 429);
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kUnimplemented), 501);
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kUnavailable), 503);
  EXPECT_EQ(HttpStatusOf(absl::StatusCode::kDataLoss), 500);
  const HttpAnswer answer = Get("/v1/jobs", "");
  EXPECT_THAT(answer.headers, Contains(Pair("WWW-Authenticate", "Bearer")));
}

}  // namespace
}  // namespace tilemend
