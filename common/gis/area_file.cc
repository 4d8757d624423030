#include "common/gis/area_file.h"

#include <dlfcn.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/grid/json_text.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr char kModule[] = "tilemend-gdal.so";
constexpr std::string_view kSqlite("SQLite format 3\0", 16);
constexpr double kLeastCentreline = 1;                                            // metres: a shorter one is a slip
constexpr int kUtmCodes[][2] = {{32601, 32660}, {32701, 32760}, {25828, 25838}};  // EPSG, first and last

struct Module {
  void (*read_vectors)(const VectorRequest&, VectorFile&) = nullptr;
  void (*fault_of_crs)(const std::string&, std::string&) = nullptr;
};

// Loads the module that lies beside the program; for a program in another folder of the build, beside the others; for
// one that is installed, in its libraries.
absl::StatusOr<Module> LoadModule() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  std::string reason;
  for (const std::filesystem::path& path :
       {folder / kModule, folder / "../bin" / kModule, folder / "../lib/tilemend" / kModule}) {
    void* const module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const read_vectors = module == nullptr ? nullptr : ::dlsym(module, "TilemendReadVectors");
    void* const fault_of_crs = module == nullptr ? nullptr : ::dlsym(module, "TilemendFaultOfCrs");
    if (read_vectors != nullptr && fault_of_crs != nullptr) {
      return Module{reinterpret_cast<void (*)(const VectorRequest&, VectorFile&)>(read_vectors),
                    reinterpret_cast<void (*)(const std::string&, std::string&)>(fault_of_crs)};
    }
    if (const char* const said = ::dlerror();
        said != nullptr && (reason.empty() || std::filesystem::exists(path, error))) {
      reason = said;
    }
  }
  return absl::InternalError(absl::StrCat("cannot load ", kModule, ", which reads GeoJSON and GeoPackage: ", reason));
}

const absl::StatusOr<Module>& TheModule() {
  static const absl::StatusOr<Module> module = LoadModule();
  return module;
}

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

// What JSON tells that GDAL does not.
absl::Status LookIntoJson(VectorRequest& request) {
  if (!LooksLikeJson(request.bytes)) {
    return absl::InvalidArgumentError(
        absl::StrCat(request.name, ": neither GeoJSON nor GeoPackage, and no other format is read; to convert it: ",
                     "ogr2ogr polygons.gpkg ", request.name));
  }
  TILEMEND_ASSIGN_OR_RETURN(const nlohmann::json json, ParseJson(std::string(request.bytes), request.name));
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
  const auto features = json.find("features");
  if (features != json.end() && features->is_array()) request.features = static_cast<int64_t>(features->size());
  return absl::OkStatus();
}

absl::StatusOr<VectorFile> Read(const std::string& bytes, const std::string& name, const SceneFrame& frame,
                                bool unite) {
  VectorRequest request;
  request.bytes = bytes;
  request.name = name;
  request.unite = unite;
  request.frame = frame;
  if (!request.bytes.starts_with(kSqlite)) TILEMEND_RETURN_IF_ERROR(LookIntoJson(request));
  TILEMEND_RETURN_IF_ERROR(TheModule().status());
  VectorFile file;
  TheModule()->read_vectors(request, file);
  if (!file.error.empty()) return absl::InvalidArgumentError(file.error);
  return file;
}

ptrdiff_t PointsInside(const std::vector<Point2>& line, const WaterArea& area) {
  return std::count_if(line.begin(), line.end(), [&](const Point2& p) { return Contains(area.polygon, p); });
}

// Takes a centreline away that is not of this water: coordinates in a property stay as they are where a program
// transforms a layer to another CRS.
void DropStrayCentreline(const std::string& name, WaterArea& area, WaterFile& file) {
  if (area.centreline.empty() || 2 * PointsInside(area.centreline, area) > std::ssize(area.centreline)) return;
  area.centreline.clear();
  file.warnings.push_back(absl::StrCat(name, ": ", area.label,
                                       ": its property centreline lies outside its polygon, so it has no effect; "
                                       "it has to be in the coordinates of the file"));
}

