#include "taut/app/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "taut/app/design/design_method.hpp"
#include "taut/app/embedded/examples.hpp"
#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/app/exact/friction_drive_exact.hpp"
#include "taut/app/exact/mast_section_exact.hpp"
#include "taut/app/method_checks.hpp"
#include "taut/base/expects.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::app {
namespace {

std::string_view example_of(const std::string& method) {
  for (const auto& [file, text] : embedded::examples) {
    if (file == method + ".yaml") return text;
  }
  expects(false, "no example for " + method);
  return {};
}

/// The blocks of a deck beside its input.
struct MethodBlocks {
  std::optional<checks::ChecksRequest> checks;
  std::optional<design::DesignRequest> design;
  static const Description& describe() {
    static const Description d =
        Describe<MethodBlocks>()
            .record(&MethodBlocks::checks, "checks", "which parts are checked by which rules")
            .record(&MethodBlocks::design, "design", "free choices; the best one that passes all checks is found");
    return d;
  }
};

/// All that a method does with its input.
template <class Input>
struct MethodWay {
  std::string name;
  std::vector<Complaint> (*complaints)(const Input&) = nullptr;
  Result (*run)(const Input&) = nullptr;
  void (*complete)(const Input&, Result&) = nullptr;
  MethodChecks<Input> offered;
  MethodDesign<Input> design;
};

/// A deck as read, or as a design has changed it.
template <class Input>
struct MethodDeck {
  MethodWay<Input> way;
  Input in;
  MethodBlocks blocks;
  std::map<std::string, catalogue::RopeRow> chosen;

  std::vector<rope::RopeUse> ropes(const Result* r) const {
    if (way.offered.ropes == nullptr) return {};
    std::vector<rope::RopeUse> all = way.offered.ropes(in, r);
    for (rope::RopeUse& use : all) {
      if (const auto row = chosen.find(use.name); row != chosen.end()) use.rope = row->second;
    }
    return all;
  }

  Result calculate() const {
    Result r = way.run(in);
    if (way.complete != nullptr) way.complete(in, r);
    if (blocks.checks) add_method_checks(*blocks.checks, ropes(&r), r);
    std::erase_if(r.unjudged, [&](const std::string& part) {
      return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.part == part && c.limits; });
    });
    return r;
  }

  /// Notes what is wrong with input and checks.
  void complain(const io::Node& input, const io::Node* others, Diagnostics& mistakes) const {
    const std::vector<Complaint> broken = way.complaints(in);
    io::place(input, broken, mistakes);
    if (!broken.empty() || !blocks.checks) return;
    io::place(*others, method_check_complaints(*blocks.checks, ropes(nullptr), way.name), mistakes);
  }
};

/// The copy of a deck that a design changes.
template <class Input>
std::shared_ptr<MethodCopy> copy_of(const MethodDeck<Input>& deck) {
  const auto own = std::make_shared<MethodDeck<Input>>(deck);
  const auto copy = std::make_shared<MethodCopy>();
  const MethodDesign<Input>& d = deck.way.design;
  copy->parameter = [own](const std::string& path) {
    return study::find_parameter(Input::describe(), &own->in, path.starts_with("input.") ? path.substr(6) : path);
  };
  if (d.put_rope != nullptr) {
    copy->put_rope = [own](const std::string& name, const catalogue::RopeRow& row, double modulus) {
      own->way.design.put_rope(own->in, name, row, modulus);
      own->chosen[name] = row;
    };
  }
  if (d.put_section != nullptr) {
    copy->put_section = [own](const std::string& section) { own->way.design.put_section(own->in, section); };
  }
  if (d.rope_length != nullptr) {
    copy->rope_length = [own](const std::string& rope) { return own->way.design.rope_length(own->in, rope); };
  }
  if (d.height != nullptr) copy->height = [own] { return own->way.design.height(own->in); };
  if (d.mass != nullptr) copy->mass = [own] { return own->way.design.mass(own->in); };
  if (d.refuse != nullptr) copy->refused = d.refuse(own->in);
  if (own->blocks.checks) copy->checks = &*own->blocks.checks;
  for (const rope::RopeUse& use : own->ropes(nullptr)) copy->ropes.push_back(use.name);
  copy->run = [own] {
    // what a design has put in may not fit the method
    const std::vector<Complaint> broken = own->way.complaints(own->in);
    if (broken.empty()) return own->calculate();
    Result r;
    r.status = Status::infeasible;
    r.message = fmt::format("{}: {}", broken.front().path, broken.front().message);
    return r;
  };
  copy->complain = [own](const io::Node& input, const io::Node* others, Diagnostics& mistakes) {
    own->complain(input, others, mistakes);
  };
  copy->tensions = [own](const Result& r) {
    std::map<std::string, double> all;
    for (const rope::RopeUse& use : own->ropes(&r)) all[use.name] = use.tension;
    return all;
  };
  return copy;
}

