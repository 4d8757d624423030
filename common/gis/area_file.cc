#include "common/gis/area_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/gis/gdal_process.h"
#include "common/gis/given_centrelines.h"
#include "common/gis/vector_message.h"
#include "common/grid/json_text.h"
#include "common/mesh/polygon_index.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr std::string_view kSqlite("SQLite format 3\0", 16);
constexpr size_t kMostWarnings = 20;   // of a file: it may have the waters of a country
constexpr size_t kMostHoles = 5;       // in the label of a decision
constexpr size_t kSqliteHeader = 100;  // bytes, at least
constexpr std::string_view kZip = "PK\3\4";
constexpr char kStem[] = "polygons";                                              // of the name that GDAL sees
constexpr double kLeastCentreline = 1;                                            // metres: a shorter one is a slip
constexpr int kUtmCodes[][2] = {{32601, 32660}, {32701, 32760}, {25828, 25838}};  // EPSG, first and last

// The name that the member `crs` of GeoJSON 2008 gives; "" if it gives none.
std::string NameOfCrs(const nlohmann::json& crs) {
  const auto properties = crs.is_object() ? crs.find("properties") : crs.end();
  if (!crs.is_object() || properties == crs.end() || !properties->is_object()) return "";
  if (const auto name = properties->find("name"); name != properties->end() && name->is_string()) return *name;
  const auto code = properties->find("code");
  return code != properties->end() && code->is_number_integer() ? absl::StrCat("EPSG:", code->get<int64_t>()) : "";
}

// Whether a text begins as JSON does that holds more than one value.
bool LooksLikeJson(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos || text[first] == '{' || text[first] == '[';
}

// The members of GeoJSON that GDAL does not tell of.
struct JsonMembers {
  nlohmann::json top;     // without what is in "features"
  int64_t features = -1;  // -1: no such array
};

// Memory does not grow with the features, of which only the number counts.
absl::StatusOr<JsonMembers> MembersOf(const std::string& bytes, const std::string& name) {
  using Event = nlohmann::json::parse_event_t;
  JsonMembers members;
  std::string member;  // at depth 1
  const auto keep = [&](int depth, Event event, const nlohmann::json& value) {
    const bool begins = event == Event::object_start || event == Event::array_start || event == Event::value;
    if (depth == 1 && event == Event::key) {
      member = value.get<std::string>();
      return member == "crs" || member == "features";
    }
    if (depth >= 1 && member == "features") {
      if (depth == 1 && begins) members.features = event == Event::array_start ? 0 : -1;
      if (depth == 2 && begins && members.features >= 0) ++members.features;
      return depth == 1;
    }
    return true;
  };
  TILEMEND_ASSIGN_OR_RETURN(members.top, ParseJson(bytes, name, keep));
  return members;
}

// What JSON tells that GDAL does not.
absl::Status LookIntoJson(const std::string& bytes, VectorRequest& request) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonMembers members, MembersOf(bytes, request.name));
  const nlohmann::json& json = members.top;
  if (!json.is_object()) return absl::InvalidArgumentError(absl::StrCat(request.name, ": GeoJSON: expected an object"));
  const auto crs = json.find("crs");
  request.names_crs = crs != json.end() && !crs->is_null();
  if (request.names_crs) {
    request.crs_name = NameOfCrs(*crs);
    if (request.crs_name.empty()) {
      return absl::InvalidArgumentError(absl::StrCat(
          request.name, R"(: crs: expected {"type": "name", "properties": {"name": "EPSG:..."}}, or none)"));
    }
  }
  request.features = members.features;
  return absl::OkStatus();
}

VectorFormat FormatOf(const VectorBytes& file) {
  if (file.bytes.starts_with(kSqlite) && file.bytes.size() >= kSqliteHeader) return VectorFormat::kGeoPackage;
  if (file.bytes.starts_with(kZip)) return VectorFormat::kArchive;
  const bool is_folder = file.bytes.empty() && !file.beside.empty();
  return !is_folder && LooksLikeJson(file.bytes) ? VectorFormat::kGeoJson : VectorFormat::kOther;
}

// What GDAL is to see the file as.
std::string SuffixFor(VectorFormat format, const std::string& name) {
  switch (format) {
    case VectorFormat::kGeoJson:
      return ".geojson";
    case VectorFormat::kGeoPackage:
      return ".gpkg";
    case VectorFormat::kArchive:
      return ".zip";
    case VectorFormat::kOther:
      break;
  }
  return absl::AsciiStrToLower(std::filesystem::path(name).extension().string());
}

