#include "coordinator/web/web_api.h"

#include <google/protobuf/util/json_util.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "common/rpc/trace.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/web/cell_map.h"
#include "coordinator/web/message_json.h"
#include "coordinator/web/open_api.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kJsonType[] = "application/json";
constexpr size_t kMostErrorText = 1024;  // bytes, as over gRPC

std::string TextOf(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

HttpAnswer JsonAnswer(std::string text) { return {.type = kJsonType, .body = std::move(text)}; }

absl::StatusOr<HttpAnswer> JsonAnswer(const google::protobuf::Message& message) {
  TILEMEND_ASSIGN_OR_RETURN(std::string text, MessageJson(message));
  return JsonAnswer(std::move(text));
}

// Of a call that gives a message.
template <typename T>
absl::StatusOr<HttpAnswer> MessageAnswer(const absl::StatusOr<T>& message) {
  if (!message.ok()) return message.status();
  return JsonAnswer(*message);
}

HttpAnswer ErrorAnswer(const absl::Status& status) {
  const ErrorInfo info = GetErrorInfo(status).value_or(ErrorInfo());
  const Json error = {{"code", absl::StatusCodeToString(status.code())},
                      {"message", Shortened(std::string(status.message()), kMostErrorText)},
                      {"reason", info.reason},
                      {"metadata", info.metadata}};
  HttpAnswer answer = JsonAnswer(TextOf({{"error", error}}));
  answer.status = HttpStatusOf(status.code());
  if (answer.status == 401) answer.headers.emplace_back("WWW-Authenticate", "Bearer");
  return answer;
}

Peer PeerOf(const HttpRequest& request) {
  constexpr absl::string_view kScheme = "Bearer ";
  Peer peer{{request.certificate_name, request.certificate_uris, ""},
            absl::StrCat("http:", request.address),
            TraceOf(request.Header("traceparent"))};
  const std::string shown = request.Header("authorization");
  if (absl::StartsWithIgnoreCase(shown, kScheme)) peer.claims.token = shown.substr(kScheme.size());
  return peer;
}

std::string JobNameOf(const Match& match) { return absl::StrCat("jobs/", match.arguments.at("job")); }

// The body of a POST as a request on the job of its path. An empty body is an empty request.
template <typename Request>
absl::StatusOr<Request> RequestOf(const Match& match, const std::string& body) {
  Request request;
  if (!body.empty()) {
    const auto status = google::protobuf::util::JsonStringToMessage(body, &request);
    if (!status.ok()) return absl::InvalidArgumentError(absl::StrCat("the body: ", std::string(status.message())));
  }
  request.set_name(JobNameOf(match));
  return request;
}

// The fields page_size and page_token of a list's request.
template <typename Request>
absl::StatusOr<Request> PageRequestOf(const HttpRequest& request) {
  Request page;
  const auto value = [&](const char* name) {
    const auto found = request.query.find(name);
    return found == request.query.end() ? std::string() : found->second;
  };
  int32_t size = 0;
  if (const std::string text = value("pageSize"); !text.empty() && !absl::SimpleAtoi(text, &size)) {
    return WithErrorInfo(absl::InvalidArgumentError("pageSize: no number"), {"INVALID_PAGE", {}});
  }
  page.set_page_size(size);
  page.set_page_token(value("pageToken"));
  return page;
}

// "COLUMN,ROW".
std::optional<CellId> CellOf(const std::string& text) {
  const std::vector<std::string> parts = absl::StrSplit(text, ',');
  CellId cell;
  if (parts.size() != 2 || !absl::SimpleAtoi(parts[0], &cell.col) || !absl::SimpleAtoi(parts[1], &cell.row)) {
    return std::nullopt;
  }
  return cell;
}

// A turn to look at a report; false if too many do.
class ReportLook {
 public:
  explicit ReportLook(std::counting_semaphore<kMostReportLooks>& all) : all_(all), has_(all.try_acquire()) {}
  ~ReportLook() {
    if (has_) all_.release();
  }
  ReportLook(const ReportLook&) = delete;
  ReportLook& operator=(const ReportLook&) = delete;
  explicit operator bool() const { return has_; }

 private:
  std::counting_semaphore<kMostReportLooks>& all_;
  const bool has_;
};

absl::Status OthersAre(const char* what) { return absl::UnavailableError(absl::StrCat("other ", what, "; ask again")); }

// 304 if the caller has this answer already.
void AddTag(const HttpRequest& request, HttpAnswer& answer) {
  const std::string tag = absl::StrCat("\"", Sha256Hex(answer.body).substr(0, 32), "\"");
  answer.headers.emplace_back("ETag", tag);
  answer.headers.emplace_back("Cache-Control", "private, no-cache");
  if (request.HasTag(tag)) answer.status = 304;
}

}  // namespace

