#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/checks/section_choice.hpp"

namespace taut::design {

/// What the least of is sought, or the most reserve: the least utilisation of the check that governs.
enum class Seek { lightest, smallest, cheapest, least_tension, most_reserve };

/// The ropes of the catalogue from which one is chosen.
struct DesignRopeRequest {
  std::string name;  ///< a rope of the machine or of the method
  std::optional<std::string> construction;
  std::optional<std::string> core;
  std::optional<std::string> standard;
  std::optional<double> grade;                            ///< Pa
  std::optional<double> least_diameter;                   ///< m
  std::optional<double> most_diameter;                    ///< m
  catalogue::Trust trust = catalogue::Trust::unverified;  ///< of the breaking force, the worst allowed
  std::optional<double> modulus;                          ///< Pa, on the metallic area; else by construction
  static const Description& describe();
};

/// The sections of the catalogue from which that of a beam is chosen.
struct DesignSectionRequest {
  std::string name;  ///< a beam of the machine, or a mast of the method
  checks::SectionChoice which;
  std::optional<double> price;  ///< of a kilogram
  static const Description& describe();
};

/// A number of the machine or of a method's input that is free within a range.
struct DesignUnknownRequest {
  std::string name;
  std::string parameter;
  std::vector<std::string> along_with;  ///< others that move by as much
  std::string from, to;                 ///< with the parameter's unit
  std::optional<std::string> start;     ///< where the search begins besides
  std::optional<int> steps;             ///< of the grid; else 4, with a start none
  std::optional<double> price;          ///< of its SI unit
  static const Description& describe();
};

/// One number of a load case.
struct DesignSettingRequest {
  std::string name;  ///< its path
  std::string value;
  static const Description& describe();
};
/// A load case: what is other in it than in the deck.
struct DesignCaseRequest {
  std::string name;
  std::vector<DesignSettingRequest> settings;
  static const Description& describe();
};

/// The block `design:` of a deck: what is chosen so that all checks pass.
struct DesignRequest {
  Seek seek = Seek::lightest;
  std::optional<std::string> of;         ///< of least_tension: a rope; else the largest of all
  std::optional<std::string> catalogue;  ///< a file
  std::vector<DesignRopeRequest> ropes;
  std::vector<DesignSectionRequest> sections;
  std::vector<DesignUnknownRequest> unknowns;
  std::vector<DesignCaseRequest> cases;
  std::vector<std::string> disregard;  ///< checks that do not bind the design
  bool refine = true;                  ///< the unknowns between the places of their grid
  int runner_ups = 5;
  int most_trials = 5000;
  static const Description& describe();
};

}  // namespace taut::design
