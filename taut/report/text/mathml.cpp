#include "taut/report/text/mathml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/report/text/formula_width.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr std::string_view times = "<mo lspace=\".22em\" rspace=\".22em\">⋅</mo>";
constexpr std::string_view thin_space = "<mspace width=\".2em\"/>";
constexpr std::string_view minus_sign = "<mo form=\"prefix\" lspace=\"0\" rspace=\"0\">−</mo>";
/// A line of a calculation is far shorter; this only keeps a formula gone wild from filling the page.
constexpr int most_nodes = 4000;

/// Parentheses grow with what stands in them; around a plain line they keep the size of the letters.
std::string fenced(std::string_view open, std::string_view inside, std::string_view close) {
  const bool tall = inside.find("<mfrac") != std::string_view::npos ||
                    inside.find("<msqrt") != std::string_view::npos || inside.find("<mroot") != std::string_view::npos;
  const std::string_view grows = tall ? "" : " stretchy=\"false\"";
  return fmt::format(
      "<mrow><mo form=\"prefix\"{0} lspace=\"0\" rspace=\"0\">{1}</mo>{2}<mo form=\"postfix\"{0} lspace=\"0\" "
      "rspace=\"0\">{3}</mo></mrow>",
      grows, open, inside, close);
}

std::string one(const std::string& inside) { return fmt::format("<mrow>{}</mrow>", inside); }

bool is_power_of_ten_text(double x) { return fmt::format("{:.6g}", x).find('e') != std::string::npos; }

std::string function_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> spelt{
      {{"asin", "arcsin"}, {"acos", "arccos"}, {"atan", "arctan"}, {"asinh", "arsinh"}, {"atanh", "artanh"}}};
  const auto* at = std::find_if(spelt.begin(), spelt.end(), [&](const auto& s) { return s.first == name; });
  return fmt::format("<mi>{}</mi>", at == spelt.end() ? escape(name) : std::string(at->second));
}

class Writer {
 public:
  Writer(Leaves leaves, std::string_view unknown) : leaves_(leaves), unknown_(unknown) {}

  /// The elements of a node, without a row around them.
  std::string write(const FormulaNode& n) {
    if (++nodes_ > most_nodes) return "<mo>…</mo>";
    switch (n.op) {
      case Op::number:
        return number_mathml(n.value);
      case Op::symbol:
        return shows_symbol(n) ? symbol_mathml(n.name) : number_mathml(n.value);
      case Op::add:
        return left(n, 1) + "<mo>+</mo>" + right(n, 2);
      case Op::subtract:
        return left(n, 1) + "<mo>−</mo>" + right(n, 2);
      case Op::multiply:
        return left(n, 2) + std::string(between(*n.arguments[0], *n.arguments[1])) + right(n, 2);
      case Op::divide:
        return fmt::format("<mfrac>{}{}</mfrac>", one(write(*n.arguments[0])), one(write(*n.arguments[1])));
      case Op::negate:
        return std::string(minus_sign) + right(n.arguments[0], 2);
      case Op::power:
        return power(n);
      case Op::call:
        return call(n);
    }
    return {};
  }

  /// Dot where two numbers would run together, thin space between letters.
  std::string_view between(const FormulaNode& a, const FormulaNode& b) const {
    const bool dot = leaves_ == Leaves::numbers || starts_with_number(b) || ends_open(a);
    return dot ? times : thin_space;
  }
  /// `n` as the right argument of something that binds like `least`.
  std::string right(const Formula& n, int least) {
    const bool parentheses = binds(*n) < least || starts_with_sign(*n);
    return parentheses ? fenced("(", write(*n), ")") : write(*n);
  }
  std::string left(const Formula& n, int least) { return binds(*n) < least ? fenced("(", write(*n), ")") : write(*n); }

 private:
  bool shows_symbol(const FormulaNode& n) const {
    return leaves_ == Leaves::symbols || (!unknown_.empty() && n.name == unknown_);
  }
  bool is_number(const FormulaNode& n) const { return n.op == Op::number || (n.op == Op::symbol && !shows_symbol(n)); }
  std::string left(const FormulaNode& n, int least) { return left(n.arguments[0], least); }
  std::string right(const FormulaNode& n, int least) { return right(n.arguments[1], least); }

