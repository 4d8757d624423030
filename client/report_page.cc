#include "client/report_page.h"

#include <array>
#include <filesystem>
#include <system_error>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "client/page_assets.h"
#include "client/page_data.h"
#include "client/page_pictures.h"
#include "client/saved_acceptance.h"
#include "common/grid/delivery_paths.h"
#include "common/grid/scene.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/page_review.h"
#include "coordinator/report/shallow_json.h"
#include "coordinator/report/tile_checks.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// "'sha256-...'" for the policy.
std::string PolicyHash(std::string_view text) {
  const std::array<char, 32> digest = Sha256Of(text);
  return absl::StrCat("'sha256-", absl::Base64Escape(std::string(digest.data(), digest.size())), "'");
}

// null where there is no holes.geojson, as for a single mesh.
absl::StatusOr<Json> ReviewOf(const Json& report, const std::string& out, const Scene* scene) {
  const auto holes = ReadFile(absl::StrCat(out, "/holes.geojson"));
  if (absl::IsNotFound(holes.status())) return Json();
  TILEMEND_RETURN_IF_ERROR(holes.status());
  return PageReview(report, *holes, scene);
}

std::string AbsoluteFolder(const std::string& folder) {
  if (IsObjectPath(folder)) return folder;
  std::error_code error;
  const std::string path = std::filesystem::absolute(folder, error).lexically_normal().string();
  return path.size() > 1 && path.ends_with('/') ? path.substr(0, path.size() - 1) : path;
}

}  // namespace

std::string ReportPage(const Json& data) {
  // "<" is the only character by which a text can end its element or begin another.
  const std::string json = absl::StrReplaceAll(data.dump(-1, ' ', true, Json::error_handler_t::replace),
                                               {{"<", "\\u003c"}, {">", "\\u003e"}, {"&", "\\u0026"}});
  const std::string script(PageScript()), style(PageStyle());
  return absl::StrCat(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src ",
      PolicyHash(script), "; style-src ", PolicyHash(style),
      "; img-src blob:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>tilemend report</title>\n<style>",
      style,
      "</style>\n</head>\n<body>\n<main id=\"page\"><noscript>This report needs JavaScript. report.json has the same "
      "facts.</noscript></main>\n<script type=\"application/json\" id=\"data\">",
      json, "</script>\n<script>", script, "</script>\n</body>\n</html>\n");
}

absl::Status WriteReportPage(const std::string& out) {
  const std::string report_path = absl::StrCat(out, "/report.json");
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(report_path));
  const Json report = ParseShallow(text);
  if (!report.is_object() || !report.contains("cells")) {
    return absl::InvalidArgumentError(absl::StrCat(report_path, ": not a report (expected an object with cells)"));
  }
  auto scene = LoadScene(Text(Member(report, "scene")), ReadTileHull, ReadTilesets);
  const Json& options = Member(report, "options");
  if (scene.ok()) {
    // Cells count from where the area begins. Without its file there are fewer pictures.
    ApplyAreaChoice(Text(Member(options, "area")), *scene).IgnoreError();
    TILEMEND_RETURN_IF_ERROR(SetDeliveryPaths(Text(Member(options, "output-format")), *scene));
  }
  PagePictures pictures;
  if (scene.ok()) {
    pictures = MakePagePictures(report, *scene, out);
  } else {
    pictures.problems.push_back(absl::StrCat("No pictures: ", std::string(scene.status().message())));
  }
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(out, "/holes.csv"), HolesCsv(report)));
  const Scene* const known = scene.ok() ? &*scene : nullptr;
  Json data = PageData(report, known, pictures);
  data["out"] = AbsoluteFolder(out);
  TILEMEND_ASSIGN_OR_RETURN(data["acceptance"], SavedAcceptance(out));
  TILEMEND_ASSIGN_OR_RETURN(data["review"], ReviewOf(report, out, known));
  return WriteFileAtomically(absl::StrCat(out, "/report.html"), ReportPage(data));
}

}  // namespace tilemend
