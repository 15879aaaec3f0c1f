#include "taut/methods/mast_section/mast_section.hpp"

#include <fmt/format.h>

#include "taut/methods/mast_section/position.hpp"

namespace taut::mast_section {
namespace {

constexpr std::array<const char*, sizes.size()> size_words{"the tube",
                                                           "the solid square",
                                                           "the hollow square",
                                                           "the tube with the ropes paid out",
                                                           "the tube with one rope hauled in, the other paid out",
                                                           "the tube with a rope at rest"};

/// Takes over one size, and what goes with it, from the position that governs it.
void take_size(std::size_t k, const Output& from, Output& out) {
  out.*sizes[k] = from.*sizes[k];
  if (sizes[k] == &Output::B_hollow) out.B_hollow_printed = from.B_hollow_printed;
  if (sizes[k] == &Output::D_tube_payout) {
    out.N_payout = from.N_payout;
    out.M_payout = from.M_payout;
  }
}

}  // namespace

template <class T>
Outcome compute_governing(const Input& in, const Governing& governing, Sheet<T>& s, Output& out) {
  if (!governing.outcome.ok()) {
    compute_at(in, 0, s, out);  // the steps up to where it fails
    return governing.outcome;
  }
  Outcome outcome = compute_at(in, governing.of[0], s, out);
  for (std::size_t k = 1; k < sizes.size() && outcome.ok(); ++k) {
    if (governing.of[k] == governing.of[0]) continue;
    s.section(fmt::format("Where {} is governed by another carriage position", size_words[k]));
    Output there;
    outcome = compute_at(in, governing.of[k], s, there);
    take_size(k, there, out);
  }
  out.D_tube_worst = worst_tube(out);
  return outcome;
}

template Outcome compute_governing<double>(const Input&, const Governing&, Sheet<double>&, Output&);
template Outcome compute_governing<Num>(const Input&, const Governing&, Sheet<Num>&, Output&);

template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out) {
  if (position_count(in) == 1) return compute_at(in, 0, s, out);
  return compute_governing(in, governing_of(sweep(in)), s, out);
}

template Outcome compute<double>(const Input&, Sheet<double>&, Output&);
template Outcome compute<Num>(const Input&, Sheet<Num>&, Output&);

Outcome solve(const Input& in, Output& out) {
  Sheet<double> s;
  return compute(in, s, out);
}

}  // namespace taut::mast_section
