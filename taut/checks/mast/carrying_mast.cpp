#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "taut/base/suggest.hpp"
#include "taut/checks/mast/mast_checks.hpp"
#include "taut/machine/state.hpp"

namespace taut::checks {
namespace {

constexpr double on_top = 1e-6;  // m
constexpr double places_on_mast = 200;

bool carries(const MastCheckRequest& request, const std::string& name) {
  return std::find(request.carries.begin(), request.carries.end(), name) != request.carries.end();
}

Vector3 strong_way(const MastCheckRequest& request) {
  if (request.towards.empty()) return Vector3::UnitX();
  return Vector3(request.towards[0], request.towards[1], 0).normalized();
}

Vector3 foot_of(const MastCheckRequest& request) {
  if (request.foot.empty()) return Vector3::Zero();
  return {request.foot[0], request.foot[1], request.foot[2]};
}

/// Horizontal unit vectors in which the strong and the weak axis bend.
std::array<Vector3, 2> axes_of(const MastCheckRequest& request) {
  const Vector3 strong = strong_way(request);
  return {strong, up().cross(strong)};
}

double height_of_pieces(const MastCheckRequest& request) {
  double h = request.height.value_or(0);
  for (const MastPieceRequest& p : request.pieces) h += p.length;
  return h;
}

/// A force at a place of the machine as a load of the mast: beside its axis it also bends and turns the mast.
void add_pull(const MastCheckRequest& request, const Vector3& place, const Vector3& F, CarriedState& all) {
  const Vector3 from_foot = place - foot_of(request);
  if (from_foot.z() <= 0) return;  // goes into the ground
  const auto [strong, weak] = axes_of(request);
  MastLoadRequest load;
  // ropes leave their rounds at changing heights; a mast has no more places than it needs
  const double height = height_of_pieces(request), grid = height / places_on_mast;
  load.at = std::clamp(std::round(from_foot.z() / grid) * grid, grid, height);
  const double above = from_foot.z() - *load.at;
  load.down = -F.z();
  load.across = F.dot(strong);
  load.sideways = F.dot(weak);
  load.moment = load.down * from_foot.dot(strong) + load.across * above;
  load.sideways_moment = load.down * from_foot.dot(weak) + load.sideways * above;
  load.torsion = load.sideways * from_foot.dot(strong) - load.across * from_foot.dot(weak);
  all.loads.push_back(std::move(load));
}

/// Each state as a combination of its own: with the deck's own loads by their factors. A name that is of a load case
/// and of an analysis means both.
class Combinations {
 public:
  Combinations(const MastCheckRequest& request, const std::vector<CarriedState>& states)
      : request_(request), states_(states), own_(request) {
    own_.combinations.clear();
  }

  MastCheckRequest all() {
    if (request_.combinations.empty()) add_each_analysis();
    for (const MastCombinationRequest& c : request_.combinations) {
      std::vector<MastTerm> own, of_states;
      for (const MastTerm& t : c.terms) {
        if (is_weight(t)) continue;
        if (is_load(t.name)) own.push_back(t);
        if (!is_load(t.name) || has_states(t.name)) of_states.push_back(t);
      }
      // named, because the factors of the states may be without the dynamic one
      if (request_.own_weight) own.push_back({std::string(weight_term), weight_factor(c.terms)});
      for (const MastTerm& t : of_states) {
        add_states(c.name + ": ", own, t);
        if (in_all_) add_states(c.name + ": ", own, {.name = std::string(put_up_analysis), .factor = t.factor});
      }
      if (of_states.empty()) own_.combinations.push_back(c);
    }
    return own_;
  }

  /// The analyses whose states are in no combination.
  std::set<std::string> left_out() const {
    std::set<std::string> names;
    for (const CarriedState& s : states_) {
      if (!taken_.contains(s.analysis)) names.insert(s.analysis);
    }
    return names;
  }

 private:
  /// Without combinations: all loads with the states of one analysis at a time.
  void add_each_analysis() {
    std::vector<MastTerm> own;
    for (const MastLoadRequest& l : request_.loads) {
      const bool known = std::any_of(own.begin(), own.end(), [&](const auto& t) { return t.name == l.load_case; });
      if (!known) own.push_back({l.load_case, request_.load_factor});
    }
    if (request_.own_weight) own.push_back({std::string(weight_term), request_.load_factor});
    for (const std::string& analysis : analyses())
      add_states("", own, {.name = analysis, .factor = request_.load_factor});
  }

  bool is_weight(const MastTerm& term) const { return request_.own_weight && term.name == weight_term; }
  bool is_load(const std::string& name) const {
    return std::any_of(request_.loads.begin(), request_.loads.end(),
                       [&](const auto& l) { return l.load_case == name; });
  }
  bool has_states(const std::string& analysis) const {
    return std::any_of(states_.begin(), states_.end(), [&](const auto& s) { return s.analysis == analysis; });
  }
  std::vector<std::string> analyses() const {
    std::vector<std::string> names;
    for (const CarriedState& s : states_) {
      if (std::find(names.begin(), names.end(), s.analysis) == names.end()) names.push_back(s.analysis);
    }
    return names;
  }

