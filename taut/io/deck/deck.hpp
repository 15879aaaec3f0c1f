#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/io/deck/document.hpp"
#include "taut/units/display.hpp"

namespace taut::io {

/// What stands around the input of a deck.
struct Deck {
  std::string title;
  Project project;
  std::string method;       ///< one of the methods; empty when the deck names none of them
  bool is_machine = false;  ///< the deck has `machine` and `analyses` in place of `method` and `input`
  Display display;
  std::optional<Node> others;  ///< of a method's deck: a map with the keys `checks`, `design`, `study` and `calibrate`
                               ///< alone, where it has any
  std::shared_ptr<const Reading> reading;  ///< what it names has been read into: includes now, other files later on
  Node parameters;                         ///< as the deck has them; `input` holds their values already
  Node input;  ///< always a map; empty at the deck's place when `input` is missing. Of a machine the deck's own map
               ///< with the keys `machine`, `analyses`, `checks`, `design`, `study` and
               ///< `calibrate` alone
};

/// The keys that a deck may have at its top.
const std::vector<std::string>& deck_keys();

/// The units of `display:`; those of print where there is none. Mistakes are added with their place.
Display read_display(const Node& root, Diagnostics& mistakes);

/// A deck as one document: its text with what it includes, and with the values that are set over it. Expressions stand
/// in it as they were written. The arguments are those of read_deck; empty when the text is not YAML, or
/// lacks a file that it includes.
std::optional<Document> read_document(std::string_view text, const std::string& name,
                                      const std::vector<std::string>& set, Diagnostics& mistakes, FileReader read = {});

/// Everything that comes before a method reads its input: YAML, `include:`, the overrides of `--set`, `parameters:`,
/// and the keys `taut`, `title`, `project`, `method`, `display`, `input` (or `machine`, `analyses`). All mistakes are
/// added to `mistakes`; when nothing can be read (not YAML, an include that can't be read) the result is empty. A deck
/// with mistakes may still be read further, to find more of them; it must not be run.
///   name: what messages call the text; a relative `include` is looked for in its folder (in the current one for
///         a name without a folder)
///   set: "input.cases[0].falls=6" and so on, in order
///   methods: names that `method:` may have
///   read: gives the files that the deck names, now and later on; empty: they are read from disk
std::optional<Deck> read_deck(std::string_view text, const std::string& name, const std::vector<std::string>& set,
                              const std::vector<std::string>& methods, Diagnostics& mistakes, FileReader read = {});

/// The same from a document whose includes, overrides and parameters are done.
Deck read_deck(const Document& document, const std::vector<std::string>& methods, Diagnostics& mistakes);

}  // namespace taut::io
