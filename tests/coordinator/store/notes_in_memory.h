// Notes of a job for tests.
#ifndef TILEMEND_TESTS_COORDINATOR_STORE_NOTES_IN_MEMORY_H_
#define TILEMEND_TESTS_COORDINATOR_STORE_NOTES_IN_MEMORY_H_

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "coordinator/store/job_notes.h"

namespace tilemend {

class NotesInMemory : public JobNotes {
 public:
  std::optional<std::string> Find(const std::string& name) const override {
    const auto note = notes_.find(name);
    return note == notes_.end() ? std::nullopt : std::optional(note->second.text);
  }
  void Put(const std::string& name, const std::string& worker, const std::string& text) override {
    notes_[name] = {worker, text};
  }
  // Who gave them.
  std::set<std::string> workers() const {
    std::set<std::string> all;
    for (const auto& [name, note] : notes_) all.insert(note.worker);
    return all;
  }

 private:
  struct Note {
    std::string worker, text;
  };
  std::map<std::string, Note> notes_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_STORE_NOTES_IN_MEMORY_H_
