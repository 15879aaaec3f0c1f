#include <emscripten.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "taut/app/explain/schema.hpp"
#include "taut/app/job.hpp"
#include "taut/base/version.hpp"
#include "taut/io/json.hpp"
#include "taut/report/html.hpp"
#include "web/deck_places.hpp"
#include "web/page_json.hpp"

/// The C interface of the engine for a page. All texts are UTF-8; an answer is valid until the next call.
namespace taut::web {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The deck's folder in the file system in memory.
constexpr const char* folder = "/deck";

// clang-format off
/// Tells the worker how far the calculation is; 0: it shall end.
EM_JS(int, tell_progress, (const char* what, double done, const char* words), {
  const tell = Module.onProgress;
  return tell && tell(UTF8ToString(what), done, UTF8ToString(words)) === false ? 0 : 1;
});
// clang-format on

std::string& answer() {
  static std::string text;
  return text;
}

std::optional<Result>& last() {
  static std::optional<Result> result;
  return result;
}

/// The files that a deck names, beside it. A name that leaves the folder is not made: the deck then says that there is
/// no such file.
void put_files(const Json& files, const std::string& deck) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  fs::create_directories(folder, ignored);
  const auto place_of = [&](const std::string& name) -> std::optional<fs::path> {
    const fs::path path = (fs::path(folder) / name).lexically_normal();
    if (!path.string().starts_with(std::string(folder) + "/")) return std::nullopt;
    fs::create_directories(path.parent_path(), ignored);
    return path;
  };
  place_of(deck);  // what it names may lead over its own folder: "../machines/line.yaml"
  for (const auto& [name, text] : files.items()) {
    const auto path = place_of(name);
    if (!path) continue;
    std::ofstream(*path, std::ios::binary) << text.get<std::string>();
  }
}

Result solved(const Json& request) {
  app::Job job;
  job.text = request.at("text").get<std::string>();
  job.name = request.value("name", "deck.yaml");
  if (request.contains("set")) job.set = request.at("set").get<std::vector<std::string>>();
  job.progress = [](const Progress& p) { return tell_progress(p.what.c_str(), p.done, p.words.c_str()) != 0; };
  put_files(request.value("files", Json::object()), job.name);
  fs::current_path(folder);
  return app::run(job);
}

/// A schema without the patterns of texts: a form needs the keys and their words.
void drop_patterns(Json& node) {
  if (node.is_object()) {
    if (node.contains("pattern") && node["pattern"].is_string()) node.erase("pattern");
    for (auto& [_, value] : node.items()) drop_patterns(value);
  } else if (node.is_array()) {
    for (Json& value : node) drop_patterns(value);
  }
}

std::string schema() {
  Json all = Json::parse(app::schema_text());
  drop_patterns(all);
  return all.dump();
}

std::string failure(const char* what) {
  return Json{{"failure", what}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace
}  // namespace taut::web

extern "C" {

/// `request`: {text, name, files: {NAME: text}, set: [..]}. The answer: {page, places}, see page_json.hpp and
/// deck_places.hpp, or {failure} for a bug of taut. The whole result is kept for taut_ask.
EMSCRIPTEN_KEEPALIVE const char* taut_solve(const char* request) {
  using namespace taut::web;
  try {
    const Json asked = Json::parse(request);
    last() = solved(asked);
    answer() = "{\"page\":" + to_page(*last()) + ",\"places\":" + places_of(asked.at("text").get<std::string>()) + "}";
  } catch (const std::exception& e) {
    last().reset();
    answer() = failure(e.what());
  }
  return answer().c_str();
}

/// `what`: of the last result "report" (HTML), "json" (result.json) or "pictures"; "schema", "version"; empty where
/// there is none.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* what) {
  using namespace taut::web;
  const std::string asked = what;
  try {
    answer().clear();
    if (asked == "version") answer() = taut::version;
    if (asked == "schema") answer() = schema();
    if (asked == "report" && last()) answer() = taut::report::to_html(*last());
    if (asked == "pictures" && last()) answer() = pictures_of(*last());
    if (asked == "json" && last()) answer() = taut::io::to_json(*last());
  } catch (const std::exception& e) {
    answer() = failure(e.what());
  }
  return answer().c_str();
}
}
