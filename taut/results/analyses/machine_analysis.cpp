#include "taut/results/analyses/machine_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/suggest.hpp"
#include "taut/study/carriage_way.hpp"

namespace taut::results {
namespace {

template <class Things>
int named(const Things& things, std::string_view kind, const std::string& name, const std::string& path,
          std::vector<Complaint>& complaints) {
  std::vector<std::string> names;
  for (const auto& one : things) {
    if (one.name == name) return static_cast<int>(names.size());
    names.push_back(one.name);
  }
  complaints.push_back({path, fmt::format("there is no {} '{}'{}", kind, name, did_you_mean(name, names))});
  return -1;
}

}  // namespace

int carriage_of(Preparation& p, const std::string& name, const std::string& path) {
  return named(p.model.carriages, "carriage", name, path, p.complaints);
}

int reeving_of(Preparation& p, const std::string& name, const std::string& path) {
  return named(p.model.reevings, "reeving or guy", name, path, p.complaints);
}

std::string ending_of(Preparation& p, const std::string& kind, const std::optional<std::string>& name,
                      const std::string& path) {
  const auto before = std::count_if(p.endings.begin(), p.endings.end(), [&](const auto& e) { return e.first == kind; });
  const std::string text = name ? "_" + *name : before == 0 ? std::string{} : fmt::format("_{}", before + 1);
  if (std::find(p.endings.begin(), p.endings.end(), std::pair(kind, text)) != p.endings.end()) {
    p.complaints.push_back({path + ".name", "another analysis of this kind has the same name"});
  }
  // it becomes part of files' names
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!plain || (name && name->empty())) {
    p.complaints.push_back({path + ".name", "a name of letters, digits, _ and - is expected"});
  }
  p.endings.emplace_back(kind, text);
  return text;
}

std::optional<machine::Prescribed> prescribed_of(const std::optional<std::string>& carriage,
                                                 const std::optional<double>& x, const std::vector<double>& along,
                                                 const std::string& path, Preparation& p) {
  const Vector3 way = study::direction_of(along, path + ".along", p.complaints);
  if (carriage.has_value() != x.has_value()) {
    p.complaints.push_back({path, "'carriage' and 'x' belong together"});
    return std::nullopt;
  }
  if (!carriage) return std::nullopt;
  const int car = carriage_of(p, *carriage, path + ".carriage");
  if (car < 0) return std::nullopt;
  if (const machine::Node* support = study::support_at(p.model, car, *x, way)) {
    p.complaints.push_back({path + ".x", fmt::format("the carriage would be on '{}', in no span", support->name)});
  }
  study::check_hold(p.model, car, p.complaints);
  return machine::Prescribed{car, *x, way, {}};
}

Outcome install_guys(const machine::Machine& machine, machine::Model& model) {
  const std::size_t first = machine.reevings.size();
  machine::Model bare;
  bare.gravity = model.gravity;
  bare.bodies = model.bodies;
  for (machine::Body& body : bare.bodies) body.free.clear();
  bare.reevings.assign(model.reevings.begin() + static_cast<std::ptrdiff_t>(first), model.reevings.end());
  if (bare.reevings.empty()) return {};
  solve::EquilibriumOptions options;
  options.band = false;
  const auto result = solve::equilibrium(bare, options);
  if (!result.outcome.ok()) {
    return {result.outcome.status, fmt::format("the guys can't be put up: {}", result.outcome.message)};
  }
  const machine::Model done = solve::installed(bare, result);
  std::copy(done.reevings.begin(), done.reevings.end(), model.reevings.begin() + static_cast<std::ptrdiff_t>(first));
  return {};
}

void note_failure(Result& r, const Outcome& outcome, const std::string& what) {
  if (outcome.ok() || r.status != Status::ok) return;
  r.status = outcome.status;
  r.message = fmt::format("{}: {}", what, outcome.message);
}

}  // namespace taut::results
