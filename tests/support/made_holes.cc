#include "tests/support/made_holes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/value_noise.h"

namespace tilemend {
namespace {

double DistanceToSegment(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

bool IsInStrip(const StripHole& strip, const Point2& p) {
  for (size_t k = 1; k < strip.through.size(); ++k) {
    if (DistanceToSegment(p, strip.through[k - 1], strip.through[k]) < strip.half_width) return true;
  }
  return false;
}

}  // namespace

double FeatureSize(const SceneMakerOptions& o) { return o.feature_size > 0 ? o.feature_size : o.cell_size; }

MadeHoles::MadeHoles(const SceneMakerOptions& options) : o_(options) {
  width_ = o_.cols * o_.cell_size;
  height_ = o_.rows * o_.cell_size;
  if (o_.lakes) lake_level_ = Level(200, 1 - o_.lake_share);
  if (o_.islands) island_level_ = Level(300, 0.9);
  empty_.insert(o_.empty.begin(), o_.empty.end());
  AddShapes();
  AddSmall();
  AddClosed();
}

bool MadeHoles::Contains(double x, double y) const {
  return InLake(x, y) || InRiver(x, y) || InShape({x, y}) || empty_.contains(CellAt({x, y}));
}

void MadeHoles::AddShapes() {
  for (const EllipseHole& ellipse : o_.ellipses) AddEllipse(ellipse);
  for (const BoxHole& box : o_.boxes) {
    const auto contains = [box](const Point2& p) {
      return (p.array() > box.lo.array()).all() && (p.array() < box.hi.array()).all();
    };
    File({contains, box.only_cell}, box.lo, box.hi);
  }
  for (const StripHole& strip : o_.strips) {
    Point2 lo = strip.through.front(), hi = lo;
    for (const Point2& p : strip.through) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    const Point2 reach(strip.half_width, strip.half_width);
    File({[strip](const Point2& p) { return IsInStrip(strip, p); }, strip.only_cell}, lo - reach, hi + reach);
  }
}

void MadeHoles::AddSmall() {
  const auto count = static_cast<int64_t>(std::llround(o_.small_per_cell * o_.cols * o_.rows));
  for (int64_t k = 0; k < count; ++k) {
    const auto random = [&](uint64_t purpose) { return HashedNumber(o_.seed + 5, k, 0, purpose); };
    const double radius = o_.spacing * (1.5 + 4.5 * random(2));
    AddEllipse({{random(0) * width_, random(1) * height_}, {radius, radius * (0.4 + 0.6 * random(3))}, {}});
  }
}

void MadeHoles::AddClosed() {
  constexpr int kMostTrials = 100000;
  const std::set<CellId> away(o_.out_of_area.begin(), o_.out_of_area.end());
  int left = o_.closed;
  for (int k = 0; left > 0 && k < kMostTrials; ++k) {
    const auto random = [&](uint64_t purpose) { return HashedNumber(o_.seed + 11, k, 0, purpose); };
    const Point2 centre(width_ * random(0), height_ * random(1));
    const Point2 radii = o_.cell_size * Point2(0.035 + 0.055 * random(2), 0.035 + 0.055 * random(3));
    const EllipseHole ellipse{centre, radii, {}};
    if (away.contains(CellAt(centre)) || !IsClear(ellipse)) continue;
    AddEllipse(ellipse);
    --left;
  }
}

bool MadeHoles::IsClear(const EllipseHole& ellipse) const {
  constexpr int kDirections = 60;
  const double gap = 0.05 * o_.cell_size;
  const CellId cell = CellAt(ellipse.centre);
  for (const double share : {0.05, 0.35, 0.7, 1.0}) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * std::numbers::pi * k / kDirections;
      const Point2 around = (ellipse.radii + Point2(gap, gap)).cwiseProduct(Point2(std::cos(angle), std::sin(angle)));
      const Point2 p = ellipse.centre + share * around;
      if (CellAt(p) != cell || Contains(p.x(), p.y())) return false;
    }
  }
  return true;
}

