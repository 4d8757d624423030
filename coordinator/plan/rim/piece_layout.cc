#include "coordinator/plan/rim/piece_layout.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/weighted_median.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

// Of the median length of an edge: how far away the other edge of a pair is looked for.
constexpr double kSearch = 3;
// How exactly the surfaces at a pair lie opposite each other: the cosine between the ways into them.
constexpr double kOpposite = -0.8;
// The pairs agree if their median absolute deviation is at most this share of the search. In exports in pieces, of two
// sites, it was at most .001; in tiles of one piece, of four sites, at least .14. This lies between.
constexpr double kAgreement = 0.05;
// Fewer say nothing (as of the places that tell a level, level_evidence.h).
constexpr int64_t kLeastPairs = 20;
constexpr size_t kMostEdges = 4000;         // that are asked for their other one
constexpr int64_t kMostLooks = 20'000'000;  // at others, in all: some tenths of a second
constexpr size_t kMostAsked = 100;          // pairs: each costs a look at all edges
// Standard deviations of a normal distribution in a median absolute deviation; what is farther off than three is none
// of the usual (Hampel 1974).
constexpr double kDeviations = 1.4826;
constexpr double kFinestAngle = 1e-5;  // radians: a millimetre in 100 m

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// An edge of a pair.
struct PairedEdge {
  size_t edge = 0;
  Vector3d way{0, 0, 0};  // from its middle to the other edge
  double overlap = 0;     // how far its surface goes on beyond the other edge; negative: how far before it ends
};

class LayoutFinder {
 public:
  explicit LayoutFinder(const SurveyRecord& record) : record_(record) {}

  std::optional<PieceLayout> Run() {
    if (record_.edges.empty() || !Closes()) return std::nullopt;
    SetUp();
    std::vector<PairedEdge> pairs = Pairs();
    if (std::ssize(pairs) < kLeastPairs) return std::nullopt;
    const double usual = MedianOver(pairs, [](double overlap) { return overlap; });
    if (usual <= kMeetTolerance) return std::nullopt;
    const auto off = [&](double overlap) { return std::abs(overlap - usual); };
    const double deviation = MedianOver(pairs, off);
    if (deviation > kAgreement * search_) return std::nullopt;
    const double slack = std::max(3 * kDeviations * deviation, kMeetTolerance);
    std::erase_if(pairs, [&](const PairedEdge& pair) { return off(pair.overlap) > slack; });
    if (!LieOnEachOther(pairs)) return std::nullopt;
    const double direction = DirectionOf(pairs);
    return PieceLayout{3 * std::max(usual, slack), {std::cos(direction), std::sin(direction)}};
  }

