#include "client/fill_owners.h"

#include <set>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace tilemend {

std::optional<int64_t> FillOwners::Of(int32_t triangle) {
  if (triangle < 0 || !added_[triangle]) return std::nullopt;
  if (!fills_) {
    fills_ = FillsOf(after_, added_);
    holes_.resize(fills_->rims.size());
  }
  const int32_t fill = fills_->of_triangle[triangle];
  if (!holes_[fill]) holes_[fill] = numbers_.OfRim(cell_, fills_->rims[fill]).value_or(-1);
  return *holes_[fill] >= 0 ? holes_[fill] : std::nullopt;
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
