// The paths of the JSON mirror in one table, from which requests are dispatched and the OpenAPI document is made.
#ifndef TILEMEND_COORDINATOR_WEB_ROUTES_H_
#define TILEMEND_COORDINATOR_WEB_ROUTES_H_

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tilemend {

enum class WebCall {
  kOpenApi,
  kMe,
  kListJobs,
  kGetJob,
  kWatchJob,
  kGetCells,
  kListHoles,
  kTileBefore,
  kTileAfter,
  kGetReview,
  kGetLog,
  kCancelJob,
  kPauseJob,
  kResumeJob,
  kPrioritizeJob,
  kRetryJob,
  kListWorkers,
};

struct Route {
  WebCall call;
  std::string_view method;   // "GET" or "POST"
  std::string_view pattern;  // "/v1/jobs/{job}": a name in braces stands for one part of the path
  std::string_view rpc;      // "package.Service/Method", whose role the caller needs; "": anybody
  std::string_view request;  // the message that a POST's body is, or that the query's fields are of; "": none
  std::string_view answer;   // a message, or the name of a schema of open_api.cc; "": not JSON
  std::string_view summary;
  std::string_view parameter = {};  // of the query, a text; "": none but those of `request`
};

const std::vector<Route>& Routes();

struct Match {
  const Route* route;                            // of Routes()
  std::map<std::string, std::string> arguments;  // by the names in braces
};

// None if no route has that path and method. HEAD is as GET.
std::optional<Match> MatchRoute(std::string_view method, std::string_view path);
// The methods of the routes of that path, as the header Allow has them: "GET, HEAD". "" if no route has it.
std::string AllowedMethods(std::string_view path);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_ROUTES_H_
