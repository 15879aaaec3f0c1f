#include "taut/io/pdf.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "test/support/scratch_folder.hpp"

namespace taut::io::pdf_test {

namespace fs = std::filesystem;

/// Programs in the place of Chromium; test/program/doors_test.py prints with a real one.
class Pdf : public ::testing::Test {
 protected:
  void SetUp() override { std::ofstream(top_ / "report.html") << "<p>page</p>"; }

  /// Runs a shell script as Chromium: `$to` is the file that it shall write.
  std::string printed_by(const std::string& script, std::function<bool()> go_on = {}) const {
    const fs::path program = top_ / "chromium";
    std::ofstream(program) << "#!/bin/sh\nfor one; do case $one in --print-to-pdf=*) to=${one#*=};; esac; done\n"
                           << script << '\n';
    chmod(program.c_str(), S_IRWXU);
    const auto done = print_pdf({.chromium = program.string(),
                                 .page = (top_ / "report.html").string(),
                                 .pdf = (top_ / "report.pdf").string(),
                                 .go_on = std::move(go_on)});
    return done ? std::string() : done.error();
  }
  bool has_pdf() const { return fs::exists(top_ / "report.pdf"); }
  taut_test::ScratchFolder scratch_;
  fs::path top_ = scratch_.path();
};

TEST_F(Pdf, IsKeptWhenWhole) {
  EXPECT_EQ(printed_by("printf '%%PDF-1.4\\nstartxref\\n9\\n%%%%EOF\\n' > \"$to\""), "");
  EXPECT_TRUE(has_pdf());
}

TEST_F(Pdf, IsNotKeptWhenCutShort) {
  EXPECT_NE(printed_by("printf '%%PDF-1.4\\n' > \"$to\"; echo disk is full; echo").find("disk is full"),
            std::string::npos);
  EXPECT_FALSE(has_pdf());
  EXPECT_NE(printed_by("echo no; exit 4").find("exit code 4"), std::string::npos);
  EXPECT_FALSE(has_pdf());
}

TEST_F(Pdf, EndsWhenInterrupted) {
  int asked = 0;
  EXPECT_EQ(printed_by("exec sleep 1000", [&] { return ++asked < 3; }), "interrupted");
  EXPECT_FALSE(has_pdf());
}

TEST_F(Pdf, AFailedCopyLeavesNothing) {
  fs::create_directory(top_ / "report.pdf");
  EXPECT_NE(printed_by("printf '%%PDF-1.4\\nstartxref\\n9\\n%%%%EOF\\n' > \"$to\"").find("can't write report.pdf"),
            std::string::npos);
}

TEST(PdfAddress, IsWrittenInAscii) {
  EXPECT_EQ(file_address("/a b/\xc3\xa4#1%41/report.html"), "file:///a%20b/%C3%A4%231%2541/report.html");
  EXPECT_TRUE(file_address("report.html").starts_with("file:///"));
  EXPECT_TRUE(file_address("report.html").ends_with("/report.html"));
}

}  // namespace taut::io::pdf_test
