// What a deck's author reads: mistakes all at once, answers that nobody meant.
#include <algorithm>

#include "test/support/machine_decks.hpp"

namespace machine_reasons_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

std::string with(std::string deck, const std::string& from, const std::string& to) {
  const std::size_t at = deck.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return deck.replace(at, from.size(), to);
}

TEST(MachineReasons, NamesThatNothingHasAreToldBesideWhatCantBeRead) {
  std::string deck = skyline_deck("  - equilibrium: {motion: at_rest}");
  deck = with(deck, "mass: 350 kg, rides", "mas: 350 kg, rides");
  deck = with(deck, "{over: jack2}", "{over: jack3}");
  deck = with(deck, "mass: 1.6 kg/m", "mass: 1.6 kN");
  deck = with(deck, "{at: car, mass: 0 kg}", "{at: cart, mass: 0 kg}");
  const Result r = run_text(deck);
  expect_mistake(r, "'mas' is not a field of carriages.car");
  expect_mistake(r, "'kN' is a unit of force");
  expect_mistake(r, "there is no sheave or support 'jack3'; did you mean 'jack1'?");
  expect_mistake(r, "there is no body, carriage or point 'cart'; did you mean 'car'?");
  EXPECT_EQ(r.errors.size(), 4U) << to_text(r.errors);
}

TEST(MachineReasons, AListOfAnotherNameIsOneMistake) {
  const Result r = run_text(with(skyline_deck("  - equilibrium: {motion: at_rest}"), "  supports:", "  suports:"));
  expect_mistake(r, "'suports' is not a field of machine; did you mean 'supports'?");
  EXPECT_EQ(r.errors.size(), 1U) << to_text(r.errors);
}

TEST(MachineReasons, ATowerThatFallsOverIsAWarning) {
  const auto tower = [](const std::string& force) {
    return run_text(R"(taut: 1
machine:
  ropes: {guy: {mass: 1.6 kg/m, stiffness: 20 MN}}
  bodies: {tower: {mass: 2 t, centre: [0 m, 0 m, 8 m], free: [rx, ry, rz]}}
  points:
    head: {body: tower, at: [0 m, 0 m, 16 m]}
    left: [-20 m, 6 m, 0 m]
    right: [-20 m, -6 m, 0 m]
  guys:
    g1: {rope: guy, from: head, to: left, install: {tension: 10 kN}}
    g2: {rope: guy, from: head, to: right, install: {tension: 10 kN}}
  loads: [{at: head, force: [)" +
                    force + ", 0 kN, 0 kN]}]\n");
  };
  const auto fallen = [](const Result& r) {
    return std::any_of(r.warnings.begin(), r.warnings.end(), [](const std::string& w) {
      return w.find("'tower' comes to rest turned by") != std::string::npos;
    });
  };
  const Result held = tower("60 kN");
  ASSERT_EQ(held.status, Status::ok) << held.message << to_text(held.errors);
  EXPECT_FALSE(fallen(held));
  const Result lost = tower("-60 kN");  // towards its guys: nothing holds it
  EXPECT_TRUE(lost.status != Status::ok || fallen(lost)) << lost.message;
}

}  // namespace machine_reasons_test
