#include "taut/io/deck/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <istream>
#include <optional>
#include <streambuf>
#include <unordered_set>
#include <utility>

#include "taut/io/deck/yaml_brackets.hpp"
#include "taut/io/deck/yaml_words.hpp"
#include "taut/units/parse.hpp"

namespace taut::io {
namespace {

/// Ends the reading at a mistake behind which nothing can be understood, or nothing needs to be.
struct Stop {
  Diagnostic mistake;
};

/// Gives the scanner its text in pieces. The scanner looks far ahead before it says anything (all of "[[[[..." if there
/// is no end to it) and keeps a token of some 200 bytes for each character of it: what it takes between two values is
/// limited here.
class MeteredText : public std::streambuf {
 public:
  explicit MeteredText(SourcePtr source, std::string_view text) : source_(std::move(source)), text_(text) {}
  void value_was_read() { at_last_value_ = given_; }

 protected:
  int_type underflow() override {
    if (given_ - at_last_value_ > longest_value) {
      throw Stop{at({.source = source_, .offset = at_last_value_, .width = 1},
                    fmt::format("more than {} kB from here on without a complete value", longest_value / 1024U))};
    }
    const std::size_t size = std::min(piece, text_.size() - given_);
    if (size == 0) return traits_type::eof();
    char* const first = const_cast<char*>(text_.data()) + given_;  // an input buffer only reads
    setg(first, first, first + size);
    given_ += size;
    return traits_type::to_int_type(*first);
  }

