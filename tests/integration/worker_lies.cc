#include "tests/integration/worker_lies.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

// Which vertices are on the first loop that does not reach the sides of the tile; empty: there is none.
std::vector<bool> InnerLoop(const SurveyRecord& record) {
  std::map<int32_t, int32_t> next;
  for (const BoundaryEdge& e : record.edges) next[e.from] = e.to;
  const auto at_side = [&](int32_t v) {
    const Point3& p = record.vertices[v].position;
    return p.x() == record.lo.x() || p.x() == record.hi.x() || p.y() == record.lo.y() || p.y() == record.hi.y();
  };
  for (const auto& [from, to] : next) {
    std::vector<bool> loop(record.vertices.size(), false);
    bool inner = !at_side(from);
    loop[from] = true;
    for (int32_t v = to; v != from && inner; v = next.at(v)) {
      loop[v] = true;
      inner = !at_side(v);
    }
    if (inner) return loop;
  }
  return {};
}

// The record without these vertices and what is at them, numbered anew.
SurveyRecord Without(const std::vector<bool>& hidden, const SurveyRecord& record) {
  SurveyRecord left = record;
  left.vertices.clear(), left.edges.clear(), left.band = {}, left.colours.clear();
  std::vector<int32_t> number;
  for (size_t v = 0; v < record.band.points.size(); ++v) {
    const bool boundary = v < hidden.size();
    number.push_back(boundary && hidden[v] ? -1 : static_cast<int32_t>(left.band.points.size()));
    if (number.back() < 0) continue;
    left.band.points.push_back(record.band.points[v]);
    if (boundary) left.vertices.push_back(record.vertices[v]);
  }
  std::map<int32_t, int32_t> pieces;
  for (const BoundaryEdge& e : record.edges) {
    if (hidden[e.from]) continue;
    const int32_t piece = pieces.try_emplace(e.piece, static_cast<int32_t>(pieces.size())).first->second;
    left.edges.push_back({number[e.from], number[e.to], piece});
  }
  for (const Triangle& t : record.band.triangles) {
    const bool stays = std::all_of(t.begin(), t.end(), [&](int32_t v) { return number[v] >= 0; });
    if (stays) left.band.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return left;
}

bool HideAHole(Survey& s) {
  const auto record = FromProto(s);
  EXPECT_TRUE(record.ok()) << record.status();
  const std::vector<bool> loop = InnerLoop(*record);
  if (loop.empty()) return false;
  const Survey before = s;
  s = ToProto(Without(loop, *record));
  s.set_digest(before.digest()), s.set_stamp(before.stamp());
  *s.mutable_witness() = before.witness(), *s.mutable_files() = before.files();
  return true;
}

std::vector<Lie> LiesInSurveys() {
  const auto lie = [](const char* name, std::function<bool(Survey&)> change) {
    return LieIn<Survey>(name, Stage::kSurvey, std::move(change));
  };
  const auto move = [](Survey& s, int i, double by) {
    s.mutable_vertices()->set_position(i, s.vertices().position(i) + by);
  };
  return {
      lie("MovesAVertexWithinTheTile",
          [=](Survey& s) {
            const double low = s.bounds(2), z = s.vertices().position(2);
            return move(s, 2, z - low > 0.01 ? (low - z) / 2 : 0.01), true;
          }),
      lie("CountsAVertexMore", [](Survey& s) { return s.set_vertex_count(s.vertex_count() + 1), true; }),
      lie("CountsATriangleLess", [](Survey& s) { return s.set_triangle_count(s.triangle_count() - 1), true; }),
      lie("HasTheOtherNumberType", [](Survey& s) { return s.set_float32(!s.float32()), true; }),
      lie("ExchangesTwoVertices",
          [](Survey& s) {
            const int32_t first = s.vertices().index(0);
            s.mutable_vertices()->set_index(0, s.vertices().index(1));
            return s.mutable_vertices()->set_index(1, first), true;
          }),
      lie("HidesAHole", HideAHole),
  };
}

// A file that the worker writes in place of the tile that it was asked for, and says so.
bool WriteInstead(const v1::AssembleInput& input, Tile& t, const std::string& bytes) {
  t.mutable_files(0)->set_bytes(static_cast<int64_t>(bytes.size()));
  t.mutable_files(0)->set_digest(FileDigest(bytes));
  return WriteFileAtomically(WrittenPath(input, t), bytes).ok();
}

std::vector<Lie> LiesInPatchedTiles() {
  const auto lie = [](const char* name,
                      const std::function<void(const std::string& original, std::string& bytes)>& change) {
    return LieOf<v1::AssembleInput, Tile>(name, Stage::kAssemble, [=](const v1::AssembleInput& input, Tile& t) {
      if (!input.has_patches() || input.tile().path().empty()) return false;
      const std::string original = ReadFile(input.tile().root() + "/" + input.tile().path()).value();
      std::string bytes = ReadFile(WrittenPath(input, t)).value();
      if (bytes.size() <= original.size()) return false;
      change(original, bytes);
      return WriteInstead(input, t, bytes);
    });
  };
  return {
      lie("ALargerTileThatIsAnother",
          [](const std::string& original, std::string& bytes) { bytes = original + std::string(1, 'x'); }),
      lie("AnOriginalVertexMoved",
          [](const std::string& /*original*/, std::string& bytes) {
            const size_t body = bytes.find("end_header\n") + 11;
            bytes[body] = static_cast<char>(bytes[body] ^ 1);
          }),
      lie("AFaceOfThePatchTurned",
          [](const std::string& /*original*/, std::string& bytes) {
            std::swap_ranges(bytes.end() - 13, bytes.end() - 9, bytes.end() - 9);
          }),
      lie("OneByteTooMany", [](const std::string& /*original*/, std::string& bytes) { bytes += 'x'; }),
      lie("OneByteTooFew", [](const std::string& /*original*/, std::string& bytes) { bytes.pop_back(); }),
  };
}

}  // namespace

std::vector<Lie> LiesOnTiles() {
  std::vector<Lie> all = LiesInSurveys();
  for (Lie& lie : LiesInPatchedTiles()) all.push_back(std::move(lie));
  return all;
}

}  // namespace tilemend
