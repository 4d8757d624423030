// `tilemend demo`: makes a small scene, fills it, and names the page to look at.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/commands.h"
#include "client/demo_scene.h"
#include "client/output.h"
#include "common/util/files.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// `tilemend run` on the scene, as on the command line.
int RunOn(const std::string& scene, const std::string& out, bool is_verbose) {
  const std::vector<Command> commands = ServiceCommands();
  const Command& run = *std::ranges::find(commands, "run", &Command::name);
  std::vector<std::string> words = {scene, "--out", out, "--overwrite"};
  if (is_verbose) words.emplace_back("--verbose");
  const auto args = Args::Parse(run.flags, words);
  return args.ok() ? run.run(*args) : PrintError(args.status());
}

}  // namespace

int DemoCommand(const Args& args) {
  const std::string folder = args.arguments().empty() ? "tilemend-demo" : args.arguments().front();
  const std::string scene = folder + "/scene", out = folder + "/out";
  // Nothing of somebody else's is written over.
  std::error_code error;
  const std::string mark = folder + "/.tilemend-demo";
  const bool is_ours = std::filesystem::exists(mark, error);
  if (!is_ours && std::filesystem::exists(folder, error) && !std::filesystem::is_empty(folder, error)) {
    return PrintError(absl::AlreadyExistsError(
        absl::StrCat(folder, ": exists already, and is no demonstration; name another folder: tilemend demo DIR")));
  }
  std::filesystem::create_directories(folder, error);
  absl::Status status = WriteFileAtomically(mark, "This folder is a demonstration that tilemend writes anew.\n");
  if (status.ok()) status = WriteDemoScene(scene);
  if (!status.ok()) return PrintError(status);
  const std::string shown = Printable(folder);
  std::fprintf(stderr, "made %s/scene: %d tiles with a lake and small holes; filling it\n", shown.c_str(),
               kDemoCols * kDemoRows);
  const int code = RunOn(scene, out, args.Switch("verbose"));
  if (code != kExitDone) return code;
  std::printf("\nBefore:  %s/scene/tiles\nAfter:   %s/out/tiles (faces with tilemend_filled = 1 are new)\n",
              shown.c_str(), shown.c_str());
  std::printf("Yours:   tilemend run SCENE --out DIR\n");
  return kExitDone;
}

}  // namespace tilemend
