#include "worker/service/verify_stage.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/receipt_payloads.h"
#include "common/rpc/result_digest.h"
#include "common/store/digest.h"
#include "common/store/file_receipt.h"
#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "worker/service/tile_reading.h"

namespace tilemend {
namespace {

absl::Status OfThisMachine(const absl::Status& status) { return absl::UnavailableError(status.message()); }

absl::StatusOr<v1::VerifiedFile> VerifyFile(const std::string& path) {
  auto read = ReadForReceipt(path);
  if (!read.ok()) return OfThisMachine(read.status());
  v1::VerifiedFile file;
  file.set_digest(std::move(read->digest));
  *file.mutable_receipt() = ToProto(read->receipt);
  return file;
}

absl::StatusOr<v1::VerifiedFile> VerifyTile(const v1::TileRef& tile, TaskMemory& memory) {
  v1::VerifiedFile file;
  if (!IsTileTree(tile.path())) {
    const auto digest = DigestOfFile(PathOf(tile));
    if (!digest.ok()) return OfThisMachine(digest.status());
    file.set_digest(*digest);
    return file;
  }
  const HeldMemory held(memory.tasks, SurveyMemory(PathOf(tile)));  // more than its bytes
  const auto bytes = ReadTile(tile);
  if (!bytes.ok()) return OfThisMachine(bytes.status());
  file.set_digest(FileDigest(*bytes));
  return file;
}

absl::StatusOr<v1::VerifiedFile> VerifyTask(const v1::RepeatedTask& task, const ComputeStage& compute) {
  const auto stage = static_cast<Stage>(task.stage());
  if (stage == Stage::kAssemble || stage == Stage::kVerify) {
    return absl::InvalidArgumentError(absl::StrCat("stage ", std::string(StageName(stage)), " is not computed again"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string output, compute(stage, task.input()));
  v1::VerifiedFile file;
  file.set_digest(ResultDigest(stage, output));
  return file;
}

}  // namespace

absl::StatusOr<std::string> RunVerify(const v1::VerifyInput& input, const CancelToken& cancel, TaskMemory& memory,
                                      const ComputeStage& compute) {
  v1::VerifyOutput output;
  for (const std::string& path : input.paths()) {
    if (cancel.cancelled()) return absl::CancelledError("cancelled");
    TILEMEND_ASSIGN_OR_RETURN(*output.add_files(), VerifyFile(path));
  }
  for (const v1::TileRef& tile : input.tiles()) {
    if (cancel.cancelled()) return absl::CancelledError("cancelled");
    TILEMEND_ASSIGN_OR_RETURN(*output.add_files(), VerifyTile(tile, memory));
  }
  for (const v1::RepeatedTask& task : input.tasks()) {
    TILEMEND_ASSIGN_OR_RETURN(*output.add_files(), VerifyTask(task, compute));
  }
  return output.SerializeAsString();
}

}  // namespace tilemend
