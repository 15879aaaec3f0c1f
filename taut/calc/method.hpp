#pragma once
#include <string>
#include <vector>

namespace taut {

/// A mistake in the published text: what is printed, what is correct, the evidence, and the test that shows it.
struct Erratum {
  std::string where;  ///< "(9)"
  std::string printed;
  std::string correct;
  std::string evidence;
  std::string test;  ///< "MastSection.GammaIsAboveTheBranch": suite and name of the GoogleTest test
};

/// Description of a published method, for `taut list methods`, `taut explain` and the docs.
struct Method {
  std::string name;                 ///< deck name, "mast_section"
  std::string title;                ///< "Mast section of a tractor-mounted cable yarder"
  std::string source;               ///< full citation
  std::string short_source;         ///< "Shoshin et al. 2022"
  std::string scope;                ///< what it calculates and what it neglects
  std::vector<std::string> limits;  ///< ranges and conditions outside which it must not be used
  std::vector<Erratum> errata;
};

struct Description;
struct Result;

/// The result of a published method before the calculation: titles, source and the given values. `values`: the struct
/// that `input` describes.
Result result_of(const Method& method, const Description& input, const void* values);

}  // namespace taut
