#include "taut/io/deck/yaml_brackets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace taut::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Goes through a text as far as brackets and quotes are concerned.
class BracketScan {
 public:
  explicit BracketScan(std::string_view text) : text_(text) {}

  struct Bracket {
    char kind = '{';
    std::size_t at = 0;
  };
  struct Quote {
    std::size_t from = 0, to = 0;  ///< of its quotes; to: the text's end where it is never closed
  };

  std::vector<Bracket> open;
  std::vector<Quote> quotes;
  std::optional<Bracket> crossed;  ///< closed by the other kind, at `closed_at`
  std::size_t closed_at = 0;

  void run() {
    while (i_ < text_.size() && !crossed) {
      const char c = text_[i_];
      if (c == '\n') {
        new_line();
      } else if (is_blank(c) || c == '\r') {
        ++i_;
      } else if (c == '#' && (i_ == 0 || is_blank(text_[i_ - 1]) || text_[i_ - 1] == '\n')) {
        i_ = end_of_line();
      } else if (token_ && (c == '"' || c == '\'')) {
        quote(c);
      } else if ((c == '{' || c == '[') && (token_ || !open.empty())) {
        open.push_back({c, i_++});
        token_ = true;
      } else if ((c == '}' || c == ']') && !open.empty()) {
        close(c);
      } else if (token_ && open.empty() && (c == '|' || c == '>')) {
        skip_block();
      } else {
        token_ = begins_token(c);
        ++i_;
      }
    }
  }

 private:
  std::size_t end_of_line() const { return std::min(text_.find('\n', i_), text_.size()); }

  void new_line() {
    ++i_;
    line_ = i_;
    if (open.empty()) token_ = true;
  }

  /// Whether a value may begin behind this character.
  bool begins_token(char c) const {
    const char next = i_ + 1 < text_.size() ? text_[i_ + 1] : '\n';
    const bool space_next = is_blank(next) || next == '\n' || next == '\r';
    if (!open.empty() && c == ',') return true;
    return space_next && (c == ':' || (token_ && (c == '-' || c == '?')));
  }

  void quote(char kind) {
    Quote q{.from = i_, .to = text_.size()};
    for (++i_; i_ < text_.size(); ++i_) {
      if (kind == '"' && text_[i_] == '\\') {
        ++i_;
      } else if (text_[i_] == kind) {
        if (kind == '\'' && i_ + 1 < text_.size() && text_[i_ + 1] == '\'') {
          ++i_;
          continue;
        }
        q.to = i_++;
        break;
      }
    }
    quotes.push_back(q);
    token_ = false;
  }

  void close(char c) {
    const Bracket last = open.back();
    if ((c == '}') != (last.kind == '{')) {
      crossed = last;
      closed_at = i_;
      return;
    }
    open.pop_back();
    token_ = false;
    ++i_;
  }

  /// A block text reaches as far as lines are indented more than the one that it begins in.
  void skip_block() {
    const auto indent = [&](std::size_t at) {
      std::size_t k = at;
      while (k < text_.size() && text_[k] == ' ') ++k;
      return k - at;
    };
    const std::size_t own = indent(line_);
    for (i_ = end_of_line(); i_ < text_.size();) {
      line_ = i_ + 1;
      const std::size_t deep = indent(line_);
      const bool empty = line_ + deep >= text_.size() || text_[line_ + deep] == '\n';
      i_ = line_;
      if (!empty && deep <= own) break;
      i_ = end_of_line();
    }
    token_ = true;
  }

  std::string_view text_;
  std::size_t i_ = 0, line_ = 0;
  bool token_ = true;  ///< a value may begin here
};

std::size_t line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
}

}  // namespace

std::optional<Unclosed> unclosed_bracket(std::string_view text) {
  BracketScan scan(text);
  scan.run();
  if (!scan.quotes.empty() && scan.quotes.back().to >= text.size()) return std::nullopt;
  const auto partner = [](char kind) { return kind == '{' ? '}' : ']'; };
  if (scan.crossed) {
    const auto& bracket = *scan.crossed;
    return Unclosed{
        .offset = bracket.at,
        .words = fmt::format("this '{}' is not closed before the '{}' of line {}: a '{}' is missing", bracket.kind,
                             text[scan.closed_at], line_of(text, scan.closed_at), partner(bracket.kind))};
  }
  if (scan.open.empty()) return std::nullopt;
  const auto& bracket = scan.open.front();
  return Unclosed{
      .offset = bracket.at,
      .words = fmt::format("this '{}' is never closed: a '{}' is missing", bracket.kind, partner(bracket.kind))};
}

std::optional<Unclosed> long_quote_before(std::string_view text, std::size_t offset) {
  BracketScan scan(text);
  scan.run();
  std::optional<Unclosed> found;
  for (const auto& quote : scan.quotes) {
    if (quote.to > offset || quote.to >= text.size()) break;
    const std::size_t from = line_of(text, quote.from), to = line_of(text, quote.to);
    if (from == to || line_of(text, offset) != to) continue;
    found = Unclosed{.offset = quote.from,
                     .words = fmt::format("the text that begins with this {} ends in line {} only: is its closing "
                                          "quote missing?",
                                          text[quote.from], to)};
  }
  return found;
}

}  // namespace taut::io
