#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/machine/description/machine.hpp"
#include "taut/machine/model.hpp"
#include "taut/study/load_path.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

/// The end of a rope where it is pulled in and let out, or a driven sheave of an endless rope.
struct Winch {
  std::string name;
  int reeving = 0;
  bool at_end = false;
  bool drive = false;
  std::string shared;  ///< the drum on which other ropes wind too; empty: it has its own
};

/// Ropes that end on a drum, or have a tension given, or hold the carriage as its mainline or haulback.
std::vector<Winch> winches_of(const machine::Model& m, const machine::Machine& machine, std::optional<int> carriage);

/// How a rope runs over a contact while a carriage goes its way, against how its friction has it run: towards
/// the larger tension. The rope's own way follows from its lengths on either side.
struct RopeSense {
  std::string rope, contact;
  int declared = 0;              ///< 1 along the path, -1 against it
  double with = 0, against = 0;  ///< rope that runs so, m
  double taken = 0, given = 0;   ///< energy that friction takes, and gives where the rope runs against it, J
  bool driven = true;            ///< by a winch; else the rope lies still at its ends and the carriage runs on it
};

/// From place to place of one carriage. Ropes with a winch at both ends are left out: their lengths do not say what
/// each of the winches takes in.
class RopeSenses {
 public:
  explicit RopeSenses(std::vector<Winch> winches) : winches_(std::move(winches)) {}

  /// Neighbouring places in a model with the carriage in one span; those without an answer are passed over.
  void take(const machine::Model& m, const std::vector<LoadPathPoint>& points);

  const std::vector<RopeSense>& all() const { return all_; }

 private:
  /// A rope and the node beside which it does not run.
  struct Running {
    int reeving = 0, still = 0;
    bool driven = true;
  };
  void take(const machine::Model& m, const Running& of, const LoadPathPoint& before, const LoadPathPoint& now);
  std::vector<Winch> winches_;
  std::vector<RopeSense> all_;
};

/// Of them those whose friction gives energy; the sum of it in J.
std::vector<RopeSense> giving(const std::vector<RopeSense>& senses);
double energy_given(const std::vector<RopeSense>& senses);

/// What is to be declared in place of senses that no part of the way agrees with, "haulback runs 120.6 m against its
/// motion: declare 'motion: {haulback: -1}'"; none where there is no such contact.
std::optional<std::string> wrong_senses(const std::vector<RopeSense>& senses, const Display& display = {});
/// Two ropes of which one runs as declared on the way there alone and the other on the way back alone: whichever way
/// the carriage goes, friction gives energy. A sentence; none where there are no such ropes.
std::optional<std::string> contrary_senses(const std::vector<RopeSense>& senses);

}  // namespace taut::study
