#include "taut/report/steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/report/text/mathml.hpp"
#include "taut/report/text/quantity.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::size_t most_bytes = 220'000;

/// What a line of the page holds, in multiples of the font size of formulas.
constexpr double line_width = 34;

/// Pieces of a line, each a <math> that the browser may put on the next line; a piece that is too wide for any line is
/// set smaller, down to half the size.
std::string flow(const std::string& head, const std::vector<Piece>& pieces) {
  std::string out;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double size = std::max(0.5, line_width / std::max(line_width, pieces[i].width));
    const std::string style = size < 1 ? fmt::format(" style=\"font-size:{:.2f}em\"", 1.1 * size) : "";
    out += fmt::format("{}<math displaystyle=\"true\"{}>{}{}</math>", i > 0 ? "<wbr>" : "", style, i == 0 ? head : "",
                       pieces[i].mathml);
  }
  return out;
}

/// "138865 N = 138.86 kN": the SI value that the substituted numbers give, then as shown elsewhere.
std::string value_html(const Step& s, const Display& display) {
  const ShownUnit shown = shown_unit(s.unit, display);
  const std::string symbol(s.unit.symbol);
  const bool same = shown.name.empty() || shown.name == symbol;
  std::string last = fmt::format("<b>{}</b>", escape(quantity_shown(s.value, s.unit, display, 6)));
  if (same) return last;
  const std::string si = unit_text(symbol);
  return fmt::format("{} {} = {}",
                     number_mathml(s.value).find("msup") == std::string::npos
                         ? escape(number_shown(s.value, 6))
                         : fmt::format("<math>{}</math>", number_mathml(s.value)),
                     escape(si), last);
}

std::string reference_html(const Step& s) {
  std::string out = "<div class=\"ref\">";
  if (!s.eq.empty()) out += fmt::format("<span class=\"eq\">({})</span>", escape(s.eq));
  const std::string source = source_without_number(s);
  if (!source.empty()) out += fmt::format("<span class=\"src\">{}</span>", prose_html(source));
  return out + "</div>";
}

std::string equation_html(const Step& s, const Display& display) {
  const std::string left = symbol_mathml(s.symbol);
  const std::string equals = "<mo>=</mo>";
  if (!s.formula || s.formula->op == Op::number) {  // a value that nothing is put into
    return fmt::format("<div class=\"f\"><math>{}</math> = {}</div>", left, value_html(s, display));
  }
  std::string lines;
  lines += fmt::format("<div class=\"f\">{}</div>", flow(left + equals, mathml_pieces(s.formula, Leaves::symbols)));
  const std::string result = fmt::format("<span class=\"r\">= {}</span>", value_html(s, display));
  const std::string numbers =
      s.formula->op != Op::symbol ? flow(equals, mathml_pieces(s.formula, Leaves::numbers)) : "";
  lines += fmt::format("<div class=\"n\">{} {}</div>", numbers, result);
  return lines;
}

std::string root_html(const Step& s, const Display& display) {
  const std::string zero = " <math><mo>=</mo><mn>0</mn></math>";
  std::string lines;
  lines += fmt::format("<div class=\"f\">{}{}</div>", flow({}, mathml_pieces(s.formula, Leaves::symbols)), zero);
  lines +=
      fmt::format("<div class=\"n\">{}{}</div>", flow({}, mathml_pieces(s.formula, Leaves::numbers, s.symbol)), zero);
  lines += fmt::format("<div class=\"n\">solved for <math>{}</math> <span class=\"r\">= {}</span></div>",
                       symbol_mathml(s.symbol), value_html(s, display));
  return lines;
}

std::string given_html(const Step& s, const Display& display) {
  return fmt::format("<span class=\"with\" title=\"{}\">{} = {}</span>", escape(s.words), symbol_html(s.symbol),
                     escape(quantity_shown(s.value, s.unit, display, 6)));
}

std::string step_html(const Step& s, const Display& display) {
  switch (s.kind) {
    case Step::Kind::heading:
      return fmt::format("<h3>{}</h3>\n", prose_html(s.words));
    case Step::Kind::note:
      return fmt::format("<p class=\"note\">{}</p>\n", prose_html(s.words));
    case Step::Kind::given:
      return given_html(s, display);
    case Step::Kind::root:
    case Step::Kind::equation:
      break;
  }
  const bool corrected = s.eq.ends_with('*');
  const std::string words = s.words.empty() ? "" : fmt::format("<div class=\"w\">{}</div>", prose_html(s.words));
  const std::string lines = s.kind == Step::Kind::root && s.formula ? root_html(s, display) : equation_html(s, display);
  return fmt::format("<div class=\"step{}\"><div class=\"lines\">{}{}</div>{}</div>\n", corrected ? " corrected" : "",
                     words, lines, reference_html(s));
}

}  // namespace

std::string source_without_number(const Step& s) {
  std::string_view number = s.eq;
  if (!number.empty() && number.back() == '*') number.remove_suffix(1);
  const std::string tail = fmt::format(", ({})", number);
  std::string source = s.source;
  if (!number.empty() && source.ends_with(tail)) source.resize(source.size() - tail.size());
  return source;
}

std::string steps_html(const Result& r) {
  if (r.steps.empty()) return {};
  const Display display = display_of(r);
  std::string out = "<p class=\"hint\">Numbers are put in as SI values (N, m, Pa, kg, s; angles in radians).</p>\n";
  bool in_given = false;
  for (std::size_t i = 0; i < r.steps.size(); ++i) {
    const Step& s = r.steps[i];
    const bool given = s.kind == Step::Kind::given;
    if (given && !in_given) out += "<p class=\"givens\">With ";
    if (given && in_given) out += "; ";
    if (!given && in_given) out += "</p>\n";
    in_given = given;
    out += step_html(s, display);
    if (out.size() > most_bytes && i + 1 < r.steps.size()) {
      if (in_given) out += "</p>\n";
      in_given = false;
      out += fmt::format("<p class=\"cut\">{} more lines are left out here; all of them are in result.json.</p>\n",
                         r.steps.size() - i - 1);
      break;
    }
  }
  if (in_given) out += "</p>\n";
  return out;
}

}  // namespace taut::report
