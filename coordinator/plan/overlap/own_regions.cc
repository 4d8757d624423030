#include "coordinator/plan/overlap/own_regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "common/mesh/rounding.h"
#include "coordinator/plan/overlap/chain_groups.h"
#include "coordinator/plan/overlap/link_parts.h"
#include "coordinator/plan/overlap/lost_region.h"
#include "coordinator/plan/overlap/outline_vertices.h"
#include "coordinator/plan/overlap/outline_walk.h"
#include "coordinator/plan/overlap/picture_edges.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/doubled_segments.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kClearance = 0.25;  // of its size: a new vertex is not nearer to the end of a chain

constexpr char kLost[] = "its boundary cannot be followed to the tile's own outline: pieces overlap too far there";

constexpr double kLeastSteps = 4;  // of the lattice: new vertices on an outline are not nearer to each other

// Seen from above.
double LengthOf(const Plan& plan, const std::vector<RimSegment>& segments) {
  double length = 0;
  for (const RimSegment& s : segments) {
    length += (plan.vertices[s.to].position - plan.vertices[s.from].position).head<2>().norm();
  }
  return length;
}

// Seen from above, the vertex of the segments that is nearest to a place.
int32_t NearestOf(const Plan& plan, const std::vector<RimSegment>& segments, const Point3& place) {
  const auto distance = [&](const RimSegment& s) {
    return (plan.vertices[s.from].position - place).head<2>().squaredNorm();
  };
  return std::ranges::min_element(segments, {}, distance)->from;
}

bool HaveCommon(const std::vector<Side>& a, const std::vector<Side>& b) {
  return std::ranges::any_of(a, [&](Side side) { return std::ranges::find(b, side) != b.end(); });
}

// Whether a link leads from the outline of one piece to that of another: the surface has no edge between the two.
bool AreAcross(const OutlineGap& gap, const Point3& from, const Point3& to) {
  const auto leaves = [&](const std::optional<int>& axis) {
    return axis && std::abs(to[*axis] - from[*axis]) > kMeetTolerance;
  };
  return leaves(gap.from_across) && leaves(gap.to_across);
}

// Makes one hole of two of a tile. What is left of `part` has no segments.
void Absorb(PlannedHole& part, PlannedHole& hole) {
  const auto own = static_cast<double>(hole.segments.size()), more = static_cast<double>(part.segments.size());
  hole.centre = (own * hole.centre + more * part.centre) / (own + more);  // as MeasureHole: of the segments
  hole.area += part.area;
  hole.perimeter += part.perimeter;
  hole.boundary_vertices += part.boundary_vertices;
  hole.projects &= part.projects;
  const bool reaches_rim = part.kind == HoleKind::kOpenII && hole.kind != HoleKind::kOpenII;
  if (reaches_rim || hole.kind == HoleKind::kClosed) {
    hole.kind = part.kind;
    hole.type = part.type;
    hole.single = part.single;
  }
  hole.segments.insert(hole.segments.end(), part.segments.begin(), part.segments.end());
  part.segments.clear();
}

// The chains of one tile's boundary that bound holes.
struct TileChains {
  std::vector<bool> cut, chain;  // as in JointTiles
  OutlineWalk walk;
  std::optional<PictureEdges> picture;  // of a tile with surface or area

  bool IsChain(size_t e) const { return chain[e] && !walk.on_outline[e]; }

  // The edges of the tile's chains that a segment of the plan is, or is a part of.
  std::vector<int32_t> EdgesOf(const RimSegment& s) const {
    std::vector<int32_t> edges;
    if (!picture) return edges;
    const std::optional<int32_t> whole = picture->Whole(s);
    if (whole && IsChain(*whole)) edges.push_back(*whole);
    if (s.seam) return edges;
    std::ranges::copy_if(picture->AtEnds(s), std::back_inserter(edges), [&](int32_t e) { return IsChain(e); });
    return edges;
  }

