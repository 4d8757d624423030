#include "common/rpc/look_payloads.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include "common/records/output_names.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

uint32_t Packed(Rgb c) { return uint32_t{c.r} << 16 | uint32_t{c.g} << 8 | c.b; }

Rgb Unpacked(uint32_t value) {
  return {static_cast<uint8_t>(value >> 16), static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
}

absl::Status Malformed(const char* what) {
  return absl::InvalidArgumentError(std::string("malformed payload: ") + what);
}

// Of one tile. Names stay in memory while a job runs, and each costs a file.
constexpr int kMostFiles = 10'000;
constexpr size_t kMostPathBytes = 4096;

// What the output needs for itself is no such name either: it would be written over a tile.
bool IsCarriedName(const std::string& name) {
  if (name.empty() || name.size() > kMostPathBytes) return false;
  const std::filesystem::path path(name);
  return !IsOutputName(name) && !path.is_absolute() && name.find('\0') == std::string::npos &&
         std::none_of(path.begin(), path.end(), [](const std::filesystem::path& part) { return part == ".."; });
}

template <class Repeated>
absl::StatusOr<std::vector<std::string>> Paths(const Repeated& proto) {
  if (proto.size() > kMostFiles) return Malformed("more files than a tile may name");
  std::vector<std::string> paths(proto.begin(), proto.end());
  if (!std::all_of(paths.begin(), paths.end(), IsCarriedName)) return Malformed("path of a file of a tile");
  return paths;
}

}  // namespace

uint32_t ColourToProto(const std::optional<Rgb>& colour) { return colour ? Packed(*colour) + 1 : 0; }

std::optional<Rgb> ColourFromProto(uint32_t value) {
  return value == 0 ? std::nullopt : std::optional(Unpacked(value - 1));
}

v1::TileFiles ToProto(const TileFiles& files) {
  v1::TileFiles proto;
  for (const std::string& path : files.libraries) proto.add_libraries(path);
  for (const std::string& path : files.images) proto.add_images(path);
  for (const std::string& warning : files.warnings) proto.add_warnings(warning);
  return proto;
}

absl::StatusOr<TileFiles> FromProto(const v1::TileFiles& proto) {
  TileFiles files;
  TILEMEND_ASSIGN_OR_RETURN(files.libraries, Paths(proto.libraries()));
  TILEMEND_ASSIGN_OR_RETURN(files.images, Paths(proto.images()));
  files.warnings.assign(proto.warnings().begin(), proto.warnings().end());
  return files;
}

void SetWitness(const FileWitness& files, v1::TileWitness& witness) {
  for (const FileWitness::Lookup& lookup : files.lookups) {
    v1::FileLookup* const proto = witness.add_lookups();
    proto->set_folder(lookup.folder);
    proto->set_name(lookup.name);
    proto->set_path(lookup.path);
    proto->set_problem(lookup.problem);
  }
  for (const FileWitness::Read& read : files.reads) {
    v1::FileRead* const proto = witness.add_reads();
    proto->set_path(read.path);
    proto->set_digest(read.digest);
  }
}

FileWitness WitnessOf(const v1::TileWitness& witness) {
  FileWitness files;
  for (const v1::FileLookup& l : witness.lookups())
    files.lookups.push_back({l.folder(), l.name(), l.path(), l.problem()});
  for (const v1::FileRead& read : witness.reads()) files.reads.push_back({read.path(), read.digest()});
  return files;
}

void SetColours(const FillColours& colours, v1::AssembleInput& input) {
  for (const auto& [hole, colour] : colours.of_holes) {
    v1::FillColour* const proto = input.add_colours();
    proto->set_hole(hole);
    proto->set_group(colour.group);
    proto->set_colour(Packed(colour.colour));
    proto->set_known(colour.known);
    proto->set_is_water(colour.is_water);
  }
  input.set_colour_vertices(colours.on_vertices);
}

absl::StatusOr<FillColours> ColoursOf(const v1::AssembleInput& input) {
  FillColours colours;
  colours.on_vertices = input.colour_vertices();
  for (const v1::FillColour& c : input.colours()) {
    const FillColour colour{c.group(), Unpacked(c.colour()), c.known(), c.is_water()};
    if (!colours.of_holes.emplace(c.hole(), colour).second) return Malformed("a hole with two colours");
  }
  return colours;
}

}  // namespace tilemend
