#include "taut/report/text/formula_width.hpp"

#include <algorithm>

#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

constexpr double digit = 0.5;
constexpr double sign = 1.3;
constexpr double parentheses = 0.8;
constexpr double script = 0.72;
constexpr int deepest = 200;  ///< beyond, the rest of the tree adds nothing to a line that is far too long anyway

struct Ruler {
  Leaves leaves;
  std::string_view unknown;
  int nodes = 0;

  double number(double value) const { return digit * static_cast<double>(number_text(value).size()); }

  double symbol(const FormulaNode& n) const {
    if (leaves == Leaves::numbers && (unknown.empty() || n.name != unknown)) return number(n.value);
    double all = 0;
    for (const Run& r : symbol_runs(n.name)) {
      const bool small = r.style == Run::Style::subscript || r.style == Run::Style::subscript_variable;
      all += length(r.text) * (small ? 0.36 : 0.6);
    }
    return all;
  }

  double call(const FormulaNode& n, int depth) {
    double all = parentheses + digit * static_cast<double>(n.name.size());
    for (const Formula& a : n.arguments) all += width_of(*a, depth + 1) + 0.3;
    return all;
  }

  double sum_of(const FormulaNode& n, int depth, double between) {
    double all = between;
    for (const Formula& a : n.arguments) {
      all += width_of(*a, depth + 1);
      const bool closed = n.op == Op::multiply && (a->op == Op::add || a->op == Op::subtract);
      all += closed ? parentheses : 0;
    }
    return all;
  }

  double width_of(const FormulaNode& n, int depth) {
    if (depth > deepest || ++nodes > 4000) return 0;
    switch (n.op) {
      case Op::number:
        return number(n.value);
      case Op::symbol:
        return symbol(n);
      case Op::add:
      case Op::subtract:
        return sum_of(n, depth, sign);
      case Op::multiply:
        return sum_of(n, depth, leaves == Leaves::numbers ? 0.7 : 0.25);
      case Op::negate:
        return sum_of(n, depth, 0.7);
      case Op::divide:
        return 0.3 + std::max(width_of(*n.arguments[0], depth + 1), width_of(*n.arguments[1], depth + 1));
      case Op::power:
        return width_of(*n.arguments[0], depth + 1) + script * width_of(*n.arguments[1], depth + 1);
      case Op::call:
        return call(n, depth);
    }
    return 0;
  }
};

}  // namespace

double formula_width(const FormulaNode& node, Leaves leaves, std::string_view unknown) {
  return Ruler{.leaves = leaves, .unknown = unknown}.width_of(node, 0);
}

}  // namespace taut::report
