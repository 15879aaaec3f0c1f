#include "taut/study/requests/transient_deck.hpp"

namespace taut::study {

const Description& HoistFactor::describe() {
  using enum Class;
  static const Description d =
      Describe<HoistFactor>()
          .field(&HoistFactor::rope, "rope", "the hoist rope, a reeving")
          .required()
          .choice(&HoistFactor::hoisting_class, "class", {{"HC1", HC1}, {"HC2", HC2}, {"HC3", HC3}, {"HC4", HC4}},
                  "hoisting class of EN 13001-2")
          .field(&HoistFactor::speed, "speed", "v_h", si::m_per_s, "steady hoisting speed of the load")
          .at_least(0)
          .at_most(100)
          .required();
  return d;
}

const Description& SlidRequest::describe() {
  static const Description d =
      Describe<SlidRequest>()
          .field(&SlidRequest::actuator, "actuator", "a cylinder that holds its length")
          .field(&SlidRequest::drum, "drum", "a drum that is held or has a given speed")
          .exactly_one({"actuator", "drum"})
          .field(&SlidRequest::by, "by", "", si::m, "distance extended or rope taken in; below 0 retracted or let out")
          .at_least(-1000)
          .at_most(1000)
          .required();
  return d;
}

const Description& TransientRequest::describe() {
  static const Description d =
      Describe<TransientRequest>()
          .field(&TransientRequest::name, "name",
                 "appended to the names of its tables and files, when a deck has several")
          .field(&TransientRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&TransientRequest::duration, "duration", "t", si::s, "duration, from the start or the restart")
          .above(0)
          .at_most(3.2e7)
          .required()
          .field(&TransientRequest::output_step, "output_step", "dt", si::s,
                 "time between two recorded lines; default: a thousandth of the duration")
          .above(0)
          .at_most(3.2e7)
          .field(&TransientRequest::tolerance, "tolerance", "", si::one,
                 "largest error of the steps, relative to the largest tension, the size of the machine and the "
                 "energy exchanged; default 1e-6, with verlet or a given step 1e-3")
          .at_least(1e-12)
          .at_most(0.1)
          .field(&TransientRequest::step, "step", "dt", si::s, "fixed step, without error control")
          .above(0)
          .choice(&TransientRequest::method, "method",
                  {{"implicit", Method::implicit}, {"verlet", Method::verlet}, {"reference", Method::reference}},
                  "implicit with steps by the tolerance, explicit (verlet) for waves and breaks, or the slow reference "
                  "(IDA of SUNDIALS) to judge both")
          .choice(&TransientRequest::start, "start",
                  {{"settled", Start::settled}, {"assembled", Start::assembled}, {"sliding", Start::sliding}},
                  "settled: from the equilibrium at rest; assembled: places and lengths as described, at rest; "
                  "sliding: settled, with the friction after the slow movement that 'slid' gives")
          .record(&TransientRequest::slid, "slid", "slow movements before a start 'sliding'")
          .field(&TransientRequest::quasi_static, "quasi_static",
                 "true: slow motion without inertia: an equilibrium at the end of every step, with friction")
          .field(&TransientRequest::damping_ratio, "damping_ratio", "zeta", si::one,
                 "damping ratio of ropes without their own, in the lowest mode that stretches the rope")
          .at_least(0)
          .at_most(10)
          .field(&TransientRequest::rope_mass, "rope_mass", "false: ropes without weight and inertia")
          .choice(
              &TransientRequest::branches, "branches",
              {{"straight", Branches::straight}, {"catenary", Branches::catenary}, {"by_weight", Branches::by_weight}},
              "straight: half of the weight of a branch at each end; catenary: the elastic catenary at rest between "
              "its moving ends; by_weight: catenary where a branch weighs more than 5 % of its tension at the start")
          .field(&TransientRequest::save, "save", "file for the final state, in the folder of the results")
          .field(&TransientRequest::restart, "restart",
                 "file with such a state from which to continue, beside the deck")
          .record(&TransientRequest::hoist_factor, "hoist_factor",
                  "checks peak over static tension of a rope against phi2 = phi2_min + beta2 v_h of EN 13001-2");
  return d;
}

}  // namespace taut::study
