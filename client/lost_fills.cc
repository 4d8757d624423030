#include "client/lost_fills.h"

#include "client/rounded_place.h"

namespace tilemend {

LostFills::LostFills(const std::vector<std::vector<Point2>>& rims) : rims_(static_cast<int32_t>(rims.size())) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int32_t r = 0; r < rims_; ++r) {
    for (size_t k = 1; k < rims[r].size(); ++k) {
      const Point2 &a = rims[r][k - 1], &b = rims[r][k];
      segments_.push_back({a, b, r});
      Eigen::AlignedBox3d& box = boxes.emplace_back(Point3(a.x(), a.y(), 0));
      box.extend(Point3(b.x(), b.y(), 0));
    }
  }
  tree_ = BoxTree(boxes);
}

template <typename Visit>
bool LostFills::AnyAt(const Point3& a, const Point3& b, const Visit& visit) const {
  const Point3 middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2, 0), reach(kOfRounding, kOfRounding, 0);
  return tree_.AnyMeeting({middle - reach, middle + reach}, [&](int32_t i) {
    const Segment& s = segments_[i];
    return IsRoundedTo(s.a, s.b, a, b) && visit(i);
  });
}

bool LostFills::IsAtRim(const Point3& a, const Point3& b) const {
  return AnyAt(a, b, [](int32_t) { return true; });
}

void LostFills::Add(const NewOpenEdge& edge) {
  AnyAt(edge.edge.from, edge.edge.to, [&](int32_t i) {
    if (edge.edge.after == 1) {
      segments_[i].open.push_back(edge);
    } else {
      segments_[i].is_closed = true;
    }
    return false;
  });
}

std::vector<NewOpenEdge> LostFills::Lost() const {
  std::vector<double> open(rims_, 0), all(rims_, 0);  // metres
  for (const Segment& s : segments_) {
    const double length = (s.b - s.a).norm();
    all[s.rim] += length;
    if (!s.is_closed && !s.open.empty()) open[s.rim] += length;
  }
  std::vector<NewOpenEdge> lost;
  for (const Segment& s : segments_) {
    if (!s.is_closed && open[s.rim] > all[s.rim] / 2) lost.insert(lost.end(), s.open.begin(), s.open.end());
  }
  return lost;
}

}  // namespace tilemend