void MadeHoles::File(const Shape& shape, const Point2& lo, const Point2& hi) {
  // Bent outlines reach further; tiles may reach over the scene's rim.
  const Point2 reach(o_.bend * o_.cell_size, o_.bend * o_.cell_size);
  const CellId first = CellAt(lo - reach);
  const CellId last = CellAt(hi + reach);
  for (int32_t row = std::max(first.row, -1); row <= std::min(last.row, o_.rows); ++row) {
    for (int32_t col = std::max(first.col, -1); col <= std::min(last.col, o_.cols); ++col) {
      if (!shape.only_cell || *shape.only_cell == CellId{col, row}) shapes_[{col, row}].push_back(shape);
    }
  }
}

void MadeHoles::AddEllipse(const EllipseHole& ellipse) {
  const auto contains = [ellipse](const Point2& p) {
    return (p - ellipse.centre).cwiseQuotient(ellipse.radii).squaredNorm() < 1;
  };
  File({contains, ellipse.only_cell}, ellipse.centre - ellipse.radii, ellipse.centre + ellipse.radii);
}

CellId MadeHoles::CellAt(const Point2& p) const {
  return {static_cast<int32_t>(std::floor(p.x() / o_.cell_size)),
          static_cast<int32_t>(std::floor(p.y() / o_.cell_size))};
}

double MadeHoles::Field(uint64_t purpose, double x, double y) const {
  const double scale = (purpose == 200 ? 0.8 : 4) / FeatureSize(o_);
  return FractalNoise(o_.seed + 7, x * scale, y * scale, 3, purpose);
}

// The value that `share` of the scene lies below.
double MadeHoles::Level(uint64_t purpose, double share) const {
  constexpr int kSamples = 64;
  std::vector<double> values;
  for (int j = 0; j < kSamples; ++j) {
    for (int i = 0; i < kSamples; ++i) {
      values.push_back(Field(purpose, (i + 0.5) / kSamples * width_, (j + 0.5) / kSamples * height_));
    }
  }
  const auto at = values.begin() + static_cast<ptrdiff_t>(std::clamp(share, 0.0, 1.0) * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

bool MadeHoles::InLake(double x, double y) const {
  if (!o_.lakes || Field(200, x, y) <= lake_level_) return false;
  return !o_.islands || Field(300, x, y) < island_level_;
}

bool MadeHoles::InRiver(double x, double y) const {
  if (!o_.river) return false;
  const double size = FeatureSize(o_);
  const double t = x / size;
  const double phase = 6.28 * HashedNumber(o_.seed, 0, 0, 400);
  const double middle = height_ / 2 + size * (0.3 * std::sin(1.1 * t + phase) + 0.08 * std::sin(3.7 * t));
  return std::abs(y - middle) < size * (0.1 + 0.03 * std::sin(2.3 * t + phase));
}

bool MadeHoles::InShape(const Point2& p) const {
  const auto at = shapes_.find(CellAt(p));
  if (at == shapes_.end()) return false;
  const Point2 bent = Bent(p);
  return std::any_of(at->second.begin(), at->second.end(), [&](const Shape& shape) { return shape.contains(bent); });
}

Point2 MadeHoles::Bent(const Point2& p) const {
  if (o_.bend == 0) return p;
  const auto phase = [this](uint64_t purpose) { return 6.28 * HashedNumber(o_.seed, 0, 0, purpose); };
  const Point2 q = p / o_.cell_size;
  const Point2 waves(std::sin(9 * q.x() + phase(410)) * std::sin(8 * q.y() + phase(411)),
                     std::sin(8 * q.x() + phase(412)) * std::sin(9 * q.y() + phase(413)));
  return p + o_.bend * o_.cell_size * waves;
}

}  // namespace tilemend
