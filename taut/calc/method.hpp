#pragma once
#include <string>
#include <vector>

namespace taut {

/// A mistake of the published text: what is printed, what it should be, how we know, and the test that shows it.
struct Erratum {
  std::string where;  ///< "(9)"
  std::string printed;
  std::string correct;
  std::string evidence;
  std::string test;  ///< "MastSection.GammaIsAboveTheBranch": suite and name of the GoogleTest test
};

/// What a published method is, for `taut list methods`, `taut explain` and the docs.
struct Method {
  std::string name;                 ///< deck name, "mast_section"
  std::string title;                ///< "Mast section of a tractor-mounted cable yarder"
  std::string source;               ///< full citation
  std::string short_source;         ///< "Shoshin et al. 2022"
  std::string scope;                ///< what it is for and what it leaves out
  std::vector<std::string> limits;  ///< ranges and conditions outside which it must not be used
  std::vector<Erratum> errata;
};

struct Description;
struct Result;

/// The result of a published method before anything is computed: what it is called, where it is from, what is given.
Result result_of(const Method& method, const Description& input, const void* values);

}  // namespace taut
