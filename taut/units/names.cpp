#include "taut/units/names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "taut/units/unit.hpp"

namespace taut {
namespace {

constexpr UnitScale pound_force{44'482'216'152'605, 1e13};  // 0.45359237 kg of standard gravity, 9.80665 m/s^2

/// The same units in Cyrillic letters.
constexpr std::array<std::pair<std::string_view, std::string_view>, 33> cyrillic_names = {
    {{"м", "m"},     {"мм", "mm"}, {"см", "cm"},   {"дм", "dm"},     {"км", "km"},   {"с", "s"},     {"мс", "ms"},
     {"мин", "min"}, {"ч", "h"},   {"кг", "kg"},   {"г", "g"},       {"т", "t"},     {"Н", "N"},     {"даН", "daN"},
     {"кН", "kN"},   {"МН", "MN"}, {"кгс", "kgf"}, {"тс", "tf"},     {"Па", "Pa"},   {"кПа", "kPa"}, {"МПа", "MPa"},
     {"ГПа", "GPa"}, {"Дж", "J"},  {"кДж", "kJ"},  {"МДж", "MJ"},    {"Вт", "W"},    {"кВт", "kW"},  {"МВт", "MW"},
     {"Гц", "Hz"},   {"К", "K"},   {"рад", "rad"}, {"мрад", "mrad"}, {"град", "deg"}}};

const std::vector<NameRow>& latin_rows() {
  static const std::vector<NameRow> rows = {
      {"m", "metre", "length", si::m.dimension},
      {"mm", "millimetre", "length", si::m.dimension, false, {1, 1e3}},
      {"cm", "centimetre", "length", si::m.dimension, false, {1, 100}},
      {"dm", "decimetre", "length", si::m.dimension, false, {1, 10}},
      {"km", "kilometre", "length", si::m.dimension, false, {1e3}},
      {"um", "micrometre", "length", si::m.dimension, false, {1, 1e6}},
      {"in", "inch, 25.4 mm", "length", si::m.dimension, false, {254, 1e4}},
      {"ft", "foot, 0.3048 m", "length", si::m.dimension, false, {3048, 1e4}},
      {"yd", "yard, 0.9144 m", "length", si::m.dimension, false, {9144, 1e4}},
      {"s", "second", "time", si::s.dimension},
      {"ms", "millisecond", "time", si::s.dimension, false, {1, 1e3}},
      {"us", "microsecond", "time", si::s.dimension, false, {1, 1e6}},
      {"min", "minute", "time", si::s.dimension, false, {60}},
      {"h", "hour", "time", si::s.dimension, false, {3600}},
      {"kg", "kilogram", "mass", si::kg.dimension},
      {"g", "gram", "mass", si::kg.dimension, false, {1, 1e3}},
      {"t", "tonne, 1000 kg", "mass", si::kg.dimension, false, {1e3}},
      {"lb", "pound mass, 0.45359237 kg", "mass", si::kg.dimension, false, {45359237, 1e8}},
      {"N", "newton", "force", si::N.dimension},
      {"daN", "decanewton", "force", si::N.dimension, false, {10}},
      {"kN", "kilonewton", "force", si::N.dimension, false, {1e3}},
      {"MN", "meganewton", "force", si::N.dimension, false, {1e6}},
      {"kgf", "kilogram-force, 9.80665 N", "force", si::N.dimension, false, {980665, 1e5}},
      {"tf", "tonne-force, 9806.65 N", "force", si::N.dimension, false, {980665, 100}},
      {"lbf", "pound-force, 4.4482216 N", "force", si::N.dimension, false, pound_force},
      {"kip", "1000 pound-force", "force", si::N.dimension, false, {pound_force.over, 1e10}},
      {"Pa", "pascal", "stress", si::Pa.dimension},
      {"kPa", "kilopascal", "stress", si::Pa.dimension, false, {1e3}},
      {"MPa", "megapascal, N/mm2", "stress", si::Pa.dimension, false, {1e6}},
      {"GPa", "gigapascal", "stress", si::Pa.dimension, false, {1e9}},
      {"bar", "bar, 0.1 MPa", "stress", si::Pa.dimension, false, {1e5}},
      {"psi", "pound-force per square inch", "stress", si::Pa.dimension, false, {pound_force.over, 6'451'600'000}},
      {"ksi", "1000 psi", "stress", si::Pa.dimension, false, {pound_force.over, 6'451'600}},
      {"J", "joule", "energy", si::J.dimension},
      {"kJ", "kilojoule", "energy", si::J.dimension, false, {1e3}},
      {"MJ", "megajoule", "energy", si::J.dimension, false, {1e6}},
      {"W", "watt", "power", si::W.dimension},
      {"kW", "kilowatt", "power", si::W.dimension, false, {1e3}},
      {"MW", "megawatt", "power", si::W.dimension, false, {1e6}},
      {"Hz", "hertz", "frequency", si::per_s.dimension},
      {"K", "kelvin", "temperature", si::K.dimension},
      {"degC", "degree Celsius, for a temperature alone", "temperature", si::K.dimension, false, {1, 1, false, 273.15}},
      {"rad", "radian", "angle", {}, true},
      {"mrad", "milliradian", "angle", {}, true, {1, 1e3}},
      {"deg", "degree", "angle", {}, true, {1, 180, true}},
      {"°", "degree", "angle", {}, true, {1, 180, true}},
      {"gon", "gon, 1/400 of a turn", "angle", {}, true, {1, 200, true}},
      {"%", "slope, atan(p/100); or a hundredth of a plain number", "angle", {}, true, {1, 100}},
  };
  return rows;
}

}  // namespace

const std::vector<NameRow>& name_rows() {
  static const std::vector<NameRow> rows = [] {
    std::vector<NameRow> all = latin_rows();
    for (const auto& [cyrillic, latin] : cyrillic_names) {
      NameRow row = *std::find_if(all.begin(), all.end(), [&](const NameRow& r) { return r.name == latin; });
      row.name = cyrillic;
      all.push_back(row);
    }
    return all;
  }();
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