  /// As `binding`, with the value in place of a symbol, and fractions as closed as a symbol.
  int binds(const FormulaNode& n) const {
    if (n.op == Op::divide) return 5;
    if (is_number(n) && std::signbit(n.value)) return 3;
    return n.op == Op::symbol ? 5 : binding(n);
  }
  bool starts_with_sign(const FormulaNode& n) const {
    if (n.op == Op::negate || (is_number(n) && std::signbit(n.value))) return true;
    const bool inherits = n.op == Op::multiply || n.op == Op::add || n.op == Op::subtract;
    return inherits && binds(*n.arguments[0]) >= binds(n) && starts_with_sign(*n.arguments[0]);
  }
  bool starts_with_number(const FormulaNode& n) const {
    if (n.op == Op::number) return n.value != std::numbers::pi;
    if (n.op == Op::multiply || n.op == Op::power) return starts_with_number(*n.arguments[0]);
    return false;
  }
  /// "sin(x)" before a factor, or "f(...)" after a lone letter, could be misread without a dot.
  static bool ends_open(const FormulaNode& n) {
    if (n.op == Op::call) return n.name != "sqrt" && n.name != "cbrt" && n.name != "abs" && n.name != "hypot";
    return n.op == Op::multiply && ends_open(*n.arguments[1]);
  }

  std::string power(const FormulaNode& n) {
    const FormulaNode& base = *n.arguments[0];
    const bool closed = base.op == Op::symbol || base.op == Op::number;
    const bool split = is_number(base) && (std::signbit(base.value) || is_power_of_ten_text(base.value));
    const std::string inside = write(base);
    return fmt::format("<msup>{}{}</msup>", closed && !split ? one(inside) : fenced("(", inside, ")"),
                       one(write(*n.arguments[1])));
  }

  std::string square(const Formula& f) {
    return write(FormulaNode{.op = Op::power, .value = 0, .name = {}, .arguments = {f, make_number(2)}});
  }

  std::string call(const FormulaNode& n) {
    if (n.name == "sqrt") return fmt::format("<msqrt>{}</msqrt>", write(*n.arguments[0]));
    if (n.name == "cbrt") return fmt::format("<mroot>{}<mn>3</mn></mroot>", one(write(*n.arguments[0])));
    if (n.name == "abs") return fenced("|", write(*n.arguments[0]), "|");
    if (n.name == "hypot" && n.arguments.size() == 2) {
      return fmt::format("<msqrt>{}<mo>+</mo>{}</msqrt>", square(n.arguments[0]), square(n.arguments[1]));
    }
    std::string inside;
    for (const Formula& a : n.arguments) {
      if (!inside.empty()) inside += "<mo separator=\"true\">,</mo>";
      inside += write(*a);
    }
    return function_name(n.name) + "<mo>&#x2061;</mo>" + fenced("(", inside, ")");
  }

  Leaves leaves_;
  std::string_view unknown_;
  int nodes_ = 0;
};

struct Term {
  const Formula* formula;
  Op op;  ///< add or subtract; multiply
};

/// a + b - c -> a, +b, -c. Only the left spine: what stands in parentheses stays together.
std::vector<Term> spine(const Formula& f, bool sum) {
  std::vector<Term> terms;
  const Formula* at = &f;
  const auto splits = [&](Op op) { return sum ? op == Op::add || op == Op::subtract : op == Op::multiply; };
  while (splits((*at)->op)) {
    terms.push_back({&(*at)->arguments[1], (*at)->op});
    at = &(*at)->arguments.front();
  }
  terms.push_back({at, sum ? Op::add : Op::multiply});
  std::reverse(terms.begin(), terms.end());
  return terms;
}

/// Collects the pieces of a line.
struct Breaker {
  Writer writer;
  Leaves leaves;
  std::string_view unknown;
  double most_width;
  std::vector<Piece> pieces;

  double width(const Formula& f) const { return formula_width(*f, leaves, unknown); }

