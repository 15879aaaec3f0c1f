#include "web/answers.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "taut/app/explain/schema.hpp"
#include "taut/io/deck/source.hpp"
#include "taut/io/json.hpp"
#include "taut/report/html.hpp"
#include "web/deck_places.hpp"
#include "web/page_json.hpp"

namespace taut::web {
namespace {

using Json = nlohmann::ordered_json;

/// An asked deck has a map of texts in a map. What is nested deeper takes a hundred times its size to read.
constexpr int deepest = 3;

std::string normal(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

/// Out of the folder that the names of decks begin in.
bool leads_out(const std::string& path) {
  const std::string plain = normal(path);
  return plain.starts_with("/") || plain == ".." || plain.starts_with("../");
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void drop_patterns(Json& node) {
  if (node.is_object()) {
    if (node.contains("pattern") && node["pattern"].is_string()) node.erase("pattern");
    for (auto& [_, value] : node.items()) drop_patterns(value);
  } else if (node.is_array()) {
    for (Json& value : node) drop_patterns(value);
  }
}

}  // namespace

AskedDeck asked_deck(std::string_view json) {
  try {
    const Json asked = Json::parse(json, [](int depth, Json::parse_event_t, const Json&) {
      if (depth > deepest) throw std::invalid_argument("no deck: it is nested too deep");
      return true;
    });
    AskedDeck deck;
    deck.text = asked.at("text").get<std::string>();
    deck.name = asked.value("name", deck.name);
    const Json files = asked.value("files", Json::object());
    if (!files.is_object()) throw std::invalid_argument("no deck: its files are no map");
    for (const auto& [name, text] : files.items()) {
      if (!leads_out(name)) deck.files[normal(name)] = text.get<std::string>();
    }
    deck.set = asked.value("set", deck.set);
    return deck;
  } catch (const Json::exception& e) {
    throw std::invalid_argument(fmt::format("no deck: {}", e.what()));
  }
}

std::string to_json(const AskedDeck& deck) {
  return dumped({{"text", deck.text}, {"name", deck.name}, {"files", deck.files}, {"set", deck.set}});
}

app::Job job_of(const AskedDeck& deck, io::FileReader beyond) {
  auto read = [files = deck.files,
               beyond = std::move(beyond)](const std::string& path) -> tl::expected<std::string, io::Unreadable> {
    const auto found = files.find(normal(path));
    if (found != files.end()) return found->second;
    if (beyond) return beyond(path);
    return tl::unexpected(io::Unreadable{
        .message = fmt::format("{} can't be read: No such file or directory", io::in_quotes(path)), .missing = true});
  };
  return {.text = deck.text, .name = deck.name, .set = deck.set, .progress = {}, .read = std::move(read)};
}

std::string answer_of(const Result& result, const std::string& text) {
  return fmt::format("{{\"page\":{},\"places\":{}}}", to_page(result), places_of(text));
}

std::string failure(std::string_view what) { return dumped({{"failure", what}}); }

std::string part_of(const Result& result, std::string_view what) {
  if (what == "report") return report::to_html(result);
  if (what == "pictures") return pictures_of(result);
  if (what == "json") return io::to_json(result);
  return {};
}

std::string page_schema() {
  Json all = Json::parse(app::schema_text());
  drop_patterns(all);
  return all.dump();
}

}  // namespace taut::web
