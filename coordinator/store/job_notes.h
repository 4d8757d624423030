// What a job has found out and need not find out again after a restart of the coordinator.
#ifndef TILEMEND_COORDINATOR_STORE_JOB_NOTES_H_
#define TILEMEND_COORDINATOR_STORE_JOB_NOTES_H_

#include <optional>
#include <string>

namespace tilemend {

// Notes by name. This class keeps none.
class JobNotes {
 public:
  virtual ~JobNotes() = default;

  // The text that an earlier process put, or an earlier pipeline of the job. None if the note is damaged.
  virtual std::optional<std::string> Find(const std::string& /*name*/) const { return std::nullopt; }
  bool Has(const std::string& name) const { return Find(name).has_value(); }

  // `worker` is who said so, "" for nobody. If its results are revoked, the note is dropped.
  virtual void Put(const std::string& /*name*/, const std::string& /*worker*/, const std::string& /*text*/ = "") {}
  // Waits until what was put is durable.
  virtual void Await() {}
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STORE_JOB_NOTES_H_
