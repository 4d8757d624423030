#include "common/rpc/clear_payloads.h"

#include <cmath>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

absl::Status Malformed(const char* what) {
  return absl::InvalidArgumentError(absl::StrCat("malformed payload: ", what));
}

absl::StatusOr<std::vector<PlaneSegment>> OutlineOf(const v1::ClearArea& proto) {
  constexpr int kNumbers = 4;  // of a segment
  if (proto.outline_size() % kNumbers != 0) return Malformed("segments without both ends");
  std::vector<PlaneSegment> outline;
  for (int i = 0; i < proto.outline_size(); i += kNumbers) {
    const PlaneSegment segment = {{proto.outline(i), proto.outline(i + 1)},
                                  {proto.outline(i + 2), proto.outline(i + 3)}};
    if (!segment.first.allFinite() || !segment.second.allFinite()) return Malformed("a position that is no number");
    outline.push_back(segment);
  }
  return outline;
}

}  // namespace

v1::ClearArea ToProto(const ClearArea& area) {
  v1::ClearArea proto;
  for (const std::vector<Point2>& ring : area.polygon.rings) {
    proto.add_ring_points(static_cast<int32_t>(ring.size()));
    for (const Point2& p : ring) {
      proto.add_point(p.x());
      proto.add_point(p.y());
    }
  }
  proto.set_top(area.top);
  for (const auto& [from, to] : area.outline) {
    for (const double x : {from.x(), from.y(), to.x(), to.y()}) proto.add_outline(x);
  }
  return proto;
}

absl::StatusOr<ClearArea> FromProto(const v1::ClearArea& proto) {
  ClearArea area;
  area.top = proto.top();
  if (std::isnan(area.top)) return Malformed("a height that is no number");
  TILEMEND_ASSIGN_OR_RETURN(area.outline, OutlineOf(proto));
  int64_t at = 0;
  for (const int32_t points : proto.ring_points()) {
    if (points < 3 || 2 * (at + points) > proto.point_size()) return Malformed("rings without their points");
    std::vector<Point2>& ring = area.polygon.rings.emplace_back();
    for (int32_t k = 0; k < points; ++k, ++at) {
      const auto i = static_cast<int>(2 * at);
      ring.emplace_back(proto.point(i), proto.point(i + 1));
      if (!ring.back().allFinite()) return Malformed("a position that is no number");
    }
  }
  return 2 * at == proto.point_size() ? absl::StatusOr<ClearArea>(std::move(area))
                                      : Malformed("points without their rings");
}

v1::HeightTally ToProto(const HeightTally& tally) {
  v1::HeightTally proto;
  for (const auto& [bin, area] : tally.area_of_bin) {
    proto.add_bin(bin);
    proto.add_area(area);
  }
  return proto;
}

absl::StatusOr<HeightTally> FromProto(const v1::HeightTally& proto) {
  if (proto.bin_size() != proto.area_size()) return Malformed("columns of unequal length");
  HeightTally tally;
  for (int i = 0; i < proto.bin_size(); ++i) {
    if (proto.area(i) <= 0) return Malformed("an area that is not positive");
    if (i > 0 && proto.bin(i) <= proto.bin(i - 1)) return Malformed("bins that do not rise");
    tally.area_of_bin[proto.bin(i)] = proto.area(i);
  }
  return tally;
}

absl::StatusOr<ClearedTile> ClearTile(const v1::TileRef& tile, std::string_view bytes) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(tile.path()));
  std::vector<ClearArea> areas;
  for (const v1::ClearArea& area : tile.clear()) {
    TILEMEND_ASSIGN_OR_RETURN(areas.emplace_back(), FromProto(area));
  }
  return ClearTile(format, bytes, areas, absl::StrCat(tile.root(), "/", tile.path()));
}

}  // namespace tilemend
