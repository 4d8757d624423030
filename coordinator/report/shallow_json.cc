#include "coordinator/report/shallow_json.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// The values of a text as they come: those that are open, and what they hold.
class OpenLevels {
 public:
  explicit OpenLevels(const ShallowOptions& options) : options_(options) {}

  Json TakeWhole() { return std::move(whole_); }

  // The name of the value that comes next, in an object.
  void Name(std::string name) {
    if (too_deep_ == 0) open_.back().member = std::move(name);
  }

  // To the innermost level. False: reading is to stop, as below.
  bool Add(Json value) {
    if (options_.stop.stop_requested()) return false;
    if (too_deep_ > 0) return true;
    if (open_.empty()) {
      whole_ = std::move(value);
    } else if (Level& level = open_.back(); level.value.is_array()) {
      level.value.push_back(std::move(value));
    } else {
      level.value[std::move(level.member)] = std::move(value);
    }
    return true;
  }

  bool Open(Json::value_t type) {
    if (too_deep_ > 0 || open_.size() > static_cast<size_t>(kMostDepth)) {
      ++too_deep_;
    } else {
      open_.push_back({.value = Json(type)});
    }
    return !options_.stop.stop_requested();
  }

  bool Close() {
    if (too_deep_ > 0) {
      --too_deep_;
      return true;
    }
    Json value = std::move(open_.back().value);
    open_.pop_back();
    return (options_.keep && !options_.keep(static_cast<int>(open_.size()), value)) || Add(std::move(value));
  }

 private:
  // A list or an object whose end has not come.
  struct Level {
    Json value;
    std::string member = {};  // of an object: the name of the value that comes next
  };

  const ShallowOptions& options_;
  Json whole_;
  std::vector<Level> open_;  // the outermost first
  size_t too_deep_ = 0;      // levels that are open and left out
};

class ShallowReader : public nlohmann::json_sax<Json> {
 public:
  explicit ShallowReader(OpenLevels& levels) : levels_(levels) {}

  bool null() override { return levels_.Add(nullptr); }
  bool boolean(bool value) override { return levels_.Add(value); }
  bool number_integer(number_integer_t value) override { return levels_.Add(value); }
  bool number_unsigned(number_unsigned_t value) override { return levels_.Add(value); }
  bool number_float(number_float_t value, const string_t&) override { return levels_.Add(value); }
  bool string(string_t& value) override { return levels_.Add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // JSON has none
  bool start_object(size_t) override { return levels_.Open(Json::value_t::object); }
  bool end_object() override { return levels_.Close(); }
  bool start_array(size_t) override { return levels_.Open(Json::value_t::array); }
  bool end_array() override { return levels_.Close(); }
  bool key(string_t& name) override {
    levels_.Name(std::move(name));
    return true;
  }
  bool parse_error(size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  OpenLevels& levels_;
};

}  // namespace

Json ParseShallow(const std::string& text, const ShallowOptions& options) {
  OpenLevels levels(options);
  ShallowReader reader(levels);
  return Json::sax_parse(text, &reader) ? levels.TakeWhole() : Json(Json::value_t::discarded);
}

}  // namespace tilemend