 private:
  void SetUp() {
    std::vector<AlignedBox3d> boxes;
    std::vector<double> lengths;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      lengths.push_back(LengthOf(e));
      inward_.push_back(InwardOf(e));
      boxes.push_back(AlignedBox3d(Begin(e)).extend(End(e)));
    }
    std::ranges::nth_element(lengths, lengths.begin() + std::ssize(lengths) / 2);
    search_ = kSearch * lengths[lengths.size() / 2];
    tree_ = BoxTree(boxes);
  }

  // Of some edges all over the boundary; none if there are too many others around them.
  std::vector<PairedEdge> Pairs() const {
    std::vector<PairedEdge> pairs;
    int64_t looks = 0;
    const size_t step = std::max<size_t>(1, record_.edges.size() / kMostEdges);
    for (size_t e = 0; e < record_.edges.size(); e += step) {
      if (const std::optional<Vector3d> way = WayAcross(e, looks)) {
        pairs.push_back({e, *way, way->dot(inward_[e])});
      }
      if (looks > kMostLooks) return {};
    }
    return pairs;
  }

  const Point3& Begin(size_t e) const { return record_.vertices[record_.edges[e].from].position; }
  const Point3& End(size_t e) const { return record_.vertices[record_.edges[e].to].position; }
  double LengthOf(size_t e) const { return (End(e) - Begin(e)).norm(); }

  // Whether as many edges arrive at each vertex as leave it: else the boundary winds around no region.
  bool Closes() const {
    std::vector<int32_t> leaving(record_.vertices.size(), 0);
    for (const BoundaryEdge& e : record_.edges) {
      ++leaving[e.from];
      --leaving[e.to];
    }
    return std::ranges::all_of(leaving, [](int32_t more) { return more == 0; });
  }

  // From the edge into the surface, along it.
  Vector3d InwardOf(size_t e) const {
    const Vector3d normal =
        record_.vertices[record_.edges[e].from].normal + record_.vertices[record_.edges[e].to].normal;
    return normal.cross(End(e) - Begin(e)).normalized();
  }

  bool Touch(size_t a, size_t b) const {
    const BoundaryEdge &one = record_.edges[a], &other = record_.edges[b];
    return one.from == other.from || one.from == other.to || one.to == other.from || one.to == other.to;
  }

  // From the middle of an edge to the nearest edge whose surface lies on the other side; none if no such edge is near.
  std::optional<Vector3d> WayAcross(size_t e, int64_t& looks) const {
    const Point3 middle = (Begin(e) + End(e)) / 2;
    const Vector3d reach = Vector3d::Constant(search_);
    std::optional<Vector3d> nearest;
    tree_.AnyMeeting({middle - reach, middle + reach}, [&](int32_t number) {
      const auto other = static_cast<size_t>(number);
      if (++looks > kMostLooks) return true;
      if (other == e || inward_[e].dot(inward_[other]) > kOpposite || Touch(e, other)) return false;
      const Vector3d along = End(other) - Begin(other);
      const double share = std::clamp((middle - Begin(other)).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const Vector3d way = Begin(other) + share * along - middle;
      if (way.norm() < (nearest ? nearest->norm() : search_)) nearest = way;
      return false;
    });
    return nearest;
  }

  // Whether two pieces lie between the edges of most pairs, and not a strip of one. Some of the pairs tell.
  bool LieOnEachOther(const std::vector<PairedEdge>& pairs) const {
    const size_t step = std::max<size_t>(1, pairs.size() / kMostAsked);
    int64_t asked = 0, doubled = 0;
    for (size_t i = 0; i < pairs.size(); i += step, ++asked) {
      const size_t e = pairs[i].edge;
      doubled += WindingAt(((Begin(e) + End(e)) / 2 + pairs[i].way / 2).head<2>()) >= 2;
    }
    return 2 * doubled > asked;
  }

  // How often the boundary winds around a place, seen from above: by the edges to the east.
  int WindingAt(const Point2& p) const {
    int winding = 0;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const Point2 a = Begin(e).head<2>() - p, b = End(e).head<2>() - p;
      if ((a.y() > 0) == (b.y() > 0)) continue;
      const double east = a.x() - a.y() * (b.x() - a.x()) / (b.y() - a.y());
      if (east > 0) winding += b.y() > 0 ? 1 : -1;
    }
    return winding;
  }

  // Of a value of the overlaps; a long edge counts more. Precondition: there are pairs.
  template <typename Value>
  double MedianOver(const std::vector<PairedEdge>& pairs, const Value& value) const {
    std::vector<std::pair<double, double>> values;
    for (const PairedEdge& pair : pairs) values.emplace_back(value(pair.overlap), LengthOf(pair.edge));
    return *WeightedMedian(std::move(values));
  }

  // Of the upright planes that most of the edges lie in: the angle of one to the x axis. Long edges tell it best.
  double DirectionOf(const std::vector<PairedEdge>& pairs) const {
    constexpr double kQuarter = std::numbers::pi / 2;
    const auto way_of = [&](const PairedEdge& pair) { return Point2((End(pair.edge) - Begin(pair.edge)).head<2>()); };
    std::complex<double> mean = 0;  // of directions to a quarter turn
    for (const PairedEdge& pair : pairs) {
      const Point2 way = way_of(pair);
      mean += way.squaredNorm() * std::polar(1.0, 4 * std::atan2(way.y(), way.x()));
    }
    double direction = std::arg(mean) / 4;
    for (double within = kQuarter; within > kFinestAngle; within /= 4) {
      std::vector<std::pair<double, double>> turns;
      for (const PairedEdge& pair : pairs) {
        const Point2 way = way_of(pair);
        const double turn = std::remainder(std::atan2(way.y(), way.x()) - direction, kQuarter);
        if (std::abs(turn) <= within) turns.emplace_back(turn, way.squaredNorm());
      }
      direction += WeightedMedian(std::move(turns)).value_or(0);
    }
    return direction;
  }

  const SurveyRecord& record_;
  std::vector<Vector3d> inward_;
  double search_ = 0;
  BoxTree tree_;
};

}  // namespace

std::optional<PieceLayout> FindPieceLayout(const SurveyRecord& record) { return LayoutFinder(record).Run(); }

}  // namespace tilemend