  // The segments that are edges of the tile which were not cut.
  std::vector<RimSegment> WholeSegments(const PlannedHole& hole) const {
    std::vector<RimSegment> whole;
    for (const RimSegment& s : hole.segments) {
      const std::optional<int32_t> edge = picture ? picture->Whole(s) : std::nullopt;
      if (edge && !cut[*edge]) whole.push_back(s);
    }
    return whole;
  }
};

std::vector<ChainGroup> GroupsOf(const std::vector<size_t>& holes, const Plan& plan, const SurveyRecord& record,
                                 const TileChains& chains) {
  std::vector<bool> is_chain(record.edges.size());
  for (size_t e = 0; e < is_chain.size(); ++e) is_chain[e] = chains.IsChain(e);
  std::vector<std::vector<int32_t>> edges_of_hole;
  for (const size_t h : holes) {
    std::vector<int32_t>& edges = edges_of_hole.emplace_back();
    for (const RimSegment& s : plan.holes[h].segments) {
      const std::vector<int32_t> of_segment = chains.EdgesOf(s);
      edges.insert(edges.end(), of_segment.begin(), of_segment.end());
    }
  }
  std::vector<ChainGroup> groups = GroupChains(record, is_chain, chains.walk.gaps, edges_of_hole);
  for (ChainGroup& group : groups) {
    for (size_t& h : group.holes) h = holes[h];
  }
  return groups;
}

std::vector<Side> SidesOf(const Plan& plan, const ClipSquare& square, int32_t v) {
  std::vector<Side> sides;
  for (const Side s : kSides) {
    if (plan.vertices[v].position[AxisOf(s)] == square.side[s]) sides.push_back(s);
  }
  return sides;
}

double PlaceOnOutline(const Point3& position, const std::vector<Side>& sides, const Outline& outline) {
  if (sides.size() == 1) return outline.PlaceOf(position, sides[0]);
  const bool east = sides[0] == kEast, north = sides[1] == kNorth;
  return outline.CornerPlace(north ? (east ? 2 : 3) : (east ? 1 : 0));
}

// The holes' vertices on the grid lines, around the tile's outline.
std::vector<VertexOnLine> VerticesOnLines(const Plan& plan, const PlannedHole& hole, const ClipSquare& square,
                                          const Outline& outline, const std::optional<PictureEdges>& picture) {
  std::map<int32_t, VertexOnLine> found;
  for (const RimSegment& s : hole.segments) {
    for (const int32_t v : {s.from, s.to}) {
      const std::vector<Side> sides = SidesOf(plan, square, v);
      if (sides.empty() || (picture && picture->IsOwn(v))) continue;
      VertexOnLine& at = found[v];
      const bool on_rim =
          at.on_rim || (!s.seam && HaveCommon(SidesOf(plan, square, s.from), SidesOf(plan, square, s.to)));
      at = {PlaceOnOutline(plan.vertices[v].position, sides, outline), v, sides, on_rim};
    }
  }
  std::vector<VertexOnLine> line;
  for (const auto& [v, at] : found) line.push_back(at);
  std::sort(line.begin(), line.end(), [](const VertexOnLine& a, const VertexOnLine& b) {
    return std::pair(a.place, a.vertex) < std::pair(b.place, b.vertex);
  });
  return line;
}

int32_t Nearest(double place, const std::vector<VertexOnLine>& line, const Outline& outline) {
  const double length = outline.Length();
  const auto distance = [&](const VertexOnLine& v) {
    const double d = std::fmod(std::abs(v.place - place), length);
    return std::min(d, length - d);
  };
  return std::min_element(line.begin(), line.end(),
                          [&](const VertexOnLine& a, const VertexOnLine& b) { return distance(a) < distance(b); })
      ->vertex;
}

const SurveyRecord& NoTile() {
  static const SurveyRecord none;
  return none;
}

