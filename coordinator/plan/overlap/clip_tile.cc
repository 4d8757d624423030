#include "coordinator/plan/overlap/clip_tile.h"

#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

class Clipper {
 public:
  Clipper(const SurveyRecord& record, const ClipSquare& square) : record_(record), square_(square) {}

  ClippedTile Run() {
    for (size_t e = 0; e < record_.edges.size(); ++e) Clip(static_cast<int32_t>(e));
    for (const BoundaryVertex& v : record_.vertices) AddCorner(v.position);
    return std::move(result_);
  }

 private:
  // A place along an edge: one of its ends, or where it passes a side.
  struct Place {
    double share = 0;  // of the way from its beginning to its end
    int side = -1;     // that it passes
    int32_t crossing = -1;
  };

  void Clip(int32_t e) {
    const BoundaryEdge& edge = record_.edges[e];
    const Point3 &p = record_.vertices[edge.from].position, &q = record_.vertices[edge.to].position;
    std::vector<Place> places = {{0, -1, -1}, {1, -1, -1}};
    for (const Side s : kSides) {
      if (square_.Beyond(p, s) == square_.Beyond(q, s)) continue;
      const int axis = AxisOf(s);
      places.push_back({std::clamp((square_.cut[s] - p[axis]) / (q[axis] - p[axis]), 0.0, 1.0), s, -1});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      const auto order = [](const Place& x) { return x.side >= 0 ? 1 : x.share > 0 ? 2 : 0; };  // ends stay at the ends
      return a.share != b.share ? a.share < b.share : order(a) < order(b);
    });
    std::array<bool, 4> beyond{};
    for (const Side s : kSides) beyond[s] = square_.Beyond(p, s);
    for (size_t i = 0; i + 1 < places.size(); ++i) {
      if (places[i].side >= 0) beyond[places[i].side] = !beyond[places[i].side];
      AddPart(e, beyond, places[i], places[i + 1]);
    }
  }

  void AddPart(int32_t e, const std::array<bool, 4>& beyond, Place& from, Place& to) {
    const auto count = std::count(beyond.begin(), beyond.end(), true);
    if (count > 1) return;  // pressed into a corner
    if (count == 0) {
      result_.inner.push_back({EndAt(e, from, false), EndAt(e, to, true)});
      return;
    }
    const auto s = static_cast<Side>(std::find(beyond.begin(), beyond.end(), true) - beyond.begin());
    SidePart part;
    part.side = s;
    if (from.side == s) part.from_crossing = CrossingAt(e, from, true);
    if (to.side == s) part.to_crossing = CrossingAt(e, to, false);
    const Point3 a = At(e, from.share), b = At(e, to.share);
    part.from = Along(a, s, from), part.to = Along(b, s, to);
    part.from_height = a.z(), part.to_height = b.z();
    if (part.from != part.to || part.from_crossing >= 0 || part.to_crossing >= 0) result_.at_side.push_back(part);
  }

  ClipEnd EndAt(int32_t e, Place& place, bool leaves) {
    if (place.side >= 0) return {-1, CrossingAt(e, place, leaves)};
    const BoundaryEdge& edge = record_.edges[e];
    return {place.share == 0 ? edge.from : edge.to, -1};
  }

  int32_t CrossingAt(int32_t e, Place& place, bool leaves) {
    if (place.crossing >= 0) return place.crossing;
    place.crossing = static_cast<int32_t>(result_.crossings.size());
    const auto s = static_cast<Side>(place.side);
    const Point3 p = At(e, place.share);
    const double length = (At(e, 1) - At(e, 0)).head<2>().norm();
    result_.crossings.push_back({e, s, Along(p, s, {}), p.z(), length, leaves});
    return place.crossing;
  }

  Point3 At(int32_t e, double share) const {
    const BoundaryEdge& edge = record_.edges[e];
    const Point3 &p = record_.vertices[edge.from].position, &q = record_.vertices[edge.to].position;
    return share == 0 ? p : share == 1 ? q : Point3(p + share * (q - p));
  }

  // The coordinate along side s, pressed between its corners.
  double Along(const Point3& p, Side s, const Place& place) const {
    const Side low = AxisOf(s) == 0 ? kSouth : kWest, high = AxisOf(s) == 0 ? kNorth : kEast;
    if (square_.Beyond(p, low) || place.side == low) return square_.side[low];
    if (square_.Beyond(p, high) || place.side == high) return square_.side[high];
    return p[1 - AxisOf(s)];
  }

  void AddCorner(const Point3& p) {
    for (const Side x : {kWest, kEast}) {
      for (const Side y : {kSouth, kNorth}) {
        if (square_.Beyond(p, x) && square_.Beyond(p, y)) result_.corners.push_back({{x, y}, p.z()});
      }
    }
  }

  const SurveyRecord& record_;
  const ClipSquare& square_;
  ClippedTile result_;
};

}  // namespace

bool ClipSquare::Contains(const Point3& p) const {
  return std::none_of(kSides.begin(), kSides.end(), [&](Side s) { return Beyond(p, s); });
}

ClippedTile ClipTile(const SurveyRecord& record, const ClipSquare& square) { return Clipper(record, square).Run(); }

}  // namespace tilemend