VectorRequest RequestFor(const VectorBytes& file, const std::string& name, const SceneFrame& frame, VectorUse use) {
  VectorRequest request;
  request.name = name;
  request.use = use;
  request.frame = frame;
  request.format = FormatOf(file);
  request.opened = kStem + SuffixFor(request.format, name);
  const bool is_folder = file.bytes.empty() && !file.beside.empty();
  if (!is_folder) request.parts.push_back({request.opened, file.bytes});
  for (const SideFile& side : file.beside) {
    const std::string before = is_folder ? request.opened + "/" : absl::StrCat(kStem, ".");
    request.parts.push_back({before + side.name, side.bytes});
  }
  return request;
}

absl::StatusOr<VectorFile> Read(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                VectorUse use, const std::stop_token& stop) {
  VectorRequest request = RequestFor(bytes, name, frame, use);
  if (request.format == VectorFormat::kGeoJson) TILEMEND_RETURN_IF_ERROR(LookIntoJson(bytes.bytes, request));
  const std::string message = static_cast<char>(GdalTask::kReadVectors) + Encode(request);
  TILEMEND_ASSIGN_OR_RETURN(const std::string answer, AskGdal(message, name, stop));
  VectorFile file;
  if (!Decode(answer, file)) return absl::InternalError(absl::StrCat(name, ": tilemend-gdal is of another release"));
  if (!file.error.empty()) return absl::InvalidArgumentError(file.error);
  return file;
}

// Takes a centreline away that is not of this water: coordinates in a property stay as they are where a program
// transforms a layer to another CRS.
void DropStrayCentreline(const std::string& name, WaterArea& area, WaterFile& file) {
  if (area.centreline.empty() || MostLiesIn(PolygonIndex(area.polygon), area.centreline)) return;
  area.centreline.clear();
  file.warnings.push_back(absl::StrCat(name, ": ", area.label,
                                       ": its property centreline lies outside its polygon, so it has no effect; "
                                       "it has to be in the coordinates of the file"));
}

double LengthOf(const std::vector<Point2>& line) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

// Takes a centreline away that can have no effect.
void DropIdleCentreline(const std::string& name, WaterArea& area, WaterFile& file) {
  if (area.centreline.empty()) return;
  const char* reason = nullptr;
  if (LengthOf(area.centreline) < kLeastCentreline) reason = "it has no length";
  if (area.level) reason = "level_m is given as well, which makes the water level";
  if (area.kind == WaterKind::kLake) reason = "kind is lake, which makes the water level";
  if (reason == nullptr) return;
  area.centreline.clear();
  file.warnings.push_back(absl::StrCat(name, ": ", area.label, ": its centreline has no effect, since ", reason));
}

void WarnOfIdleClearHeight(const std::string& name, const VectorFeature& feature, WaterFile& file) {
  if (!feature.clear_height || (feature.clear && feature.water)) return;
  file.warnings.push_back(absl::StrCat(
      name, ": ", feature.label, ": its clear_height has no effect, since ",
      feature.clear ? "of what is no water all is taken out, however high" : "\"clear\": true is not given as well"));
}

// What the properties of an area say together.
absl::Status CheckKind(const std::string& name, WaterArea& area, WaterFile& file) {
  if (area.kind == WaterKind::kRiver && area.level && area.water) {
    return absl::InvalidArgumentError(absl::StrCat(
        name, ": ", area.label, ": kind is river, but level_m makes the water level; leave one of the two out"));
  }
  if (area.kind == WaterKind::kUnsaid || area.water) return absl::OkStatus();
  area.kind = WaterKind::kUnsaid;
  file.warnings.push_back(absl::StrCat(name, ": ", area.label, ": kind has no effect, since water is false"));
  return absl::OkStatus();
}

// What `clear` and the other properties of an area say together. Its water is level.
absl::Status CheckClear(const std::string& name, WaterArea& area, std::vector<std::string>& warnings) {
  if (area.kind == WaterKind::kRiver) {
    return absl::InvalidArgumentError(absl::StrCat(
        name, ": ", area.label, ": kind is river, but clear makes the water level; leave one of the two out"));
  }
  if (area.centreline.empty()) return absl::OkStatus();
  area.centreline.clear();
  warnings.push_back(absl::StrCat(name, ": ", area.label,
                                  ": its centreline has no effect, since the area is cleared, which makes its water "
                                  "level"));
  return absl::OkStatus();
}

// "decision on hole 4", "decision on holes 0, 2 and 3 more", "decision of feature 7".
std::string DecisionLabel(const VectorFeature& feature) {
  const std::vector<int64_t>& holes = feature.holes;
  if (holes.empty()) return absl::StrCat("decision of ", feature.label);
  const size_t shown = std::min(holes.size(), kMostHoles);
  std::string label = absl::StrCat("decision on ", holes.size() == 1 ? "hole " : "holes ",
                                   absl::StrJoin(holes.begin(), holes.begin() + static_cast<ptrdiff_t>(shown), ", "));
  if (shown < holes.size()) absl::StrAppend(&label, " and ", holes.size() - shown, " more");
  return label;
}

}  // namespace

