#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/solve/motion/parts/values.hpp"

/// Rope that lies loose: branches without tension on either side of a contact share their rope as they did before.
namespace taut::solve::dynamics {
namespace {

constexpr double hardly = 1e-12;       ///< of a line's length
constexpr double hardly_taut = 1e-10;  ///< a strain that rounding leaves of a line that drums keep straight

bool has_no_tension(const Line& line, const LineValues& is) { return is.T <= hardly_taut * line.stiffness; }

/// What a slack line can give before it is straight, m; a broken one nearly all it has.
double spare(const LineValues& line) {
  constexpr double nearly_all = 0.5;
  return line.gone == 0 ? std::max(0.0, nearly_all * line.L) : std::max(0.0, line.L - on_rounds(line) - line.l);
}

}  // namespace

bool put_loose_back(const Mechanism& m, const Values& before, Values& now) {
  bool any = false;
  for (const bool back : {false, true}) {
    if (back && !any) break;
    for (std::size_t k = 0; k < m.contacts.size(); ++k) {
      const std::size_t i = back ? m.contacts.size() - 1 - k : k;
      const Contact& contact = m.contacts[i];
      if (contact.load || contact.in < 0 || contact.out < 0 || now.contacts[i].grip == Grip::stuck) continue;
      LineValues &in = now.lines[contact.in], &out = now.lines[contact.out];
      if (!has_no_tension(m.lines[contact.in], in) || !has_no_tension(m.lines[contact.out], out)) continue;
      double& q = now.q[contact.column];
      const double by = std::clamp(before.q[contact.column] - q, -spare(out), spare(in));
      if (std::abs(by) <= hardly * (in.l + out.l)) continue;
      q += by;
      in.L -= by;
      out.L += by;
      any = true;
    }
  }
  return any;
}

}  // namespace taut::solve::dynamics
