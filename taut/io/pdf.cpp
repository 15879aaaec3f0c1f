#include "taut/io/pdf.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "taut/io/child.hpp"

namespace taut::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* chromium_names[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};

/// A folder of its own that is removed at the end.
class Scratch {
 public:
  Scratch() {
    std::error_code failed;
    const fs::path base = fs::temp_directory_path(failed);
    name_ = ((failed ? fs::path("/tmp") : base) / "taut-pdf-XXXXXX").string();
    made_ = mkdtemp(name_.data()) != nullptr;
  }
  ~Scratch() {
    std::error_code failed;
    if (made_) fs::remove_all(name_, failed);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  bool made() const { return made_; }
  fs::path path() const { return name_; }

 private:
  std::string name_;
  bool made_ = false;
};

/// The last line of what Chromium printed that says something, at most 200 characters.
std::string last_words(const fs::path& output) {
  std::ifstream file(output);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  std::string clean;
  constexpr std::size_t longest = 200;
  for (const char c : last.substr(0, longest)) clean += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
  return clean.empty() ? std::string("it says nothing") : clean;
}

/// The file is a PDF from its head to its end mark.
bool is_whole_pdf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream all;
  all << file.rdbuf();
  const std::string text = std::move(all).str();
  return text.starts_with("%PDF-") && text.find("%%EOF", text.rfind("startxref")) != std::string::npos;
}

Child chromium_child(const PdfJob& job, const fs::path& scratch, const fs::path& made) {
  Child child;
  child.words = {job.chromium,
                 "--headless",
                 "--disable-gpu",
                 "--disable-quic",
                 "--disable-dev-shm-usage",  // it is small in containers
                 "--disable-background-networking",
                 "--disable-component-update",
                 "--disable-sync",
                 "--disable-extensions",
                 "--disable-breakpad",
                 "--no-first-run",
                 "--no-default-browser-check",
                 "--no-pdf-header-footer",
                 fmt::format("--user-data-dir={}", (scratch / "profile").string()),
                 fmt::format("--print-to-pdf={}", made.string())};
  // Chromium refuses to start its sandbox as root.
  if (geteuid() == 0) child.words.emplace_back("--no-sandbox");
  child.words.push_back(file_address(job.page));
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME"}) {
    child.environment.push_back(fmt::format("{}={}", name, (scratch / "profile").string()));
  }
  child.output = (scratch / "output.txt").string();
  child.go_on = job.go_on;
  return child;
}

}  // namespace

tl::expected<std::string, std::string> find_chromium() {
  const char* chosen = std::getenv("TAUT_CHROMIUM");
  if (chosen != nullptr && *chosen != '\0') {
    if (auto path = program_path(chosen)) return std::move(*path);
    return tl::unexpected(fmt::format("TAUT_CHROMIUM names '{}', which is no program that can be run", chosen));
  }
  for (const char* name : chromium_names) {
    if (auto path = program_path(name)) return std::move(*path);
  }
  return tl::unexpected(
      std::string("no Chromium in PATH. Install Debian's package chromium (apt-get install chromium), or set "
                  "TAUT_CHROMIUM to the program"));
}

tl::expected<void, std::string> print_pdf(const PdfJob& job) {
  if (job.go_on && !job.go_on()) return tl::unexpected(std::string("interrupted"));
  const Scratch scratch;
  if (!scratch.made()) {
    return tl::unexpected(fmt::format("can't make the folder {}: {}", scratch.path().string(), std::strerror(errno)));
  }
  const fs::path made = scratch.path() / "report.pdf";
  const Child child = chromium_child(job, scratch.path(), made);
  const auto done = run_child(child);
  if (!done) return tl::unexpected(done.error());
  if (done->end == ChildEnd::stopped) return tl::unexpected(std::string("interrupted"));
  if (done->end == ChildEnd::too_long) {
    return tl::unexpected(fmt::format("{} did not end within {} s", job.chromium, child.limit.count()));
  }
  if (done->code != 0 || !is_whole_pdf(made)) {
    return tl::unexpected(
        fmt::format("{} wrote no PDF (exit code {}): {}", job.chromium, done->code, last_words(child.output)));
  }
  std::error_code failed;
  fs::copy_file(made, job.pdf, fs::copy_options::overwrite_existing, failed);
  if (!failed) return {};
  const std::string why = failed.message();
  fs::remove(job.pdf, failed);
  return tl::unexpected(fmt::format("can't write {}: {}", fs::path(job.pdf).filename().string(), why));
}

std::string file_address(const std::string& path) {
  std::error_code failed;
  const fs::path whole = fs::absolute(path, failed);
  std::string address = "file://";
  for (const char c : failed ? path : whole.lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool as_is =
        byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/-_.~").find(c) != std::string_view::npos);
    address += as_is ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

}  // namespace taut::io
