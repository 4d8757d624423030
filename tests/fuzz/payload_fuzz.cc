// The payloads of tasks and results, as any worker may send them. The first byte says which; what is taken must come
// back the same when it is sent on.
#include <google/protobuf/stubs/logging.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/rpc/surface_payloads.h"
#include "tests/fuzz/fuzz_target.h"

namespace tilemend {
namespace {

// Of text that is not UTF-8, once for each field.
[[maybe_unused]] google::protobuf::LogHandler* const kNoLog = google::protobuf::SetLogHandler(nullptr);

void Require(bool condition) {
  if (!condition) std::abort();
}

CellHoles SquareHole() {
  CellHoles holes;
  holes.cell = {1, 2};
  holes.lattice_step = 0x1p-10;
  for (const Point3& p : {Point3(0, 0, 5), Point3(9, 0, 5), Point3(9, 9, 6), Point3(0, 9, 5)}) {
    RimVertex v;
    v.tile = holes.cell;
    v.index = static_cast<int32_t>(holes.vertices.size());
    v.position = p;
    v.size = 9;
    holes.vertices.push_back(v);
    holes.band.points.push_back(p);
  }
  holes.vertices[3].index = -1;
  holes.vertices[3].seam_vertex = 7;
  holes.band.points.push_back({-3, 4, 5});
  holes.band.triangles.push_back({0, 3, 4});
  holes.holes.push_back({.id = 0, .open = true, .segments = {{0, 1}, {1, 2}, {2, 3, true}, {3, 0}}, .tension = 0.5});
  return holes;
}

SurveyRecord SquareSurvey() {
  SurveyRecord record;
  const CellHoles holes = SquareHole();
  record.vertex_count = 4;
  record.triangle_count = 1;
  record.lo = {0, 0, 5};
  record.hi = {9, 9, 6};
  for (int32_t i = 0; i < 4; ++i) record.vertices.push_back({i, holes.vertices[static_cast<size_t>(i)].position});
  record.edges = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  record.band = holes.band;
  record.colours = {Rgb{1, 2, 3}, std::nullopt, Rgb{}, Rgb{}};
  return record;
}

HolePatch SquarePatch() {
  return {.hole = 0, .new_points = {{4, 4, 5}}, .triangles = {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}}};
}

template <typename Message>
bool Read(const std::string& bytes, Message& message) {
  return message.ParseFromString(bytes);
}

void TrySurvey(const std::string& bytes) {
  v1::SurveyOutput message;
  if (!Read(bytes, message)) return;
  (void)FromProto(message.files());
  v1::TileWitness witness;
  SetWitness(WitnessOf(message.witness()), witness);
  const auto record = FromProto(message);
  if (!record.ok()) return;
  const auto again = FromProto(ToProto(*record));
  Require(again.ok() && again->vertices.size() == record->vertices.size() &&
          again->edges.size() == record->edges.size() && again->band.triangles.size() == record->band.triangles.size());
}

void TryHoles(const std::string& bytes) {
  v1::FillInput message;
  if (!Read(bytes, message)) return;
  const auto holes = FromProto(message.holes());
  if (!holes.ok()) return;
  const auto again = FromProto(ToProto(*holes));
  Require(again.ok() && again->vertices.size() == holes->vertices.size() && again->holes.size() == holes->holes.size());
}

void TryPatches(const std::string& bytes) {
  v1::FillOutput message;
  if (!Read(bytes, message)) return;
  (void)FromProto(message.quality());
  for (const v1::PatchExtent& patch : message.patches()) (void)FromProto(patch.hold_out());
  const std::vector<RimVertex> vertices = SquareHole().vertices;
  const auto patches = FromProto(message, vertices.size());
  if (!patches.ok()) return;
  for (const HolePatch& patch : *patches) {
    for (const Triangle& t : patch.triangles) {
      for (const int32_t v : t) {
        Require(v < std::ssize(vertices) && v >= -std::ssize(patch.new_points));
      }
    }
  }
}

void TryAssemble(const std::string& bytes) {
  v1::AssembleInput message;
  if (!Read(bytes, message)) return;
  (void)ColoursOf(message);
  (void)FromProto(message.vertices());
}

}  // namespace

std::vector<std::string> FuzzSeeds() {
  const CellHoles holes = SquareHole();
  v1::SurveyOutput survey = ToProto(SquareSurvey());
  *survey.mutable_files() = ToProto(TileFiles{{"a.mtl"}, {"a.jpg"}, {"a warning"}});
  SetWitness({{{"Data", "a.mtl", "Data/a.mtl", ""}}, {{"Data/a.mtl", std::string(64, '0')}}},
             *survey.mutable_witness());
  v1::FillInput fill;
  *fill.mutable_holes() = ToProto(holes);
  v1::FillOutput filled = ToProto({SquarePatch()}, holes.vertices, holes.lattice_step);
  *filled.mutable_quality() = ToProto(QualityTally());
  v1::AssembleInput assemble;
  *assemble.mutable_vertices() = ToProto(holes.vertices);
  *assemble.mutable_patches() = filled;
  SetColours({{{0, {0, {1, 2, 3}, true}}}, true}, assemble);
  return {'\0' + survey.SerializeAsString(), '\1' + fill.SerializeAsString(), '\2' + filled.SerializeAsString(),
          '\3' + assemble.SerializeAsString()};
}

}  // namespace tilemend

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0:
      tilemend::TrySurvey(bytes);
      break;
    case 1:
      tilemend::TryHoles(bytes);
      break;
    case 2:
      tilemend::TryPatches(bytes);
      break;
    default:
      tilemend::TryAssemble(bytes);
  }
  return 0;
}
