#include "common/util/version.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <string_view>

#include "absl/strings/escaping.h"

namespace tilemend {
namespace {

// The build id among the notes of a segment; empty if it is not there.
std::string_view BuildIdIn(const char* notes, size_t size) {
  const auto padded = [](size_t bytes) { return (bytes + 3) / 4 * 4; };
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes, sizeof(note));
    const char* const name = notes + sizeof(note);
    const char* const id = name + padded(note.n_namesz);
    const size_t all = sizeof(note) + padded(note.n_namesz) + padded(note.n_descsz);
    if (all > size) return {};
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0) {
      return {id, note.n_descsz};
    }
    notes += all;
    size -= all;
  }
  return {};
}

// Called with the program first; its id goes to `result`, a std::string.
int TakeBuildId(dl_phdr_info* info, size_t, void* result) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
    const std::string_view id = BuildIdIn(notes, segment.p_filesz);
    if (id.empty()) continue;
    *static_cast<std::string*>(result) = absl::BytesToHexString({id.data(), id.size()});
    break;
  }
  return 1;
}

}  // namespace

const char* Version() { return TILEMEND_VERSION; }

std::string BuildId() {
  std::string id;
  dl_iterate_phdr(TakeBuildId, &id);
  return id.empty() ? Version() : id;
}

}  // namespace tilemend