template <class Input>
std::function<Result()> prepare_method(const MethodWay<Input>& way, const io::Node& node, const io::Node* others,
                                       const std::function<bool(const Progress&)>& progress, Diagnostics& mistakes) {
  const auto deck = std::make_shared<MethodDeck<Input>>();
  deck->way = way;
  const std::size_t before = mistakes.size();
  io::read(node, Input::describe(), &deck->in, "the input of " + way.name, mistakes);
  if (others != nullptr) io::read(*others, MethodBlocks::describe(), &deck->blocks, "the deck", mistakes);
  if (mistakes.size() > before) return {};
  if (!deck->blocks.design) {
    deck->complain(node, others, mistakes);
    if (mistakes.size() > before) return {};
    return [deck] { return deck->calculate(); };
  }
  const design::DesignRequest& design = *deck->blocks.design;
  const CopyMethod copy = [deck] { return copy_of(*deck); };
  design::DesignSpace space = method_space(*others, design, *copy(), mistakes);
  if (mistakes.size() > before) return {};
  // what is free is read as the first of its candidates
  const auto first = copy();
  put_design(*first, space, design::first_place(space));
  first->complain(node, others, mistakes);
  if (mistakes.size() > before) return {};
  const design::DesignTask task = method_task(design, std::move(space), copy, progress);
  return [task] { return design::run_design(task); };
}

template <class Input, class Output>
MethodEntry entry(const Method& about, const MethodWay<Input>& way, const Description* exact = nullptr) {
  MethodEntry e;
  e.about = &about;
  e.input = &Input::describe();
  e.output = &Output::describe();
  e.exact = exact;
  e.example = example_of(about.name);
  e.prepare = [way](const io::Node& node, const io::Node* others, const std::function<bool(const Progress&)>& progress,
                    Diagnostics& mistakes) { return prepare_method(way, node, others, progress, mistakes); };
  return e;
}

}  // namespace

const std::vector<MethodEntry>& methods() {
  static const std::vector<MethodEntry> all = {
      entry<mast_section::Input, mast_section::Output>(mast_section::about(),
                                                       {.name = "mast_section",
                                                        .complaints = mast_section::complaints,
                                                        .run = run_mast_section,
                                                        .complete = complete_mast_section,
                                                        .offered = {ropes_of_mast},
                                                        .design = design_of_mast()},
                                                       &MastSectionExact::describe()),
      entry<closed_loop::Input, closed_loop::Output>(closed_loop::about(), {.name = "closed_loop",
                                                                            .complaints = closed_loop::complaints,
                                                                            .run = run_closed_loop,
                                                                            .complete = nullptr,
                                                                            .offered = {ropes_of_loop},
                                                                            .design = design_of_loop()}),
      entry<friction_drive::Input, friction_drive::Output>(friction_drive::about(),
                                                           {.name = "friction_drive",
                                                            .complaints = friction_drive::complaints,
                                                            .run = friction_drive::run,
                                                            .complete = complete_friction_drive,
                                                            .offered = {ropes_of_drive},
                                                            .design = design_of_drive()},
                                                           &FrictionDriveExact::describe()),
      entry<boom_ropes::Input, boom_ropes::Output>(boom_ropes::about(), {.name = "boom_ropes",
                                                                         .complaints = boom_ropes::complaints,
                                                                         .run = boom_ropes::run,
                                                                         .complete = nullptr,
                                                                         .offered = {ropes_of_boom},
                                                                         .design = design_of_boom()}),
  };
  return all;
}

const MethodEntry* find_method(std::string_view name) {
  const auto& all = methods();
  const auto at = std::find_if(all.begin(), all.end(), [&](const MethodEntry& e) { return e.about->name == name; });
  return at == all.end() ? nullptr : &*at;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodEntry& e : methods()) names.push_back(e.about->name);
  return names;
}

}  // namespace taut::app
