#include "taut/structure/mast.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "taut/base/expects.hpp"

namespace taut::structure {
namespace {

void take_worse(MastWorst& worst, double value, const MastPlace& at) {
  if (value > worst.value) worst = {.value = value, .at = at};
}

/// Parts that are one member with this one: beside each other in the same section and steel. Cuts where something acts
/// make no members.
std::pair<std::size_t, std::size_t> member_of(const Mast& mast, std::size_t part) {
  const auto same = [&](std::size_t other) {
    const SteelSection &a = mast.parts.at(part).member.steel, &b = mast.parts.at(other).member.steel;
    return a.section.name == b.section.name && a.section.area == b.section.area && a.yield == b.yield;
  };
  std::size_t first = part, last = part;
  while (first > 0 && same(first - 1)) --first;
  while (last + 1 < mast.parts.size() && same(last + 1)) ++last;
  return {first, last};
}

/// The section of a part, and of a tapered one that of its other end.
std::vector<SteelSection> ends_of(const MastPart& part) {
  std::vector<SteelSection> ends = {part.member.steel};
  if (part.stronger_end) {
    ends.push_back(part.member.steel);
    ends.back().section = *part.stronger_end;
  }
  return ends;
}

/// False where a wall is of class 4.
bool take_walls(const SteelSection& steel, const CrossForces& forces, const MastPlace& at, MastUse& u) {
  const WallClass wall = section_class(steel.section, steel.yield, forces);
  const double share = wall.slenderness / wall.limit_3;
  if (share > u.slenderness.value) {
    u.slenderness = {.value = share, .at = at};
    u.slenderest = wall;
    u.slenderest_section = steel.section.name;
  }
  if (wall.value == 4 && u.refused.empty()) u.refused = class_4_words(steel.section, wall);
  return wall.value < 4;
}

/// One end of a part at a station; a section of class 4 is only classed.
void take_section(const SteelSection& steel, const CrossForces& design, const MastPlace& at, MastUse& u) {
  if (!take_walls(steel, design, at, u)) return;
  Sheet<double> plain;
  const CrossSectionUse use = cross_section(steel, design, plain);
  take_worse(u.section, use.utilisation, at);
  take_worse(u.shear, use.shear, at);
  take_worse(u.torsion, use.torsion, at);
}

void take_station(const Mast& mast, const MastCase& c, const MastPlace& at, MastUse& u) {
  const MastStation& station = c.stations[at.station];
  const MastPart& part = mast.parts[station.part];
  const double stress = elastic_stress(part.member.steel.section, station.service);
  take_worse(u.stress, stress, at);
  if (part.allowable_stress) take_worse(u.stress_use, stress / *part.allowable_stress, at);
  for (const SteelSection& steel : ends_of(part)) take_section(steel, station.design, at, u);
}

void take_member(const Mast& mast, const MastCase& c, std::size_t load_case, std::size_t part, MastUse& u) {
  const CrossForces f = member_forces(mast, c, part);
  if (!is_pressed(mast.parts.at(part).member.steel, f)) return;
  u.pressed = true;
  Member member = member_in(mast, c, part);
  const MastPlace at{.load_case = load_case, .station = 0, .part = part};
  for (const SteelSection& steel : ends_of(mast.parts.at(part))) {
    member.steel = steel;
    // the largest of all forces together may ask for more of the walls than any of the stations
    if (section_class(steel.section, steel.yield, f).value == 4) {
      take_walls(steel, f, at, u);
      return;
    }
    Sheet<double> plain;
    const MemberUse use = member_use(member, f, plain);
    take_worse(u.flexural, use.flexural, at);
    if (c.members) take_worse(u.member, use.worst(), at);
  }
}

}  // namespace

double MastUse::utilisation() const {
  if (!refused.empty()) return std::numeric_limits<double>::infinity();
  return std::max({section.value, shear.value, torsion.value, flexural.value, member.value, stress_use.value});
}

CrossForces member_forces(const Mast& mast, const MastCase& c, std::size_t part) {
  const bool round = mast.parts.at(part).member.steel.section.shape == catalogue::SectionShape::chs;
  const auto [first, last] = member_of(mast, part);
  CrossForces most;
  bool any = false;
  for (const MastStation& s : c.stations) {
    if (s.part < first || s.part > last) continue;
    most.N = any ? std::max(most.N, s.member.N) : s.member.N;
    most.M_y = std::max(most.M_y, round ? std::hypot(s.member.M_y, s.member.M_z) : std::abs(s.member.M_y));
    if (!round) most.M_z = std::max(most.M_z, std::abs(s.member.M_z));
    any = true;
  }
  return most;
}

Member member_in(const Mast& mast, const MastCase& c, std::size_t part) {
  Member m = mast.parts.at(part).member;
  if (part >= c.critical_force.size()) return m;
  // that of the part that is pressed most
  const auto [first, last] = member_of(mast, part);
  const auto from = c.critical_force.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = c.critical_force.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  const auto most = [&](double CriticalForces::*axis) {
    return (*std::max_element(from, to, [&](const auto& a, const auto& b) { return a.*axis < b.*axis; })).*axis;
  };
  m.y.critical_force = most(&CriticalForces::y);
  m.z.critical_force = most(&CriticalForces::z);
  return m;
}

MastUse mast_use(const Mast& mast, const std::vector<MastCase>& cases) {
  MastUse u;
  bool any = false;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t k = 0; k < cases[i].stations.size(); ++k) {
      expects(cases[i].stations[k].part < mast.parts.size(), "a station lies in one of the mast's parts");
      take_station(mast, cases[i], {.load_case = i, .station = k, .part = cases[i].stations[k].part}, u);
      any = true;
    }
    for (std::size_t part = 0; part < mast.parts.size(); ++part) take_member(mast, cases[i], i, part, u);
  }
  expects(any, "a mast is checked under some forces");
  return u;
}

}  // namespace taut::structure
