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
#include "taut/report/page_one.hpp"
#include "taut/report/sections.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

namespace mustache = kainjow::mustache;

/// Sections that a reader may fold away: those of several pages.
bool folds(const Section& s) { return s.id != "errors" && s.id != "warnings" && s.id != "assumptions"; }

mustache::data section_list(const std::vector<Section>& all, const HtmlOptions& options) {
  mustache::data list{mustache::data::type::list};
  int number = 1;  // page 1
  for (const Section& s : all) {
    const bool appendix = s.id == "appendix";
    mustache::data one;
    one.set("id", s.id);
    one.set("title", s.numbered ? fmt::format("{} {}", ++number, s.title) : s.title);
    one.set("html", s.html);
    one.set("folds", folds(s));
    one.set("open", !appendix || options.appendix);
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

/// At the foot of each printed page: which calculation it belongs to.
std::string foot_text(const Result& r) {
  std::string text = fmt::format("taut {}", version);
  if (!r.deck_name.empty()) text += fmt::format(" \u00B7 {}", shortened(clean(r.deck_name), 60));
  if (!r.deck_hash.empty()) text += fmt::format(" \u00B7 {}", shortened(clean(r.deck_hash), 64));
  return text;
}

}  // namespace

std::string to_html(const Result& r, const HtmlOptions& options) {
  const std::string title = clean(title_of(r));
  constexpr PrintedSheet a4{}, a3{.width = 263, .height = 381};
  const PageOne first = page_one(r, options.paper == Paper::a3 ? a3 : a4);
  mustache::data page;
  page.set("title", title);
  page.set("page_one", first.html);
  page.set("sections", section_list(sections(r, first.figures), options));
  page.set("version", std::string(version));
  page.set("css", packed(embedded::page_css) + packed(embedded::figure_css));
  page.set("paper", std::string(options.paper == Paper::a3 ? "A3" : "A4"));
  page.set("sheet", std::string(options.paper == Paper::a3 ? "381mm" : "258mm"));  // what the margins leave, less 1 mm
  if (!options.appendix) page.set("without_appendix", true);
  page.set("running", css_string(shortened(title, 90)));
  page.set("foot", css_string(foot_text(r)));
  page.set("math_font", base64(embedded::math_font));
  page.set("italic_font", base64(embedded::italic_font));
  mustache::mustache view{std::string(embedded::page_template)};
  expects(view.is_valid(), "the page template is well formed");
  return view.render(page);
}

}  // namespace taut::report
