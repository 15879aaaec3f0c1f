#include "taut/app/method_deck.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "taut/app/design/design_method.hpp"
#include "taut/app/method_checks.hpp"
#include "taut/io/deck/read.hpp"

namespace taut::app {

const Description& MethodBlocks::describe() {
  static const Description d =
      Describe<MethodBlocks>()
          .record(&MethodBlocks::checks, "checks", "which parts are checked by which rules")
          .record(&MethodBlocks::study, "study", "many cases of this deck: what varies, and what is asked for")
          .record(&MethodBlocks::calibrate, "calibrate", "numbers of this deck that measurements shall tell")
          .record(&MethodBlocks::design, "design", "free choices; the best one that passes all checks is found");
  return d;
}

std::vector<rope::RopeUse> MethodDeck::ropes(const Result* r) const {
  std::vector<rope::RopeUse> all = method->ropes(input, r);
  for (rope::RopeUse& use : all) {
    use.display = display;
    const auto row = chosen.find(use.name);
    if (row == chosen.end()) continue;
    use.rope = row->second;
    use.chosen = true;
  }
  return all;
}

tl::expected<study::Parameter, std::string> MethodDeck::parameter(const std::string& path) {
  return study::find_parameter(*method->input, input.place(), path.starts_with("input.") ? path.substr(6) : path);
}

Result MethodDeck::calculate() const {
  Result r = method->run(input, display);
  if (r.status == Status::ok) r.answers = method->answers(input, r, display);
  if (!r.figures.empty()) r.key_figure = std::visit([](const auto& one) { return one.name; }, r.figures.front());
  if (blocks.checks) add_method_checks(*blocks.checks, asked, ropes(&r), display, r);
  std::erase_if(r.unjudged, [&](const std::string& part) {
    return std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return judges(c, part); });
  });
  return r;
}

checks::AskedChecks MethodDeck::resolve(const io::Node& node, const io::Node* others, Diagnostics& mistakes) const {
  const std::vector<Complaint> broken = method->complaints(input);
  io::place(node, broken, mistakes);
  if (!broken.empty() || !blocks.checks) return {};
  std::vector<Complaint> complaints;
  checks::AskedChecks found = resolve_checks(*blocks.checks, ropes(nullptr), method->about->name, complaints);
  io::place(*others, complaints, mistakes);
  return found;
}

namespace {

/// The deck, its checks not resolved.
MethodDeck as_written(const MethodEntry& method, const io::Node& node, const io::Node* others, const Display& display,
                      Diagnostics& mistakes) {
  MethodDeck deck{.method = &method, .input = method.input_of_defaults(), .display = display};
  io::read(node, *method.input, deck.input.place(), "the input of " + method.about->name, mistakes);
  if (others != nullptr) io::read(*others, MethodBlocks::describe(), &deck.blocks, "the deck", mistakes);
  return deck;
}

/// Whether no value is missing because its expression has none.
bool is_whole(const io::Node& node, const io::Node* others) {
  return !io::has_expression(node) && (others == nullptr || !io::has_expression(*others));
}

}  // namespace

std::optional<MethodDeck> read_method(const MethodEntry& method, const io::Node& node, const io::Node* others,
                                      const Display& display, Diagnostics& mistakes) {
  const std::size_t before = mistakes.size();
  MethodDeck deck = as_written(method, node, others, display, mistakes);
  if (deck.blocks.design) {
    io::place(*others,
              {{.path = "design",
                .message = "the cases of a study have their choices made: a method's deck with 'design' has not"}},
              mistakes);
  }
  if (mistakes.size() > before || !is_whole(node, others)) return std::nullopt;
  deck.asked = deck.resolve(node, others, mistakes);
  if (mistakes.size() > before) return std::nullopt;
  return deck;
}

std::function<Result()> prepare_method(const MethodEntry& method, const io::Node& node, const io::Node* others,
                                       const MethodSurroundings& around, Diagnostics& mistakes) {
  const std::size_t before = mistakes.size();
  MethodDeck deck = as_written(method, node, others, around.display, mistakes);
  if (mistakes.size() > before || !is_whole(node, others)) return {};
  if (!deck.blocks.design) {
    deck.asked = deck.resolve(node, others, mistakes);
    if (mistakes.size() > before) return {};
    return [deck = std::move(deck)] { return deck.calculate(); };
  }
  design::DesignSpace space = method_space(*others, deck, mistakes);
  if (mistakes.size() > before) return {};
  // what is free is read as the first of its candidates
  deck.asked = with_design(deck, space, design::first_place(space)).resolve(node, others, mistakes);
  if (mistakes.size() > before) return {};
  return [task = method_task(std::move(deck), std::move(space), around.progress)] { return design::run_design(task); };
}

}  // namespace taut::app
