#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/checks/rope/rope_checks_deck.hpp"
#include "taut/rope/life.hpp"
#include "taut/rope/rope_check.hpp"

namespace taut::checks {

/// What is wrong with a rope's `duty` and `life`, at paths below `path`. `rounds`: names of what bends it, with a
/// diameter.
void complain_of_life(const RopeCheckRequest& request, const catalogue::RopeRow& rope,
                      const std::vector<std::string>& rounds, const std::string& path,
                      std::vector<Complaint>& complaints);

/// Checks NAME.life (the most damaging of its counts) and NAME.donandt, values NAME.life_damage and
/// NAME.life_repeats, the table `life_NAME` of a rope with a duty, and the table `discard_NAME`.
void add_life(const RopeCheckRequest& request, const rope::RopeUse& use, const rope::RopeRules& rules, Result& r);

/// The tables `life_ROPE` and `discard_ROPE` as described.
TableWords life_words();
TableWords discard_words();

/// The table `discard_NAME`: when the rope is to be put away, with its own numbers where its data are known.
/// `group`: class of the mechanism, "M5"; may be empty. rope_discard.cpp.
void add_discard(const std::string& group, const rope::RopeUse& use, Result& r);

}  // namespace taut::checks
