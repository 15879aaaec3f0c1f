#include "cli/report_files.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "taut/app/job.hpp"
#include "taut/io/child.hpp"
#include "taut/io/pdf.hpp"

namespace taut::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* pdf_name = "report.pdf";

/// The PDF of the report in `place`; why there is none.
tl::expected<void, std::string> print_report(const std::string& place) {
  const auto chromium = io::find_chromium();
  if (!chromium) return tl::unexpected(std::string("no Chromium"));
  return io::print_pdf({.chromium = *chromium,
                        .page = (fs::path(place) / "report.html").string(),
                        .pdf = (fs::path(place) / pdf_name).string(),
                        .go_on = InterruptHeld::goes_on});
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(at);
    if (end != 0) parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parts;
}

/// The commands that BROWSER lists, as words with the address in place; programs that are not there are left out.
std::vector<std::vector<std::string>> browsers(std::string_view list, const std::string& address) {
  std::vector<std::vector<std::string>> commands;
  for (const std::string& command : split(list, ':')) {
    std::vector<std::string> words = split(command, ' ');
    const auto program = words.empty() ? std::nullopt : io::program_path(words.front());
    if (!program) continue;
    bool placed = false;
    for (std::string& word : words) {
      const std::size_t at = word.find("%s");
      if (at == std::string::npos) continue;
      word.replace(at, 2, address);
      placed = true;
    }
    if (!placed) words.push_back(address);
    words.front() = *program;
    commands.push_back(std::move(words));
  }
  return commands;
}

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

/// The command that opens the address; why there is none.
tl::expected<std::vector<std::string>, std::string> opener(const std::string& address) {
  if (is_set("BROWSER")) {
    const char* list = std::getenv("BROWSER");
    auto found = browsers(list, address);
    if (found.empty()) {
      return tl::unexpected(fmt::format("BROWSER names '{}', in which no program can be run", list));
    }
    return std::move(found.front());
  }
  const auto program = io::program_path("xdg-open");
  if (!program) {
    return tl::unexpected(std::string("neither BROWSER is set nor xdg-open installed (Debian's package xdg-utils)"));
  }
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) {
    return tl::unexpected(std::string("there is no display; set BROWSER to a program that needs none"));
  }
  return std::vector<std::string>{*program, address};
}

void open_report(const std::string& path) {
  // what cannot open anything ends within this time; a browser lives longer
  constexpr std::chrono::milliseconds watched{500};
  const auto words = opener(io::file_address(path));
  if (!words) {
    say("taut: --open: {}; the report is {}\n", words.error(), path);
    return;
  }
  const auto code = io::start_apart(*words, watched);
  if (!code) {
    say("taut: --open: {}\n", code.error());
  } else if (*code) {
    say("taut: --open: {} ended with {}; the report is {}\n", words->front(), **code, path);
  }
}

}  // namespace

void warn_without_chromium(const RunOptions& options) {
  if (!options.pdf) return;
  if (const auto chromium = io::find_chromium(); !chromium) {
    say("taut: {} will not be written: {}\n", pdf_name, chromium.error());
  }
}

int write_report(const Result& result, const RunOptions& options) {
  std::string no_pdf;
  const auto pdf = [&](const std::string& place) -> std::vector<std::string> {
    if (!options.pdf) return {};
    const InterruptHeld held;
    if (const auto printed = print_report(place); !printed) {
      no_pdf = printed.error();
      return {};
    }
    return {pdf_name};
  };
  const app::FileUnits units = options.si ? app::FileUnits::si : app::FileUnits::display;
  const auto written = app::write_files(
      result, options.folder, {.units = units, .appendix = options.appendix, .a3 = options.paper == "a3", .more = pdf});
  if (!written) {
    say("taut: {}\n", written.error().message);
    return file_trouble;
  }
  const std::string report = (fs::path(options.folder) / "report.html").string();
  if (!no_pdf.empty()) say("taut: {} is not written: {}\n", pdf_name, no_pdf);
  if (!options.quiet) say("report: {}{}\n", report, options.pdf && no_pdf.empty() ? " and report.pdf" : "");
  if (options.pdf && !InterruptHeld::goes_on()) return interrupted;
  if (options.open) open_report(report);
  return no_pdf.empty() ? computed : file_trouble;
}

}  // namespace taut::cli