  /// A product, broken before each factor; `sign` stands before it.
  void add_product(const Formula& f, const std::string& sign) {
    const auto factors = spine(f, false);
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Formula& t = *factors[i].formula;
      if (i == 0) {
        pieces.push_back({sign + (factors.size() == 1 ? writer.write(*t) : writer.left(t, 2)), width(t)});
        continue;
      }
      // The factor before decides with this one whether a dot is needed; it leads the new piece.
      const std::string before(writer.between(**factors[i - 1].formula, *t));
      if (width(t) > most_width && (t->op == Op::add || t->op == Op::subtract)) {
        add_parenthesis(t, before);
        continue;
      }
      pieces.push_back({before + writer.right(t, 2), width(t) + 1});
    }
  }

  /// A sum in parentheses that is too wide for a line: its terms on lines of their own, the parentheses as tall as what
  /// they hold, which a browser can't see across lines.
  void add_parenthesis(const Formula& f, const std::string& before) {
    const std::size_t from = pieces.size();
    const auto terms = spine(f, true);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const std::string sign =
          i == 0 ? "" : fmt::format("<mo form=\"infix\">{}</mo>", terms[i].op == Op::add ? "+" : "−");
      pieces.push_back({sign + (i == 0 ? writer.left(*terms[i].formula, 1) : writer.right(*terms[i].formula, 2)),
                        width(*terms[i].formula) + 1});
    }
    const bool tall = std::any_of(pieces.begin() + static_cast<std::ptrdiff_t>(from), pieces.end(),
                                  [](const Piece& p) { return p.mathml.find("<mfrac") != std::string::npos; });
    const std::string_view size = tall ? "minsize=\"2.6em\"" : "stretchy=\"false\"";
    pieces[from].mathml =
        fmt::format("{}<mo form=\"prefix\" {} symmetric=\"true\">(</mo>{}", before, size, pieces[from].mathml);
    pieces.back().mathml += fmt::format("<mo form=\"postfix\" {} symmetric=\"true\">)</mo>", size);
  }

  /// A term of a sum: whole when it fits on a line.
  void add_term(const Formula& f, const std::string& sign, bool first) {
    const double w = width(f) + 1;
    if (w > most_width && f->op == Op::multiply) return add_product(f, sign);
    pieces.push_back({sign + (first ? writer.left(f, 1) : writer.right(f, 2)), w});
  }
};

}  // namespace

std::string number_mathml(double x) {
  if (std::isnan(x)) return "<mtext>–</mtext>";
  if (x == std::numbers::pi) return "<mi>π</mi>";
  const std::string sign(std::signbit(x) && x != 0 ? minus_sign : "");
  if (std::isinf(x)) return sign + "<mn>∞</mn>";
  const std::string text = number_text(std::abs(x));
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return fmt::format("{}<mn>{}</mn>", sign, text);
  const int exponent = std::stoi(text.substr(e + 1));
  const std::string power = fmt::format("{}<mn>{}</mn>", exponent < 0 ? minus_sign : "", std::abs(exponent));
  const std::string ten = fmt::format("<msup><mn>10</mn><mrow>{}</mrow></msup>", power);
  if (e == 1 && text[0] == '1') return sign + ten;
  return fmt::format("{}<mn>{}</mn><mo lspace=\".1em\" rspace=\".1em\">×</mo>{}", sign, text.substr(0, e), ten);
}

std::string to_mathml(const Formula& f, Leaves leaves, std::string_view unknown) {
  return f ? Writer(leaves, unknown).write(*f) : std::string{};
}

std::vector<Piece> mathml_pieces(const Formula& f, Leaves leaves, std::string_view unknown, double most_width) {
  if (!f) return {};
  Breaker b{
      .writer = Writer(leaves, unknown), .leaves = leaves, .unknown = unknown, .most_width = most_width, .pieces = {}};
  const bool sum = f->op == Op::add || f->op == Op::subtract;
  if (!sum) {
    b.add_product(f, "");
    return b.pieces;
  }
  const auto terms = spine(f, true);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const std::string sign =
        i == 0 ? "" : fmt::format("<mo form=\"infix\">{}</mo>", terms[i].op == Op::add ? "+" : "−");
    b.add_term(*terms[i].formula, sign, i == 0);
  }
  return b.pieces;
}

}  // namespace taut::report
