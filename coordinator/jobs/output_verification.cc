#include "coordinator/jobs/output_verification.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/receipt_payloads.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/jobs/checked_files.h"

namespace tilemend {
namespace {

// What a network file system reads in about a second (SATA SSDs read 500 MB/s, network file systems half of that).
constexpr int64_t kTaskBytes = int64_t{256} << 20;
constexpr size_t kTaskFiles = 256;

constexpr char kWrongDigest[] = "reported a wrong digest of";

absl::Status ChangedOutput(const std::string& path) {
  const absl::Status changed = absl::AbortedError(
      absl::StrCat(Printable(path),
                   ": not there as it was written; was it removed or changed while the job ran? Run the job again"));
  return WithErrorInfo(changed, {"OUTPUT_CHANGED", {{"file", Printable(path)}}});
}

std::optional<CaughtWorker> Caught(const std::string& worker, const std::string& what, const std::string& path) {
  return CaughtWorker{worker, absl::StrCat("worker ", worker.empty() ? "(unknown)" : Printable(worker), " ", what, " ",
                                           Printable(path), "; all its results in this job are computed again")};
}

// Whether a tile has another digest than `tile` says. kAborted if the tile changed since it was surveyed.
absl::StatusOr<bool> HasWrongDigest(const v1::TileRef& tile, const std::string& stamp) {
  const std::string path = TilePath(tile);
  TILEMEND_ASSIGN_OR_RETURN(const bool same,
                            TileHasDigest(path, tile.digest(), {tile.frame().begin(), tile.frame().end()}));
  if (same) return false;
  return TileHasStamp(path, stamp) ? absl::StatusOr<bool>(true) : ChangedInJob(path);
}

// Names of notes. That a file was verified, as it looked then:
std::string NoteOfFile(const std::string& path, const std::string& digest, const FileReceipt& receipt) {
  return absl::StrCat("file ", digest, " ", receipt.bytes, " ", receipt.inode, " ", receipt.modified, " ", path);
}
// A tile, as it looked before its survey. Without a stamp nobody can tell if it still does.
std::string NoteOfTile(const v1::TileRef& tile, const std::string& digest, const std::string& stamp) {
  return stamp.empty() ? "" : absl::StrCat("tile ", digest, " ", stamp, " ", TilePath(tile));
}

}  // namespace

OutputVerification::OutputVerification(double share) : share_(share) {}

void OutputVerification::UseNotes(std::shared_ptr<JobNotes> notes, uint64_t key) {
  notes_ = std::move(notes);
  share_.UseKey(key);
}

void OutputVerification::AddWritten(const Written& written, const std::string& output, const std::string& scene) {
  if (share_.is_none()) return;
  for (const v1::WrittenFile& file : written.files.files()) {
    if (file.digest().empty()) continue;  // a link to the scene's file
    Target target{written.cell, file.digest(), absl::StrCat(output, "/", file.path())};
    const auto now = ReceiptOf(target.path);
    const FileReceipt told = FromProto(file.receipt());
    // If this machine sees another file than the writer, the file is verified in any case.
    const bool agrees = now.ok() && *now == told;
    if (agrees && !share_.Has(target.path)) continue;
    if (now.ok() && notes_->Has(NoteOfFile(target.path, target.digest, *now))) continue;
    target.receipt = written.is_known || !now.ok() ? told : *now;
    target.is_tile = file.path() == written.files.files(0).path();
    if (file.carried()) target.original = absl::StrCat(scene, "/", file.path());
    Add(written.worker, std::move(target), file.bytes());
  }
}

void OutputVerification::AddTile(CellId cell, const std::string& worker, v1::TileRef tile, std::string stamp) {
  if (share_.is_none()) return;
  const std::string path = TilePath(tile);
  Target target{cell, tile.digest()};
  const int64_t bytes = TileSize(tile).value_or(0);
  const std::string note = NoteOfTile(tile, tile.digest(), stamp);
  const bool is_verified = !note.empty() && notes_->Has(note) && TileHasStamp(path, stamp);
  surveyed_[cell] = {&*workers_.insert(worker).first, std::move(tile), std::move(stamp)};
  if (share_.Has(path) && !is_verified) Add(worker, std::move(target), bytes);
}

void OutputVerification::Add(const std::string& worker, Target target, int64_t bytes) {
  Batch& batch = waiting_[worker];
  batch.told_by = worker;
  if (batch.bytes >= kTaskBytes || batch.targets.size() >= kTaskFiles) {
    full_.push_back(std::exchange(batch, {worker, {}, 0}));
  }
  batch.bytes += bytes;
  batch.targets.push_back(std::move(target));
}

std::optional<NewTask> OutputVerification::Next(bool all) {
  if (full_.empty() && all && !waiting_.empty()) {
    full_.push_back(std::move(waiting_.begin()->second));
    waiting_.erase(waiting_.begin());
  }
  if (full_.empty()) return std::nullopt;
  NewTask task = TaskOf(full_.front());
  out_[Sha256Hex(task.input)] = std::move(full_.front());
  full_.pop_front();
  return task;
}

NewTask OutputVerification::TaskOf(const Batch& batch) {
  v1::VerifyInput input;
  input.set_round(share_.NextNumber());
  for (const Target& target : batch.targets) {
    if (!target.path.empty()) input.add_paths(target.path);
    if (target.ComparesOriginal()) input.add_paths(target.original);
  }
  for (const Target& target : batch.targets) {
    if (!target.path.empty()) continue;
    v1::TileRef& tile = *input.add_tiles();
    tile = surveyed_.at(target.cell).tile;
    tile.clear_digest();  // for the worker to find out
  }
  NewTask task{batch.targets.front().cell, Stage::kVerify, input.SerializeAsString(), {}};
  if (!batch.told_by.empty()) task.avoid.push_back(batch.told_by);
  return task;
}

absl::StatusOr<std::optional<CaughtWorker>> OutputVerification::Take(const TaskResult& result) {
  const auto out = out_.extract(result.input);
  if (out.empty()) return absl::InternalError("the result of a verification that was not given out");
  const Batch& batch = out.mapped();
  v1::VerifyOutput output;
  const bool is_read = result.output.ok() && output.ParseFromString(*result.output);
  const Comparison comparison = Compare(batch, is_read ? &output : nullptr);
  for (const Doubt& doubt : comparison.doubts) {
    TILEMEND_ASSIGN_OR_RETURN(auto caught, Judge(batch.told_by, *doubt.target));
    if (!caught && doubt.is_contradicted) caught = Caught(result.worker, kWrongDigest, PathOf(*doubt.target));
    if (caught) return caught;
  }
  for (const std::string& note : comparison.notes) notes_->Put(note, result.worker);
  return std::nullopt;
}

OutputVerification::Comparison OutputVerification::Compare(const Batch& batch, const v1::VerifyOutput* output) const {
  Comparison comparison;
  int file = 0;
  const auto next = [&] {
    return output != nullptr && file < output->files_size() ? output->files(file++) : v1::VerifiedFile();
  };
  for (const Target& target : batch.targets) {
    if (target.path.empty()) continue;
    const v1::VerifiedFile found = next();
    const bool has_original = !target.ComparesOriginal() || next().digest() == target.digest;
    const auto now = ReceiptOf(target.path);
    const bool same_file = now.ok() && *now == FromProto(found.receipt());
    const bool same_bytes = found.digest() == target.digest;
    // The verifier contradicts the writer only if it read the file that this machine sees.
    const bool is_contradicted = output != nullptr && same_file && !same_bytes;
    if (!same_file || !same_bytes || !has_original) comparison.doubts.push_back({&target, is_contradicted});
    if (now.ok()) comparison.notes.push_back(NoteOfFile(target.path, target.digest, *now));
  }
  for (const Target& target : batch.targets) {
    if (!target.path.empty()) continue;
    if (next().digest() != target.digest) comparison.doubts.push_back({&target, output != nullptr});
    const Surveyed& surveyed = surveyed_.at(target.cell);
    const std::string note = NoteOfTile(surveyed.tile, target.digest, surveyed.stamp);
    if (!note.empty()) comparison.notes.push_back(note);
  }
  return comparison;
}

absl::StatusOr<std::optional<CaughtWorker>> OutputVerification::Judge(const std::string& told_by,
                                                                      const Target& target) const {
  const std::string path = PathOf(target);
  if (target.path.empty()) {
    const Surveyed& surveyed = surveyed_.at(target.cell);
    TILEMEND_ASSIGN_OR_RETURN(const bool is_wrong, HasWrongDigest(surveyed.tile, surveyed.stamp));
    return is_wrong ? Caught(told_by, kWrongDigest, path) : std::nullopt;
  }
  const auto now = ReceiptOf(path);
  if (!now.ok()) return ChangedOutput(path);
  const auto digest = DigestOfFile(path);
  if (!digest.ok()) return absl::UnavailableError(digest.status().message());
  if (*digest != target.digest) {
    if (*now != target.receipt) return ChangedOutput(path);
    const auto surveyed = surveyed_.find(target.cell);
    const bool is_original = target.is_tile && !target.original.empty() && HaveSameContent(target.original, path);
    if (is_original && surveyed != surveyed_.end()) {
      return Caught(*surveyed->second.worker, kWrongDigest, target.original);
    }
    return Caught(told_by, "wrote something else than it reported to", path);
  }
  if (target.ComparesOriginal() && DigestOfFile(target.original).value_or("") != target.digest) {
    return Caught(told_by, "wrote another file than that of the scene to", path);
  }
  return std::nullopt;
}

std::string OutputVerification::PathOf(const Target& target) const {
  return target.path.empty() ? TilePath(surveyed_.at(target.cell).tile) : target.path;
}

std::optional<CaughtWorker> OutputVerification::WhoIsWrongNear(CellId cell) const {
  for (int32_t col = cell.col - 1; col <= cell.col + 1; ++col) {
    for (int32_t row = cell.row - 1; row <= cell.row + 1; ++row) {
      const auto found = surveyed_.find({col, row});
      if (found == surveyed_.end()) continue;
      const auto& [worker, tile, stamp] = found->second;
      if (HasWrongDigest(tile, stamp).value_or(false)) return Caught(*worker, kWrongDigest, TilePath(tile));
    }
  }
  return std::nullopt;
}

}  // namespace tilemend
