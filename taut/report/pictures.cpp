#include "taut/report/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/report/figure/any_figure.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

std::string caption_html(const FigureWords& w) {
  std::string out = "<figcaption>";
  if (!w.title.empty()) out += fmt::format("<b>{}</b> ", prose_html(w.title));
  if (!w.caption.empty()) out += prose_html(w.caption) + " ";
  if (!w.scale.empty()) out += escape(w.scale) + " ";
  if (!w.csv.empty()) out += fmt::format("<a href=\"{0}\">{0}</a>", escape(w.csv));
  return out + "</figcaption>";
}

int order_of(const Figure& f) {
  return is_turned(f) ? 3 : std::holds_alternative<Plot>(f) ? 2 : std::holds_alternative<Animation>(f) ? 1 : 0;
}

}  // namespace

const Figure* key_figure(const Result& r) {
  if (r.figures.empty()) return nullptr;
  const auto named = std::find_if(r.figures.begin(), r.figures.end(), [&](const Figure& f) {
    return !r.key_figure.empty() && words_of(f).name == r.key_figure;
  });
  return named == r.figures.end() ? &r.figures.front() : &*named;
}

std::string pictures_html(const std::vector<const Figure*>& figures, const Result& r, FiguresAbove& above) {
  const Display display = display_of(r);
  std::string out;
  above.listed.clear();
  for (const Figure* f : figures) {
    const std::string picture = live_figure(*f, display, above);
    if (picture.empty()) continue;
    const char* own = is_turned(*f) ? " class=\"landscape\"" : "";
    out += fmt::format("<figure{}>{}{}</figure>\n", own, picture, caption_html(words_of(*f)));
  }
  return out;
}

std::vector<const Figure*> figures_in_order(const Result& r) {
  std::vector<const Figure*> all;
  all.reserve(r.figures.size());
  for (const Figure& f : r.figures) all.push_back(&f);
  std::stable_sort(all.begin(), all.end(),
                   [](const Figure* a, const Figure* b) { return order_of(*a) < order_of(*b); });
  return all;
}

}  // namespace taut::report
