// A calculation of your own that shows its work: each line with its formula, its numbers and its unit, as in a report.
#include <cmath>
#include <iostream>

#include "taut/calc/sheet.hpp"
#include "taut/units/parse.hpp"

namespace {

struct Input {
  double load = taut::parse_quantity("20 kN", taut::si::N).value();
  double efficiency = 0.97;
  double falls = 4;
  static const taut::Description& describe() {
    static const taut::Description d =
        taut::Describe<Input>()
            .field(&Input::load, "load", "Q", taut::si::N, "weight on the hook")
            .field(&Input::efficiency, "efficiency", "eta", taut::si::one, "of one sheave")
            .field(&Input::falls, "falls", "n", taut::si::one, "falls that carry the load");
    return d;
  }
};

/// The pull on the lead line of a tackle, hoisting: written once, for `double` and for `Num`.
template <class T>
T lead_line(const Input& in, taut::Sheet<T>& s) {
  using std::exp, std::log;
  const T Q = s.given(in.load), eta = s.given(in.efficiency), n = s.given(in.falls);
  const T share = s.eq("1", "s", taut::si::one, (1 - exp(n * log(eta))) / (1 - eta));
  return s.eq("2", "P", taut::si::N, Q / share);
}

}  // namespace

int main() {
  const Input in;
  taut::Sheet<double> quick;  // costs what the formula costs
  taut::Sheet<taut::Num> note("tackle", Input::describe(), &in);
  const taut::Num P = lead_line(in, note);
  taut::Result result;
  note.move_to(result);
  for (const taut::Step& line : result.steps) {
    if (!line.symbol.empty()) std::cout << "(" << line.eq << ") " << line.symbol << " = " << line.value << "\n";
  }
  return taut::value(P) == lead_line(in, quick) ? 0 : 1;
}
