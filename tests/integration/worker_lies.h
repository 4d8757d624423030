// Ways in which a worker lies in a result.
#ifndef TILEMEND_TESTS_INTEGRATION_WORKER_LIES_H_
#define TILEMEND_TESTS_INTEGRATION_WORKER_LIES_H_

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "common/util/stage.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// A way to lie in the result of a stage; the runner may look at the input. False: there is nothing to lie about in it.
struct Lie {
  const char* name;
  Stage stage;
  std::function<bool(const std::string& input, std::string& output)> tell;
};

template <typename Output>
Lie LieIn(const char* name, Stage stage, std::function<bool(Output&)> change) {
  return {name, stage, [=](const std::string&, std::string& bytes) {
            Output output;
            EXPECT_TRUE(output.ParseFromString(bytes));
            if (!change(output)) return false;
            bytes = output.SerializeAsString();
            return true;
          }};
}

template <typename Input, typename Output>
Lie LieOf(const char* name, Stage stage, std::function<bool(const Input&, Output&)> change) {
  return {name, stage, [=](const std::string& asked, std::string& bytes) {
            Input input;
            Output output;
            EXPECT_TRUE(input.ParseFromString(asked) && output.ParseFromString(bytes));
            if (!change(input, output)) return false;
            bytes = output.SerializeAsString();
            return true;
          }};
}

using Survey = v1::SurveyOutput;
using Tile = v1::AssembleOutput;

// What was written, so that a lie can spoil it.
inline std::string WrittenPath(const v1::AssembleInput& input, const Tile& tile) {
  return input.attempts() + "/" + tile.files(0).attempt();
}

// Lies of results that agree with themselves: only who reads the tile can tell.
std::vector<Lie> LiesOnTiles();

}  // namespace tilemend

#endif  // TILEMEND_TESTS_INTEGRATION_WORKER_LIES_H_
