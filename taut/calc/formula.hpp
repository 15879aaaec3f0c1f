#pragma once
#include <memory>
#include <string>
#include <vector>

namespace taut {

/// Operation of a node of a formula.
enum class Op { number, symbol, add, subtract, multiply, divide, negate, power, call };

struct FormulaNode;
/// A formula as a shared, immutable tree; empty means "no formula".
using Formula = std::shared_ptr<const FormulaNode>;

/// number: `value`. symbol: `name` with its `value` when the formula was computed. power: base, exponent.
/// call: function `name` (sqrt, exp, cos, atan2, ...) of its arguments.
struct FormulaNode {
  Op op = Op::number;
  double value = 0;
  std::string name;
  std::vector<Formula> arguments;
};

Formula make_number(double value);
Formula make_symbol(std::string name, double value);
Formula make_node(Op op, std::vector<Formula> arguments, double value);
Formula make_call(std::string function, std::vector<Formula> arguments, double value);

/// "m*(P_p + c*(e - 1))/(e - r)".
std::string formula_text(const Formula& f);

/// The same with the value of every symbol, six significant digits: "1.2*(2500 + 240*(1.80896 - 1))/(1.80896 - 1.08)".
std::string numbers_text(const Formula& f);

/// A number as in numbers_text: six significant digits, no trailing zeros.
std::string number_text(double value);

/// Precedence of a node: an argument of lower precedence than its operator needs parentheses. add, subtract 1;
/// multiply, divide 2; negate 3; power 4; everything else 5. A negative number has the precedence of negate.
int binding(const FormulaNode& node);

}  // namespace taut
