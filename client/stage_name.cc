#include "client/stage_name.h"

#include <utility>

#include "common/util/text.h"

namespace tilemend {
namespace {

// By the beginning of a phase (PhaseOf in coordinator/waves/wave_order.h).
constexpr std::pair<std::string_view, const char*> kStages[] = {
    {"measure", "measure levels"}, {"survey", "look at the tiles"}, {"ground", "tell ground from objects"},
    {"plan", "find the holes"},    {"sample", "fit the surface"},   {"smooth", "smooth the seams"},
    {"fill", "fill the holes"},    {"assemble", "write the tiles"}, {"verify", "verify the tiles"},
};

}  // namespace

std::string StageName(std::string_view phase) {
  for (const auto& [beginning, name] : kStages) {
    if (phase.starts_with(beginning)) return name;
  }
  return Printable(std::string(phase));
}

}  // namespace tilemend
