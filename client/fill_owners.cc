#include "client/fill_owners.h"

#include <algorithm>
#include <map>
#include <set>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/mesh/faces_down.h"

namespace tilemend {

const TileFills& FillOwners::Fills() {
  if (!fills_) {
    fills_ = FillsOf(after_, added_);
    holes_.resize(fills_->rims.size());
  }
  return *fills_;
}

std::optional<int64_t> FillOwners::Of(int32_t triangle) {
  if (triangle < 0 || !added_[triangle]) return std::nullopt;
  const int32_t fill = Fills().of_triangle[triangle];
  if (!holes_[fill]) holes_[fill] = numbers_.OfRim(cell_, fills_->rims[fill]).value_or(-1);
  return *holes_[fill] >= 0 ? holes_[fill] : std::nullopt;
}

std::vector<int32_t> FillOwners::FoldedTriangles(const std::set<int64_t>& height_fields) {
  std::vector<int32_t> folded;
  std::map<int32_t, bool> is_height_field;  // by fill
  for (int32_t t = 0; t < std::ssize(after_.triangles); ++t) {
    const auto [a, b, c] = after_.triangles[t];
    if (!added_[t] || !FacesDown(after_.points[a], after_.points[b], after_.points[c])) continue;
    const int32_t fill = Fills().of_triangle[t];
    const auto [known, is_new] = is_height_field.try_emplace(fill);
    if (is_new) {
      const std::vector<int64_t> holes = numbers_.AllOfRim(cell_, fills_->rims[fill]);
      known->second =
          !holes.empty() && std::ranges::all_of(holes, [&](int64_t h) { return height_fields.contains(h); });
    }
    if (known->second) folded.push_back(t);
  }
  return folded;
}

std::string FillOwners::CrossedText(const AddedFaultPlace& place) {
  std::set<int64_t> others;
  const std::optional<int64_t> own = Of(place.triangle);
  for (const int32_t t : place.others) {
    if (const std::optional<int64_t> hole = Of(t); hole && hole != own) others.insert(*hole);
  }
  if (others.empty()) return "";
  return absl::StrCat("crosses the fill of hole", others.size() == 1 ? " " : "s ", absl::StrJoin(others, ", "));
}

}  // namespace tilemend
