#include "worker/delivery/obj_delivery.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/codec/obj.h"

namespace tilemend {
namespace {

template <typename Number>
void AppendNumber(Number value, std::string& text) {
  char digits[32];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  text += ' ';
  text.append(digits, end);
}

std::string MaterialOf(const DeliverySurface& surface) {
  if (surface.image >= 0) return absl::StrCat("image_", surface.image);
  return absl::StrFormat("colour_%02x%02x%02x", surface.colour.r, surface.colour.g, surface.colour.b);
}

class ObjMaker {
 public:
  ObjMaker(const DeliveryTile& tile, const std::string& stem) : tile_(tile), stem_(stem) {}

  std::vector<DeliveryFile> Make() {
    obj_ = absl::StrCat("mtllib ", stem_, ".mtl\n");
    // Whether or not a face is left that has them.
    for (size_t i = 0; i < tile_.own_images; ++i) {
      DeliverySurface any;
      any.image = static_cast<int32_t>(i);
      AddMaterial(any, MaterialOf(any));
    }
    AddSurfaces(false);
    AddSurfaces(true);
    std::vector<DeliveryFile> files = {{stem_ + ".obj", std::move(obj_)}, {stem_ + ".mtl", std::move(mtl_)}};
    for (size_t i = 0; i < tile_.images.size(); ++i) {
      files.push_back({ImageName(static_cast<int32_t>(i)), tile_.images[i]});
    }
    return files;
  }

 private:
  std::string ImageName(int32_t image) const {
    return absl::StrCat(stem_, "_", image, ".", std::string(ImageEnding(tile_.images[static_cast<size_t>(image)])));
  }

  void AddMaterial(const DeliverySurface& surface, const std::string& name) {
    if (!materials_.insert(name).second) return;
    if (surface.image >= 0) {
      absl::StrAppend(&mtl_, "newmtl ", name, "\nKd 1 1 1\nmap_Kd ", ImageName(surface.image), "\n");
    } else {
      absl::StrAppendFormat(&mtl_, "newmtl %s\nKd %.6f %.6f %.6f\n", name, surface.colour.r / 255.0,
                            surface.colour.g / 255.0, surface.colour.b / 255.0);
    }
  }

  // Those that are filled, as a group, or the others.
  void AddSurfaces(bool are_filled) {
    bool is_first = are_filled;
    for (const DeliveryPiece& piece : tile_.pieces) {
      for (const DeliverySurface& surface : piece.surfaces) {
        if (surface.is_filled != are_filled) continue;
        if (std::exchange(is_first, false)) absl::StrAppend(&obj_, "g ", std::string(kFilledGroup), "\n");
        AddSurface(surface);
      }
    }
  }

  // Its number.
  int64_t AddPoint(const Point3& point) {
    obj_ += 'v';
    for (int k = 0; k < 3; ++k) AppendNumber(point[k], obj_);
    obj_ += '\n';
    return ++points_;
  }

  void AddSurface(const DeliverySurface& surface) {
    const std::string name = MaterialOf(surface);
    AddMaterial(surface, name);
    const int64_t first = points_ + 1;
    for (const Point3& point : surface.mesh.points) AddPoint(point);
    for (const std::array<float, 2>& uv : surface.uv) {
      obj_ += "vt";
      for (const float value : uv) AppendNumber(value, obj_);
      obj_ += '\n';
    }
    absl::StrAppend(&obj_, "usemtl ", name, "\n");
    for (const Triangle& triangle : surface.mesh.triangles) {
      std::array<int64_t, 3> numbers{};
      for (size_t k = 0; k < 3; ++k) {
        numbers[k] = first + triangle[k];
        // Readers leave out a face that names one vertex twice.
        if (std::find(numbers.begin(), numbers.begin() + k, numbers[k]) == numbers.begin() + k) continue;
        numbers[k] = AddPoint(surface.mesh.points[static_cast<size_t>(triangle[k])]);
      }
      obj_ += 'f';
      for (size_t k = 0; k < 3; ++k) {
        AppendNumber(numbers[k], obj_);
        if (!surface.uv.empty()) absl::StrAppend(&obj_, "/", places_ + triangle[k] + 1);
      }
      obj_ += '\n';
    }
    places_ += std::ssize(surface.uv);
  }

  const DeliveryTile& tile_;
  const std::string& stem_;
  std::string obj_, mtl_;
  std::set<std::string> materials_;
  int64_t points_ = 0, places_ = 0;  // that are written
};

}  // namespace

std::vector<DeliveryFile> ObjFilesOf(const DeliveryTile& tile, const std::string& stem) {
  return ObjMaker(tile, stem).Make();
}

}  // namespace tilemend
