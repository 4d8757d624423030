#include "worker/service/task_memory.h"

#include "absl/strings/str_cat.h"
#include "common/util/cores.h"
#include "common/util/heap.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

// Heap of less than this is kept for the thread's next task.
constexpr int64_t kLarge = 96 * kMegabyte;

// Of each byte of a tile's file.
constexpr int64_t kSurveyed = 5;
constexpr int64_t kSearched = 5;
constexpr int64_t kAssembled = 5;
constexpr int64_t kFiltered = 24;     // of each byte of rasters
constexpr int64_t kOfTriangle = 100;  // of a patch that is assembled

// Zero for one that cannot be read: the task fails.
int64_t SizeOf(const std::string& path) { return SizeOfTile(path).value_or(0); }

}  // namespace

HeldMemory::HeldMemory(MemoryBudget& budget, int64_t bytes) : bytes_(bytes) {
  const LentCore lent;
  share_.emplace(budget, bytes);
}

HeldMemory::~HeldMemory() {
  if (bytes_ >= kLarge) ReturnHeap();
}

int64_t SurveyMemory(const std::string& path) { return kSurveyed * SizeOf(path); }
int64_t SurfaceMemory(const std::string& path) { return kSearched * SizeOf(path); }

int64_t GroundMemory(const v1::GroundInput& input) {
  int64_t bytes = 0;
  for (const v1::GroundRasterBlob& raster : input.rasters()) bytes += static_cast<int64_t>(raster.heights().size());
  return kFiltered * bytes;
}

int64_t AssembleMemory(const v1::AssembleInput& input) {
  int64_t triangles = 0;
  for (const v1::PatchExtent& patch : input.patches().patches()) triangles += patch.triangles();
  const bool is_delivery = !input.output_format().empty();
  if (triangles == 0 && !is_delivery) return 0;
  const std::string& path = input.tile().path();
  const int64_t of_tile =
      path.empty() ? 0 : (is_delivery ? 2 : 1) * kAssembled * SizeOf(absl::StrCat(input.tile().root(), "/", path));
  return of_tile + kOfTriangle * triangles;
}

}  // namespace tilemend
