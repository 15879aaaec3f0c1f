#include "taut/report/html.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>

#include "taut/base/expects.hpp"
#include "taut/base/version.hpp"
#include "taut/report/embedded/figure_css.hpp"
#include "taut/report/embedded/italic_font.hpp"
#include "taut/report/embedded/math_font.hpp"
#include "taut/report/embedded/page_css.hpp"
#include "taut/report/embedded/page_template.hpp"
#include "taut/report/sections.hpp"
#include "taut/report/summary.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

namespace mustache = kainjow::mustache;

std::string_view mood_class(Mood m) {
  switch (m) {
    case Mood::good:
      return "good";
    case Mood::warning:
      return "warning";
    case Mood::bad:
      return "bad";
    case Mood::neutral:
      break;
  }
  return "neutral";
}

mustache::data section_list(const Result& r) {
  mustache::data list{mustache::data::type::list};
  for (const Section& s : sections(r)) {
    mustache::data one;
    one.set("id", s.id);
    one.set("title", s.title);
    one.set("html", s.html);
    list.push_back(one);
  }
  return list;
}

/// Drops the line breaks and the indentation of the style sheet's source.
std::string packed(std::string_view css) {
  std::string out;
  bool at_start = true;
  for (const char c : css) {
    if (c == '\n') at_start = true;
    if (c == '\n' || (at_start && c == ' ')) continue;
    at_start = false;
    out += c;
  }
  return out;
}

}  // namespace

std::string to_html(const Result& r) {
  const std::string title =
      clean(r.title.empty() ? (r.method_title.empty() ? "Calculation" : r.method_title) : r.title);
  const Banner v = banner(r);
  mustache::data page;
  page.set("title", title);
  page.set("method", r.method_title.empty() || r.title.empty() ? clean(r.method) : clean(r.method_title));
  page.set("source", clean(r.source));
  if (const std::string line = project_line(r.project); !line.empty()) page.set("project", clean(line));
  page.set("mood", std::string(mood_class(v.mood)));
  page.set("headline", clean(v.headline));
  page.set("icon", v.icon);
  page.set("detail", clean(v.detail));
  if (!v.scope.empty()) page.set("scope", clean(v.scope));
  page.set("sections", section_list(r));
  page.set("version", std::string(version));
  page.set("deck", clean(r.deck_name));
  page.set("hash", clean(r.deck_hash));
  page.set("set", clean(overrides_text(r)));
  page.set("css", packed(embedded::page_css) + packed(embedded::figure_css));
  page.set("running", css_string(shortened(title, 90)));
  page.set("math_font", base64(embedded::math_font));
  page.set("italic_font", base64(embedded::italic_font));
  mustache::mustache view{std::string(embedded::page_template)};
  expects(view.is_valid(), "the page template is well formed");
  return view.render(page);
}

}  // namespace taut::report