// Gives a hole what bounds its own region, first `whole` of its segments. It may bound nothing, where a link runs back
// along the only edge. Pieces overlap, or part, by less than `reach` metres.
void Settle(const Plan& plan, double reach, std::vector<RimSegment> region, size_t whole, bool on_outline,
            PlannedHole& hole) {
  const bool is_own = whole < region.size();
  DropDoubled(region);
  const bool is_none = region.empty();
  if (is_none ? is_own && !IsSliver(plan, hole.segments, reach)
              : IsLostRegion(plan, hole.segments, region, on_outline)) {
    hole.failure = kLost;
  } else if (is_own && !is_none) {
    hole.own_regions = {std::move(region)};
  } else if (is_own || whole < hole.segments.size()) {
    hole.segments.clear();  // a sliver beside a line that no chain of the tile bounds, or where pieces just part
  }
}

// The regions of one cell.
class CellRegions {
 public:
  CellRegions(CellId cell, const GridLines& own, const JointTiles& joint, const std::vector<bool>& in_picture,
              const std::vector<size_t>& holes, Plan& plan)
      : cell_(cell),
        record_(joint.own.contains(cell) ? *joint.own.at(cell) : NoTile()),
        square_(joint.squares.at(cell)),
        in_picture_(in_picture),
        reach_(std::max(own.pieces.reach, kMeetTolerance)),
        plan_(plan),
        new_(cell, outline_, plan) {
    for (const Side s : kSides) outline_.side[s] = own.At(cell, s);
    std::vector<ChainPassage> passages;
    if (joint.own.contains(cell)) {
      chains_.cut = joint.cut.at(cell);
      chains_.chain = joint.chain.at(cell);
      std::vector<int32_t>& of = plan_.vertex_of_boundary[cell];
      of.resize(joint.records.at(cell).vertices.size(), -1);  // it may have none that bounds a hole
      chains_.picture.emplace(joint, cell, of);
      for (const size_t h : holes) {
        const std::vector<ChainPassage> of_hole = chains_.picture->PassagesOf(plan, plan.holes[h]);
        passages.insert(passages.end(), of_hole.begin(), of_hole.end());
      }
    }
    chains_.walk = WalkOutline(record_, chains_.chain, outline_, own.pieces.reach, passages);
  }

  // Of the holes of this cell. Those that one chain bounds become one; what is none stays without segments.
  void Lay(const std::vector<size_t>& holes) {
    for (const ChainGroup& members : GroupsOf(holes, plan_, record_, chains_)) {
      PlannedHole& first = plan_.holes[members.holes.front()];
      for (size_t i = 1; i < members.holes.size(); ++i) Absorb(plan_.holes[members.holes[i]], first);
      std::vector<RimSegment> region = chains_.WholeSegments(first);
      const size_t whole = region.size();
      for (const int32_t e : members.edges) AddEdge(record_.edges[e], first, region);
      const std::vector<VertexOnLine> line = VerticesOnLines(plan_, first, square_, outline_, chains_.picture);
      LinkParts link_parts(LengthOf(plan_, region), std::ssize(region));
      for (const OutlineGap& gap : members.gaps) AddGap(gap, first, line, link_parts, region);
      const bool is_at_outline = std::ranges::any_of(members.gaps, &OutlineGap::open);  // of the tile
      const bool is_ring = chains_.walk.all_open && !line.empty() && !is_at_outline;
      if (is_ring) AddRing(line, region);
      Settle(plan_, reach_, std::move(region), whole, is_ring || is_at_outline, first);
    }
  }

 private:
  int32_t PlanVertexOf(int32_t own) const { return plan_.vertex_of_boundary.at(cell_)[own]; }

  void AddEdge(const BoundaryEdge& e, const PlannedHole& hole, std::vector<RimSegment>& region) {
    const int32_t a = PlanVertexOf(e.to), b = PlanVertexOf(e.from);
    if (e.piece != kAreaPiece) return AddRim(a, b, region);
    for (const int32_t v : {a, b}) FollowPicture(v, hole);
    region.push_back({a, b, true});
  }

  // A vertex on the area's edge that no tile has inside its cell follows the nearest of the hole.
  void FollowPicture(int32_t v, const PlannedHole& hole) {
    PlanVertex& vertex = plan_.vertices[v];
    if (vertex.index >= 0 || vertex.follows >= 0 || in_picture_[v]) return;
    vertex.follows = NearestOf(plan_, hole.segments, vertex.position);
    vertex.size = plan_.vertices[vertex.follows].size;
  }

