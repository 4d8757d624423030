#include "coordinator/report/area_choice.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/gis/area_file.h"
#include "common/grid/scene_area.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr char kUnknownArea[] =
    "the area is not known, so holes that reach the rim of these cells are left; --area FILE says what it is "
    "(tilemend inspect --propose-area FILE draws a first one)";

absl::Status Cover(PlanePolygon area, const std::string& name, Scene& scene) {
  const absl::Status status = CoverArea(std::move(area), scene);
  return status.ok() ? status : absl::Status(status.code(), absl::StrCat(name, ": ", std::string(status.message())));
}

// Of WKT over several lines the first, which has the name.
std::string ShownCrs(const std::string& crs) {
  const size_t end = crs.find('\n');
  return end == std::string::npos ? Printable(crs) : absl::StrCat(Printable(crs.substr(0, end)), "...");
}

}  // namespace

void CheckCrs(Scene& scene, const std::stop_token& stop) {
  const auto fault = CrsFaultOf(scene, stop);
  const std::string what = fault.ok() ? *fault : absl::StrCat("not checked: ", std::string(fault.status().message()));
  if (what.empty()) return;
  const std::string place = scene.found_by_name ? "/metadata.xml: SRS" : "/scene.json: crs";
  scene.warnings.push_back(absl::StrCat(scene.root, place, ": '", ShownCrs(scene.crs), "': ", what,
                                        "; the fill is the same, but files for a GIS carry that name"));
}

absl::StatusOr<std::string> ApplyAreaChoice(const std::string& value, Scene& scene, const std::stop_token& stop) {
  const std::string path = value.empty() ? scene.area_file : value;
  if (path.empty()) {
    if (!scene.area.empty()) TILEMEND_RETURN_IF_ERROR(Cover(scene.area, scene.root + "/scene.json: area", scene));
    if (scene.found_by_name && !scene.area_known) scene.warnings.emplace_back(kUnknownArea);
    return std::string();
  }
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(path));
  TILEMEND_ASSIGN_OR_RETURN(AreaFile file, ParseAreaFile(bytes, path, FrameOf(scene), stop));
  TILEMEND_RETURN_IF_ERROR(Cover(std::move(file.area), path, scene));
  for (std::string& warning : file.warnings) scene.warnings.push_back(std::move(warning));
  return Sha256Hex(ContentOf(bytes));
}

}  // namespace tilemend
