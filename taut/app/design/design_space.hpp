#pragma once
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/checks/mast/mast_checks_deck.hpp"
#include "taut/design/design.hpp"
#include "taut/io/deck/node.hpp"
#include "taut/study/deck/parameter.hpp"

namespace taut::app {

/// A number that a design may change, by its path.
using FindParameter = std::function<tl::expected<study::Parameter, std::string>(const std::string& path)>;

/// A beam or mast whose section may be chosen.
struct DesignSection {
  std::string name;
  std::optional<std::string> steel;
  std::string refused;  ///< why its section can't be chosen
};

/// What a machine or a method has that a design may change.
struct DesignParts {
  std::string owner;                  ///< "the machine"
  std::vector<std::string> ropes;     ///< that can be chosen
  std::vector<std::string> tensions;  ///< names that least_tension may be `of`
  std::vector<DesignSection> sections;
  FindParameter parameter;
  /// Pa, on the metallic area, with which a deck calculates that has this row in place of its rope; nothing: none is
  /// known.
  std::function<std::optional<double>(const std::string& rope, const catalogue::RopeRow&)> modulus;
};

/// The candidates of a design, or what is wrong with it: mistakes of the catalogue's file and of the block `design`,
/// each at its place. `input`: the map with the key `design`.
design::DesignSpace design_space(const io::Node& input, const design::DesignRequest& design, const DesignParts& parts,
                                 Diagnostics& mistakes);

/// The candidates of one beam or mast, without the walls that its steel is not made in; empty with complaints.
design::SectionCandidates candidates_of_section(const design::DesignSectionRequest& request, design::Seek seek,
                                                const std::vector<DesignSection>& known, const std::string& owner,
                                                std::vector<Complaint>& complaints);

/// Masts that stand in `checks` alone, with a section of theirs, where no part of that name is known yet.
void add_masts(const std::vector<checks::MastCheckRequest>& masts, std::vector<DesignSection>& sections);
/// Their sections of a design put in.
void put_masts(const design::DesignSpace& space, const std::vector<std::size_t>& choice,
               std::vector<checks::MastCheckRequest>& masts);
/// m; nothing where there is no such mast, or its height is not given.
std::optional<double> mast_height(const std::vector<checks::MastCheckRequest>& masts, const std::string& name);

/// Puts values of the unknowns where they belong; those along with them keep their distance from it.
void put_values(const design::DesignSpace& space, const std::vector<double>& values, const FindParameter& parameter);
void put_case(const design::DesignCase& one, const FindParameter& parameter);

/// Lengths of one metre, and of what else costs: the unknowns by their prices.
design::DesignLengths by_the_metre(const design::DesignRequest& request, const design::DesignSpace& space,
                                   const std::vector<double>& values);

/// Runs each case and puts them together: the result of the one that governs, with the checks of all, "rope.T_max
/// [full]". `first`: the case that is tried first, the one that failed last. Without cases one run without any. A quick
/// look ends at a check that fails, not at a case without an answer.
design::DesignRun run_cases(const std::vector<design::DesignCase>& cases, design::Depth depth, std::size_t& first,
                            const std::function<design::DesignRun(const design::DesignCase*, design::Depth)>& one);

/// The table `design_cases` as described.
TableWords cases_words();

}  // namespace taut::app
