// What the tasks of a worker may take of the memory at once.
#ifndef TILEMEND_WORKER_SERVICE_TASK_MEMORY_H_
#define TILEMEND_WORKER_SERVICE_TASK_MEMORY_H_

#include <cstdint>
#include <optional>
#include <string>

#include "common/util/memory_budget.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

inline constexpr int64_t kMegabyte = 1'000'000;
// What --task-memory takes.
inline constexpr int64_t kLeastTaskMegabytes = 64;
inline constexpr int64_t kMostTaskMegabytes = 1'000'000;

// Thread-safe. A task has a share of `tasks` while it runs. One that then reads tiles to test a patch against takes
// another one of `surfaces` for the rest of its time. It is never the other way, so nobody waits for one who waits.
struct TaskMemory {
  explicit TaskMemory(int64_t bytes) : tasks(bytes - bytes / 4), surfaces(bytes / 4) {}

  MemoryBudget tasks;
  MemoryBudget surfaces;
};

// A share that lends the thread's core to others until it is there (common/util/cores.h). Of large ones the heap goes
// back to the system at the end, or each thread would keep as much for the next.
class HeldMemory {
 public:
  HeldMemory(MemoryBudget& budget, int64_t bytes);
  ~HeldMemory();
  HeldMemory(const HeldMemory&) = delete;
  HeldMemory& operator=(const HeldMemory&) = delete;

 private:
  const int64_t bytes_;
  std::optional<MemoryBudget::Share> share_;
};

// Bytes that a task takes at most beside its input, by measurement (docs/decisions/2026-11-25-memory-of-tasks.md).
int64_t SurveyMemory(const std::string& path);   // of a tile that is surveyed
int64_t SurfaceMemory(const std::string& path);  // of one that is searched for triangles near a place
int64_t GroundMemory(const v1::GroundInput& input);
int64_t AssembleMemory(const v1::AssembleInput& input);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_TASK_MEMORY_H_
