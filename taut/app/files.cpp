#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <system_error>

#include "taut/app/job.hpp"
#include "taut/io/hdf5.hpp"
#include "taut/io/include.hpp"
#include "taut/io/json.hpp"
#include "taut/io/table.hpp"
#include "taut/io/vtk.hpp"
#include "taut/report/html.hpp"
#include "taut/report/markdown.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

std::string read_standard_input() {
  std::string text;
  char block[65536];
  while (text.size() <= io::largest_deck && std::cin.read(block, sizeof block).gcount() > 0) {
    text.append(block, static_cast<std::size_t>(std::cin.gcount()));
  }
  return text;
}

using Pieces = std::function<void(const std::function<void(const std::string&)>&)>;

/// Writes beside its place and moves it there whole. `pieces` gives the text, one piece after the other.
tl::expected<void, FileError> write(const fs::path& path, const Pieces& pieces) {
  const fs::path part = path.string() + ".part";
  errno = 0;
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    pieces([&](const std::string& text) { file.write(text.data(), static_cast<std::streamsize>(text.size())); });
    file.close();
    if (!file) return tl::unexpected(FileError{fmt::format("can't write {}: {}", path.string(), reason())});
  }
  std::error_code error;
  fs::rename(part, path, error);
  if (error) return tl::unexpected(FileError{fmt::format("can't write {}: {}", path.string(), error.message())});
  return {};
}

/// Files as name and text; returns their paths.
tl::expected<std::vector<std::string>, FileError> write_all(
    const std::vector<std::pair<std::string, std::string>>& files, const std::string& folder) {
  std::vector<std::string> written;
  for (const auto& [name, text] : files) {
    const fs::path path = fs::path(folder) / name;
    if (const auto done = write(path, [&](const auto& put) { put(text); }); !done) return tl::unexpected(done.error());
    written.push_back(path.string());
  }
  return written;
}

}  // namespace

tl::expected<Job, FileError> read_job(const std::string& path) {
  if (path == "-") return Job{read_standard_input(), "<stdin>", {}, {}};
  auto text = io::read_file(path);
  if (!text) return tl::unexpected(FileError{fmt::format("can't read {}: {}", path, text.error())});
  return Job{std::move(*text), path, {}, {}};
}

tl::expected<std::vector<std::string>, FileError> write_files(const Result& result, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return tl::unexpected(FileError{fmt::format("can't make the folder {}: {}", folder, error.message())});
  std::vector<std::pair<std::string, std::string>> files = {
      {"result.json", io::to_json(result, io::SeriesFiles::named)},
      {"report.html", report::to_html(result)},
      {"report.md", report::to_markdown(result)}};
  for (const Table& t : result.tables) files.emplace_back(t.name + ".csv", io::to_csv(t));
  for (const Figure& f : result.figures) {
    if (const auto* plot = std::get_if<Plot>(&f); plot != nullptr && !plot->name.empty())
      files.emplace_back(plot->name + ".csv", io::to_csv(io::series_table(*plot)));
  }
  for (const Attachment& a : result.attachments) files.emplace_back(a.name, a.text);
  if (!result.comparisons.empty())
    files.emplace_back("comparison.csv", io::to_csv(comparison_table(result.comparisons)));
  auto written = write_all(files, folder);
  if (!written || result.series.empty()) return written;
  for (const Table& t : result.series) {
    const fs::path path = fs::path(folder) / (t.name + ".csv");
    if (const auto done = write(path, [&](const auto& put) { io::to_csv(t, put); }); !done) {
      return tl::unexpected(done.error());
    }
    written->push_back(path.string());
  }
  const fs::path path = fs::path(folder) / "series.h5";
  const fs::path part = path.string() + ".part";
  if (const auto done = io::write_hdf5(result.series, part.string()); !done) {
    return tl::unexpected(FileError{fmt::format("can't write {}: {}", path.string(), done.error())});
  }
  fs::rename(part, path, error);
  if (error) return tl::unexpected(FileError{fmt::format("can't write {}: {}", path.string(), error.message())});
  written->push_back(path.string());
  return written;
}

tl::expected<std::vector<std::string>, FileError> write_vtk(const Result& result, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return tl::unexpected(FileError{fmt::format("can't make the folder {}: {}", folder, error.message())});
  std::vector<std::pair<std::string, std::string>> files;
  for (const Scene& scene : result.scenes) {
    for (auto& file : io::to_vtk(scene)) files.push_back(std::move(file));
  }
  return write_all(files, folder);
}

}  // namespace taut::app
