#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "taut/app/design/design_space.hpp"
#include "taut/checks/checks_deck.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/rope/rope_use.hpp"

/// `design:` beside the `input:` of a published method.
namespace taut::app {

/// How a method's input takes what a design chooses. What is empty it does not have.
template <class Input>
struct MethodDesign {
  /// Puts a rope in by its name; `modulus`: Pa, on its area.
  void (*put_rope)(Input&, const std::string& name, const catalogue::RopeRow& row, double modulus) = nullptr;
  double (*rope_length)(const Input&, const std::string& name) = nullptr;  ///< m; 1 where the input does not tell
  void (*put_section)(Input&, const std::string& section) = nullptr;       ///< of its one mast, `mast`
  double (*height)(const Input&) = nullptr;                                ///< of that mast, m
  double (*mass)(const Input&) = nullptr;         ///< of what else is built: take-up weights, kg
  std::string (*refuse)(const Input&) = nullptr;  ///< why its ropes or section can't be chosen
};

MethodDesign<closed_loop::Input> design_of_loop();
MethodDesign<friction_drive::Input> design_of_drive();
MethodDesign<boom_ropes::Input> design_of_boom();
MethodDesign<mast_section::Input> design_of_mast();

/// A copy of a method's deck, to be changed and run.
struct MethodCopy {
  FindParameter parameter;  ///< below its input
  std::function<void(const std::string& name, const catalogue::RopeRow& row, double modulus)> put_rope;
  std::function<void(const std::string& section)> put_section;
  std::function<double(const std::string& rope)> rope_length;
  std::function<double()> height, mass;
  std::string refused;
  checks::ChecksRequest* checks = nullptr;  ///< of the copy; none: the deck has none
  std::vector<std::string> ropes;
  std::function<Result()> run;
  /// Notes what is wrong with its input and its checks, at their places.
  std::function<void(const io::Node& input, const io::Node* others, Diagnostics& mistakes)> complain;
  /// Of a result, by rope, N.
  std::function<std::map<std::string, double>(const Result&)> tensions;
};
using CopyMethod = std::function<std::shared_ptr<MethodCopy>()>;

/// The candidates of a method's design, or what is wrong with it. `block`: the map with the key `design`.
design::DesignSpace method_space(const io::Node& block, const design::DesignRequest& design, const MethodCopy& copy,
                                 Diagnostics& mistakes);

/// Puts a design into a copy.
void put_design(MethodCopy& copy, const design::DesignSpace& space, const design::DesignPlace& place,
                const design::DesignCase* load_case = nullptr);

design::DesignTask method_task(const design::DesignRequest& design, design::DesignSpace space, CopyMethod copy,
                               std::function<bool(const Progress&)> progress);

}  // namespace taut::app
