#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "test/paths.hpp"

// Decks of the method, read as a user's are.

namespace taut::closed_loop::closed_loop_deck_test {

struct ReadDeck {
  Input in;
  Diagnostics mistakes;
};

ReadDeck read_text(const std::string& text) {
  ReadDeck r;
  const auto deck = io::read_deck(text, "deck.yaml", {}, {"closed_loop"}, r.mistakes);
  if (!deck) return r;
  if (io::read(deck->input, Input::describe(), &r.in, "the input of closed_loop", r.mistakes)) {
    io::place(deck->input, complaints(r.in), r.mistakes);
  }
  return r;
}

const std::string paper_deck = R"(taut: 1
title: The paper's example
method: closed_loop
input:
  span: 200 m
  sag: 10 m
  gathering_force: 3000 kgf
  gathering_angle: 30 deg
  return_weight: 1 kgf/m
  traction_weight: 1.5 kgf/m
  tail_efficiency: 0.9
  return_stiffness: .inf
)";

std::string deck_with(const char* lines) { return fmt::format("{}{}", paper_deck, lines); }

TEST(ClosedLoopDecks, ThePapersExampleInItsOwnUnits) {
  const ReadDeck r = read_text(paper_deck);
  ASSERT_TRUE(r.mistakes.empty()) << to_text(r.mistakes);
  Output out;
  ASSERT_TRUE(solve(r.in, out).ok());
  EXPECT_NEAR(out.P_b / 9.80665, 1166.19, 0.01);
}

TEST(ClosedLoopDecks, OnePositionOrAList) {
  EXPECT_EQ(read_text(deck_with("  position: 80 m\n")).in.position, std::vector<double>{80});
  const auto list = read_text(deck_with("  position: [80 m, 12000 cm]\n"));
  EXPECT_EQ(list.in.position, (std::vector<double>{80, 120}));
}

TEST(ClosedLoopDecks, AComplaintHasItsPlace) {
  const ReadDeck r = read_text(deck_with("  position: [80 m, 210 m]\n  loop_length: 402 m\n"));
  const std::string text = to_text(r.mistakes);
  EXPECT_NE(text.find("deck.yaml:13:20"), std::string::npos) << text;
  EXPECT_NE(text.find("deck.yaml:14:16"), std::string::npos) << text;
}

TEST(ClosedLoopDecks, TheStarterDeckRunsAndPasses) {
  std::ifstream file(taut_test::source_dir() / "examples/closed_loop.yaml");
  std::stringstream text;
  text << file.rdbuf();
  const ReadDeck r = read_text(text.str());
  ASSERT_TRUE(r.mistakes.empty()) << to_text(r.mistakes);
  const Result result = run(r.in);
  ASSERT_EQ(result.status, Status::ok) << result.message;
  EXPECT_EQ(exit_code(result), 0);
  EXPECT_EQ(result.checks.size(), 3U);
  EXPECT_NE(result.find_table("positions"), nullptr);
  EXPECT_NE(result.find_table("ropes"), nullptr);
}

}  // namespace taut::closed_loop::closed_loop_deck_test
