// The quality of many triangles, counted where they are and merged in any order.
#ifndef TILEMEND_COMMON_MESH_QUALITY_TALLY_H_
#define TILEMEND_COMMON_MESH_QUALITY_TALLY_H_

#include <array>
#include <cstdint>
#include <vector>

namespace tilemend {

// Triangles of a quality (TriangleQuality, triangle_shape.h) below this are poor.
inline constexpr double kPoorQuality = 0.2;

// A plain sum of triangles; all of it but `least` is in integers, so that merging in any order gives the same bits.
struct QualityTally {
  static constexpr int kBins = 200;

  int64_t triangles = 0;
  int64_t sum_millionths = 0;  // of qualities rounded to 1e-6
  double least = 1;
  std::array<int64_t, kBins> histogram{};  // bin k: k / kBins <= quality < (k + 1) / kBins; 1 is in the last
  int64_t poor = 0;
  int64_t poor_forced = 0;  // of these, those that no filler could avoid

  void Add(double quality, bool forced);
  void Merge(const QualityTally& other);

  // 0 without triangles.
  double Mean() const;
  // The quality below which a `share` (0 to 1) of the triangles lies, within 1 / kBins. 0 without triangles.
  double Quantile(double share) const;
};

// A tally without its empty bins, to keep many: one of few triangles takes some 100 bytes instead of 1,600.
class PackedTally {
 public:
  // Precondition: fewer than 2^31 triangles.
  explicit PackedTally(const QualityTally& tally);
  QualityTally Unpack() const;

 private:
  struct Bin {
    int32_t number, triangles;
  };

  int64_t sum_millionths_;
  double least_;
  int32_t triangles_, poor_, poor_forced_;
  std::vector<Bin> bins_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_QUALITY_TALLY_H_
