#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

std::string designation_words(const std::string& id) {
  const catalogue::RopeRow* row = catalogue::rope_of_id(id);
  return row == nullptr ? id : catalogue::words_of_rope(*row);
}

/// The largest of these values that exist, with its words; nullptr: none exists.
const Value* largest(const Result& r, std::initializer_list<const char*> names) {
  const Value* most = nullptr;
  for (const char* name : names) {
    const Value* v = r.find_value(name);
    if (v != nullptr && (most == nullptr || v->value > most->value)) most = v;
  }
  return most;
}

/// A sag at the carriage, its position, and the length of the loop there; m.
struct Sag {
  double f;
  double x;
  double loop;
};

/// Where the sag of a position is deeper.
void deepen(const Table& positions, Sag& sag) {
  constexpr double alike = 1e-9;  // a sag that is given is that of each position
  for (std::size_t i = 0; i < positions.rows.size(); ++i) {
    const double f = number_in(positions, i, "f");
    if (!(f > sag.f * (1 + alike))) continue;
    sag = {.f = f, .x = number_in(positions, i, "x"), .loop = number_in(positions, i, "loop_length_exact")};
  }
}

}  // namespace

std::vector<Answer> answers(const Input& in, const Result& r, const Display& display) {
  Result lines;
  const auto shown = [&](const Value& v) { return display.brief(v.value, v.unit); };
  if (const Table* ropes = r.find_table("ropes")) {
    std::vector<std::string> parts, loads;
    for (std::size_t i = 0; i < ropes->rows.size(); ++i) {
      const std::string role = text_in(*ropes, i, "role");
      const Value* length = r.find_value(role + "_length_exact");
      parts.push_back(fmt::format("{} rope {}{}", role, designation_words(text_in(*ropes, i, "designation")),
                                  length == nullptr ? "" : fmt::format(", {} unstretched", shown(*length))));
      loads.push_back(
          fmt::format("{} rope {} ({}), factor {}", role, display.brief(number_in(*ropes, i, "largest_tension"), si::N),
                      text_in(*ropes, i, "where"), display.brief(number_in(*ropes, i, "safety_factor"), si::one)));
    }
    add_answer_line(lines, in.choose_ropes ? build_label : given_label, parts);
    add_answer_line(lines, "Load", loads);
  } else {
    std::vector<std::string> areas;
    for (const char* role : {"return", "traction"}) {
      const Value* area = r.find_value(fmt::format("F_{}", role));
      if (area != nullptr) areas.push_back(fmt::format("{} rope of {} metallic area", role, shown(*area)));
    }
    add_answer_line(lines, needs_label, areas);
  }
  const Value* x = r.find_value("x");
  const std::string place = x == nullptr ? std::string() : fmt::format(", carriage at {}", shown(*x));
  const Value* exact =
      largest(r, {"T_uA_exact", "T_uB_exact", "T_lA_exact", "T_lB_exact", "T_12_exact", "T_winch_exact"});
  if (const Value* T = exact != nullptr ? exact : largest(r, {"T_uA", "T_uB", "T_lA", "T_lB", "T_12", "T_winch"})) {
    add_answer_line(lines, "Tension", {fmt::format("{}, {}{}", shown(*T), T->label, place)});
  }
  if (const Value* f = r.find_value("f")) {
    Sag sag{.f = f->value, .x = number_of(r, "x"), .loop = number_of(r, "loop_length_exact")};
    if (const Table* positions = r.find_table("positions")) deepen(*positions, sag);
    std::vector<std::string> parts = {
        fmt::format("{} at the carriage, carriage at {}", display.brief(sag.f, si::m), display.brief(sag.x, si::m))};
    if (std::isfinite(sag.loop))
      parts.push_back(fmt::format("the loop is {} long, unstretched", display.brief(sag.loop, si::m)));
    add_answer_line(lines, "Sag", parts);
  }
  return lines.answers;
}

}  // namespace taut::closed_loop
