#include "taut/machine/description/beam_keys.hpp"

#include "taut/machine/description/machine_limits.hpp"

namespace taut::machine::description {

const Description& Imperfection::describe() {
  static const Description d =
      Describe<Imperfection>()
          .field(&Imperfection::bow, "bow", "e/L", si::one,
                 "largest offset of its axis over its length, a half sine wave; negative: opposite direction")
          .at_least(-0.05)
          .at_most(0.05)
          .field(&Imperfection::sway, "sway", "phi", si::one,
                 "inclination of the whole beam (tangent), if its top is free; negative: opposite direction")
          .at_least(-0.1)
          .at_most(0.1)
          .field(&Imperfection::towards, "towards", "", si::one,
                 "direction of the imperfection, in the ground frame; default: 'strong'");
  return d;
}

const Description& Beam::describe() {
  static const Description d =
      Describe<Beam>()
          .field(&Beam::from, "from", "its base: a point, a body's origin, or another beam's top")
          .required()
          .field(&Beam::to, "to",
                 "its other end: a point of the ground (place of the free top as built), or a point of a body to which "
                 "it is joined")
          .required()
          .field(&Beam::section, "section", "section of the catalogue, as 'taut list sections' shows it")
          .field(&Beam::A, "A", "A", si::m2.in("cm^2"), "area of the section, in place of a section of the catalogue")
          .above(0)
          .at_most(100)
          .field(&Beam::I, "I", "I", si::m4.in("cm^4"), "second moment of area, for bending towards 'strong'")
          .above(0)
          .at_most(100)
          .field(&Beam::I_weak, "I_weak", "I_z", si::m4.in("cm^4"),
                 "second moment of area for the other direction; default: the same")
          .above(0)
          .at_most(100)
          .field(&Beam::J, "J", "I_t", si::m4.in("cm^4"), "torsion constant; default: I + I_weak, as of a round tube")
          .above(0)
          .at_most(100)
          .field(&Beam::W_t, "W_t", "W_t", si::m3.in("cm^3"),
                 "elastic torsion modulus, for the stress: torsion over it is the largest shear stress; default: not "
                 "known, of a round section 2 W")
          .above(0)
          .at_most(100)
          .field(&Beam::round, "round",
                 "true: a section by figures that is round, so that both bending moments add as vectors; default: of a "
                 "box "
                 "where 'strong', 'I_weak' or 'W_weak' is given, else not known")
          .field(&Beam::W, "W", "W", si::m3.in("cm^3"), "elastic section modulus, for the stress")
          .above(0)
          .at_most(100)
          .field(&Beam::W_weak, "W_weak", "W_z", si::m3.in("cm^3"),
                 "elastic section modulus for the other direction; default: the same")
          .above(0)
          .at_most(100)
          .field(&Beam::E, "E", "E", si::Pa.in("GPa"), "modulus of elasticity; G = E/2.6")
          .above(0)
          .at_most(1e13)
          .field(&Beam::mass, "mass", "m", si::kg_per_m,
                 "mass per metre; default: that of the catalogue, or A times 7850 kg/m3")
          .at_least(0)
          .at_most(1e6)
          .field(&Beam::steel, "steel", "steel grade, for the check of the stress, as 'taut list steels' shows it")
          .field(&Beam::expansion, "expansion", "a", si::per_K, "thermal expansion (EN 1993-1-1, 3.2.6)")
          .at_least(0)
          .at_most(most_expansion)
          .field(&Beam::reference_temperature, "reference_temperature", "", si::K.in("degC"),
                 "temperature at which it reaches from 'from' to 'to' without stress; default: that of the machine")
          .at_least(0)
          .at_most(hottest)
          .field(&Beam::strong, "strong", "", si::one,
                 "direction of bending about its strong axis; default: upwards for a horizontal beam, x for a vertical "
                 "one")
          .field(&Beam::elements, "elements", "n", si::one,
                 "number of intervals between the sections that tables show; the largest values are looked for at 48 "
                 "or more")
          .at_least(1)
          .at_most(256)
          .choice(
              &Beam::base, "base", {{"clamped", BeamBase::clamped}, {"hinge", BeamBase::hinge}},
              "connection at 'from'; a hinge inclines in any direction but does not turn about the axis of the beam")
          .choice(&Beam::top, "top",
                  {{"free", BeamEnd::free}, {"clamped", BeamEnd::clamped}, {"hinge", BeamEnd::hinge}},
                  "connection at 'to'; default: free where 'to' is a point of the ground, else clamped")
          .choice(&Beam::order, "order", {{"second", Order::second}, {"first", Order::first}},
                  "second: equilibrium of the deformed beam, any rotations; first: of the beam as built")
          .record(&Beam::imperfection, "imperfection", "initial imperfection, free of stress")
          .shorthand("bow")
          .exactly_one({"section", "A"});
  return d;
}

}  // namespace taut::machine::description
