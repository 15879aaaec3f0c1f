#pragma once
#include <string>
#include <vector>

#include "taut/app/guy_checks_deck.hpp"
#include "taut/app/machine_run.hpp"

/// `checks: guys:`, `anchors:`, `lines:` of a machine.
namespace taut::app {

void complain_of_guys(const std::vector<GuyCheckRequest>& guys, const MachineDeck& deck, const model::Model& model,
                      std::vector<Complaint>& complaints);
void add_guy_checks(const std::vector<GuyCheckRequest>& guys, const MachineDeck& deck, const MachineRun& run,
                    Result& r);

void complain_of_anchors(const std::vector<AnchorCheckRequest>& anchors, const model::Model& model,
                         std::vector<Complaint>& complaints);
void add_anchor_checks(const std::vector<AnchorCheckRequest>& anchors, const MachineRun& run, Result& r);

void complain_of_lines(const std::vector<LineCheckRequest>& lines, const model::Model& model,
                       std::vector<Complaint>& complaints);
void add_line_checks(const std::vector<LineCheckRequest>& lines, const MachineRun& run, Result& r);

/// A limit of the catalogue's rules with its words and trust.
struct RuleLimit {
  double value = 0;
  std::string words, trust;
};
/// `safe_end`: of a range the high end (what must be reached) or the low one.
RuleLimit rule_limit(const std::string& id, bool high_end);

/// A check that belongs to a part.
void add_part_check(const std::string& part, const std::string& name, double value, Sense sense, double limit,
                    const Unit& unit, std::string rule, std::string trust, Result& r);

}  // namespace taut::app
