#include "common/util/stage_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

TEST(StageWordsTest, PhasesAreInWordsOfTheUser) {
  EXPECT_EQ(StageWordsOf("survey"), "look at the tiles");
  EXPECT_EQ(StageWordsOf("sample clusters and fill"), "fit the surface");
  EXPECT_EQ(StageWordsOf("fill layer 1 of 2"), "fill the holes");
}

TEST(StageWordsTest, APhaseOfAnotherReleaseIsShownAsItIs) { EXPECT_EQ(StageWordsOf("a new phase"), "a new phase"); }

TEST(StageWordsTest, ThePageHasTheSameList) {
  std::ifstream file(TILEMEND_PAGE_STAGES);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::pair<std::string, std::string>> of_page, known;
  const std::regex pair(R"(\['([^']*)', '([^']*)'\])");
  for (std::sregex_iterator it(text.begin(), text.end(), pair), end; it != end; ++it)
    of_page.emplace_back((*it)[1], (*it)[2]);
  for (const auto& [beginning, words] : AllStageWords()) known.emplace_back(beginning, words);
  EXPECT_THAT(of_page, testing::ElementsAreArray(known));
}

}  // namespace
}  // namespace tilemend