  void AddRim(int32_t a, int32_t b, std::vector<RimSegment>& region) {
    region.push_back({a, b, false});
    const double length = (plan_.vertices[b].position - plan_.vertices[a].position).norm();
    for (const int32_t v : {a, b}) {
      PlanVertex& vertex = plan_.vertices[v];
      if (!square_.Contains(vertex.position)) vertex.size = std::max(vertex.size, length);
    }
  }

  // From the end of one chain along the outline to the next, over new vertices beside those on the grid lines.
  void AddGap(const OutlineGap& gap, const PlannedHole& hole, const std::vector<VertexOnLine>& line,
              LinkParts& link_parts, std::vector<RimSegment>& region) {
    for (const int32_t e : gap.along) AddEdge(record_.edges[e], hole, region);
    const auto [own_from, own_to] = gap.link.value_or(std::pair(gap.from, gap.to));
    const int32_t from = PlanVertexOf(own_from), to = PlanVertexOf(own_to);
    if (from == to) return;
    std::vector<int32_t> way = {from};
    if (gap.open && !line.empty()) {
      const bool apart =
          gap.end - gap.begin > kClearance * std::min(plan_.vertices[from].size, plan_.vertices[to].size);
      const auto add_ahead = [&](int32_t end, double place) {
        const auto v = apart ? new_.Ahead(end, place, Nearest(place, line, outline_)) : std::nullopt;
        if (v) way.push_back(*v);
      };
      add_ahead(from, gap.begin);
      for (const int32_t v : Between(gap, line)) way.push_back(v);
      add_ahead(to, gap.end);
      Follow(from, Nearest(gap.begin, line, outline_));
      Follow(to, Nearest(gap.end, line, outline_));
    }
    if (way.size() == 1) AddLink(gap, to, hole, link_parts, way);
    way.push_back(to);
    for (size_t i = 0; i + 1 < way.size(); ++i) region.push_back({way[i], way[i + 1], true});
  }

  // New vertices between ends of chains of two pieces, as far apart as those of the rim; at least one half-way where
  // the surface may have an edge between the two. Between ends on outlines that cross the way goes along both. The edge
  // of the area has no heights: from there they follow the hole.
  //   end  the vertex that it leads to
  //   way  the first vertex
  void AddLink(const OutlineGap& gap, int32_t end, const PlannedHole& hole, LinkParts& link_parts,
               std::vector<int32_t>& way) {
    const PlanVertex from = plan_.vertices[way.back()], to = plan_.vertices[end];
    Point3 middle = (from.position + to.position) / 2;
    if (gap.from_across && gap.to_across && *gap.from_across != *gap.to_across) {
      middle[*gap.from_across] = from.position[*gap.from_across];
      middle[*gap.to_across] = to.position[*gap.to_across];
    }
    const double straight = (to.position - from.position).head<2>().norm();
    if (AreAcross(gap, from.position, to.position) && !link_parts.Wants(straight)) return;
    PlanVertex v = from;
    v.tile = cell_;
    v.index = -1;
    v.lines = 0;
    v.follows = -1;
    v.height_known = from.index >= 0 && to.index >= 0;
    for (const auto& [a, b] : {std::pair(from.position, middle), std::pair(middle, to.position)}) {
      const Point3 leg = b - a;
      const double length = leg.head<2>().norm();
      const int64_t parts = link_parts.Take(length);
      v.size = parts == 1 ? std::min(from.size, to.size) : length / static_cast<double>(parts);
      for (int64_t k = 1; k <= parts; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(parts);
        v.position = RoundedToLattice(Point3(a + share * leg), plan_.lattice_step);
        if (v.position == RoundedToLattice(plan_.vertices[way.back()].position, plan_.lattice_step) ||
            v.position == RoundedToLattice(to.position, plan_.lattice_step)) {
          continue;  // the ends may lie beside the lattice
        }
        if (!v.height_known) v.follows = NearestOf(plan_, hole.segments, v.position);
        way.push_back(static_cast<int32_t>(plan_.vertices.size()));
        plan_.vertices.push_back(v);
      }
    }
  }

