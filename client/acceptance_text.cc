#include "client/acceptance_text.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/csv.h"
#include "client/output.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kShownPlaces = 3;  // of one kind, on a terminal
constexpr char kChapter[] = "user guide, \"If an output is not accepted\" (docs/user-guide.md)";
constexpr char kOtherCount[] =
    "`crossings` in the report is another count, made when the hole was filled: without crossings with later fills, "
    "and\n"
    "with some that only go on from the input's. `rim_crossed` says that surface passes through the hole's boundary.";
constexpr char kOverlapPlaces[] =
    "fills that overlap were measured where one ends: up or down from its edge to the other.\n"
    "The report has another figure: it measures along the whole border, where both tiles have a fill.";

std::string PlaceText(const AcceptancePlace& place) {
  if (!place.at) return Printable(place.note);
  std::string text = absl::StrFormat("[%.2f,%.2f,%.2f] in cell %d,%d", place.at->x(), place.at->y(), place.at->z(),
                                     place.cell.col, place.cell.row);
  if (place.hole) absl::StrAppend(&text, ", hole ", *place.hole);
  if (!place.note.empty()) absl::StrAppend(&text, ": ", Printable(place.note));
  return text;
}

bool HasCrossings(const Acceptance& acceptance) {
  return std::ranges::any_of(acceptance.findings, [](const AcceptanceFinding& f) {
    return f.count > 0 && (f.name == "crossed_fills" || f.name == "crossed_surface" || f.name == "crossed_rims");
  });
}

}  // namespace

std::string VerdictOf(const Acceptance& acceptance) {
  std::string left_out;
  if (acceptance.cells_left_out > 0) {
    left_out = absl::StrCat("; ", acceptance.tiles, " of ", acceptance.tiles + acceptance.cells_left_out,
                            " tiles were chosen by --cells");
  }
  if (acceptance.IsAccepted()) {
    return absl::StrCat("accepted: all ", acceptance.original_faces - acceptance.cleared_faces,
                        " original triangles are there, and nothing is wrong with the ", acceptance.added_faces,
                        " new ones", left_out);
  }
  std::vector<std::string> faults;
  for (const AcceptanceFinding& finding : acceptance.findings) {
    if (finding.is_fault && finding.count > 0) {
      faults.push_back(Counted(static_cast<size_t>(finding.count), finding.one, finding.many));
    }
  }
  std::string text = "not accepted: ";
  for (size_t i = 0; i < faults.size(); ++i) absl::StrAppend(&text, i == 0 ? "" : ", ", faults[i]);
  return text + left_out;
}

std::string AcceptanceText(const Acceptance& acceptance) {
  std::string text = absl::StrCat(VerdictOf(acceptance), "\n\n");
  const auto counted = [](int64_t count, const char* one, const char* many) {
    return Counted(static_cast<size_t>(count), one, many);
  };
  absl::StrAppend(
      &text, "compared: ", counted(acceptance.tiles, "tile", "tiles"), ", ",
      counted(acceptance.original_faces, "original triangle", "original triangles"), ", ", acceptance.cleared_faces,
      " cleared, ", acceptance.added_faces, " new, ", counted(acceptance.files, "file", "files"), ", ",
      counted(acceptance.water_fills, "fill of water", "fills of water"), ", ",
      counted(acceptance.overlap_places, "place where fills overlap", "places where fills overlap"), "\n\n");
  for (const AcceptanceFinding& finding : acceptance.findings) {
    absl::StrAppendFormat(&text, "%9d  %s%s\n", finding.count, finding.count == 1 ? finding.one : finding.many,
                          finding.is_fault ? "" : " (no fault)");
    const size_t shown = std::min(finding.places.size(), kShownPlaces);
    for (size_t i = 0; i < shown; ++i) absl::StrAppend(&text, "             ", PlaceText(finding.places[i]), "\n");
    const int64_t more = finding.count - static_cast<int64_t>(shown);
    if (more > 0) absl::StrAppend(&text, "             and ", more, " more\n");
  }
  if (acceptance.overlap_places > 0) absl::StrAppend(&text, "\n", kOverlapPlaces, "\n");
  if (HasCrossings(acceptance)) absl::StrAppend(&text, "\n", kOtherCount, "\n");
  if (!acceptance.IsAccepted()) absl::StrAppend(&text, "\nwhat to do: ", kChapter, "\n");
  return text;
}

Json AcceptanceJson(const Acceptance& acceptance) {
  Json findings = Json::object();
  for (const AcceptanceFinding& finding : acceptance.findings) {
    Json places = Json::array();
    for (const AcceptancePlace& place : finding.places) {
      Json row = Json::object();
      if (place.at) {
        row["cell"] = {place.cell.col, place.cell.row};
        row["at"] = {place.at->x(), place.at->y(), place.at->z()};
      }
      if (place.hole) row["hole"] = *place.hole;
      if (!place.note.empty()) row["note"] = place.note;
      places.push_back(std::move(row));
    }
    findings[finding.name] = {{"text", finding.count == 1 ? finding.one : finding.many},
                              {"fault", finding.is_fault},
                              {"count", finding.count},
                              {"places", std::move(places)}};
  }
  return {{"accepted", acceptance.IsAccepted()},
          {"verdict", VerdictOf(acceptance)},
          {"tiles", acceptance.tiles},
          {"cells_left_out", acceptance.cells_left_out},
          {"original_triangles", acceptance.original_faces},
          {"cleared_triangles", acceptance.cleared_faces},
          {"new_triangles", acceptance.added_faces},
          {"files", acceptance.files},
          {"water_fills", acceptance.water_fills},
          {"overlap_places", acceptance.overlap_places},
          {"findings", std::move(findings)},
          {"warnings", acceptance.warnings}};
}

std::string_view AcceptanceCsvHead() { return "what,fault,column,row,x,y,z,hole,note\r\n"; }

std::string AcceptanceCsv(const Acceptance& acceptance) {
  std::string text(AcceptanceCsvHead());
  for (const AcceptanceFinding& finding : acceptance.findings) {
    for (const AcceptancePlace& place : finding.places) {
      absl::StrAppend(&text, finding.name, ",", finding.is_fault ? "yes" : "no", ",");
      if (place.at) {
        absl::StrAppendFormat(&text, "%d,%d,%.4f,%.4f,%.4f,", place.cell.col, place.cell.row, place.at->x(),
                              place.at->y(), place.at->z());
      } else {
        absl::StrAppend(&text, ",,,,,");
      }
      absl::StrAppend(&text, place.hole ? absl::StrCat(*place.hole) : "", ",", CsvField(place.note), "\r\n");
    }
  }
  return text;
}

}  // namespace tilemend
