#include "coordinator/web/routes.h"

#include "absl/strings/str_split.h"

namespace tilemend {
namespace {

constexpr char kGet[] = "GET", kPost[] = "POST";
constexpr char kJob[] = "tilemend.v1.Job";

std::optional<std::map<std::string, std::string>> ArgumentsOf(std::string_view pattern, std::string_view path) {
  const std::vector<std::string> wanted = absl::StrSplit(absl::string_view(pattern.data(), pattern.size()), '/');
  const std::vector<std::string> parts = absl::StrSplit(absl::string_view(path.data(), path.size()), '/');
  if (wanted.size() != parts.size()) return std::nullopt;
  std::map<std::string, std::string> arguments;
  for (size_t k = 0; k < wanted.size(); ++k) {
    if (wanted[k].starts_with('{')) {
      if (parts[k].empty()) return std::nullopt;
      arguments[wanted[k].substr(1, wanted[k].size() - 2)] = parts[k];
    } else if (wanted[k] != parts[k]) {
      return std::nullopt;
    }
  }
  return arguments;
}

}  // namespace

const std::vector<Route>& Routes() {
  static const std::vector<Route> routes = {
      {WebCall::kOpenApi, kGet, "/v1/openapi.json", "", "", "OpenApi", "This document"},
      {WebCall::kMe, kGet, "/v1/me", "tilemend.v1.Jobs/ListJobs", "", "Me", "Who calls, and what it may do"},
      {WebCall::kListJobs, kGet, "/v1/jobs", "tilemend.v1.Jobs/ListJobs", "tilemend.v1.ListJobsRequest",
       "tilemend.v1.ListJobsResponse", "Jobs, the newest first"},
      {WebCall::kGetJob, kGet, "/v1/jobs/{job}", "tilemend.v1.Jobs/GetJob", "", kJob, "One job"},
      {WebCall::kWatchJob, kGet, "/v1/jobs/{job}/watch", "tilemend.v1.Jobs/WatchJob", "", kJob,
       "One job, as soon as its cursor is above that of the query; after 20 s as it is; 429 if too many wait",
       "cursor"},
      {WebCall::kGetCells, kGet, "/v1/jobs/{job}/cells", "tilemend.v1.Jobs/GetJob", "", "Cells",
       "How far each cell is, one letter a cell"},
      {WebCall::kListHoles, kGet, "/v1/jobs/{job}/holes", "tilemend.v1.Jobs/GetJob", "", "Holes",
       "The holes of a job: as planned while it runs, then as its report has them"},
      {WebCall::kTileBefore, kGet, "/v1/jobs/{job}/cells/{cell}/before", "tilemend.v1.Jobs/GetJob", "", "",
       "The mesh of cell COLUMN,ROW as it was, or the file of its tile with that path from it", "path"},
      {WebCall::kTileAfter, kGet, "/v1/jobs/{job}/cells/{cell}/after", "tilemend.v1.Jobs/GetJob", "", "",
       "The mesh of cell COLUMN,ROW in the output, or the file of its tile with that path from it", "path"},
      {WebCall::kGetReview, kGet, "/v1/jobs/{job}/review", "tilemend.v1.Jobs/GetJob", "", "Review",
       "The review queue of a job that is over"},
      {WebCall::kGetLog, kGet, "/v1/jobs/{job}/log", "tilemend.v1.Jobs/GetJob", "", "Log",
       "The last lines of the coordinator's log on a job"},
      {WebCall::kCancelJob, kPost, "/v1/jobs/{job}/cancel", "tilemend.v1.Jobs/CancelJob",
       "tilemend.v1.CancelJobRequest", kJob, "Ends a job"},
      {WebCall::kPauseJob, kPost, "/v1/jobs/{job}/pause", "tilemend.v1.Jobs/PauseJob", "tilemend.v1.PauseJobRequest",
       kJob, "Gives out no task of a job"},
      {WebCall::kResumeJob, kPost, "/v1/jobs/{job}/resume", "tilemend.v1.Jobs/ResumeJob",
       "tilemend.v1.ResumeJobRequest", kJob, "Goes on with a paused job"},
      {WebCall::kPrioritizeJob, kPost, "/v1/jobs/{job}/priority", "tilemend.v1.Jobs/PrioritizeJob",
       "tilemend.v1.PrioritizeJobRequest", kJob, "Gives a job another priority"},
      {WebCall::kRetryJob, kPost, "/v1/jobs/{job}/retry", "tilemend.v1.Jobs/RetryJob", "tilemend.v1.RetryJobRequest",
       kJob, "A new job with the options of one that is over"},
      {WebCall::kListWorkers, kGet, "/v1/workers", "tilemend.v1.Workers/ListWorkers", "tilemend.v1.ListWorkersRequest",
       "tilemend.v1.ListWorkersResponse", "Workers and the tasks that they hold"},
  };
  return routes;
}

std::optional<Match> MatchRoute(std::string_view method, std::string_view path) {
  for (const Route& route : Routes()) {
    if (route.method != (method == "HEAD" ? kGet : method)) continue;
    if (auto arguments = ArgumentsOf(route.pattern, path)) return Match{&route, *std::move(arguments)};
  }
  return std::nullopt;
}

std::string AllowedMethods(std::string_view path) {
  std::string allowed;
  for (const Route& route : Routes()) {
    if (!ArgumentsOf(route.pattern, path)) continue;
    if (!allowed.empty()) allowed += ", ";
    allowed += route.method == kGet ? "GET, HEAD" : route.method;
  }
  return allowed;
}

}  // namespace tilemend
