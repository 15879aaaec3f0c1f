#pragma once
#include <optional>
#include <string>

#include "taut/calc/field.hpp"

/// The keys of an elastic beam in a deck: plain values, references by name, one `describe` table each.
namespace taut::machine::description {

/// Initial imperfection of a beam, free of stress.
struct Imperfection {
  std::optional<double> bow;   ///< e/L of a half sine wave
  std::optional<double> sway;  ///< tangent of the inclination
  std::optional<Triple> towards;
  static const Description& describe();
};

enum class BeamBase { clamped, hinge };
enum class BeamEnd { usual, free, clamped, hinge };
enum class Order { first, second };

struct Beam {
  std::string name;
  std::string from;
  std::string to;
  std::optional<std::string> section;  ///< in the catalogue
  std::optional<double> A;             ///< m2
  std::optional<double> I;             ///< m4
  std::optional<double> I_weak;        ///< m4; default: I
  std::optional<double> J;             ///< torsion, m4; default: I + I_weak
  std::optional<double> W_t;           ///< m3; default: not known, of a round one 2 W
  bool round = false;                  ///< the section by figures; false: not said, a box if its axes are
  std::optional<double> W;             ///< m3
  std::optional<double> W_weak;        ///< m3; default: W
  double E = 210e9;                    ///< Pa
  std::optional<double> mass;          ///< kg/m; default: the catalogue's, or A times 7850 kg/m3
  std::optional<std::string> steel;
  double expansion = 12e-6;                     ///< 1/K, EN 1993-1-1, 3.2.6
  std::optional<double> reference_temperature;  ///< K
  std::optional<Triple> strong;
  int elements = 16;
  BeamBase base = BeamBase::clamped;
  BeamEnd top = BeamEnd::usual;
  Order order = Order::second;
  std::optional<Imperfection> imperfection;
  static const Description& describe();
};

}  // namespace taut::machine::description
