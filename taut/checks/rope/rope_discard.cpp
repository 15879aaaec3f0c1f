#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "taut/calc/none.hpp"
#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/rope/rope_life.hpp"

namespace taut::checks {
namespace {

using catalogue::RuleRow;

/// One criterion of discard. NaN: it has no such number.
struct DiscardRow {
  std::string criterion;
  double on_length = none;       ///< m
  double broken_wires = none;    ///< how many
  double least_diameter = none;  ///< m
  std::string limit, trust;
};

const Quantities<DiscardRow>& discard_quantities() {
  using Row = DiscardRow;
  static const Quantities<Row> all = {
      {"criterion", "", si::one, "the criterion of discard, ISO 4309", &Row::criterion},
      {"on_length", "", si::m.in("mm"), "length of rope on which visible broken wires are counted: 6 d, 30 d",
       &Row::on_length},
      {"broken_wires", "", si::one, "number of visible broken wires on it at which the rope is discarded",
       &Row::broken_wires},
      {"least_diameter", "d", si::m.in("mm"), "measured diameter below which it is discarded", &Row::least_diameter},
      {"limit", "", si::one, "the limit in words, and what it rests on", &Row::limit},
      {"trust", "", si::one, "trust in the limit", &Row::trust}};
  return all;
}

/// "M5" is 5; 0: no class.
int class_number(const std::string& group) { return group.size() == 2 && group[0] == 'M' ? group[1] - '0' : 0; }

/// Filler wires of a strand 1 + k + kF + 2k, k: they bear nothing. "6x25" is such a strand without saying so.
int fillers(const catalogue::Construction& rope) {
  const bool usual = rope.wires == 21 || rope.wires == 25 || rope.wires == 29;
  return (rope.lay == "f" || rope.lay == "kf" || (rope.lay.empty() && usual)) ? (rope.wires - 1) / 4 : 0;
}

/// Outer strands of Seale lay with 19 wires or fewer count two rows higher: their outer wires are thick. A strand whose
/// lay is not known may be one of them.
bool is_thick_wired(const catalogue::Construction& rope) {
  return rope.wires <= 19 && (rope.lay == "s" || rope.lay == "ks" || (rope.lay.empty() && rope.wires > 9));
}

constexpr int many_strands = 10;  ///< from here on they lie in several layers

/// Ropes of 3 or 4 strands stand with those of several layers (ISO 4309, RCN 21 and 22).
bool resists_turning(const catalogue::Construction& rope) { return rope.strands >= many_strands || rope.strands <= 4; }

/// Above 300 wires the standard gives shares of their number (RCN 13), low on 6 d, high on 30 d.
RuleRow beyond_table(RuleRow last, int wires) {
  const double high = (last.id.starts_with("discard.lang") ? 0.04 : 0.08) * wires;
  last.low = std::floor(high / 2);
  last.high = std::floor(high);
  return last;
}

/// The row for so many wires in the outer strands that bear, or one that stands higher in the table.
std::optional<RuleRow> row_for(const std::string& topic, int wires, std::size_t higher) {
  std::vector<RuleRow> rows = catalogue::rules_of(topic);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].up_to && wires <= *rows[i].up_to) return std::move(rows[i - std::min(i, higher)]);
  }
  if (rows.empty()) return std::nullopt;
  return beyond_table(std::move(rows.back()), wires);
}

/// The wires that are counted, and how the table is read for them.
struct CountedWires {
  bool turns = false;  ///< strands that do not turn the rope have their outer wires in another layer
  int fill = 0;        ///< filler wires of a strand
  bool thick = false;  ///< two rows higher
  bool twice = false;  ///< by the class of the mechanism
  int wires = 0;       ///< that bear
  std::string why;     ///< class and lay, in words
};

CountedWires counted(const catalogue::Construction& rope, const std::string& group) {
  CountedWires all;
  all.turns = resists_turning(rope);
  all.fill = all.turns ? 0 : fillers(rope);
  all.thick = !all.turns && is_thick_wired(rope);
  all.twice = class_number(group) >= (all.turns ? 3 : 5);
  all.wires = rope.strands * (rope.wires - all.fill);
  all.why = class_number(group) > 0 ? "class " + group : std::string("class not known");
  if (all.thick) all.why += rope.lay.empty() ? "; lay not known, Seale assumed: two rows up" : "; Seale: two rows up";
  return all;
}

