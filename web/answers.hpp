#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "taut/app/job.hpp"
#include "taut/calc/result.hpp"
#include "taut/io/file_reader.hpp"

/// What a page asks its engine and is answered, whether the engine runs in the browser (engine.cpp) or beside it
/// (serve.cpp). All texts are UTF-8.
namespace taut::web {

/// A deck as a page gives it.
struct AskedDeck {
  std::string text;
  std::string name = "deck.yaml";
  std::map<std::string, std::string> files = {};  ///< texts of what the deck names, by path
  std::vector<std::string> set = {};
};

/// Reads {text, name, files: {NAME: text}, set: [..]}; all but the text may be missing. A file whose name leads out of
/// the folder is left out: the deck then says that there is no such file. Throws std::invalid_argument for what is no
/// such object.
AskedDeck asked_deck(std::string_view json);

/// The same as JSON.
std::string to_json(const AskedDeck& deck);

/// The job of a deck. What it names is taken from its files, else from `beyond`; without that it is missing.
app::Job job_of(const AskedDeck& deck, io::FileReader beyond = {});

/// {page, places} of a result and the text of its deck, see page_json.hpp and deck_places.hpp.
std::string answer_of(const Result& result, const std::string& text);

/// {failure}: a bug of taut, or why there is no answer.
std::string failure(std::string_view what);

/// "report" (HTML), "json" (result.json) or "pictures" of a result; empty for other words.
std::string part_of(const Result& result, std::string_view what);

/// The schema of decks without the patterns of texts: a form needs the keys and their words.
std::string page_schema();

}  // namespace taut::web
