#include "common/util/stage_words.h"

#include "common/util/text.h"

namespace tilemend {

std::span<const StageWords> AllStageWords() {
  static constexpr StageWords kStages[] = {
      {"measure", "measure levels"}, {"survey", "look at the tiles"}, {"ground", "tell ground from objects"},
      {"plan", "find the holes"},    {"sample", "fit the surface"},   {"smooth", "smooth the seams"},
      {"fill", "fill the holes"},    {"assemble", "write the tiles"}, {"verify", "verify the tiles"},
  };
  return kStages;
}

std::string StageWordsOf(std::string_view phase) {
  for (const auto& [beginning, words] : AllStageWords()) {
    if (phase.starts_with(beginning)) return std::string(words);
  }
  return Printable(std::string(phase));
}

}  // namespace tilemend