int HttpStatusOf(absl::StatusCode code) {
  switch (code) {
    case absl::StatusCode::kOk:
      return 200;
    case absl::StatusCode::kInvalidArgument:
    case absl::StatusCode::kOutOfRange:
    case absl::StatusCode::kFailedPrecondition:
      return 400;
    case absl::StatusCode::kUnauthenticated:
      return 401;
    case absl::StatusCode::kPermissionDenied:
      return 403;
    case absl::StatusCode::kNotFound:
      return 404;
    case absl::StatusCode::kAborted:
    case absl::StatusCode::kAlreadyExists:
      return 409;
    case absl::StatusCode::kResourceExhausted:
      return 429;
    case absl::StatusCode::kUnimplemented:
      return 501;
    case absl::StatusCode::kUnavailable:
      return 503;
    default:
      return 500;
  }
}

HttpAnswer WebApi::Answer(const HttpRequest& request) {
  const auto match = MatchRoute(request.method, request.path);
  if (!match) {
    const std::string allowed = AllowedMethods(request.path);
    if (allowed.empty()) return ErrorAnswer(absl::NotFoundError("no such path; see /v1/openapi.json"));
    HttpAnswer answer = ErrorAnswer(absl::UnimplementedError(
        absl::StrCat("this path allows ", allowed, " only; see /v1/openapi.json. Jobs are created over gRPC")));
    answer.status = 405;
    answer.headers.emplace_back("Allow", allowed);
    return answer;
  }
  auto answer = AnswerMatch(*match, request);
  if (!answer.ok()) return ErrorAnswer(answer.status());
  if (match->route->method == "GET") {
    AddTag(request, *answer);
  } else {
    answer->headers.emplace_back("Cache-Control", "no-store");
  }
  return *std::move(answer);
}

absl::StatusOr<HttpAnswer> WebApi::AnswerMatch(const Match& match, const HttpRequest& request) {
  const Peer peer = PeerOf(request);
  if (match.route->method == "GET") return Read(match, request, peer);
  // A form of another site cannot send this type without asking first, and is never answered then.
  if (!absl::StartsWith(request.Header("content-type"), kJsonType)) {
    return absl::InvalidArgumentError("expected Content-Type: application/json");
  }
  return Steer(match, request, peer);
}

absl::StatusOr<HttpAnswer> WebApi::Read(const Match& match, const HttpRequest& request, const Peer& peer) {
  switch (match.route->call) {
    case WebCall::kOpenApi:
      return JsonAnswer(OpenApiDocument());
    case WebCall::kMe:
      return Me(peer);
    case WebCall::kListJobs: {
      TILEMEND_ASSIGN_OR_RETURN(const auto page, PageRequestOf<v1::ListJobsRequest>(request));
      return MessageAnswer(calls_.ListJobs(peer, page));
    }
    case WebCall::kGetJob: {
      v1::GetJobRequest get;
      get.set_name(JobNameOf(match));
      return MessageAnswer(calls_.GetJob(peer, get));
    }
    case WebCall::kWatchJob:
      return Watch(match, request, peer);
    case WebCall::kGetCells:
      return Cells(JobNameOf(match), peer);
    case WebCall::kListHoles:
      return Holes(JobNameOf(match), peer);
    case WebCall::kTileBefore:
    case WebCall::kTileAfter:
      return TileOf(match, request, peer);
    case WebCall::kGetReview:
      return Review(JobNameOf(match), peer);
    case WebCall::kGetLog:
      return LogOf(JobNameOf(match), peer);
    case WebCall::kListWorkers: {
      TILEMEND_ASSIGN_OR_RETURN(const auto page, PageRequestOf<v1::ListWorkersRequest>(request));
      return MessageAnswer(calls_.ListWorkers(peer, page));
    }
    default:
      return absl::UnimplementedError("not a path to read");
  }
}

absl::StatusOr<HttpAnswer> WebApi::Steer(const Match& match, const HttpRequest& request, const Peer& peer) {
  const auto change = [&]<typename Request>(absl::StatusOr<v1::Job> (GuardedCalls::*call)(const Peer&, const Request&)
                                                const) -> absl::StatusOr<HttpAnswer> {
    TILEMEND_ASSIGN_OR_RETURN(const auto asked, RequestOf<Request>(match, request.body));
    return MessageAnswer(std::invoke(call, calls_, peer, asked));
  };
  switch (match.route->call) {
    case WebCall::kCancelJob:
      return change(&GuardedCalls::CancelJob);
    case WebCall::kPauseJob:
      return change(&GuardedCalls::PauseJob);
    case WebCall::kResumeJob:
      return change(&GuardedCalls::ResumeJob);
    case WebCall::kPrioritizeJob:
      return change(&GuardedCalls::PrioritizeJob);
    case WebCall::kRetryJob:
      return change(&GuardedCalls::RetryJob);
    default:
      return absl::UnimplementedError("not a path to change anything");
  }
}

