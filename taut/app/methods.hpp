#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/app/method_input.hpp"
#include "taut/calc/field.hpp"
#include "taut/calc/method.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/calc/result.hpp"
#include "taut/rope/rope_use.hpp"
#include "taut/units/display.hpp"

namespace taut::app {

/// How a method's input takes what a design chooses. What is empty it does not have.
struct MethodDesign {
  /// Puts a rope in by its name; `modulus`: Pa, on its area.
  std::function<void(MethodInput&, const std::string& name, const catalogue::RopeRow& row, double modulus)> put_rope =
      {};
  /// Pa, that a deck without a stiffness takes for a rope, infinite where it does not stretch; else 100 GPa.
  std::function<double(const MethodInput&, const std::string& name, const catalogue::RopeRow& row)> modulus = {};
  /// m; 1 where the input does not tell.
  std::function<double(const MethodInput&, const std::string& rope)> rope_length = {};
  std::function<void(MethodInput&, const std::string& section)> put_section = {};  ///< of its one mast, `mast`
  /// Adds a check to a mast that may be given, but not chosen.
  std::function<void(Result&)> check_choice = {};
  std::function<double(const MethodInput&)> height = {};       ///< of that mast, m
  std::function<double(const MethodInput&)> mass = {};         ///< of what else is built: take-up weights, kg
  std::function<std::string(const MethodInput&)> refuse = {};  ///< why its ropes or section can't be chosen
};

/// A method as the doors see it: what it is, its fields, its example, and all that is done with its input.
struct MethodEntry {
  const Method* about = nullptr;
  MethodInput (*input_of_defaults)() = nullptr;
  const Description* input = nullptr;
  const Description* output = nullptr;
  const Description* exact = nullptr;  ///< values that the engine adds; none where it does not
  std::vector<TableWords> tables;      ///< of its result, those of the engine too
  std::string_view example;            ///< the text of examples/<name>.yaml
  /// Rules between fields and names that the catalogue lacks; paths below `input`.
  std::function<std::vector<Complaint>(const MethodInput&)> complaints;
  /// The whole calculation, with the engine's values: each input is solved once. For inputs without complaints. The
  /// display is of its messages.
  std::function<Result(const MethodInput&, const Display&)> run;
  /// The lines of the main answer, of a result that is ok.
  std::function<std::vector<Answer>(const MethodInput&, const Result&, const Display&)> answers;
  /// Its ropes by name for `checks`, with what the deck says of them; with a result also with the largest tensions in
  /// it.
  std::function<std::vector<rope::RopeUse>(const MethodInput&, const Result*)> ropes;
  MethodDesign design;
};

/// Every method that taut has, in the order of print. To add one: a row in methods.cpp.
const std::vector<MethodEntry>& methods();

/// nullptr when there is none of that name.
const MethodEntry* find_method(std::string_view name);

/// Names of all methods.
std::vector<std::string> method_names();

}  // namespace taut::app