  std::vector<int32_t> Between(const OutlineGap& gap, const std::vector<VertexOnLine>& line) {
    const double length = outline_.Length();
    std::map<double, int32_t> between;
    for (const VertexOnLine& v : line) {
      const double place = v.place >= gap.begin ? v.place : v.place + length;
      const bool corner = v.sides.size() == 2;
      const double size = plan_.vertices[v.vertex].size;
      const double after = kClearance * std::min(plan_.vertices[PlanVertexOf(gap.from)].size, size);
      const double before = kClearance * std::min(plan_.vertices[PlanVertexOf(gap.to)].size, size);
      const bool inside =
          corner ? place > gap.begin && place < gap.end : place > gap.begin + after && place < gap.end - before;
      if (inside) between.emplace(place, new_.Beside(v));
    }
    for (int c = 0; c < 8; ++c) {
      const double place = outline_.CornerPlace(c % 4) + (c >= 4 ? length : 0);
      if (place > gap.begin && place < gap.end && !between.contains(place)) {
        between.emplace(place, new_.AtCorner(c % 4, Nearest(place, line, outline_)));
      }
    }
    std::vector<int32_t> vertices;
    double last = -std::numeric_limits<double>::infinity();
    for (const auto& [place, v] : between) {
      if (place - last < kLeastSteps * plan_.lattice_step) continue;  // chains of two pieces cross the line there
      vertices.push_back(v);
      last = place;
    }
    return vertices;
  }

  void AddRing(const std::vector<VertexOnLine>& line, std::vector<RimSegment>& region) {
    std::map<double, int32_t> ring;
    for (const VertexOnLine& v : line) ring.emplace(v.place, new_.Beside(v));
    for (int c = 0; c < 4; ++c) {
      const double place = outline_.CornerPlace(c);
      if (!ring.contains(place)) ring.emplace(place, new_.AtCorner(c, Nearest(place, line, outline_)));
    }
    for (auto it = ring.begin(); it != ring.end(); ++it) {
      const auto next = std::next(it) == ring.end() ? ring.begin() : std::next(it);
      region.push_back({it->second, next->second, true});
    }
  }

  void Follow(int32_t end, int32_t source) {
    if (plan_.vertices[end].index >= 0 && plan_.vertices[end].follows < 0) plan_.vertices[end].follows = source;
  }

  const CellId cell_;
  const SurveyRecord& record_;
  const ClipSquare& square_;
  const std::vector<bool>& in_picture_;  // of each plan vertex of the joint tiles: whether it bounds a hole
  const double reach_;                   // metres: pieces overlap, or part, by less
  Plan& plan_;
  Outline outline_;
  OutlineVertices new_;
  TileChains chains_;
};

}  // namespace

void LayOwnRegions(const PlanInput& input, const GridLines& own, const JointTiles& joint, Plan& plan) {
  std::map<CellId, std::vector<size_t>> holes;
  std::vector<bool> in_picture(plan.vertices.size(), false);
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (plan.holes[h].failure.empty()) holes[plan.holes[h].cell].push_back(h);
    for (const RimSegment& s : plan.holes[h].segments) in_picture[s.from] = in_picture[s.to] = true;
  }
  for (const auto& [cell, of_cell] : holes) CellRegions(cell, own, joint, in_picture, of_cell, plan).Lay(of_cell);
  std::erase_if(plan.holes, [](const PlannedHole& hole) { return hole.segments.empty(); });
  std::erase_if(plan.vertex_of_boundary, [&](const auto& of) { return input.cells.at(of.first) == nullptr; });
  for (auto& [cell, vertices] : plan.vertex_of_boundary)
    vertices.resize(input.cells.at(cell).Outline()->vertices.size());
}

}  // namespace tilemend
