#include "worker/fill/seam/sample_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tilemend {
namespace {

// A known boundary point as one grid line sees it.
struct Projection {
  double t;         // along the line
  double distance;  // to the line
  double height;
};

struct HoleBoundary {
  // Vertices of the hole, each once, in order of the segments. Known ones on objects only where there are no others.
  std::vector<int32_t> known, unknown;
  std::set<int32_t> seam_ends;  // original vertices at which a seam begins
};

HoleBoundary Collect(const CellHoles& cell, const CellHole& hole) {
  HoleBoundary boundary;
  std::vector<bool> seen(cell.vertices.size(), false);
  for (const RimSegment& s : hole.segments) {
    for (const int32_t v : {s.from, s.to}) {
      if (s.seam && cell.vertices[v].index >= 0) boundary.seam_ends.insert(v);
      if (seen[v]) continue;
      seen[v] = true;
      (cell.vertices[v].height_known ? boundary.known : boundary.unknown).push_back(v);
    }
  }
  const auto is_on_object = [&](int32_t v) { return cell.vertices[v].on_object; };
  if (!std::ranges::all_of(boundary.known, is_on_object)) std::erase_if(boundary.known, is_on_object);
  return boundary;
}

double HeightOf(const CellHoles& cell, const HoleBoundary& boundary, int32_t v) {
  const RimVertex& vertex = cell.vertices[v];
  return vertex.index < 0 || boundary.seam_ends.contains(v) ? vertex.position.z() : vertex.centroid_height;
}

// The projections onto a line in order, and of those the nearest to it, one for each bin along it.
class LineProfile {
 public:
  LineProfile(std::vector<Projection> all, double bin, double same_place)
      : all_(std::move(all)), same_place_(same_place) {
    std::sort(all_.begin(), all_.end(), [](const Projection& a, const Projection& b) {
      return a.t != b.t ? a.t < b.t : a.distance != b.distance ? a.distance < b.distance : a.height < b.height;
    });
    for (const Projection& p : all_) {
      if (!nearest_.empty() && std::floor(p.t / bin) == std::floor(nearest_.back().t / bin)) {
        if (p.distance < nearest_.back().distance) nearest_.back() = p;
      } else {
        nearest_.push_back(p);
      }
    }
  }

  double At(double t) const {
    const Projection* const here = NearestAt(t);
    return here != nullptr ? here->height : Between(t);
  }

 private:
  // What projects to a place itself, the nearest to the line; null: nothing.
  const Projection* NearestAt(double t) const {
    const Projection* nearest = nullptr;
    const auto first = std::lower_bound(all_.begin(), all_.end(), t - same_place_,
                                        [](const Projection& p, double v) { return p.t < v; });
    for (auto it = first; it != all_.end() && it->t <= t + same_place_; ++it) {
      if (nearest == nullptr || it->distance < nearest->distance) nearest = &*it;
    }
    return nearest;
  }

  double Between(double t) const {
    const auto next = std::lower_bound(nearest_.begin(), nearest_.end(), t,
                                       [](const Projection& p, double value) { return p.t < value; });
    if (next == nearest_.begin()) return next->height;
    const auto before = next - 1;
    if (next == nearest_.end()) return before->height;
    const double f = (t - before->t) / (next->t - before->t);
    return before->height + f * (next->height - before->height);
  }

  std::vector<Projection> all_, nearest_;
  double same_place_;
};

class HoleSampler {
 public:
  HoleSampler(const CellHoles& cell, const CellHole& hole) : cell_(cell), boundary_(Collect(cell, hole)) {}

  void Run(std::vector<HeightSample>& samples) {
    if (boundary_.known.empty()) return;  // the plan starts such a cluster at this hole: see the service
    for (const int32_t v : boundary_.unknown) {
      const RimVertex& vertex = cell_.vertices[v];
      double sum = 0;
      int lines = 0;
      for (const int axis : {0, 1}) {
        if ((vertex.lines & (1 << axis)) == 0) continue;
        sum += Profile(axis, vertex.position[axis]).At(vertex.position[1 - axis]);
        ++lines;
      }
      samples.push_back({vertex.seam_vertex, sum / lines});
    }
  }

 private:
  // The profile on the line where axis `axis` has value `line`.
  const LineProfile& Profile(int axis, double line) {
    const auto key = std::make_pair(axis, std::llround(line * 100));
    const auto it = profiles_.find(key);
    if (it != profiles_.end()) return it->second;
    std::vector<Projection> all;
    double size = 0;
    for (const int32_t v : boundary_.known) {
      const RimVertex& vertex = cell_.vertices[v];
      all.push_back({vertex.position[1 - axis], std::abs(vertex.position[axis] - line), HeightOf(cell_, boundary_, v)});
      size += vertex.size;
    }
    const double bin = std::max(size / static_cast<double>(all.size()), 1e-6);
    return profiles_.emplace(key, LineProfile(std::move(all), bin, cell_.lattice_step)).first->second;
  }

  const CellHoles& cell_;
  const HoleBoundary boundary_;
  std::map<std::pair<int, int64_t>, LineProfile> profiles_;
};

}  // namespace

std::vector<HeightSample> SampleHeights(const CellHoles& cell) {
  std::vector<HeightSample> samples;
  for (const CellHole& hole : cell.holes) {
    if (hole.open) HoleSampler(cell, hole).Run(samples);
  }
  return samples;
}

}  // namespace tilemend