 private:
  static constexpr std::size_t piece = 4096;
  SourcePtr source_;
  std::string_view text_;
  std::size_t given_ = 0;
  std::size_t at_last_value_ = 0;
};

constexpr std::string_view core_tag = "tag:yaml.org,2002:";

/// Builds the tree from the events of the scanner.
class Builder : public YAML::EventHandler {
 public:
  Builder(Document& document, std::string_view text, MeteredText& meter)
      : document_(document), text_(text), meter_(meter) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!complete_) return;
    const std::size_t at_byte = offset(mark);
    const bool marked = text_.substr(at_byte, 3) == "---";
    throw Stop{at(spot(at_byte), marked ? "a second document begins here: a deck is one document"
                                        : "this does not belong to what stands above: check the indentation")};
  }
  void OnDocumentEnd() override { complete_ = true; }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    count(0);
    Node n;
    n.spot = spot_of_null(mark);
    finish(std::move(n));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse_anchor(mark, 1);
    count(0);
    Node n;
    n.spot = spot(offset(mark));
    finish(std::move(n));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag, Node::Kind::scalar);
    count(value.size());
    Node n;
    n.kind = Node::Kind::scalar;
    n.text = value;
    n.quoted = tag == "!" || tag == "tag:yaml.org,2002:str";
    n.spot = spot(offset(mark));
    measure(n);
    last_end_ = n.spot.offset + n.spot.width;
    finish(std::move(n));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    begin(mark, tag, anchor, Node::Kind::sequence, style);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    begin(mark, tag, anchor, Node::Kind::map, style);
  }
  void OnMapEnd() override { end(); }

  /// The quote that opens a text which the scanner found no end of: the first one behind the last value.
  std::size_t open_quote(std::size_t from_end) const {
    for (std::size_t i = last_end_; i < text_.size(); ++i) {
      const bool begins = i == 0 || std::string_view(" \t\r\n[{,:").find(text_[i - 1]) != std::string_view::npos;
      if (begins && (text_[i] == '"' || text_[i] == '\'')) return i;
    }
    return from_end;
  }

 private:
  /// A map or list that is not complete yet.
  struct Open {
    Node node;
    std::optional<Entry> entry;  ///< map: the entry whose key was read and whose value comes next
    bool block = false;          ///< written by indentation, not in brackets
    bool drop = false;           ///< that entry is a mistake already reported
    std::unordered_set<std::string> keys;
  };

  std::size_t offset(const YAML::Mark& mark) const {
    return mark.pos < 0 ? 0 : std::min(static_cast<std::size_t>(mark.pos), text_.size());
  }
  Spot spot(std::size_t at_byte, std::size_t width = 1) const {
    return {.source = document_.source, .offset = at_byte, .width = width};
  }
  void mistake(const Spot& where, std::string message) { add(document_.mistakes, where, std::move(message)); }

  /// Every value passes here: the limits of the whole deck.
  void count(std::size_t text_size) {
    meter_.value_was_read();
    if (++values_ > most_values) {
      throw Stop{{.file = document_.source->name,
                  .place = {.line = 1, .column = 1},
                  .message = fmt::format("more than {} values in one deck", most_values),
                  .source_line = {},
                  .width = 1}};
    }
    text_size_ += text_size;
    if (text_size_ > most_text) {
      throw Stop{
          {.file = document_.source->name,
           .place = {.line = 1, .column = 1},
           .message = fmt::format("more than {} MB of text in the values of one deck", most_text / 1024U / 1024U),
           .source_line = {},
           .width = 1}};
    }
  }

  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor == YAML::NullAnchor) return;
    mistake(spot(offset(mark)),
            "anchors (&) and aliases (*) are not used in decks: write the value out, or include it");
  }

  void refuse_tag(const YAML::Mark& mark, std::string_view tag, Node::Kind kind) {
    if (tag.empty() || tag == "?" || tag == "!") return;
    const std::string_view name = tag.substr(0, core_tag.size()) == core_tag ? tag.substr(core_tag.size()) : "";
    const std::array<std::string_view, 5> scalars = {"str", "int", "float", "bool", "null"};
    const bool fits = kind == Node::Kind::map        ? name == "map"
                      : kind == Node::Kind::sequence ? name == "seq"
                                                     : std::find(scalars.begin(), scalars.end(), name) != scalars.end();
    if (!fits) mistake(spot(offset(mark)), "tags (!) are not used in decks: quote a text that begins with '!'");
  }

  /// An empty value has the place of its key, an empty item that of its dash; `~` and `null` have their own.
  Spot spot_of_null(const YAML::Mark& mark) {
    const std::size_t at_byte = offset(mark);
    if (!open_.empty() && open_.back().entry) {
      const Spot& key = open_.back().entry->key_spot;
      if (at_byte == key.offset && open_.back().block) {
        mistake(key, fmt::format("{} stands alone: a key is followed by ': ' and its value", in_quotes(key_text())));
        open_.back().drop = true;
      }
      if (!is_null_word(at_byte)) return key;
    }
    if (is_null_word(at_byte)) return spot(at_byte, text_[at_byte] == '~' ? 1 : 4);
    if (open_.empty() && at_byte < text_.size() && text_[at_byte] == ',') {
      throw Stop{at(spot(at_byte), "a ',' can't stand here")};
    }
    std::size_t back = std::min(at_byte, text_.size());
    while (back > 0 && std::string_view(" \t\r\n").find(text_[back - 1]) != std::string_view::npos) --back;
    return spot(back > 0 && text_[back - 1] == '-' ? back - 1 : at_byte);
  }
  const std::string& key_text() const { return open_.back().entry->key; }
  bool is_null_word(std::size_t at_byte) const {
    const std::string_view word = text_.substr(at_byte, 4);
    return word.substr(0, 1) == "~" || word == "null" || word == "Null" || word == "NULL";
  }

  /// Finds how far the scalar reaches in the text, and whether it stands there letter by letter.
  void measure(Node& n) {
    const std::size_t from = n.spot.offset;
    const char first = from < text_.size() ? text_[from] : ' ';
    const bool has_quotes = n.quoted && (first == '"' || first == '\'');
    if (has_quotes) {
      const std::size_t close = closing_quote(from, first);
      if (close == std::string_view::npos) throw Stop{at(n.spot, "a quoted text that is never closed")};
      n.spot.width = close - from + 1;
      n.literal = text_.substr(from + 1, close - from - 1) == n.text;
    } else {
      n.literal = !n.quoted && text_.substr(from, n.text.size()) == n.text;
      n.spot.width = n.literal ? std::max<std::size_t>(1, n.text.size()) : 1;
    }
    const auto control = std::find_if(n.text.begin(), n.text.end(), [](char c) {
      const auto b = static_cast<unsigned char>(c);
      return (b < 0x20U && c != '\n' && c != '\t') || b == 0x7FU;
    });
    if (control != n.text.end()) mistake(n.spot, "a control character in a text");
  }

  std::size_t closing_quote(std::size_t from, char quote) const {
    for (std::size_t i = from + 1; i < text_.size(); ++i) {
      if (quote == '"' && text_[i] == '\\') {
        ++i;
      } else if (text_[i] == quote) {
        if (quote == '"' || i + 1 == text_.size() || text_[i + 1] != '\'') return i;
        ++i;
      }
    }
    return std::string_view::npos;
  }

  void begin(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Node::Kind kind,
             YAML::EmitterStyle::value style) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag, kind);
    count(0);
    if (open_.size() == static_cast<std::size_t>(deepest_nesting)) {
      throw Stop{at(spot(offset(mark)), fmt::format("nested deeper than {}", deepest_nesting))};
    }
    open_.emplace_back();
    open_.back().node.kind = kind;
    open_.back().node.spot = spot(offset(mark));
    open_.back().block = style == YAML::EmitterStyle::Block;
  }

  void end() {
    Node done = std::move(open_.back().node);
    open_.pop_back();
    meter_.value_was_read();
    finish(std::move(done));
  }

  void finish(Node n) {
    if (open_.empty()) {
      document_.root = std::move(n);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.kind == Node::Kind::sequence) {
      parent.node.items.push_back(std::move(n));
    } else if (!parent.entry) {
      take_key(parent, std::move(n));
    } else {
      parent.entry->value = std::move(n);
      if (!parent.drop) parent.node.entries.push_back(std::move(*parent.entry));
      parent.entry.reset();
    }
  }

  void take_key(Open& map, Node n) {
    map.drop = true;
    if (n.kind != Node::Kind::scalar) {
      mistake(n.spot, fmt::format("a key is a text, not {}", kind_text(n)));
    } else if (with_plain_spaces(n.text).starts_with(' ') && !n.text.starts_with(' ')) {
      mistake(n.spot, "a no-break or thin space stands before this key: write plain spaces");
    } else if (!map.keys.insert(n.text).second) {
      mistake(n.spot, fmt::format("the key {} stands here a second time", in_quotes(n.text)));
    } else {
      map.drop = false;
    }
    map.entry = Entry{.key = std::move(n.text), .key_spot = n.spot, .value = {}};
  }

  Document& document_;
  std::string_view text_;
  MeteredText& meter_;
  std::vector<Open> open_;
  bool complete_ = false;
  std::size_t last_end_ = 0;
  std::size_t values_ = 0;
  std::size_t text_size_ = 0;
};

