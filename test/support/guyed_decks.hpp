#pragma once
#include <string>

/// Decks of guyed masts and lines over supports.
namespace taut_test {

/// A hinged mast between two pairs of guys, pulled towards x.
inline std::string guyed(const std::string& checks, const std::string& pull = "[30 kN, 0 N, -20 kN]") {
  return R"(taut: 1
machine:
  ropes: {guy: {mass: 1.2 kg/m, stiffness: 15 MN, breaking_force: 200 kN}}
  points:
    foot: [0 m, 0 m, 0 m]
    head: [0 m, 0 m, 12 m]
    a1: [-12 m, 6 m, 0 m]
    a2: [-12 m, -6 m, 0 m]
    a3: [12 m, 6 m, 0 m]
    a4: [12 m, -6 m, 0 m]
  beams:
    mast: {from: foot, to: head, section: CHS 219.1x8, steel: S355, base: hinge}
  guys:
    g1: {rope: guy, from: mast.top, to: a1, install: {tension: 20 kN, at: top}}
    g2: {rope: guy, from: mast.top, to: a2, install: {tension: 20 kN, at: top}}
    g3: {rope: guy, from: a3, to: mast.top, install: {tension: 20 kN, at: anchor}}
    g4: {rope: guy, from: mast.top, to: a4, install: {tension: 20 kN, at: top}}
  loads: [{at: mast.top, force: )" +
         pull + "}]\nchecks:\n" + checks;
}

/// A line over a jack and a tail tree.
inline std::string line_over_tree(const std::string& checks, const std::string& anchor = "[330 m, 0 m, 10 m]") {
  return R"(taut: 1
machine:
  ropes: {skyline: {mass: 2 kg/m, stiffness: 30 MN, breaking_force: 400 kN}}
  points: {head: [0 m, 0 m, 30 m], stump: )" +
         anchor + R"(}
  supports:
    jack: {at: [150 m, 0 m, 40 m], friction: 0}
    tree: {at: [300 m, 0 m, 35 m], friction: 0}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {over: jack}, {over: tree}, {anchor: stump}], tension_at_start: 100 kN}
checks:
)" + checks;
}

}  // namespace taut_test
