// What a coordinator reads back after a restart: jobs and errors as the journal has them, and the file of results
// beside an output. The first byte says which.
#include <google/protobuf/stubs/logging.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "common/options/job_options.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "coordinator/jobs/job_proto.h"
#include "coordinator/store/result_log.h"
#include "tests/fuzz/fuzz_target.h"

namespace tilemend {
namespace {

const std::string kKey = Sha256Hex("key"), kOther = Sha256Hex("other");

// Of text that is not UTF-8, once for each field.
[[maybe_unused]] google::protobuf::LogHandler* const kNoLog = google::protobuf::SetLogHandler(nullptr);

void Require(bool condition) {
  if (!condition) std::abort();
}

std::string LogPath() {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("tilemend-journal-fuzz-" + std::to_string(::getpid()))).string();
  return path;
}

void TryJob(const std::string& bytes) {
  v1::Job message;
  if (!message.ParseFromString(bytes)) return;
  ToldJob told = JobFromProto(message);
  CheckJob(told.spec).IgnoreError();
  const v1::Job again = JobToProto(told.job, told.spec, told.outcome, told.error, told.origin);
  Require(AreEqual(WithDefaults(again.spec()), told.spec));
}

void TryStatus(const std::string& bytes) {
  v1::Status message;
  if (!message.ParseFromString(bytes)) return;
  const absl::Status status = StatusFromProto(message);
  Require(StatusFromProto(StatusToProto(status)).code() == status.code());
}

// Whatever the file: what is found is what was put, and what is put is found.
void TryLog(const std::string& bytes) {
  Require(WriteFileAtomically(LogPath(), bytes, Sync::kNo).ok());
  using Opening = ResultLog::Opening;
  for (const Opening how : {Opening::kNewJob, Opening::kSameJob, Opening::kSameJobAnew}) {
    auto log = ResultLog::Open(LogPath(), how);
    Require(log.ok());
    if (const auto result = log->Find(kKey)) Require(*result == "first" || *result == "second");
    Require(log->Put(kOther, "new").ok());
  }
  auto log = ResultLog::Open(LogPath(), ResultLog::Opening::kNewJob);
  Require(log.ok() && log->Find(kOther) == "new" && log->KeepUsed().ok());
  Require(ResultLog::Open(LogPath(), ResultLog::Opening::kNewJob)->Find(kOther) == "new");
  std::filesystem::remove(LogPath());
}

std::string Log() {
  std::filesystem::remove(LogPath());
  for (const char* result : {"first", "second"}) {
    auto log = ResultLog::Open(LogPath(), ResultLog::Opening::kNewJob);
    Require(log.ok() && log->Put(kKey, result).ok());
  }
  return ReadFile(LogPath()).value();
}

}  // namespace

std::vector<std::string> FuzzSeeds() {
  Job job;
  job.id = "0123456789ab";
  job.state = JobState::kPartial;
  job.ended = job.created;
  job.warnings = {"a worker does not see the scene"};
  JobSpec spec;
  spec.set_scene("/scene");
  spec.set_out("/out");
  spec.set_tension(0.5);
  spec.set_cells("1,1-2,2");
  const absl::Status error = absl::AbortedError("changed while the job ran");
  const v1::Job message = JobToProto(job, spec, {true, "7 of 8 holes filled", "/out/report.json"}, error, {"a", "b"});
  return {'\0' + message.SerializeAsString(), '\1' + StatusToProto(error).SerializeAsString(), '\2' + Log()};
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 3) {
    case 0:
      tilemend::TryJob(bytes);
      break;
    case 1:
      tilemend::TryStatus(bytes);
      break;
    default:
      tilemend::TryLog(bytes);
  }
  return 0;
}