/// What to say of a mistake that the scanner met at `offset`: it may have begun long before, with a bracket or a quote
/// that is not closed; what was reported of the text behind that is not meant.
Stop scanner_stop(Document& document, std::string_view text, std::size_t offset, const std::string& message,
                  const Builder& builder) {
  if (message == YAML::ErrorMsg::EOF_IN_SCALAR)
    return Stop{yaml_mistake(document.source, builder.open_quote(offset), message)};
  auto begun = unclosed_bracket(text);
  if (!begun || begun->offset > offset) begun = long_quote_before(text, offset);
  if (!begun) return Stop{yaml_mistake(document.source, offset, message)};
  Diagnostic mistake = at({.source = document.source, .offset = begun->offset, .width = 1}, begun->words);
  const auto behind = [&](const Diagnostic& d) { return d.place.line >= mistake.place.line; };
  document.mistakes.erase(std::remove_if(document.mistakes.begin(), document.mistakes.end(), behind),
                          document.mistakes.end());
  return Stop{std::move(mistake)};
}

/// Reads the first document and makes sure that there is no second.
void read_events(Document& document, std::string_view text) {
  MeteredText meter(document.source, text);
  std::istream stream(&meter);
  Builder builder(document, text, meter);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& e) {
    const std::size_t offset = e.mark.pos < 0 ? 0 : static_cast<std::size_t>(e.mark.pos);
    throw scanner_stop(document, text, offset, e.msg, builder);
  }
}

}  // namespace

tl::expected<Document, Diagnostics> parse(std::string_view text, SourcePtr source) {
  Diagnostics unreadable = check_text(source);
  if (!unreadable.empty()) return tl::unexpected(std::move(unreadable));
  Document document;
  document.source = std::move(source);
  const auto fail = [&](Diagnostic d) {
    add(document.mistakes, std::move(d));
    return tl::unexpected(std::move(document.mistakes));
  };
  try {
    read_events(document, text);
  } catch (const Stop& stop) {
    return fail(stop.mistake);
  }
  if (document.root.kind == Node::Kind::null && document.mistakes.empty()) {
    return fail({.file = document.source->name,
                 .place = {.line = 1, .column = 1},
                 .message = "there is nothing in it",
                 .source_line = {},
                 .width = 1});
  }
  if (document.root.spot.source == nullptr) document.root.spot = {.source = document.source, .offset = 0, .width = 1};
  return document;
}

tl::expected<Document, Diagnostics> parse(std::string_view text, std::string name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  auto source = std::make_shared<Source>();
  source->name = std::move(name);
  source->reading = std::make_shared<Reading>();
  // one byte more than allowed is enough to refuse it
  source->text = std::string(text.substr(0, largest_deck + 1));
  return parse(source->text, SourcePtr(source));
}

}  // namespace taut::io
