#include "taut/methods/friction_drive/tables.hpp"

#include <array>
#include <string>
#include <utility>

namespace taut::friction_drive {
namespace {

/// The drive by one reading of k.
struct Reading {
  std::string words;
  double k = 0;
  Output out;
};

const Quantities<Reading>& reading_quantities() {
  using Row = Reading;
  const auto of = [](double Output::*part) { return [part](const Row& r) { return r.out.*part; }; };
  static const Quantities<Row> all = {
      {"reading", "", si::one, "what Andreev's k may mean", &Row::words},
      {"k", "k", si::one, "section factor by that reading", &Row::k},
      {"phi", "phi", si::rad, "working arc", of(&Output::phi)},
      {"e", "e", si::one, "exp(mu phi): largest ratio of the branches without the centrifugal tension", of(&Output::e)},
      {"P_M", "P_M", si::N, "initial tension, (18) as derived correctly", of(&Output::P_M)},
      {"takeup_no_slip", "W_no_slip", si::N, "pull on the idler of the drive that does not slip",
       of(&Output::takeup_no_slip)}};
  return all;
}

}  // namespace

Table readings_table(const Input& in, const Output& as_given) {
  constexpr double nu = 0.3;
  const std::array<std::pair<const char*, double>, 4> all{
      {{"as given", in.section_factor},
       {"none: the whole arc works", 0},
       {"half the section about a diameter, 0.180 (1 - nu)", 0.180 * (1 - nu)},
       {"whole section about the contact, 0.8 (1 - nu)", 0.8 * (1 - nu)}}};
  std::vector<Reading> rows;
  for (const auto& [words, k] : all) {
    rows.push_back({.words = words, .k = k, .out = as_given});
    if (k == in.section_factor) continue;
    Input at = in;
    at.section_factor = k;
    rows.back().out = {};
    solve(at, rows.back().out);
  }
  return make_table("readings", "Readings of Andreev's k", reading_quantities(), rows);
}

std::vector<TableWords> table_words() {
  return {{.name = "readings", .rows = "every reading of Andreev's k", .columns = words_of(reading_quantities())}};
}

}  // namespace taut::friction_drive
