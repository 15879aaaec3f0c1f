#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taut::web {

/// One file of the page as it is sent.
struct PageFile {
  std::string type;
  std::string text;
};

/// The page for a browser, whose engine is this program.
struct ServedPage {
  std::map<std::string, PageFile> files;  ///< by path: "/", "/page.js", "/style.css"
  std::string nonce;                      ///< of its styles
};

/// Where the page may be: `given` and its folder `site`, where it is not empty; else beside the program, as installed
/// (share/taut/page) and in a source tree (build-web/page).
std::vector<std::filesystem::path> page_places(const std::string& given, const std::filesystem::path& program);

/// The first of the folders with the page of `./dev web`; empty: there is none.
std::optional<std::filesystem::path> page_in(const std::vector<std::filesystem::path>& places);

/// Reads the page and puts the token into the addresses of its script and style, as a browser asks for them by
/// themselves; the attribute data-served tells the page that a program answers it. Throws std::runtime_error when a
/// file is missing or is another one.
ServedPage read_page(const std::filesystem::path& folder, const std::string& token);

}  // namespace taut::web
