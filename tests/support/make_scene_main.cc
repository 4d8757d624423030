// tilemend-make-scene: writes a made scene with holes and a known surface.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "tests/support/scene_layout.h"
#include "tests/support/scene_maker.h"

namespace tilemend {
namespace {

constexpr char kUsage[] =
    "usage: tilemend-make-scene OUT [--cols 4] [--rows 4] [--cell 250] [--spacing 2.5] [--seed 1]\n"
    "         [--cut clipped|ragged|overlap] [--margin 0.1] [--pieces 1]   (of overlap: beyond the cell; K x K "
    "pieces)\n"
    "         [--relief 20] [--noise 0.05] [--holes lakes,islands,river,small|none]\n"
    "         [--lake-share 0.12] [--small-per-cell 3] [--empty C:R,C:R] [--out-of-area C:R,C:R]\n"
    "         [--box X0,Y0,X1,Y1] [--ellipse CX,CY,RX,RY]   (--box and --ellipse any number of times, metres)\n"
    "         [--layout FILE]   (JSON: cols, rows and holes in cells, in place of --cols, --rows and --holes)\n";

// More vertices than this are a mistake in the numbers.
constexpr double kMostVertices = 2e9;

struct Command {
  std::string folder;
  std::string layout;  // a file
  SceneMakerOptions options;
};

absl::StatusOr<std::vector<double>> Numbers(const std::string& text, size_t count) {
  std::vector<double> numbers;
  for (const absl::string_view part : absl::StrSplit(text, absl::ByAnyChar(",:"), absl::SkipEmpty())) {
    double number = 0;
    if (!absl::SimpleAtod(part, &number) || !std::isfinite(number)) {
      return absl::InvalidArgumentError(absl::StrCat("\"", text, "\": expected numbers"));
    }
    numbers.push_back(number);
  }
  if (count != 0 && numbers.size() != count) {
    return absl::InvalidArgumentError(absl::StrCat("\"", text, "\": expected ", count, " numbers"));
  }
  return numbers;
}

absl::StatusOr<std::vector<CellId>> Cells(const std::string& text) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> numbers, Numbers(text, 0));
  std::vector<CellId> cells;
  if (numbers.size() % 2 != 0) return absl::InvalidArgumentError(absl::StrCat("\"", text, "\": expected C:R,C:R"));
  for (size_t i = 0; i < numbers.size(); i += 2) {
    cells.push_back({static_cast<int32_t>(numbers[i]), static_cast<int32_t>(numbers[i + 1])});
  }
  return cells;
}

absl::Status SetHoles(const std::string& text, SceneMakerOptions* options) {
  options->lakes = options->islands = options->river = false;
  bool small = false;
  for (const absl::string_view kind : absl::StrSplit(text, ',')) {
    if (kind == "lakes") {
      options->lakes = true;
    } else if (kind == "islands") {
      options->islands = true;
    } else if (kind == "river") {
      options->river = true;
    } else if (kind == "small") {
      small = true;
    } else if (kind != "none") {
      return absl::InvalidArgumentError(absl::StrCat("\"", kind, "\": no such kind of hole"));
    }
  }
  if (!small) options->small_per_cell = 0;
  return absl::OkStatus();
}

absl::Status SetNumber(const std::string& flag, const std::string& text, SceneMakerOptions* options) {
  const std::map<std::string, std::function<void(double)>> setters = {
      {"--cols", [&](double v) { options->cols = static_cast<int32_t>(v); }},
      {"--rows", [&](double v) { options->rows = static_cast<int32_t>(v); }},
      {"--cell", [&](double v) { options->cell_size = v; }},
      {"--spacing", [&](double v) { options->spacing = v; }},
      {"--seed", [&](double v) { options->seed = static_cast<uint64_t>(std::abs(v)); }},
      {"--relief", [&](double v) { options->relief = v; }},
      {"--noise", [&](double v) { options->noise = v; }},
      {"--margin", [&](double v) { options->margin = v; }},
      {"--pieces", [&](double v) { options->pieces = static_cast<int32_t>(v); }},
      {"--lake-share", [&](double v) { options->lake_share = v; }},
      {"--small-per-cell", [&](double v) { options->small_per_cell = v; }}};
  const auto at = setters.find(flag);
  if (at == setters.end()) return absl::InvalidArgumentError("no such flag");
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> value, Numbers(text, 1));
  if (std::abs(value[0]) > 1e9) return absl::InvalidArgumentError("too large");
  at->second(value[0]);
  return absl::OkStatus();
}

absl::Status SetCut(const std::string& text, SceneMakerOptions* options) {
  const std::map<std::string, Cut> cuts = {
      {"clipped", Cut::kClipped}, {"ragged", Cut::kRagged}, {"overlap", Cut::kOverlap}};
  const auto at = cuts.find(text);
  if (at == cuts.end()) return absl::InvalidArgumentError("expected clipped, ragged or overlap");
  options->cut = at->second;
  return absl::OkStatus();
}