SceneFrame FrameOf(const Scene& scene) {
  SceneFrame frame{scene.crs, scene.origin};
  const Grid& grid = scene.grid;
  if (grid.cell_size.minCoeff() <= 0) return frame;
  frame.lo = grid.corner;
  frame.hi = grid.corner + grid.cell_size.cwiseProduct(Point2(scene.cols, scene.rows));
  return frame;
}

bool IsInMetres(const std::string& crs) {
  constexpr std::string_view epsg = "EPSG:";
  const char* const end = crs.data() + crs.size();
  int code = 0, read = 0;
  if (crs.starts_with(epsg) && std::from_chars(crs.data() + epsg.size(), end, code).ptr == end) {
    return std::any_of(std::begin(kUtmCodes), std::end(kUtmCodes),
                       [&](const auto& codes) { return code >= codes[0] && code <= codes[1]; });
  }
  double latitude = 0, longitude = 0;
  return std::sscanf(crs.c_str(), "ENU:%lf,%lf%n", &latitude, &longitude, &read) == 2 && read == std::ssize(crs) &&
         std::abs(latitude) <= 90 && std::abs(longitude) <= 180;
}

absl::StatusOr<std::string> CrsFaultOf(const Scene& scene, const std::stop_token& stop) {
  if (scene.crs.empty() || IsInMetres(scene.crs)) return std::string();
  return AskGdal(static_cast<char>(GdalTask::kFaultOfCrs) + scene.crs, "crs", stop);
}

// What is read of a file beside its features, which stay in `read`.
WaterFile WithoutAreas(VectorFile& read, const std::string& name) {
  WaterFile file{{}, std::move(read.coordinates), std::move(read.warnings)};
  for (std::string& warning : file.warnings) warning = absl::StrCat(name, ": ", warning);
  return file;
}

absl::StatusOr<WaterFile> ParseWaterFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                         const std::stop_token& stop, ClearChoice clear) {
  TILEMEND_ASSIGN_OR_RETURN(VectorFile read, Read(bytes, name, frame, VectorUse::kWater, stop));
  WaterFile file = WithoutAreas(read, name);
  for (VectorFeature& f : read.features) {
    if (f.polygon.empty()) continue;
    f.clear = f.clear || clear == ClearChoice::kAll;
    file.areas.push_back({f.water, std::move(f.polygon), f.level, std::move(f.line), f.label, f.kind, f.clear,
                          f.clear_height.value_or(kClearHeight), f.level_sigma, f.is_as_found});
    WarnOfIdleClearHeight(name, f, file);
    f.line.clear();
    DropStrayCentreline(name, file.areas.back(), file);
    TILEMEND_RETURN_IF_ERROR(CheckKind(name, file.areas.back(), file));
  }
  if (read.features.empty()) file.warnings.push_back(absl::StrCat(name, ": holds no polygon, so it has no effect"));
  TILEMEND_RETURN_IF_ERROR(GiveCentrelines(std::move(read.features), name, stop, file));
  for (WaterArea& area : file.areas) {
    DropIdleCentreline(name, area, file);
    if (area.clear) TILEMEND_RETURN_IF_ERROR(CheckClear(name, area, file.warnings));
  }
  KeepFirst(kMostWarnings, name, file.warnings);
  return file;
}

absl::StatusOr<WaterFile> ParseDecisionFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                            const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(VectorFile read, Read(bytes, name, frame, VectorUse::kDecisions, stop));
  WaterFile file = WithoutAreas(read, name);
  for (VectorFeature& f : read.features) {
    if (f.polygon.empty()) {
      return absl::InvalidArgumentError(
          absl::StrCat(name, ": ", f.label, ": a decision on a line; expected the polygon of a hole"));
    }
    const bool is_water = f.decision == ReviewDecision::kWater;
    if (f.level && !is_water) {
      file.warnings.push_back(
          absl::StrCat(name, ": ", f.label, ": its level_m has no effect, since its decision is not water"));
    }
    WaterArea& area = file.areas.emplace_back();
    area.water = is_water;
    area.polygon = std::move(f.polygon);
    if (is_water) area.level = f.level;
    area.label = DecisionLabel(f);
    area.decision = f.decision;
  }
  if (file.areas.empty()) file.warnings.push_back(absl::StrCat(name, ": holds no decision"));
  KeepFirst(kMostWarnings, name, file.warnings);
  return file;
}

absl::StatusOr<AreaFile> ParseAreaFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                       const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(VectorFile read, Read(bytes, name, frame, VectorUse::kArea, stop));
  AreaFile file{{}, std::move(read.coordinates), std::move(read.warnings)};
  if (read.features.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": holds no polygon"));
  file.area = std::move(read.features.front().polygon);
  for (std::string& warning : file.warnings) warning = absl::StrCat(name, ": ", warning);
  KeepFirst(kMostWarnings, name, file.warnings);
  return file;
}

}  // namespace tilemend
