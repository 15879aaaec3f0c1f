#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut::report {

/// Text from a deck or a message made harmless to print anywhere: control characters (ESC, NUL, ...) and switches of
/// the writing direction are dropped, line breaks and tabs become spaces, bytes that are not UTF-8 become U+FFFD.
std::string clean(std::string_view text);

/// Cleaned text for HTML or SVG, between tags or in a quoted attribute: & < > " ' as entities.
std::string escape(std::string_view text);

/// Cleaned text in a Markdown table cell or paragraph: | ` * < [ ] # and \ lose their meaning; `_` stays.
std::string escape_markdown(std::string_view text);

/// How many characters (code points) a text shows.
int length(std::string_view utf8);

/// At most `most` characters, the cut marked with "...".
std::string shortened(std::string_view utf8, int most);

/// Lines of at most `width` characters, broken at spaces; a longer word stays whole. At least one line.
std::vector<std::string> wrapped(std::string_view text, int width);

/// A text for `content: "..."` in a style sheet, quotes included; harmless inside <style>.
std::string css_string(std::string_view text);

/// Standard base 64, for data: addresses.
std::string base64(std::string_view bytes);

}  // namespace taut::report