absl::Status SetFlag(const std::string& flag, const std::string& text, SceneMakerOptions* options) {
  if (flag == "--holes") return SetHoles(text, options);
  if (flag == "--cut") return SetCut(text, options);
  if (flag == "--empty" || flag == "--out-of-area") {
    TILEMEND_ASSIGN_OR_RETURN((flag == "--empty" ? options->empty : options->out_of_area), Cells(text));
    return absl::OkStatus();
  }
  if (flag == "--box" || flag == "--ellipse") {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> v, Numbers(text, 4));
    if (flag == "--box") options->boxes.push_back({{v[0], v[1]}, {v[2], v[3]}, {}});
    if (flag == "--ellipse") options->ellipses.push_back({{v[0], v[1]}, {v[2], v[3]}, {}});
    return absl::OkStatus();
  }
  return SetNumber(flag, text, options);
}

absl::Status Check(const SceneMakerOptions& o) {
  if (o.cols < 1 || o.rows < 1) return absl::InvalidArgumentError("--cols and --rows must be at least 1");
  if (!(o.cell_size > 0)) return absl::InvalidArgumentError("--cell must be greater than 0");
  if (!(o.spacing > 0) || o.spacing > o.cell_size / 2) {
    return absl::InvalidArgumentError("--spacing must be greater than 0 and at most half of --cell");
  }
  if (!(o.margin >= 0) || o.margin > o.cell_size / 2) {
    return absl::InvalidArgumentError("--margin must be at least 0 and at most half of --cell");
  }
  if (o.pieces < 1 || o.pieces * o.spacing > o.cell_size) {
    return absl::InvalidArgumentError("--pieces must be at least 1, and a piece no smaller than --spacing");
  }
  if (std::pow(o.cell_size / o.spacing, 2) * o.cols * o.rows > kMostVertices) {
    return absl::InvalidArgumentError("these numbers give too many vertices");
  }
  const bool strips_are_wide =
      std::all_of(o.strips.begin(), o.strips.end(), [](const StripHole& strip) { return strip.half_width > 0; });
  if (!strips_are_wide) return absl::InvalidArgumentError("half_width must be greater than 0");
  for (const EllipseHole& ellipse : o.ellipses) {
    if (!(ellipse.radii.minCoeff() > 0))
      return absl::InvalidArgumentError("--ellipse: the radii must be greater than 0");
  }
  return absl::OkStatus();
}

// Once the cell size is known.
absl::Status TakeLayout(const std::string& file, SceneMakerOptions* options) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(file));
  TILEMEND_RETURN_IF_ERROR(SetHoles("none", options));
  return ApplyLayout(text, file, options);
}

absl::StatusOr<Command> Parse(const std::vector<std::string>& arguments) {
  Command command;
  SceneMakerOptions& options = command.options;
  options.cell_size = 250;
  options.relief = 20;
  options.noise = 0.05;
  options.lakes = options.river = true;
  options.small_per_cell = 3;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!argument.starts_with("--")) {
      if (!command.folder.empty()) return absl::InvalidArgumentError("more than one OUT");
      command.folder = argument;
      continue;
    }
    if (i + 1 == arguments.size()) return absl::InvalidArgumentError(absl::StrCat(argument, ": value missing"));
    if (argument == "--layout") {
      command.layout = arguments[++i];
      continue;
    }
    const absl::Status status = SetFlag(argument, arguments[++i], &options);
    if (!status.ok()) return absl::InvalidArgumentError(absl::StrCat(argument, ": ", status.message()));
  }
  if (command.folder.empty()) return absl::InvalidArgumentError("OUT missing");
  if (!command.layout.empty()) TILEMEND_RETURN_IF_ERROR(TakeLayout(command.layout, &options));
  TILEMEND_RETURN_IF_ERROR(Check(options));
  return command;
}

int Main(const std::vector<std::string>& arguments) {
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end()) {
    std::fputs(kUsage, stdout);
    return 0;
  }
  const absl::StatusOr<Command> command = Parse(arguments);
  if (!command.ok()) {
    const std::string message(command.status().message());
    std::fprintf(stderr, "tilemend-make-scene: %s\n%s", message.c_str(), kUsage);
    return 2;
  }
  const MadeScene scene = MakeScene(command->options);
  const absl::Status status = WriteScene(scene, command->folder);
  if (!status.ok()) {
    const std::string message(status.message());
    std::fprintf(stderr, "tilemend-make-scene: %s\n", message.c_str());
    return 6;
  }
  size_t triangles = 0;
  for (const MadeTile& tile : scene.tiles) triangles += tile.mesh.triangles.size();
  std::printf("%s: %zu cells, %zu triangles, %zu vertices removed\n", command->folder.c_str(), scene.tiles.size(),
              triangles, scene.removed.size());
  return 0;
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main({argv + 1, argv + argc}); }
