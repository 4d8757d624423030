// The JSON mirror: requests of the web server as calls of clients, and their answers as JSON.
#ifndef TILEMEND_COORDINATOR_WEB_WEB_API_H_
#define TILEMEND_COORDINATOR_WEB_WEB_API_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <semaphore>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/http/http_server.h"
#include "common/util/job_log_tail.h"
#include "coordinator/api/guarded_calls.h"
#include "coordinator/web/byte_budget.h"
#include "coordinator/web/job_files.h"
#include "coordinator/web/routes.h"

namespace tilemend {

// Tiles that are read at once, and calls that look whether a report has changed, of the server's 16 threads. A shared
// folder that hangs holds no more of them.
inline constexpr std::ptrdiff_t kMostTileReads = 6, kMostReportLooks = 4;

// Of tiles that are read or sent.
inline constexpr int64_t kMostTileBytesAtOnce = kMostTileReads * kMostTileBytes;

// Thread-safe. Who calls is said by "Authorization: Bearer TOKEN" or by a certificate, as over gRPC, and has the same
// rights there and here (GuardedCalls).
class WebApi {
 public:
  // Both must outlive this. `log`: where the lines on jobs are; null: nowhere. `listen`: where gRPC is served.
  explicit WebApi(const GuardedCalls& calls, const JobLogTail* log = nullptr, std::string listen = "")
      : calls_(calls), log_(log), listen_(std::move(listen)) {}

  // The answer to a request below /v1/. Errors are {"error": {"code", "message", "reason", "metadata"}}. An answer to
  // GET has an ETag; 304 if that is the one in If-None-Match. A watch without news waits (HttpAnswer::wait).
  HttpAnswer Answer(const HttpRequest& request);

 private:
  absl::StatusOr<HttpAnswer> AnswerMatch(const Match& match, const HttpRequest& request);
  absl::StatusOr<HttpAnswer> Read(const Match& match, const HttpRequest& request, const Peer& peer);
  absl::StatusOr<HttpAnswer> Steer(const Match& match, const HttpRequest& request, const Peer& peer);
  absl::StatusOr<HttpAnswer> Me(const Peer& peer) const;
  absl::StatusOr<HttpAnswer> Watch(const Match& match, const HttpRequest& request, const Peer& peer);
  absl::StatusOr<HttpAnswer> Cells(const std::string& name, const Peer& peer);
  absl::StatusOr<HttpAnswer> Holes(const std::string& name, const Peer& peer);
  absl::StatusOr<HttpAnswer> Review(const std::string& name, const Peer& peer);
  absl::StatusOr<HttpAnswer> LogOf(const std::string& name, const Peer& peer) const;
  absl::StatusOr<HttpAnswer> TileOf(const Match& match, const HttpRequest& request, const Peer& peer);

  const GuardedCalls& calls_;
  const JobLogTail* const log_;
  const std::string listen_;
  JobFiles files_;
  ByteBudget tile_bytes_{kMostTileBytesAtOnce};
  std::counting_semaphore<kMostReportLooks> report_looks_{kMostReportLooks};
};

// The HTTP status for an error of a call.
int HttpStatusOf(absl::StatusCode code);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_WEB_API_H_
