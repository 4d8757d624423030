#include "client/border_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/output.h"
#include "common/util/text.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// Metres. Tiles that are less apart are as good as photogrammetry makes them.
constexpr double kApart = 0.1;
// Metres: fills that are less apart at 99 % of the places are one surface.
constexpr double kFillApart = 0.02;

constexpr char kLegend[] =
    "apart: of tiles that overlap, how far one surface is from the other at half of\n"
    "the places, and at nine in ten; of others, how far they end from each other.\n"
    "fill: the same of the fill, and at 99 % of the places.\n";

// Where coordinator/waves/fill_gaps.h measures, and where `check` does: their figures differ.
constexpr char kFillPlaces[] =
    "these places lie along the whole border, where both tiles have a fill.\n"
    "`tilemend check` measures only where one fill ends:\n"
    "up or down from its edge to the other fill.\n";

// Of tiles that overlap, how far one surface is from the other, in the median; of those with a gap, its width. How far
// they overlap is no fault.
double ApartOf(const Json& row) {
  if (Member(row, "kind") == "overlap") return Number(Member(Member(row, "apart_m"), "median"));
  return std::abs(Number(Member(row, "offset_m")));
}

double FillApartOf(const Json& row) { return Number(Member(Member(row, "fill_apart_m"), "percentile_99")); }

// "[0,0] [1,0]"
std::string CellsText(const Json& cells) {
  std::vector<std::string> texts;
  for (const Json& cell : cells) texts.push_back(Text(cell));
  return absl::StrJoin(texts, " ");
}

std::vector<std::string> Row(const Json& row) {
  const bool overlap = Member(row, "kind") == "overlap";
  const Json& fill = Member(row, "fill_apart_m");
  return {CellsText(Member(row, "cells")),
          Text(Member(row, "kind")),
          overlap ? Decimals(Member(row, "offset_m"), 3) : "",
          absl::StrFormat("%.3f", ApartOf(row)),
          Decimals(Member(Member(row, "apart_m"), "ninth_decile"), 3),
          Decimals(Member(fill, "median"), 3),
          Decimals(Member(fill, "ninth_decile"), 3),
          Decimals(Member(fill, "percentile_99"), 3)};
}

// What fills differ by at the border where they differ most.
std::string FillText(const Json& borders) {
  size_t compared = 0;
  double farthest = 0;
  for (const Json& row : Member(borders, "inexact")) {
    compared += Member(row, "fill_apart_m").is_object();
    farthest = std::max(farthest, FillApartOf(row));
  }
  if (compared == 0) return "";
  return absl::StrCat(absl::StrFormat("fills overlap at %s: at most %.3f m apart at 99 %% of the places of each\n",
                                      Counted(compared, "border"), farthest),
                      kFillPlaces);
}

std::string CountsText(const Json& borders) {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : borders.items()) {
    if (count.is_number_integer() && count != 0)
      parts.push_back(absl::StrCat(count.get<int64_t>(), " ", Printable(kind)));
  }
  return absl::StrJoin(parts, ", ");
}

}  // namespace

std::string BordersText(const Json& report) {
  const Json& borders = Member(report, "borders");
  if (!borders.is_object()) return "";
  const std::string counts = CountsText(borders);
  if (counts.empty()) return "";
  std::vector<const Json*> pairs;
  for (const Json& row : Member(borders, "inexact")) {
    if (ApartOf(row) > kApart || FillApartOf(row) > kFillApart) pairs.push_back(&row);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Json* a, const Json* b) { return ApartOf(*a) > ApartOf(*b); });
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < std::min(pairs.size(), kMostListedRows); ++i) rows.push_back(Row(*pairs[i]));
  std::string text = absl::StrCat("\nborders between tiles: ", counts, "\n", FillText(borders));
  if (rows.empty()) return text;
  return absl::StrCat(
      text, Counted(pairs.size(), "pair"), " of tiles more than 0.1 m apart, or fills more than 0.02 m\n",
      Table({"cells", "they meet", "overlap, m", "apart, m", "90 %, m", "fill, m", "90 %, m", "99 %, m"}, rows),
      MoreText(pairs.size(), "see report.json"), kLegend);
}

}  // namespace tilemend
