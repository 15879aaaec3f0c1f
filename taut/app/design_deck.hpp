#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/app/section_choice.hpp"
#include "taut/calc/field.hpp"

namespace taut::app {

/// What the least of is sought.
enum class Seek { lightest, smallest, cheapest };
enum class LeastTrust { verified, derived, any };

/// The ropes of the catalogue from which one is chosen.
struct DesignRopeRequest {
  std::string name;  ///< a rope of the machine
  std::optional<std::string> construction;
  std::optional<std::string> core;
  std::optional<std::string> standard;
  std::optional<double> grade;           ///< Pa
  std::optional<double> least_diameter;  ///< m
  std::optional<double> most_diameter;   ///< m
  LeastTrust trust = LeastTrust::any;    ///< of the breaking force
  double modulus = 100e9;                ///< Pa, on the metallic area
  static const Description& describe();
};

/// The sections of the catalogue from which that of a beam is chosen.
struct DesignSectionRequest {
  std::string name;  ///< a beam of the machine
  SectionChoice which;
  static const Description& describe();
};

/// A number of the machine that is free within a range, tried at equal steps.
struct DesignUnknownRequest {
  std::string name;
  std::string parameter;
  std::string from, to;  ///< with the parameter's unit
  int steps = 4;
  static const Description& describe();
};

/// The block `design:` of a machine's deck: what is chosen so that all checks pass.
struct DesignRequest {
  Seek seek = Seek::lightest;
  std::optional<std::string> catalogue;  ///< a file
  std::vector<DesignRopeRequest> ropes;
  std::vector<DesignSectionRequest> sections;
  std::vector<DesignUnknownRequest> unknowns;
  bool refine = false;  ///< the unknowns between the places of their grid
  int runner_ups = 5;
  int most_trials = 5000;
  static const Description& describe();
};

}  // namespace taut::app
