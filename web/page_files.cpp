#include "web/page_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace taut::web {
namespace {

namespace fs = std::filesystem;

std::string whole(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file) throw std::runtime_error(fmt::format("'{}' can't be read", path.string()));
  return text.str();
}

/// Replaces the one place of `from`: a page without it is not the page that this program knows.
void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    throw std::runtime_error(fmt::format("the page is of another version of taut: it lacks {}", from));
  }
  text.replace(at, from.size(), to);
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(to, begin + from.size());
  return end == std::string::npos ? std::string() : text.substr(begin + from.size(), end - begin - from.size());
}

}  // namespace

std::vector<fs::path> page_places(const std::string& given, const fs::path& program) {
  if (!given.empty()) return {fs::path(given), fs::path(given) / "site"};
  const fs::path above = program.parent_path().parent_path();  // of bin
  return {above / "share" / "taut" / "page" / "site", above.parent_path() / "build-web" / "page" / "site"};
}

std::optional<fs::path> page_in(const std::vector<fs::path>& places) {
  std::error_code ignored;
  for (const fs::path& place : places) {
    if (fs::exists(place / "index.html", ignored) && fs::exists(place / "page.js", ignored)) return place;
  }
  return std::nullopt;
}

ServedPage read_page(const fs::path& folder, const std::string& token) {
  std::string index = whole(folder / "index.html");
  ServedPage page;
  page.nonce = between(index, "data-nonce=\"", "\"");
  replace(index, "<html ", "<html data-served=\"\" ");
  replace(index, "href=\"style.css\"", fmt::format("href=\"style.css?token={}\"", token));
  replace(index, "src=\"page.js\"", fmt::format("src=\"page.js?token={}\"", token));
  page.files["/"] = {.type = "text/html; charset=utf-8", .text = std::move(index)};
  page.files["/page.js"] = {.type = "text/javascript; charset=utf-8", .text = whole(folder / "page.js")};
  page.files["/style.css"] = {.type = "text/css; charset=utf-8", .text = whole(folder / "style.css")};
  return page;
}

}  // namespace taut::web
