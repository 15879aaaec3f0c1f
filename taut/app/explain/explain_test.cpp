#include "taut/app/explain/explain.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "test/paths.hpp"

namespace taut::app::explain_test {

TEST(Explain, TellsEquationsKeysValuesAndErrata) {
  const std::string text = explain_text(*find_method("mast_section"));
  for (const char* part : {"skyline_force", "required", "D_tube", "exp(", "Errata", "at least", "Shoshin"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST(Explain, TheReferencePageIsWhatTheProgramSays) {
  std::ifstream file(taut_test::source_dir() / "docs/guide/reference.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_TRUE(page.str() == reference_guide())
      << "the page is stale; run: build/bin/taut explain all --markdown > docs/guide/reference.md";
}

}  // namespace taut::app::explain_test
