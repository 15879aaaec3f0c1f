#include "taut/study/deck/given.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/math/index.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/names.hpp"

namespace taut::study {
namespace {

using Kind = solve::Condition::Kind;

class GivenResolver {
 public:
  GivenResolver(const GivenRequest& request, std::optional<int> carriage, std::string path, Names& p)
      : request_(request), carriage_(carriage), path_(std::move(path)), p_(p) {}

  solve::Condition resolve() {
    solve::Condition c;
    const auto own = reeving_of(p_, request_.reeving, path_ + ".reeving");
    for (const std::string& name : request_.of) {
      if (const auto one = reeving_of(p_, name, path_ + ".of")) c.of.push_back(*one);
    }
    if (!own || c.of.size() != request_.of.size()) return {};
    c.reeving = *own;
    c.at_end = request_.at == RopeEnd::end;
    if (carriage_ && p_.model.carriages[*carriage_].mainline == c.reeving) {
      complain("reeving",
               fmt::format("the place of '{}' decides the length of its mainline; name the rope it rides on, "
                           "or another, and the mainline with 'of'",
                           p_.model.carriages[*carriage_].name));
    }
    if (p_.model.reevings[c.reeving].given == machine::Given::torque && !request_.loop_length) {
      complain("reeving", "its rope is given by a torque already");
    }
    if (request_.winch_pull) pull(c);
    if (request_.loop_length) length(c);
    if (request_.sag) sag(c);
    if (!request_.winch_pull && !request_.loop_length && !request_.sag) free(c);
    if (request_.efficiency && !request_.winch_pull) complain("efficiency", "belongs to a 'winch_pull'");
    if (c.at_end && !request_.winch_pull) complain("at", "belongs to a 'winch_pull'");
    if (request_.span && !request_.sag) complain("span", "belongs to a 'sag'");
    if (!request_.of.empty() && !request_.winch_pull && !request_.loop_length) {
      complain("of", "belongs to a 'winch_pull' or a 'loop_length'");
    }
    return c;
  }

 private:
  void complain(const std::string& key, std::string message) {
    p_.complaints.push_back({path_ + "." + key, std::move(message)});
  }

  void pull(solve::Condition& c) {
    c.value = *request_.winch_pull * request_.efficiency.value_or(1);
    if (c.of.size() > 1) complain("of", "a winch pulls one rope");
    const bool own = c.of.empty() || (c.of.size() == 1 && c.of.front() == c.reeving);
    const int pulled = own ? c.reeving : c.of.front();
    if (p_.model.reevings[pulled].closed) complain("winch_pull", "an endless rope has no end for a winch");
    c.kind = !own ? Kind::tension_of : c.at_end ? Kind::tension_at_end : Kind::tension_at_start;
  }

  void length(solve::Condition& c) {
    c.value = *request_.loop_length;
    const bool own = c.of.empty() || (c.of.size() == 1 && c.of.front() == c.reeving);
    if (!own && std::find(c.of.begin(), c.of.end(), c.reeving) == c.of.end()) {
      complain("of", fmt::format("'{}', whose length follows, is not part of the loop", request_.reeving));
    }
    c.kind = own ? Kind::length : Kind::length_of;
  }

  void sag(solve::Condition& c) {
    c.value = *request_.sag;
    c.kind = carriage_ && !request_.span ? Kind::sag_at_carriage : Kind::sag_of_span;
    if (c.kind == Kind::sag_at_carriage) return;
    if (!p_.model.reevings[c.reeving].guides.empty()) {
      complain("sag", fmt::format("the spans of '{}' change at its guides with 'holds': give its 'winch_pull' or "
                                  "'loop_length'",
                                  request_.reeving));
    }
    const int spans = machine::branch_count(p_.model.reevings[c.reeving]);
    c.span = request_.span ? *request_.span - 1 : longest_span(p_.model, c.reeving);
    if (c.span >= spans) complain("span", fmt::format("'{}' has {} free spans", request_.reeving, spans));
  }

  void free(solve::Condition& c) {
    c.kind = Kind::free_running;
    if (!request_.free_running) return complain("free_running", "false says nothing: give one of the modes");
    if (!carriage_) return complain("free_running", "needs 'carriage' and 'x': where it is to stand");
    const machine::Carriage& car = p_.model.carriages[*carriage_];
    const bool clamped = p_.model.reevings[car.reeving].nodes[car.node].kind == machine::NodeKind::clamp;
    if (car.mainline || clamped) {
      complain("free_running", fmt::format("'{}' is {}", car.name, clamped ? "clamped" : "held by its mainline"));
    }
  }

  const GivenRequest& request_;
  std::optional<int> carriage_;
  std::string path_;
  Names& p_;
};

}  // namespace

int longest_span(const machine::Model& m, int reeving) {
  const machine::State state = machine::initial_state(m);
  const auto& nodes = m.reevings[reeving].nodes;
  int longest = 0;
  double most = 0;
  for (int k = 0; k < machine::branch_count(m.reevings[reeving]); ++k) {
    const auto& next = nodes[as_size(k + 1) % nodes.size()];
    const double chord = (machine::in_ground(state, next.at) - machine::in_ground(state, nodes[k].at)).norm();
    if (chord <= most) continue;
    most = chord;
    longest = k;
  }
  return longest;
}

const Description& GivenRequest::describe() {
  static const Description d =
      Describe<GivenRequest>()
          .field(&GivenRequest::reeving, "reeving", "the rope whose length (or given tension) follows")
          .required()
          .field(&GivenRequest::winch_pull, "winch_pull", "F", si::N, "tension at its start; its length follows")
          .above(0)
          .at_most(strongest)
          .field(&GivenRequest::loop_length, "loop_length", "L", si::m,
                 "its unstretched length, in place of that in the machine")
          .above(0)
          .at_most(farthest)
          .field(&GivenRequest::sag, "sag", "f", si::m,
                 "sag of the carriage below the line between its supports; without a carriage, of a free span below "
                 "its chord at half its horizontal length")
          .above(0)
          .at_most(farthest)
          .field(
              &GivenRequest::free_running, "free_running",
              "true: the carriage, rolling and without mainline, is in equilibrium at its place without another force")
          .field(&GivenRequest::of, "of",
                 "the rope that the winch pulls, or all ropes of the loop; default: this rope alone")
          .field(&GivenRequest::efficiency, "efficiency", "eta", si::one,
                 "efficiency of the lead sheaves of a winch: the tension of the rope is winch_pull times this; "
                 "default: 1")
          .above(0)
          .at_most(1)
          .choice(&GivenRequest::at, "at", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "end of the path at which the winch pulls")
          .field(&GivenRequest::span, "span", "", si::one,
                 "number of the free span with the sag, from 1; default: the longest")
          .at_least(1)
          .exactly_one({"winch_pull", "loop_length", "sag", "free_running"});
  return d;
}

solve::Condition condition_of(const GivenRequest& request, std::optional<int> carriage, const std::string& path,
                              Names& names) {
  return GivenResolver(request, carriage, path, names).resolve();
}

}  // namespace taut::study