absl::StatusOr<HttpAnswer> WebApi::Me(const Peer& peer) const {
  TILEMEND_ASSIGN_OR_RETURN(const Caller caller, calls_.Identify(peer));
  return JsonAnswer(TextOf({{"name", caller.name},
                            {"maySteer", caller.May(Role::kSubmit)},
                            {"isAdmin", caller.May(Role::kAdmin)},
                            {"listen", listen_}}));
}

absl::StatusOr<HttpAnswer> WebApi::Watch(const Match& match, const HttpRequest& request, const Peer& peer) {
  v1::WatchJobRequest watch;
  watch.set_name(JobNameOf(match));
  TILEMEND_ASSIGN_OR_RETURN(const v1::Job job, calls_.WatchedJob(peer, watch));
  uint64_t cursor = 0;
  const auto given = request.query.find("cursor");
  if (given != request.query.end() && !absl::SimpleAtoi(given->second, &cursor)) {
    return absl::InvalidArgumentError("cursor: expected that of the last answer, a whole number");
  }
  TILEMEND_ASSIGN_OR_RETURN(HttpAnswer answer, JsonAnswer(job));
  if (job.cursor() > cursor || job.has_end_time()) return answer;
  if (request.made_room) {
    return absl::ResourceExhaustedError("too many watch jobs over HTTP; wait some seconds before you ask again");
  }
  if (request.has_waited) return answer;
  watch.set_cursor(cursor);
  answer.wait = [this, peer, watch](std::function<void()> wake) {
    return calls_.AwaitJob(peer, watch, std::move(wake));
  };
  return answer;
}

absl::StatusOr<HttpAnswer> WebApi::Cells(const std::string& name, const Peer& peer) {
  TILEMEND_ASSIGN_OR_RETURN(const JobCells job, calls_.GetCells(peer, name));
  const auto sight = files_.SightOf(name, job);
  if (absl::IsUnavailable(sight.status()) && job.cells.empty()) return sight.status();  // else a map without cells
  TILEMEND_ASSIGN_OR_RETURN(std::string text, CellMapJson(job, sight.ok() ? sight->get() : nullptr));
  return JsonAnswer(std::move(text));
}

absl::StatusOr<HttpAnswer> WebApi::Holes(const std::string& name, const Peer& peer) {
  TILEMEND_ASSIGN_OR_RETURN(const JobCells job, calls_.GetCells(peer, name));
  const ReportLook turn(report_looks_);
  if (!turn && !job.report.empty()) return OthersAre("reports are being read");
  TILEMEND_ASSIGN_OR_RETURN(const auto holes, files_.HolesOf(name, job));
  return JsonAnswer(*holes);
}

absl::StatusOr<HttpAnswer> WebApi::Review(const std::string& name, const Peer& peer) {
  TILEMEND_ASSIGN_OR_RETURN(const JobCells job, calls_.GetCells(peer, name));
  const ReportLook turn(report_looks_);
  if (!turn) return OthersAre("reports are being read");
  TILEMEND_ASSIGN_OR_RETURN(const auto review, files_.ReviewOf(name, job));
  return JsonAnswer(*review);
}

absl::StatusOr<HttpAnswer> WebApi::LogOf(const std::string& name, const Peer& peer) const {
  v1::GetJobRequest get;
  get.set_name(name);
  TILEMEND_RETURN_IF_ERROR(calls_.GetJob(peer, get).status());
  const std::string id = name.substr(name.find('/') + 1);
  return JsonAnswer(TextOf({{"lines", log_ == nullptr ? std::vector<std::string>() : log_->LinesOf(id)}}));
}

absl::StatusOr<HttpAnswer> WebApi::TileOf(const Match& match, const HttpRequest& request, const Peer& peer) {
  const std::string name = JobNameOf(match);
  TILEMEND_ASSIGN_OR_RETURN(const JobCells job, calls_.GetCells(peer, name));
  const auto id = CellOf(match.arguments.at("cell"));
  if (!id) return absl::InvalidArgumentError("expected a cell as COLUMN,ROW");
  const bool after = match.route->call == WebCall::kTileAfter;
  const auto path = request.query.find("path");
  const auto wanted = path == request.query.end() ? "" : path->second;
  const auto share = tile_bytes_.Take(kMostTileBytes);
  if (share == nullptr) return OthersAre("tiles are being read or sent");
  TILEMEND_ASSIGN_OR_RETURN(JobFiles::File file, files_.FileOf(name, job, *id, after, wanted));
  share->ShrinkTo(static_cast<int64_t>(file.bytes.size()));
  HttpAnswer answer{.type = "application/octet-stream", .body = std::move(file.bytes), .until_sent = share};
  const size_t dot = file.name.rfind('.');
  answer.headers.emplace_back("X-Tile-Format", dot == std::string::npos ? "" : file.name.substr(dot + 1));
  if (!file.frame.empty()) {
    answer.headers.emplace_back("X-Tile-Frame", absl::StrJoin(file.frame, " ", [](std::string* text, double number) {
                                  absl::StrAppendFormat(text, "%.17g", number);
                                }));
  }
  return answer;
}

}  // namespace tilemend
