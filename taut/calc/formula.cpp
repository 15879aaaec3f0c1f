#include "taut/calc/formula.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/base/expects.hpp"

namespace taut {
namespace {

enum class Leaf { symbols, values };

std::string write(const FormulaNode& node, Leaf leaf);

enum class Side { left, right };

/// A sign right after an operator needs parentheses: 2*(-3), not 2*-3.
std::string write_in(const FormulaNode& node, Leaf leaf, int least_binding, Side side) {
  const std::string text = write(node, leaf);
  const bool negative_value = leaf == Leaf::values && node.op == Op::symbol && std::signbit(node.value);
  const int bound = negative_value ? 3 : binding(node);
  const bool signed_right = side == Side::right && bound == 3;
  return bound < least_binding || signed_right ? fmt::format("({})", text) : text;
}

std::string write_call(const FormulaNode& node, Leaf leaf) {
  std::string arguments;
  for (const Formula& a : node.arguments) {
    if (!arguments.empty()) arguments += ", ";
    arguments += write(*a, leaf);
  }
  return fmt::format("{}({})", node.name, arguments);
}

std::string write(const FormulaNode& node, Leaf leaf) {
  const auto at = [&](std::size_t i, int least) {
    return write_in(*node.arguments[i], leaf, least, i == 0 ? Side::left : Side::right);
  };
  switch (node.op) {
    case Op::number:
      return number_text(node.value);
    case Op::symbol:
      return leaf == Leaf::symbols ? node.name : number_text(node.value);
    case Op::add:
      return fmt::format("{} + {}", at(0, 1), at(1, 2));
    case Op::subtract:
      return fmt::format("{} - {}", at(0, 1), at(1, 2));
    case Op::multiply:
      return fmt::format("{}*{}", at(0, 2), at(1, 3));
    case Op::divide:
      return fmt::format("{}/{}", at(0, 2), at(1, 4));
    case Op::negate:
      return fmt::format("-{}", at(0, 3));
    case Op::power:
      return fmt::format("{}^{}", at(0, 5), at(1, 5));
    case Op::call:
      return write_call(node, leaf);
  }
  return {};
}

}  // namespace

Formula make_number(double value) {
  return std::make_shared<FormulaNode>(FormulaNode{.op = Op::number, .value = value, .name = {}, .arguments = {}});
}

Formula make_symbol(std::string name, double value) {
  return std::make_shared<FormulaNode>(
      FormulaNode{.op = Op::symbol, .value = value, .name = std::move(name), .arguments = {}});
}

Formula make_node(Op op, std::vector<Formula> arguments, double value) {
  return std::make_shared<FormulaNode>(
      FormulaNode{.op = op, .value = value, .name = {}, .arguments = std::move(arguments)});
}

Formula make_call(std::string function, std::vector<Formula> arguments, double value) {
  return std::make_shared<FormulaNode>(
      FormulaNode{.op = Op::call, .value = value, .name = std::move(function), .arguments = std::move(arguments)});
}

std::string number_text(double value) { return fmt::format("{:.6g}", value); }

int binding(const FormulaNode& node) {
  switch (node.op) {
    case Op::add:
    case Op::subtract:
      return 1;
    case Op::multiply:
    case Op::divide:
      return 2;
    case Op::negate:
      return 3;
    case Op::power:
      return 4;
    case Op::number:
      return std::signbit(node.value) ? 3 : 5;
    case Op::symbol:
    case Op::call:
      return 5;
  }
  return 5;
}

std::string formula_text(const Formula& f) { return f ? write(*f, Leaf::symbols) : std::string{}; }
std::string numbers_text(const Formula& f) { return f ? write(*f, Leaf::values) : std::string{}; }

}  // namespace taut
