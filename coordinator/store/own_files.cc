#include "coordinator/store/own_files.h"

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

std::string NoteOf(const std::string& file) { return absl::StrCat("own ", file); }

}  // namespace

bool OwnFiles::Has(const std::string& file) const { return added_.contains(file) || notes_->Has(NoteOf(file)); }

void OwnFiles::Add(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    notes_->Put(NoteOf(file), "");
    added_.insert(file);
  }
  if (!files.empty()) notes_->Await();
}

}  // namespace tilemend