/// Those of one row of the table, on 6 and on 30 diameters. `layered`: it lies in layers on a drum.
void add_counts(const RuleRow& row, const CountedWires& counted, double diameter, bool layered,
                std::vector<DiscardRow>& rows) {
  for (const auto& [length, count] : {std::pair{6, *row.low}, std::pair{30, *row.high}}) {
    const double most = counted.twice ? 2 * count : count;
    const std::string on_drum = layered && !counted.twice
                                    ? fmt::format("; {:.0f} on the part that lies in layers on a drum", 2 * count)
                                    : std::string();
    rows.push_back({.criterion = row.item,
                    .on_length = length * (diameter > 0 ? diameter : none),
                    .broken_wires = most,
                    .limit = fmt::format("{:.0f} or more on {} d: {} wires{}{}, {}{}", most, length, counted.wires,
                                         counted.fill > 0 ? " that bear" : "",
                                         counted.turns ? "" : " in the outer strands", counted.why, on_drum),
                    .trust = catalogue::trust_words(row)});
  }
}

/// Broken wires that one sees, on 6 and on 30 diameters.
void add_wires(const std::string& group, const rope::RopeUse& use, std::vector<DiscardRow>& rows) {
  const auto construction = catalogue::parse_construction(use.rope.construction);
  if (!construction) return;
  const bool layered = std::any_of(use.drums.begin(), use.drums.end(), [](const auto& d) { return d.layers > 1; });
  const CountedWires wires = counted(*construction, group);
  for (const char* topic : {"discard.ordinary", "discard.lang", "discard.rotation_resistant"}) {
    if (wires.turns != (std::string_view(topic) == "discard.rotation_resistant")) continue;
    if (const auto row = row_for(topic, wires.wires, wires.thick ? 2 : 0))
      add_counts(*row, wires, use.rope.diameter, layered, rows);
  }
}

void add_diameter(const rope::RopeUse& use, std::vector<DiscardRow>& rows) {
  const auto construction = catalogue::parse_construction(use.rope.construction);
  const bool turns = construction && construction->strands >= many_strands;
  const std::string core = turns ? "WSC" : use.rope.core;
  // of a core that nobody knows the one that allows least
  const auto row = catalogue::find_rule("discard.diameter." + (core.empty() ? std::string("IWRC") : core));
  if (!row || !row->low) return;
  const double least = use.rope.diameter > 0 ? use.rope.diameter * (1 - *row->low) : none;
  std::string words = row->text;
  if (!std::isnan(least)) words += ": " + use.display.brief(least, si::m.in("mm"));
  if (core.empty()) words += "; core not known";
  rows.push_back({.criterion = row->item,
                  .least_diameter = least,
                  .limit = std::move(words),
                  .trust = catalogue::trust_words(*row)});
}

}  // namespace

TableWords discard_words() {
  return {.name = "discard_ROPE",
          .rows = "every criterion of a rope with `discard`",
          .columns = words_of(discard_quantities())};
}

void add_discard(const std::string& group, const rope::RopeUse& use, Result& r) {
  std::vector<DiscardRow> rows;
  add_wires(group, use, rows);
  add_diameter(use, rows);
  for (const RuleRow& row : catalogue::rules_of("discard")) {
    if (row.low) continue;  // reported above
    rows.push_back({.criterion = row.item, .limit = row.text, .trust = catalogue::trust_words(row)});
  }
  if (!catalogue::parse_construction(use.rope.construction) || !(use.rope.diameter > 0)) {
    r.warnings.push_back(fmt::format(
        "{}: broken wires and lost diameter are reported in numbers where 'construction' and 'diameter' are known{}",
        use.name, use.rope.construction.empty() ? "" : fmt::format("; construction '{}'", use.rope.construction)));
  }
  r.tables.push_back(
      make_table("discard_" + use.name,
                 fmt::format("When {} is put away (ISO 4309 as recalled: compare with the standard)", use.name),
                 discard_quantities(), rows));
}

}  // namespace taut::checks
