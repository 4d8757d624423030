#include "coordinator/plan/colour/hole_colours.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace tilemend {
namespace {

// Of the plan's vertices; where several tiles share one, that of the first which has a colour there.
std::vector<std::optional<Rgb>> VertexColours(const Plan& plan, const PlanInput& input) {
  std::vector<std::optional<Rgb>> colours(plan.vertices.size());
  for (const auto& [cell, record] : input.cells) {
    const auto vertices = plan.vertex_of_boundary.find(cell);
    if (record == nullptr || vertices == plan.vertex_of_boundary.end()) continue;
    const auto outline = record.Outline();
    for (size_t i = 0; i < std::min(vertices->second.size(), outline->colours.size()); ++i) {
      const int32_t v = vertices->second[i];
      if (v >= 0 && !colours[v]) colours[v] = outline->colours[i];
    }
  }
  return colours;
}

// The original vertices on the rims of the holes, each once.
std::vector<int32_t> RimOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::vector<int32_t> rim;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) continue;
      rim.push_back(s.from);
      rim.push_back(s.to);
    }
  }
  std::sort(rim.begin(), rim.end());
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  return rim;
}

class MedianColour {
 public:
  void Add(Rgb c) {
    ++count_;
    ++tally_[0][c.r];
    ++tally_[1][c.g];
    ++tally_[2][c.b];
  }

  // The lower of the two in the middle. None without a colour.
  std::optional<Rgb> Find() const {
    if (count_ == 0) return std::nullopt;
    return Rgb{MedianOf(tally_[0]), MedianOf(tally_[1]), MedianOf(tally_[2])};
  }

 private:
  using Tally = std::array<int64_t, 256>;

  uint8_t MedianOf(const Tally& tally) const {
    int64_t below = 0;
    size_t value = 0;
    while (2 * (below + tally[value]) < count_) below += tally[value++];
    return static_cast<uint8_t>(value);
  }

  int64_t count_ = 0;
  std::array<Tally, 3> tally_ = {};
};

// The holes by group.
std::map<std::pair<int, int32_t>, std::vector<int32_t>> GroupsOf(const Plan& plan) {
  std::map<std::pair<int, int32_t>, std::vector<int32_t>> groups;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    const auto id = static_cast<int32_t>(h);
    const std::pair<int, int32_t> group = hole.water >= 0     ? std::pair{0, hole.water}
                                          : hole.cluster >= 0 ? std::pair{1, hole.cluster}
                                                              : std::pair{2, id};
    groups[group].push_back(id);
  }
  return groups;
}

}  // namespace

std::vector<FillColour> ColourHoles(const Plan& plan, const PlanInput& input, const std::optional<Rgb>& water) {
  const std::vector<std::optional<Rgb>> of_vertices = VertexColours(plan, input);
  std::vector<FillColour> colours(plan.holes.size());
  for (const auto& [group, holes] : GroupsOf(plan)) {
    const int32_t body = plan.holes[holes.front()].water;
    const bool is_water = body >= 0 && plan.water[body].kind == BodyKind::kWater;
    MedianColour ground, all;
    for (const int32_t v : RimOf(plan, holes)) {
      if (!of_vertices[v]) continue;
      all.Add(*of_vertices[v]);
      if (!plan.vertices[v].on_object) ground.Add(*of_vertices[v]);
    }
    const std::optional<Rgb> seen = ground.Find() ? ground.Find() : all.Find();
    const std::optional<Rgb> known = is_water && water ? water : seen;
    const FillColour colour{holes.front(), known.value_or(is_water ? kWaterColour : kGroundColour), known.has_value(),
                            is_water};
    for (const int32_t h : holes) colours[h] = colour;
  }
  return colours;
}

}  // namespace tilemend
