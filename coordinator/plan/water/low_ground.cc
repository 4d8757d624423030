#include "coordinator/plan/water/low_ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tilemend {
namespace {

constexpr double kNearest = 4;  // metres: the first rows of triangles lie on the shore, which rises slowly
constexpr double kNearestEdges = 1.5, kFarthestEdges = 3;  // mean edges, if that is more
constexpr double kSquareShare = 0.1;                       // of the reach: side of the squares that count
constexpr double kFreeboard = 0.15;                        // metres that ground stands above water
constexpr double kSteepest = 0.1;                          // rise / run; what is higher at the reach is an object
constexpr double kLeastOfAll = 0.05;                       // of all squares; fewer are a jetty or a spike
constexpr double kWidestSquares = 0.4;                     // of the reach: wider ones tell nothing
constexpr int64_t kMinSquares = 5, kMinSquaresOfBands = 10;

// The shore of one rim in squares as wide as its reach.
class ShoreIndex {
 public:
  explicit ShoreIndex(const Shore& shore) : most_above_(kSigmas * std::max(shore.noise, kMinSigma)) {
    nearest_ = std::max(kNearest, kNearestEdges * shore.mean_edge);
    reach_ = std::max(kSurroundingsReach, kFarthestEdges * shore.mean_edge);
    for (const Point3& p : shore.edges) {
      squares_[SquareOf(p, reach_)].push_back(p);
      box_.extend(p.head<2>());
    }
    box_.min().array() -= reach_;
    box_.max().array() += reach_;
  }

  const Eigen::AlignedBox2d& box() const { return box_; }

  // Squares of ground reach as far as this rim asks, and are small enough.
  bool IsToldBy(const RimGround& ground) const {
    return reach_ <= kSurroundingsReach && ground.side <= kWidestSquares * kSurroundingsReach;
  }

  // A place with surface, on ground as far as that is told.
  void Add(const Point3& p, bool is_ground) {
    if (!box_.contains(p.head<2>())) return;
    const auto [distance, level] = NearestEdge(p);
    if (distance < nearest_ || distance > reach_ || std::isnan(level)) return;
    Lowest& square = lowest_[SquareOf(p, kSquareShare * reach_)];
    square.above = std::min(square.above, p.z() - level);
    square.is_ground = square.is_ground || is_ground;
  }

  GroundAround Shares() const {
    const double most = std::max(most_above_, kSteepest * reach_);
    const auto is_lower = [&](const auto& square) {
      return square.second.above <= (square.second.is_ground ? kFreeboard : most_above_);
    };
    const auto is_low = [&](const auto& square) { return square.second.is_ground || square.second.above <= most; };
    const auto lower = static_cast<double>(std::ranges::count_if(lowest_, is_lower));
    const auto low = std::ranges::count_if(lowest_, is_low);
    const auto told = std::ranges::count_if(lowest_, [](const auto& square) { return square.second.is_ground; });
    if (told < kMinSquares && low < kMinSquaresOfBands) return {};
    const auto is_sunk = [&](const auto& square) { return square.second.above < -most_above_; };
    const auto known = static_cast<double>(low);
    const bool are_many = lower > kLeastOfAll * static_cast<double>(lowest_.size());
    return {are_many ? lower / known : 0, static_cast<double>(std::ranges::count_if(lowest_, is_sunk)) / known};
  }

 private:
  using Square = std::pair<int64_t, int64_t>;

  static Square SquareOf(const Point3& p, double side) {
    return {std::llround(std::floor(p.x() / side)), std::llround(std::floor(p.y() / side))};
  }

  // How far away it is, and the height of the water there.
  std::pair<double, double> NearestEdge(const Point3& p) const {
    const Square middle = SquareOf(p, reach_);
    std::pair<double, double> nearest(std::numeric_limits<double>::infinity(), 0);
    for (int64_t column = middle.first - 1; column <= middle.first + 1; ++column) {
      for (int64_t row = middle.second - 1; row <= middle.second + 1; ++row) {
        const auto square = squares_.find({column, row});
        if (square == squares_.end()) continue;
        for (const Point3& q : square->second) {
          const double squared = (q - p).head<2>().squaredNorm();
          if (squared < nearest.first) nearest = {squared, q.z()};
        }
      }
    }
    return {std::sqrt(nearest.first), nearest.second};
  }

  struct Lowest {
    double above = std::numeric_limits<double>::infinity();  // metres above the water, of the surface in the square
    bool is_ground = false;
  };

  double most_above_, nearest_ = 0, reach_ = 0;  // metres
  std::map<Square, std::vector<Point3>> squares_;
  Eigen::AlignedBox2d box_;
  std::map<Square, Lowest> lowest_;
};

void AddGround(const RimGround& ground, const std::vector<ShoreIndex*>& shores) {
  for (const GroundSquare& square : ground.around) {
    const Point3 middle((square.col + 0.5) * ground.side, (square.row + 0.5) * ground.side, square.height);
    for (ShoreIndex* shore : shores) shore->Add(middle, true);
  }
}

void AddBand(const SurveyRecord& record, std::span<const int32_t> plan_vertex, const std::vector<ShoreIndex*>& shores) {
  for (size_t i = 0; i < record.band.points.size(); ++i) {
    const bool is_on_rim = i < plan_vertex.size() && plan_vertex[i] >= 0;
    if (is_on_rim) continue;
    for (ShoreIndex* shore : shores) shore->Add(record.band.points[i], false);
  }
}

}  // namespace

std::vector<GroundAround> GroundAroundShores(const Plan& plan, const PlanInput& input, std::span<const Shore> shores) {
  std::vector<ShoreIndex> indices(shores.begin(), shores.end());
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->vertex_count == 0) continue;
    const auto told = input.rim_ground.find(cell);
    const RimGround* ground = told == input.rim_ground.end() ? nullptr : &told->second;
    Eigen::AlignedBox2d tile(record->lo.head<2>(), record->hi.head<2>());
    tile.min().array() -= kSurroundingsReach;
    tile.max().array() += kSurroundingsReach;
    std::vector<ShoreIndex*> by_ground, by_band;
    for (ShoreIndex& shore : indices) {
      if (!shore.box().intersects(tile)) continue;
      (ground != nullptr && shore.IsToldBy(*ground) ? by_ground : by_band).push_back(&shore);
    }
    if (!by_ground.empty()) AddGround(*ground, by_ground);
    if (!by_band.empty()) AddBand(*record.WithBand(), VerticesOf(plan, cell), by_band);
  }
  std::vector<GroundAround> shares;
  for (const ShoreIndex& shore : indices) shares.push_back(shore.Shares());
  return shares;
}

}  // namespace tilemend
