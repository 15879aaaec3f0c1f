#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/num.hpp"
#include "taut/rope/rope_use.hpp"

/// Life of a running rope in bending cycles. docs/theory/rope-life.md
namespace taut::rope {

/// Constants of one rope for one count of cycles (mean number to the break, ...).
struct LifeConstants {
  std::string count;          ///< "mean_break", "break_10", "discard", "discard_10"
  std::array<double, 4> a{};  ///< a0, a1, a2, a3
  std::string words;          ///< where they come from
  std::string trust;
};

/// Endurance factor of the rope's diameter (m): 0.52/(-0.48 + (d/16 mm)^0.3); 1 at 16 mm, 1.96 at 6 mm. It has a pole
/// at 1.385 mm, so life_of takes thinner ropes than 6 mm as those of 6 mm. Feyrer, Wire Ropes, table 3.14a.
template <class T>
T life_of_diameter(const T& ratio_to_16mm) {
  using std::exp, std::log;
  return 0.52 / (-0.48 + exp(0.3 * log(ratio_to_16mm)));
}

/// Endurance factor of the bent length l: 1.49/(2.49 - ((l/d - 2.5)/57.5)^-0.14); 1 at l = 60 d, 0.598 of an endless
/// one. As printed for l/d > 2.585, where it has a pole; life_of takes it from 60 d on. The same table.
template <class T>
T life_of_length(const T& length_over_d) {
  using std::exp, std::log;
  return 1.49 / (2.49 - exp(-0.14 * log((length_over_d - 2.5) / 57.5)));
}

/// lg N of bending over sheaves: a0 + (a1 + a3 lg(D/d)) (lg(S/d^2) - 0.4 lg(R0/1770)) + a2 lg(D/d) + lg f, with S/d^2
/// and R0 in N/mm^2; `pull` = S d0^2/(d^2 S0), `grade` = R0/1770, `ratio` = D/d, `factors` = f_d f_L f_C. Feyrer, Wire
/// Ropes, general form as recalled.
template <class T>
T log_cycles(const LifeConstants& c, const T& pull, const T& grade, const T& ratio, const T& factors) {
  using std::log;
  const double ln10 = std::numbers::ln10;
  const T lg_ratio = log(ratio) / ln10;
  return c.a[0] + (c.a[1] + c.a[3] * lg_ratio) * (log(pull) / ln10 - 0.4 * (log(grade) / ln10)) + c.a[2] * lg_ratio +
         log(factors) / ln10;
}

/// What happens so often in the wanted life.
struct Duty {
  std::string name;
  double cycles = 0;              ///< working cycles
  double load = 1;                ///< share of the largest tension at each bend
  std::vector<std::string> over;  ///< the rounds that bend the rope in it; empty: all
};

/// Whether a duty bends the rope there: over a sheave or a drum, under tension.
bool counts(const Duty& duty, const Bend& bend);

/// What a life is computed from besides the use.
struct LifeRules {
  std::vector<Duty> duty;
  std::vector<LifeConstants> constants;
  double core_factor = 1;  ///< f_C
  std::string core_words;
  std::optional<double> bent_length;  ///< l, m; none, or shorter than that: 60 d
  double reverse_weight = 1;          ///< of a bending in the sense opposite to the one before
  double dynamic_factor = 1;
};

/// One bend in one duty.
struct LifeLine {
  std::string duty, bend;
  double ratio = 0;    ///< D/d
  double pull = 0;     ///< S, N
  double cycles = 0;   ///< bendings: working cycles times 1 (sheave), 0.5 (drum), or the reverse weight
  double endures = 0;  ///< N
  double damage = 0;   ///< cycles/endures
};

/// Whether two neighbours that turn the rope about these axes bend it in opposite senses.
bool turns_back(const Vector3& before, const Vector3& about);

/// Life by Palmgren and Miner for one count: sum of n/N over all bends of all duties.
struct Life {
  const LifeConstants* constants = nullptr;
  std::vector<LifeLine> lines;
  double damage = 0;      ///< at most 1 in the wanted life; how often the duty list can run is its inverse
  bool reversed = false;  ///< some round turns against the one before
};
/// Whether every N is a number above 0, and the damage too. Constants of no rope give 10^lg N = 0 or infinite.
bool is_finite(const Life& life);

/// Saddles do not count: what runs over them slides. A drum is half a bending. Precondition: diameter > 1.4 mm and a
/// grade.
std::vector<Life> life_of(const RopeUse& use, const LifeRules& rules);

}  // namespace taut::rope
