#include "taut/units/names.hpp"

#include "taut/units/unit.hpp"

namespace taut {

const std::vector<NameRow>& name_rows() {
  static const std::vector<NameRow> rows = {
      {"m", "m", "metre", "length", si::m.dimension},
      {"mm", "mm", "millimetre", "length", si::m.dimension},
      {"cm", "cm", "centimetre", "length", si::m.dimension},
      {"dm", "dm", "decimetre", "length", si::m.dimension},
      {"km", "km", "kilometre", "length", si::m.dimension},
      {"um", "um", "micrometre", "length", si::m.dimension},
      {"in", "inch", "inch, 25.4 mm", "length", si::m.dimension},
      {"ft", "international_foot", "foot, 0.3048 m", "length", si::m.dimension},
      {"yd", "international_yard", "yard, 0.9144 m", "length", si::m.dimension},
      {"s", "s", "second", "time", si::s.dimension},
      {"ms", "ms", "millisecond", "time", si::s.dimension},
      {"us", "us", "microsecond", "time", si::s.dimension},
      {"min", "min", "minute", "time", si::s.dimension},
      {"h", "h", "hour", "time", si::s.dimension},
      {"kg", "kg", "kilogram", "mass", si::kg.dimension},
      {"g", "g", "gram", "mass", si::kg.dimension},
      {"t", "tonne", "tonne, 1000 kg", "mass", si::kg.dimension},
      {"lb", "0.45359237 kg", "pound mass, 0.45359237 kg", "mass", si::kg.dimension},
      {"N", "N", "newton", "force", si::N.dimension},
      {"daN", "daN", "decanewton", "force", si::N.dimension},
      {"kN", "kN", "kilonewton", "force", si::N.dimension},
      {"MN", "MN", "meganewton", "force", si::N.dimension},
      {"kgf", "kilogram_force", "kilogram-force, 9.80665 N", "force", si::N.dimension},
      {"tf", "1000 kilogram_force", "tonne-force, 9806.65 N", "force", si::N.dimension},
      {"lbf", "pound_force", "pound-force, 4.4482216 N", "force", si::N.dimension},
      {"kip", "1000 pound_force", "1000 pound-force", "force", si::N.dimension},
      {"Pa", "Pa", "pascal", "stress", si::Pa.dimension},
      {"kPa", "kPa", "kilopascal", "stress", si::Pa.dimension},
      {"MPa", "MPa", "megapascal, N/mm2", "stress", si::Pa.dimension},
      {"GPa", "GPa", "gigapascal", "stress", si::Pa.dimension},
      {"bar", "bar", "bar, 0.1 MPa", "stress", si::Pa.dimension},
      {"psi", "psi", "pound-force per square inch", "stress", si::Pa.dimension},
      {"ksi", "1000 psi", "1000 psi", "stress", si::Pa.dimension},
      {"J", "J", "joule", "energy", si::J.dimension},
      {"kJ", "kJ", "kilojoule", "energy", si::J.dimension},
      {"MJ", "MJ", "megajoule", "energy", si::J.dimension},
      {"W", "W", "watt", "power", si::W.dimension},
      {"kW", "kW", "kilowatt", "power", si::W.dimension},
      {"MW", "MW", "megawatt", "power", si::W.dimension},
      {"Hz", "Hz", "hertz", "frequency", si::per_s.dimension},
      {"K", "K", "kelvin", "temperature", dimension(0, 0, 0, 1)},
      {"degC", "degC", "degree Celsius, for a temperature alone", "temperature", dimension(0, 0, 0, 1)},
      {"rad", "radian", "radian", "angle", {}, true},
      {"mrad", "milliradian", "milliradian", "angle", {}, true},
      {"deg", "arc_degree", "degree", "angle", {}, true},
      {"°", "arc_degree", "degree", "angle", {}, true},
      {"gon", "0.9 arc_degree", "gon, 1/400 of a turn", "angle", {}, true},
      {"%", "0.01", "slope, atan(p/100); or a hundredth of a plain number", "angle", {}, true},
  };
  return rows;
}

const std::vector<RefusedName>& refused_names() {
  static const std::vector<RefusedName> rows = {
      {"ton", "'t' (1000 kg), 'tf' (9806.65 N) or kilograms: a ton can be 907, 1000 or 1016 kg"},
      {"tons", "'t' (1000 kg), 'tf' (9806.65 N) or kilograms: a ton can be 907, 1000 or 1016 kg"},
      {"T", "'t' (1000 kg) or 'tf' (9806.65 N): T is tesla"},
      {"kn", "'kN' (force); a knot is '0.514444 m/s'"},
      {"KN", "'kN' (force)"},
      {"Kn", "'kN' (force)"},
      {"lbs", "'lb' (mass) or 'lbf' (force)"},
      {"hp", "'kW': a horsepower can be 735.5 or 745.7 W"},
      {"HP", "'kW': a horsepower can be 735.5 or 745.7 W"},
      {"rpm", "'rad/s' or the rope speed in 'm/s'"},
      {"kp", "'kgf' (9.80665 N)"},
      {"Mp", "'tf' (9806.65 N)"},
      {"kg-f", "'kgf' (9.80665 N)"},
      {"degree", "'deg'"},
      {"degrees", "'deg'"},
      {"grad", "'gon' (1/400 of a turn) or 'deg'"},
      {"C", "'degC' (temperature); a coulomb has no use here"},
      {"F", "'degC' (temperature)"},
      {"M", "'m' (length)"},
      {"mN", "'N' or 'MN': millinewtons have no use here"},
      {"mPa", "'MPa': millipascals have no use here"},
      {"sec", "'s'"},
      {"hr", "'h'"},
      {"meter", "'m'"},
      {"metre", "'m'"},
      {"a", "'m2': an are is 100 m2"},
      {"\"", "'in' (25.4 mm)"},
      {"'", "'ft' (0.3048 m)"},
  };
  return rows;
}

}  // namespace taut
