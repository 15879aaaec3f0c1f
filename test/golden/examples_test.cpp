#include <gtest/gtest.h>

#include <filesystem>

#include "taut/app/job.hpp"
#include "taut/app/methods.hpp"
#include "taut/report/markdown.hpp"
#include "taut/report/terminal.hpp"
#include "test/golden/golden.hpp"

namespace examples_test {

using namespace taut;
using taut_test::golden;
using taut_test::normalised;

class ExampleReport : public testing::TestWithParam<std::string> {};

TEST_P(ExampleReport, IsTheStoredOne) {
  const taut::app::MethodEntry* method = taut::app::find_method(GetParam());
  ASSERT_NE(method, nullptr);
  const Result r =
      taut::app::run(taut::app::Job{.text = std::string(method->example), .name = GetParam() + ".yaml", .set = {}});
  const std::string page = normalised(report::to_markdown(r));
  EXPECT_TRUE(page == golden(GetParam() + ".md", page))
      << "the report changed: write it with TAUT_WRITE_GOLDEN=1, look";
  const std::string screen = normalised(report::to_terminal(r));
  EXPECT_TRUE(screen == golden(GetParam() + ".txt", screen))
      << "the summary changed: write it with TAUT_WRITE_GOLDEN=1";
}

INSTANTIATE_TEST_SUITE_P(Methods, ExampleReport,
                         testing::Values("mast_section", "closed_loop", "friction_drive", "boom_ropes"),
                         [](const auto& one) { return one.param; });

}  // namespace examples_test