  void add_states(const std::string& before, const std::vector<MastTerm>& own, const MastTerm& term) {
    for (const CarriedState& s : states_) {
      if (s.analysis != term.name) continue;
      taken_.insert(s.analysis);
      const std::string key = fmt::format("state {}", own_.combinations.size());
      for (MastLoadRequest load : s.loads) {
        load.load_case = key;
        own_.loads.push_back(std::move(load));
      }
      std::vector<MastTerm> terms = own;
      // a motion has its dynamics in it
      terms.push_back({key, s.moves ? term.factor / request_.dynamic_factor : term.factor});
      own_.combinations.push_back({before + s.words, std::move(terms)});
    }
  }

  const MastCheckRequest& request_;
  const std::vector<CarriedState>& states_;
  MastCheckRequest own_;
  bool in_all_ = counts_put_up_in_all(request_);
  std::set<std::string> taken_;  ///< analyses
};

/// Places of the machine that a mast may carry, and where they are as described.
std::vector<std::pair<std::string, Vector3>> places_of(const machine::Model& model) {
  std::vector<std::pair<std::string, Vector3>> all;
  const machine::State state = machine::initial_state(model);
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) all.emplace_back(node.name, machine::in_ground(state, node.at));
  }
  return all;
}

}  // namespace

CarriedState carried_by(const MastCheckRequest& request, const CheckState& state) {
  CarriedState all{.words = state.words, .analysis = state.analysis, .moves = state.moves, .loads = {}};
  for (const CheckContact& c : state.contacts) {
    const machine::Reeving& rope = state.model->reevings[c.reeving];
    if (carries(request, rope.nodes[c.node].name)) add_pull(request, c.place, rope.copies * c.force, all);
  }
  for (const CheckBranch& b : state.branches) {
    const machine::Reeving& rope = state.model->reevings[b.reeving];
    if (rope.closed) continue;
    const int last = static_cast<int>(rope.nodes.size()) - 1;
    if (b.from == 0 && carries(request, rope.nodes.front().name)) {
      add_pull(request, b.start, rope.copies * b.on_start, all);
    }
    if (b.to == last && carries(request, rope.nodes.back().name)) {
      add_pull(request, b.end, rope.copies * b.on_end, all);
    }
  }
  return all;
}

void complain_of_carried(const MastCheckRequest& request, const std::string& path, const machine::Model& model,
                         const std::vector<std::string>& analyses, std::vector<Complaint>& complaints) {
  complain_of_own_mast(request, path, LoadsOf::machine, analyses, complaints);
  const bool has_foot = request.foot.empty() || request.foot.size() == 3;
  if (!has_foot) complaints.push_back({path + ".foot", "three numbers are expected: x, y, z"});
  const auto& way = request.towards;
  if (!way.empty() && (way.size() != 2 || std::hypot(way[0], way[1]) == 0)) {
    complaints.push_back({path + ".towards", "a horizontal direction is expected: [1, 0]"});
  }
  const auto places = places_of(model);
  std::vector<std::string> known;
  known.reserve(places.size());
  for (const auto& [name, place] : places) known.push_back(name);
  for (std::size_t i = 0; i < request.carries.size(); ++i) {
    const std::string& name = request.carries[i];
    const std::string at = fmt::format("{}.carries[{}]", path, i);
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      complaints.push_back({at, fmt::format("no rope runs over or ends at '{}'{}", name, did_you_mean(name, known))});
      continue;
    }
    if (!has_foot) continue;
    const double height = places[static_cast<std::size_t>(found - known.begin())].second.z() - foot_of(request).z();
    if (height > height_of_pieces(request) * (1 + on_top) + on_top || height <= 0) {
      complaints.push_back({at, fmt::format("'{}' is {:.4g} m above the mast's foot, the mast is {:.4g} m high", name,
                                            height, height_of_pieces(request))});
    }
  }
}

MastReport carrying_mast(const MastCheckRequest& request, const std::vector<CarriedState>& states, double gravity,
                         const Display& display) {
  Combinations combinations(request, states);
  const MastCheckRequest all = combinations.all();
  if (all.combinations.empty()) {
    MastReport none;
    none.name = request.name;
    none.refused = "it is not checked: no analysis found a state of the machine";
    none.unseen = true;
    return none;
  }
  MastReport report = own_mast(all, all.loads, gravity, display);
  report.left_out.merge(combinations.left_out());
  report.words.push_back(fmt::format(
      "{}: under the ropes over and at {}, in the deck's {} states; motions without the dynamic factor; its own weight "
      "{}.",
      request.name, fmt::join(request.carries, ", "), states.size(), request.own_weight ? "counted" : "left out"));
  return report;
}

}  // namespace taut::checks
