#include "taut/machine/description/beam_keys.hpp"

namespace taut::machine::description {

const Description& Imperfection::describe() {
  static const Description d =
      Describe<Imperfection>()
          .field(&Imperfection::bow, "bow", "e/L", si::one,
                 "largest offset of its axis over its length, a half wave of sine; negative: the other way")
          .at_least(-0.05)
          .at_most(0.05)
          .field(&Imperfection::sway, "sway", "phi", si::one,
                 "inclination of the whole beam (tangent), of one with a free top; negative: the other way")
          .at_least(-0.1)
          .at_most(0.1)
          .field(&Imperfection::towards, "towards", "", si::one,
                 "which way, in the ground frame; without it the direction 'strong'");
  return d;
}

const Description& Beam::describe() {
  static const Description d =
      Describe<Beam>()
          .field(&Beam::from, "from", "its base: a point, a body's origin, or another beam's top")
          .required()
          .field(&Beam::to, "to",
                 "its other end: a point of the ground, where its free top is before anything acts, or a "
                 "point of a body to which it is joined")
          .required()
          .field(&Beam::section, "section", "of the catalogue, as 'taut list sections' shows it")
          .field(&Beam::A, "A", "A", si::m2.in("cm^2"), "area of the section, in place of a section of the catalogue")
          .above(0)
          .at_most(100)
          .field(&Beam::I, "I", "I", si::m4.in("cm^4"), "second moment of area, for bending towards 'strong'")
          .above(0)
          .at_most(100)
          .field(&Beam::I_weak, "I_weak", "I_z", si::m4.in("cm^4"), "for bending across it; without it the same")
          .above(0)
          .at_most(100)
          .field(&Beam::J, "J", "I_t", si::m4.in("cm^4"), "torsion constant; without it I + I_weak, a round tube's")
          .above(0)
          .at_most(100)
          .field(&Beam::W, "W", "W", si::m3.in("cm^3"), "elastic section modulus, for the stress")
          .above(0)
          .at_most(100)
          .field(&Beam::W_weak, "W_weak", "W_z", si::m3.in("cm^3"), "for bending across; without it the same")
          .above(0)
          .at_most(100)
          .field(&Beam::E, "E", "E", si::Pa.in("GPa"), "modulus of elasticity; G = E/2.6")
          .above(0)
          .at_most(1e13)
          .field(&Beam::mass, "mass", "m", si::kg_per_m,
                 "mass per metre; without it the catalogue's, or A times 7850 kg/m3")
          .at_least(0)
          .at_most(1e6)
          .field(&Beam::steel, "steel", "its grade, for the check of the stress, as 'taut list steels' shows it")
          .field(
              &Beam::strong, "strong", "", si::one,
              "direction towards which its strong axis resists bending; without it upwards for a lying beam, x for an "
              "upright one")
          .field(&Beam::elements, "elements", "n", si::one, "reported sections along it, less one")
          .at_least(1)
          .at_most(256)
          .choice(&Beam::base, "base", {{"clamped", BeamBase::clamped}, {"hinge", BeamBase::hinge}},
                  "how its 'from' holds it; a hinge leans any way but does not turn about the beam's axis")
          .choice(&Beam::top, "top",
                  {{"free", BeamEnd::free}, {"clamped", BeamEnd::clamped}, {"hinge", BeamEnd::hinge}},
                  "how its 'to' holds it; without it free, where 'to' is a point of the ground, else clamped")
          .choice(&Beam::order, "order", {{"second", Order::second}, {"first", Order::first}},
                  "second: balance on the bent beam, whatever its rotations; first: on the straight one")
          .record(&Beam::imperfection, "imperfection", "as built, free of stress")
          .shorthand("bow")
          .exactly_one({"section", "A"});
  return d;
}

}  // namespace taut::machine::description
