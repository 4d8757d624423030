// AppendOsgb and DropOsgbTriangles.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_encode.h"
#include "common/codec/osgb/osgb_file.h"
#include "common/codec/osgb/osgb_parse.h"
#include "common/codec/osgb/osgb_patch_check.h"
#include "common/codec/osgb/osgb_splice.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr uint32_t kListOfTriangles = 4;  // GL_TRIANGLES

absl::Status CheckPatch(const OsgbLayout& layout, const OsgbPatch& patch, size_t index, const std::string& name) {
  if (patch.geode < 0 || static_cast<size_t>(patch.geode) >= layout.geodes.size()) {
    return OsgbPatchError(
        name, index, absl::StrCat("the file has ", layout.geodes.size(), " osg::Geode, none with index ", patch.geode));
  }
  const auto geode = static_cast<size_t>(patch.geode);
  if (!layout.geodes[geode].has_list)
    return OsgbPatchError(name, index, absl::StrCat("osg::Geode ", geode, " is empty, or a child of an osg::PagedLOD"));
  return CheckOsgbPatch(patch, layout.file.geodes[geode].translation, index, name);
}

absl::Status CheckSizes(const OsgbLayout& layout, std::span<const OsgbPatch> patches, const std::string& name) {
  uint64_t bytes = 0;
  for (const OsgbPatch& patch : patches) bytes += BytesOfOsgbPatch(patch);
  if (bytes > INT32_MAX) return absl::InvalidArgumentError(absl::StrCat(name, ": the file would be over 2 GiB"));
  const uint64_t ids = uint64_t{kOsgbIdsOfGeometry} * patches.size();
  if (std::max(layout.max_object_id, layout.max_array_id) + ids > UINT32_MAX) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": no ids are left for new objects"));
  }
  return absl::OkStatus();
}

// The bytes of the triangles of `site` that stay. Precondition: a list of triangles by index.
std::string KeptIndices(std::string_view bytes, const OsgbPrimitiveSite& site, const std::vector<bool>& drop) {
  const size_t triangle_bytes = 3 * size_t{site.index_bytes};
  const auto first = static_cast<size_t>(site.first_triangle);
  std::string kept;
  for (size_t k = 0; k < static_cast<size_t>(site.triangle_count); ++k) {
    if (!drop[first + k]) kept += bytes.substr(site.data_offset + k * triangle_bytes, triangle_bytes);
  }
  return kept;
}

// Takes the dropped triangles out of one primitive set.
absl::Status DropFrom(const OsgbPrimitiveSite& site, std::string_view bytes, const std::vector<bool>& drop,
                      const std::string& name, OsgbSplice& splice) {
  const auto begin = drop.begin() + site.first_triangle;
  const auto dropped = std::count(begin, begin + site.triangle_count, true);
  if (dropped == 0) return absl::OkStatus();
  const bool is_list = site.mode == kListOfTriangles && site.index_bytes > 0;
  if (!is_list && dropped < site.triangle_count) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": byte ", site.count_offset, ": ", dropped, " of ", site.triangle_count,
                     " triangles cannot be taken out of a primitive set that is no list of triangles by index"));
  }
  if (site.index_bytes == 0) {
    splice.SetNumber(site.count_offset, 0);
    return absl::OkStatus();
  }
  const std::string kept = is_list ? KeptIndices(bytes, site, drop) : "";
  splice.SetNumber(site.count_offset, static_cast<uint32_t>(kept.size() / site.index_bytes));
  splice.Replace(site.data_offset, size_t{site.count} * site.index_bytes, kept, site.bracket);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::string> AppendOsgb(std::string_view bytes, std::span<const OsgbPatch> patches,
                                       const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const OsgbLayout layout, ParseOsgb(bytes, name));
  TILEMEND_RETURN_IF_ERROR(CheckSizes(layout, patches, name));
  for (size_t i = 0; i < patches.size(); ++i) TILEMEND_RETURN_IF_ERROR(CheckPatch(layout, patches[i], i, name));
  std::vector<size_t> order(patches.size());
  std::iota(order.begin(), order.end(), size_t{0});
  // By place. Lists may end at one place; then what goes into the inner one, which begins later, comes first.
  std::ranges::stable_sort(order, {}, [&](size_t i) {
    const OsgbGeodeSite& site = layout.geodes[static_cast<size_t>(patches[i].geode)];
    return std::pair(site.end_offset, std::numeric_limits<size_t>::max() - site.count_offset);
  });
  std::vector<uint32_t> added(layout.geodes.size());
  OsgbEncoding encoding{.version = layout.file.version,
                        .bracket_bytes = layout.bracket_bytes,
                        .next_object_id = layout.max_object_id + 1,
                        .next_array_id = layout.max_array_id + 1};
  OsgbSplice splice(bytes, layout);
  for (const size_t i : order) {
    const auto geode = static_cast<size_t>(patches[i].geode);
    const OsgbGeodeSite& site = layout.geodes[geode];
    const auto count = static_cast<uint32_t>(LoadOsgbNumber(bytes.data() + site.count_offset, sizeof(uint32_t)));
    splice.SetNumber(site.count_offset, count + ++added[geode]);
    splice.Replace(site.end_offset, 0, EncodeOsgbGeometry(patches[i], layout.file.geodes[geode].translation, encoding),
                   site.bracket);
  }
  return std::move(splice).Finish(name);
}

absl::StatusOr<std::string> DropOsgbTriangles(std::string_view bytes, const std::vector<bool>& drop,
                                              const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const OsgbLayout layout, ParseOsgb(bytes, name));
  if (drop.size() != layout.file.triangles.size()) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": ", drop.size(), " marks for ", layout.file.triangles.size(), " triangles"));
  }
  OsgbSplice splice(bytes, layout);
  for (const OsgbPrimitiveSite& site : layout.primitives) {
    TILEMEND_RETURN_IF_ERROR(DropFrom(site, bytes, drop, name, splice));
  }
  return std::move(splice).Finish(name);
}

}  // namespace tilemend