// Gives a line to the area of water that most of its points are in.
absl::Status GiveCentreline(VectorFeature line, const std::string& name, WaterFile& file) {
  WaterArea* best = nullptr;
  ptrdiff_t most = 0;
  for (WaterArea& area : file.areas) {
    const ptrdiff_t inside = area.water ? PointsInside(line.line, area) : 0;
    if (inside <= most) continue;
    most = inside;
    best = &area;
  }
  if (2 * most <= std::ssize(line.line)) {
    file.warnings.push_back(
        absl::StrCat(name, ": ", line.label, ": a line that lies in no polygon of water, so it has no effect"));
    return absl::OkStatus();
  }
  if (!best->centreline.empty()) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": ", line.label, ": a second centreline of ", best->label));
  }
  best->centreline = std::move(line.line);
  return absl::OkStatus();
}

double LengthOf(const std::vector<Point2>& line) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

// Takes a centreline away that can have no effect.
void DropIdleCentreline(const std::string& name, WaterArea& area, WaterFile& file) {
  if (area.centreline.empty()) return;
  const bool is_short = LengthOf(area.centreline) < kLeastCentreline;
  if (!is_short && !area.level) return;
  area.centreline.clear();
  file.warnings.push_back(
      absl::StrCat(name, ": ", area.label, ": its centreline has no effect, since ",
                   is_short ? "it has no length" : "level_m is given as well, which makes the water level"));
}

void WarnOfIdleClearHeight(const std::string& name, const VectorFeature& feature, WaterFile& file) {
  if (!feature.clear_height || (feature.clear && feature.water)) return;
  file.warnings.push_back(absl::StrCat(
      name, ": ", feature.label, ": its clear_height has no effect, since ",
      feature.clear ? "of what is no water all is taken out, however high" : "\"clear\": true is not given as well"));
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

absl::StatusOr<std::string> ReadAreaFile(const std::string& path) {
  const std::string log = path + "-wal";
  std::error_code error;
  if (const auto size = std::filesystem::file_size(log, error); !error && size > 0) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": has changes that are still in ", log,
                                                   "; close the program that has it open, or save to another file"));
  }
  return ReadFile(path);
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

absl::StatusOr<std::string> CrsFaultOf(const Scene& scene) {
  if (scene.crs.empty() || IsInMetres(scene.crs)) return std::string();
  TILEMEND_RETURN_IF_ERROR(TheModule().status());
  std::string fault;
  TheModule()->fault_of_crs(scene.crs, fault);
  return fault;
}

absl::StatusOr<WaterFile> ParseWaterFile(const std::string& bytes, const std::string& name, const SceneFrame& frame) {
  TILEMEND_ASSIGN_OR_RETURN(VectorFile read, Read(bytes, name, frame, false));
  WaterFile file{{}, std::move(read.coordinates), std::move(read.warnings)};
  for (std::string& warning : file.warnings) warning = absl::StrCat(name, ": ", warning);
  for (VectorFeature& f : read.features) {
    if (f.polygon.empty()) continue;
    file.areas.push_back({f.water, std::move(f.polygon), f.level, std::move(f.line), f.label, f.clear,
                          f.clear_height.value_or(kClearHeight)});
    WarnOfIdleClearHeight(name, f, file);
    f.line.clear();
    DropStrayCentreline(name, file.areas.back(), file);
  }
  if (read.features.empty()) file.warnings.push_back(absl::StrCat(name, ": holds no polygon, so it has no effect"));
  for (VectorFeature& f : read.features) {
    if (!f.line.empty()) TILEMEND_RETURN_IF_ERROR(GiveCentreline(std::move(f), name, file));
  }
  for (WaterArea& area : file.areas) DropIdleCentreline(name, area, file);
  return file;
}

absl::StatusOr<AreaFile> ParseAreaFile(const std::string& bytes, const std::string& name, const SceneFrame& frame) {
  TILEMEND_ASSIGN_OR_RETURN(VectorFile read, Read(bytes, name, frame, true));
  AreaFile file{{}, std::move(read.coordinates), std::move(read.warnings)};
  if (read.features.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": holds no polygon"));
  file.area = std::move(read.features.front().polygon);
  for (std::string& warning : file.warnings) warning = absl::StrCat(name, ": ", warning);
  return file;
}

}  // namespace tilemend
