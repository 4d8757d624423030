#include "worker/check/tile_change.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace tilemend {
namespace {

// The bits of all that makes a triangle what it is.
using FaceKey = std::array<uint64_t, 10>;

FaceKey KeyOf(const LookedMesh& tile, int32_t t) {
  FaceKey key;
  for (size_t k = 0; k < 3; ++k) {
    std::memcpy(&key[3 * k], tile.mesh.points[tile.mesh.triangles[t][k]].data(), 3 * sizeof(double));
  }
  key[9] = tile.looks.empty() ? 0 : tile.looks[t];
  return key;
}

// Takes out of both lists what is in both: they have triangles of `before` and `after`, and stay rising.
void MatchInAnyOrder(const LookedMesh& before, const LookedMesh& after, TileChange& change) {
  struct Entry {
    FaceKey key;
    int32_t triangle;
    bool operator<(const Entry& other) const { return key != other.key ? key < other.key : triangle < other.triangle; }
  };
  std::vector<Entry> gone, found;
  for (const int32_t t : change.missing) gone.push_back({KeyOf(before, t), t});
  for (int32_t t = 0; t < std::ssize(change.added); ++t) {
    if (change.added[t]) found.push_back({KeyOf(after, t), t});
  }
  std::sort(gone.begin(), gone.end());
  std::sort(found.begin(), found.end());
  change.missing.clear();
  size_t next = 0;
  for (const Entry& entry : gone) {
    while (next < found.size() && found[next].key < entry.key) ++next;
    if (next < found.size() && found[next].key == entry.key) {
      change.added[found[next++].triangle] = false;
    } else {
      change.missing.push_back(entry.triangle);
    }
  }
  std::sort(change.missing.begin(), change.missing.end());
}

// Compares bits.
template <typename Value>
bool BeginsWith(const std::vector<Value>& all, const std::vector<Value>& first) {
  return first.size() <= all.size() &&
         (first.empty() || std::memcmp(all.data(), first.data(), first.size() * sizeof(Value)) == 0);
}

}  // namespace

TileChange CompareTiles(const LookedMesh& before, const LookedMesh& after) {
  TileChange change;
  change.added.assign(after.mesh.triangles.size(), true);
  const auto count = static_cast<int32_t>(before.mesh.triangles.size());
  if (BeginsWith(after.mesh.points, before.mesh.points) && BeginsWith(after.mesh.triangles, before.mesh.triangles) &&
      before.looks.empty() == after.looks.empty() &&
      BeginsWith(after.looks, before.looks)) {  // the fills were appended
    std::fill_n(change.added.begin(), count, false);
    change.added_count = std::ssize(change.added) - count;
    return change;
  }
  int32_t next = 0;
  for (int32_t t = 0; t < count; ++t) {
    if (next < std::ssize(change.added) && KeyOf(before, t) == KeyOf(after, next)) {
      change.added[next++] = false;
    } else {
      change.missing.push_back(t);
    }
  }
  if (!change.missing.empty()) MatchInAnyOrder(before, after, change);
  change.added_count = std::count(change.added.begin(), change.added.end(), true);
  return change;
}

}  // namespace tilemend
