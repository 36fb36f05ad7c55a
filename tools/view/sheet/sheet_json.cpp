#include "base/json.h"
#include "view/sheet/live_sheet.h"

#include <array>
#include <cstring>
#include <sstream>

namespace coif::view {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::array<float, kViewSettings>;

Numbers numbers_of(const ViewSettings& settings) {
  Numbers numbers;
  std::memcpy(numbers.data(), &settings, sizeof settings);
  return numbers;
}

std::string word_at(const std::string& words, float number) {
  std::istringstream text(words);
  std::string word;
  for (int i = 0; i <= int(number); ++i) std::getline(text, word, '|');
  return word;
}

/// The value for one row of controls_json().
Json value_of(const nlohmann::json& control, const Numbers& numbers) {
  const std::size_t at = control["at"], count = control["count"];
  if (control["kind"] == "choice") return word_at(control["words"], numbers[at]);
  if (count == 1) return numbers[at];
  Json values = Json::array();
  for (std::size_t i = at; i < at + count; ++i) values.push_back(numbers[i]);
  return values;
}

Json changed_settings(const nlohmann::json& controls, const Numbers& own, const Numbers& numbers) {
  Json changed = Json::object();
  for (const nlohmann::json& control : controls) {
    const std::size_t at = control["at"], count = control["count"];
    if (std::memcmp(&own[at], &numbers[at], count * sizeof(float)) == 0) continue;
    changed[control["name"].get<std::string>()] = value_of(control, numbers);
  }
  return changed;
}

/// Escapes text that would end the script element around the JSON.
std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

std::string sheet_json(const Asset& asset, const LiveSheet& sheet, TileSize size) {
  const nlohmann::json controls = nlohmann::json::parse(controls_json(asset, false));
  const Numbers own = numbers_of(settings_of(asset));
  Json galleries = Json::array();
  for (const LiveGallery& gallery : sheet.galleries) {
    Json tiles = Json::array();
    for (const LiveTile& tile : gallery.tiles) {
      Json moments = Json::array();
      for (const LiveMoment& moment : tile.moments) {
        moments.push_back({{"caption", moment.caption}, {"seconds", moment.seconds}});
      }
      tiles.push_back({{"caption", tile.caption},
                       {"settings", changed_settings(controls, own, numbers_of(tile.settings))},
                       {"moments", moments}});
    }
    galleries.push_back({{"title", gallery.title}, {"tiles", tiles}});
  }
  const Json json{{"width", size.width}, {"height", size.height}, {"note", sheet.note}, {"galleries", galleries}};
  return within_script(json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace coif::view
