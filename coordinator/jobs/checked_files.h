// What is read of tiles and files to check results: sizes, bytes, digests.
#ifndef TILEMEND_COORDINATOR_JOBS_CHECKED_FILES_H_
#define TILEMEND_COORDINATOR_JOBS_CHECKED_FILES_H_

#include <cstdint>
#include <random>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/memory_budget.h"
#include "coordinator/jobs/result_checks.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// What is read of tiles, at once for all who report results.
struct TileReading {
  explicit TileReading(TileCheck tiles) : how(tiles) {}

  const TileCheck how;
  MemoryBudget memory{int64_t{48} << 20};
  const uint64_t key = uint64_t{std::random_device()()} << 32 | std::random_device()();
};

// Times the size of a tile's file: its bytes, and as a mesh or with its patches.
inline constexpr int64_t kMemoryOfFile = 2;

// kUnavailable for what cannot be read here, in all of these.
std::string TilePath(const v1::TileRef& tile);
absl::StatusOr<int64_t> TileSize(const v1::TileRef& tile);
absl::StatusOr<int64_t> SizeOfFile(const std::string& path);
// As the worker reads it.
absl::StatusOr<std::string> BytesOf(const v1::TileRef& tile);
// `otherwise` if the tile, or the file, has another digest.
absl::Status CheckTileFile(const v1::TileRef& tile, const std::string& digest, const absl::Status& otherwise);
absl::Status CheckFile(const std::string& path, const std::string& digest, const absl::Status& otherwise);

// Of a tile that a worker read otherwise than it is here: kUnavailable.
absl::Status Changed(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_CHECKED_FILES_H_
