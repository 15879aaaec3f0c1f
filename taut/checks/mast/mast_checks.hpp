#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/gravity.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/calc/sheet.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/checks/mast/mast_checks_deck.hpp"
#include "taut/structure/column_mast.hpp"
#include "taut/structure/mast_sizing.hpp"

/// `checks: masts:`: a mast by EN 1993-1-1 and by an allowable stress, from the forces of a machine's beams, from those
/// that the deck gives, or from a published method.
namespace taut::checks {

/// A steel in the wall that counts: the section, f_y, [sigma], and the trust of both.
struct MastMaterial {
  catalogue::SectionRow section;
  double yield = 0;                        ///< Pa
  std::optional<double> allowable_stress;  ///< Pa
  std::string steel;                       ///< "EN 10025-2 S355"
  std::string trust;                       ///< of the yield stress
};

/// The section of that name in the steel `steel`, or what is wrong with them, at `path`.section or `path`.steel.
tl::expected<MastMaterial, Complaint> mast_material(const MastCheckRequest& request, const std::string& section,
                                                    const std::string& steel, const std::string& path);
/// The same for a row of the catalogue; empty where the steel is not made so thick.
std::optional<MastMaterial> mast_material(const MastCheckRequest& request, const catalogue::SectionRow& row,
                                          const std::string& steel);

std::optional<structure::Curve> curve_of(const MastCheckRequest& request);

/// What is to be reported of a mast.
struct MastReport {
  std::string name;
  Display display;  ///< units of the sentences
  std::vector<std::string>
      covers;  ///< the beams that it is, or the mast of the method; empty: a mast beside the machine
  structure::LoadedMast loaded;
  std::vector<MastMaterial> materials;  ///< by part
  std::string refused;                  ///< why there are no forces
  bool unseen = false;                  ///< because no state was found, which is no failure of the mast
  std::string relieved;                 ///< a combination in which its own weight relieves it by too much
  std::string short_length;  ///< a buckling length of the deck that is shorter than that of the machine or the column
  std::string swings;        ///< a state whose factor the machine reaches only if the tensions of its ropes grow
  std::set<std::string> left_out;  ///< analyses with states, or load cases, that no combination names
  std::string apart;               ///< load cases that are checked one at a time, though nobody said so
  std::vector<std::string> words;  ///< how it was computed
  structure::MastOf in_section;    ///< the same mast in another section, for `choose`
};

/// Adds checks (part: the mast), values, a table row, lines and a plot.
void add_mast_report(const MastCheckRequest& request, const MastReport& report, Result& r);

/// The tables `masts` and `mast_sections` as described.
TableWords mast_words();
TableWords mast_choice_words();

/// Which factors each route contains.
std::string factor_words(const MastCheckRequest& request, const MastReport& report);

/// The lightest sections that pass, as a table `mast_sections`.
void add_mast_choice(const MastCheckRequest& request, const MastReport& report, Result& r);

/// Where the loads of a mast come from that is no beam of the machine.
enum class LoadsOf { deck, method, machine };
/// What is wrong with such a mast, at paths below `path`. `analyses`: names of load cases that a machine gives.
void complain_of_own_mast(const MastCheckRequest& request, const std::string& path, LoadsOf loads,
                          const std::vector<std::string>& analyses, std::vector<Complaint>& complaints);

/// Of a number that a deck gives in three digits.
inline constexpr double as_rounded = 0.98;

/// Partial factors in two places.
void refuse_both_factors(const MastCheckRequest& request, const std::string& path, std::vector<Complaint>& complaints);

/// The term of a combination that names the mast's own weight.
inline constexpr std::string_view weight_term = "own_weight";
/// Partial factor of the own weight in a combination: that of its term `own_weight`, else the largest of its factors.
double weight_factor(const std::vector<MastTerm>& terms);

/// Whether the states while the machine is put up (`put_up_analysis`) count in every combination, with the factor of
/// its analysis: no combination names them.
bool counts_put_up_in_all(const MastCheckRequest& request);

/// Such a mast, solved. `loads`: in place of those in the request; `gravity`: of its own weight, m/s2. Of more than 500
/// combinations, as a motion has them, the cases are those that decide a check or a number of the report.
MastReport own_mast(const MastCheckRequest& request, const std::vector<MastLoadRequest>& loads,
                    double gravity = standard_gravity, const Display& display = {});

/// What the ropes of a machine do to a mast that carries their sheaves and anchors, in one state.
struct CarriedState {
  std::string words, analysis;
  bool moves = false;
  std::vector<MastLoadRequest> loads;  ///< by the mast's axes
};
CarriedState carried_by(const MastCheckRequest& request, const CheckState& state);
void complain_of_carried(const MastCheckRequest& request, const std::string& path, const machine::Model& model,
                         const std::vector<std::string>& analyses, std::vector<Complaint>& complaints);
/// Such a mast under each of the states, with the loads that the deck gives besides. Motions come without the dynamic
/// factor.
MastReport carrying_mast(const MastCheckRequest& request, const std::vector<CarriedState>& states, double gravity,
                         const Display& display = {});

/// The masts of a deck with a published method: those with loads, and of `mast_section` without loads the method's own
/// resultants on its blocks.
void complain_of_method_masts(const std::vector<MastCheckRequest>& masts, const std::string& method,
                              std::vector<Complaint>& complaints);
void add_method_masts(const std::vector<MastCheckRequest>& masts, const Display& display, Result& r);

}  // namespace taut::checks
