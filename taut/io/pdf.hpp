#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace taut::io {

/// The Chromium that prints pages: the program that TAUT_CHROMIUM names, else the first of chromium, chromium-browser,
/// google-chrome and google-chrome-stable in PATH. The error says what to install.
tl::expected<std::string, std::string> find_chromium();

struct PdfJob {
  std::string chromium;         ///< path of the program
  std::string page;             ///< HTML file
  std::string pdf;              ///< file to write
  std::function<bool()> go_on;  ///< false ends Chromium. May be empty
};

/// Prints an HTML page to PDF, on the paper that the page asks for. Chromium keeps its files in a folder below TMPDIR
/// that is removed afterwards; it is ended after five minutes. The error says why there is no PDF.
tl::expected<void, std::string> print_pdf(const PdfJob& job);

/// A path as the address of a file: "file:///home/a%20b/report.html". Relative paths count from the current folder.
std::string file_address(const std::string& path);

}  // namespace taut::io
