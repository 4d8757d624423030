#include "coordinator/api/access.h"

#include <array>
#include <optional>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr char kRolePrefix[] = "tilemend:role:";

// How often the file of tokens is read again.
constexpr absl::Duration kReadAgain = absl::Seconds(2);

std::optional<Role> RoleNamed(std::string_view name) {
  for (const Role role : {Role::kScale, Role::kWatch, Role::kSubmit, Role::kAdmin, Role::kWorker}) {
    if (RoleName(role) == name) return role;
  }
  return std::nullopt;
}

absl::Status Unauthenticated(const std::string& why) {
  return WithErrorInfo(absl::UnauthenticatedError(why), {"UNAUTHENTICATED", {}});
}

// The fields of one line; none if something is wrong with it.
std::optional<std::pair<std::string, KnownToken>> ParseLine(const std::vector<std::string>& words) {
  if (words.size() < 3 || words.size() > 4 || !IsDigest(words[2])) return std::nullopt;
  KnownToken token{words[0], {}};
  for (const auto& name : absl::StrSplit(words[1], ',')) {
    const auto role = RoleNamed({name.data(), name.size()});
    if (!role) return std::nullopt;
    token.roles.insert(*role);
  }
  std::string error;
  if (words.size() == 4 && !absl::ParseTime(absl::RFC3339_full, words[3], &token.expires, &error)) return std::nullopt;
  return std::make_pair(words[2], std::move(token));
}

}  // namespace

std::string_view RoleName(Role role) {
  constexpr std::array<std::string_view, 6> kNames = {"anybody", "scale", "watch", "submit", "admin", "worker"};
  return kNames[static_cast<size_t>(role)];
}

const std::vector<RpcNeed>& RpcNeeds() {
  static const std::vector<RpcNeed> needs = {
      {"tilemend.v1.Jobs/CreateJob", Role::kSubmit},
      {"tilemend.v1.Jobs/GetJob", Role::kWatch},
      {"tilemend.v1.Jobs/ListJobs", Role::kWatch},
      {"tilemend.v1.Jobs/WatchJob", Role::kWatch},
      {"tilemend.v1.Jobs/CancelJob", Role::kSubmit},  // of another's job: kAdmin
      {"tilemend.v1.Jobs/RetryJob", Role::kSubmit},   // likewise
      {"tilemend.v1.Jobs/PauseJob", Role::kSubmit},
      {"tilemend.v1.Jobs/ResumeJob", Role::kSubmit},
      {"tilemend.v1.Jobs/PrioritizeJob", Role::kSubmit},
      {"tilemend.v1.Workers/ListWorkers", Role::kWatch},
      {"tilemend.v1.Work/Sync", Role::kWorker},
      {"tilemend.v1.Work/ReadBlob", Role::kWorker},
      {"tilemend.v1.Work/WriteBlob", Role::kWorker},
      {"externalscaler.ExternalScaler/IsActive", Role::kScale},
      {"externalscaler.ExternalScaler/StreamIsActive", Role::kScale},
      {"externalscaler.ExternalScaler/GetMetricSpec", Role::kScale},
      {"externalscaler.ExternalScaler/GetMetrics", Role::kScale},
      // These say nothing of jobs: that the program answers, and what its public interface is.
      {"grpc.health.v1.Health/Check", Role::kAnybody},
      {"grpc.health.v1.Health/Watch", Role::kAnybody},
      {"grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", Role::kAnybody},
  };
  return needs;
}

Role NeedOf(std::string_view rpc) {
  for (const RpcNeed& need : RpcNeeds()) {
    if (need.rpc == rpc) return need.role;
  }
  return Role::kAdmin;
}

bool Caller::May(Role role) const {
  if (role == Role::kAnybody || roles.contains(role)) return true;
  if (role == Role::kWorker || role == Role::kAdmin) return false;
  return May(static_cast<Role>(static_cast<int>(role) + 1));  // the next greater one
}

absl::StatusOr<std::map<std::string, KnownToken>> ParseTokens(const std::string& text, const std::string& path) {
  std::map<std::string, KnownToken> tokens;
  int line_number = 0;
  for (const absl::string_view line : absl::StrSplit(text, '\n')) {
    ++line_number;
    const absl::string_view content = absl::StripAsciiWhitespace(line.substr(0, line.find('#')));
    if (content.empty()) continue;
    auto token = ParseLine(absl::StrSplit(content, absl::ByAnyChar(" \t"), absl::SkipEmpty()));
    if (!token) {
      return absl::InvalidArgumentError(
          absl::StrCat(path, ":", line_number,
                       ": expected NAME ROLE[,ROLE] SHA256 [EXPIRES], roles scale, watch, submit, admin, worker"));
    }
    tokens.insert(*std::move(token));
  }
  return tokens;
}

absl::StatusOr<Access> Access::Closed(const std::string& token_file, Log& log) {
  Access access;
  access.closed_ = true;
  access.token_file_ = token_file;
  access.log_ = &log;
  if (token_file.empty()) return access;
  TILEMEND_ASSIGN_OR_RETURN(access.text_, ReadOwnFile(token_file));
  TILEMEND_ASSIGN_OR_RETURN(access.tokens_, ParseTokens(access.text_, token_file));
  return access;
}

absl::Status Access::ReadAgain() {
  TILEMEND_ASSIGN_OR_RETURN(std::string text, ReadOwnFile(token_file_));
  if (text == text_) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(tokens_, ParseTokens(text, token_file_));
  text_ = std::move(text);
  log_->Info("tokens read", {{"file", token_file_}, {"tokens", static_cast<int64_t>(tokens_.size())}});
  return absl::OkStatus();
}

void Access::Reload(absl::Time now) {
  if (token_file_.empty() || now - read_ < kReadAgain) return;
  read_ = now;
  const std::string fault(ReadAgain().message());
  if (!fault.empty() && fault != fault_) {
    log_->Warn("tokens not read", {{"error", fault}, {"in_use", "what was read before"}});
  }
  fault_ = fault;
}

absl::StatusOr<Caller> Access::Identify(const Claims& claims, absl::Time now) {
  if (!claims.token.empty()) {
    std::lock_guard<std::mutex> lock(mutex_);
    Reload(now);
    const auto token = tokens_.find(Sha256Hex(claims.token));
    if (token == tokens_.end()) return Unauthenticated("the token is not known here");
    if (token->second.expires <= now) return Unauthenticated("the token has expired");
    return Caller{token->second.name, token->second.roles};
  }
  if (claims.certificate_name.empty()) return Unauthenticated("neither a certificate nor a token says who calls");
  Caller caller{claims.certificate_name, {}};
  for (const std::string& name : claims.uris) {
    if (!absl::StartsWith(name, kRolePrefix)) continue;
    if (const auto role = RoleNamed(std::string_view(name).substr(sizeof(kRolePrefix) - 1))) caller.roles.insert(*role);
  }
  return caller;
}

absl::StatusOr<Caller> Access::Admit(std::string_view rpc, const Claims& claims, absl::Time now) {
  if (!closed_) return Caller{"", {Role::kAdmin, Role::kWorker}};
  const Role need = NeedOf(rpc);
  if (need == Role::kAnybody) return Caller{};
  TILEMEND_ASSIGN_OR_RETURN(Caller caller, Identify(claims, now));
  if (caller.May(need)) return caller;
  const std::string role(RoleName(need));
  return WithErrorInfo(
      absl::PermissionDeniedError(absl::StrCat(caller.name, " may not do that; it needs the role ", role)),
      {"ROLE_NEEDED", {{"role", role}, {"rpc", std::string(rpc)}}});
}

}  // namespace tilemend
