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

/// The row of contacts from the end of line `k`, each of which may pass rope, up to the next slack line; none where
/// something on the way holds the rope.
void row_after(const Mechanism& m, const Values& now, int k, Array<int>& row) {
  row.clear();
  for (;;) {
    const int c = m.lines[k].contact[1];
    const bool passes = c >= 0 && !m.contacts[c].load && now.contacts[c].grip != Grip::stuck;
    if (!passes || m.contacts[c].out < 0) break;
    row.push_back(c);
    k = m.contacts[c].out;
    if (!(now.lines[k].T > 0)) return;
    if (row.size() > m.contacts.size()) break;  // round an endless rope
  }
  row.clear();
}

}  // namespace

void hold_between_slack(const Mechanism& m, const Values& now, Array<double>& step) {
  if (m.contacts.size() < 2) return;
  Array<int> row;
  for (int k = 0; k < static_cast<int>(m.lines.size()); ++k) {
    if (now.lines[k].T > 0) continue;
    row_after(m, now, k, row);
    if (row.size() < 2) continue;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    double open = 0;  // what the lines between are too long or too short
    for (const int c : row) {
      const double passes = step[m.contacts[c].column];
      least = std::min(least, passes);
      most = std::max(most, passes);
      const LineValues& line = now.lines[m.contacts[c].in];
      if (line.T > 0) open += line.e * line.L;
    }
    const double too_far = least > open ? least - open : most < -open ? most + open : 0;
    for (const int c : row) step[m.contacts[c].column] -= too_far;
  }
}

bool put_loose_back(const Mechanism& m, const Scheme& s, const Values& before, Values& now) {
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
      const double lay =
          before.q[contact.column] + (s.fresh || s.at_rest ? 0 : s.h * loose_flow(contact, before.contacts[i], before));
      const double by = std::clamp(lay - q, -spare(out), spare(in));
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
