#include "common/codec/mtl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_format.h"
#include "common/codec/text.h"

namespace tilemend {
namespace {

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && IsSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && IsSpace(text.back())) text.remove_suffix(1);
  return text;
}

// Takes the first word off `text`.
std::string_view TakeWord(std::string_view& text) {
  text = Trimmed(text);
  const size_t end = static_cast<size_t>(std::find_if(text.begin(), text.end(), IsSpace) - text.begin());
  const std::string_view word = text.substr(0, end);
  text = Trimmed(text.substr(end));
  return word;
}

std::optional<double> NumberIn(std::string_view word) {
  const ParsedDouble number = ParseDoubleAt(word.data(), word.data() + word.size());
  if (number.stop != word.data() + word.size() || !std::isfinite(number.value)) return std::nullopt;
  return number.value;
}

bool IsMap(const std::string& statement) {
  if (statement == "map_aat") return false;  // a switch
  if (statement.starts_with("map_")) return true;
  constexpr std::array<std::string_view, 5> kOthers = {"bump", "disp", "decal", "refl", "norm"};
  return std::find(kOthers.begin(), kOthers.end(), statement) != kOthers.end();
}

// What remains of a map statement without its options: the name of the image.
std::string_view ImageName(std::string_view text) {
  constexpr std::array<std::string_view, 3> kUpToThreeNumbers = {"-o", "-s", "-t"};
  for (std::string_view rest = text; rest.starts_with('-');) {
    const std::string_view option = TakeWord(rest);
    const bool numbers =
        std::find(kUpToThreeNumbers.begin(), kUpToThreeNumbers.end(), option) != kUpToThreeNumbers.end();
    const int most = numbers ? 3 : option == "-mm" ? 2 : 1;
    for (int i = 0; i < most; ++i) {
      std::string_view after = rest;
      const std::string_view word = TakeWord(after);
      if (i > 0 && !NumberIn(word)) break;
      rest = after;
    }
    if (rest.empty()) return text;  // it is a name that begins so
    text = rest;
  }
  return text;
}

std::optional<Rgb> DiffuseIn(std::string_view text) {
  std::array<uint8_t, 3> channels{};
  for (uint8_t& channel : channels) {
    const std::optional<double> value = NumberIn(TakeWord(text));
    if (!value) return std::nullopt;
    channel = static_cast<uint8_t>(std::lround(std::clamp(*value, 0.0, 1.0) * 255));
  }
  return Rgb{channels[0], channels[1], channels[2]};
}

// Calls `use` with every line of `text`, whatever ends it, and its number.
template <class Use>
void ForEachLine(std::string_view text, Use use) {
  for (int64_t number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    use(text.substr(0, end), number);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
  }
}

}  // namespace

MtlFile ParseMtl(std::string_view text) {
  text.remove_prefix(TextStart(text));
  MtlFile file;
  std::set<std::string_view> images;
  ForEachLine(text, [&](std::string_view line, int64_t number) {
    const std::string statement = absl::AsciiStrToLower(std::string(TakeWord(line)));
    if (line.empty()) return;
    if (statement == "newmtl") {
      file.materials.push_back({std::string(line), {}, {}});
    } else if (statement == "kd" && !file.materials.empty()) {
      file.materials.back().diffuse = DiffuseIn(line);
    } else if (IsMap(statement)) {
      const std::string_view image = ImageName(line);
      if (images.insert(image).second) {
        file.images.emplace_back(image);
        file.image_lines.push_back(number);
      }
      if (statement == "map_kd" && !file.materials.empty()) file.materials.back().image = std::string(image);
    }
  });
  return file;
}

std::string AppendToMtl(std::string_view text, const std::vector<FillMaterial>& materials) {
  const std::string_view eol = LineEndingOf(text);
  std::set<std::string> known;
  for (MtlMaterial& material : ParseMtl(text).materials) known.insert(std::move(material.name));
  std::string out(text);
  if (!out.empty() && out.back() != '\n' && out.back() != '\r') out += eol;
  for (const FillMaterial& material : materials) {
    if (!known.insert(material.name).second) continue;
    constexpr double kFull = 255;
    const Rgb c = material.colour;
    const std::string colour = absl::StrFormat("%.6f %.6f %.6f", c.r / kFull, c.g / kFull, c.b / kFull);
    for (const std::string& line : {"newmtl " + material.name, "Ka " + colour, "Kd " + colour, std::string("Ks 0 0 0"),
                                    std::string("d 1"), std::string("illum 1")}) {
      (out += line) += eol;
    }
    if (!material.image.empty()) ((out += "map_Kd ") += material.image) += eol;
  }
  return out;
}

}  // namespace tilemend
