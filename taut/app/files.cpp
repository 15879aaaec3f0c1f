#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "taut/app/job.hpp"
#include "taut/calc/comparison.hpp"
#include "taut/calc/shown.hpp"
#include "taut/io/data_files.hpp"
#include "taut/io/file.hpp"
#include "taut/io/folder.hpp"
#include "taut/io/hdf5.hpp"
#include "taut/io/json.hpp"
#include "taut/io/table.hpp"
#include "taut/io/vtk.hpp"
#include "taut/report/html.hpp"
#include "taut/report/markdown.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

using Written = tl::expected<std::vector<std::string>, std::string>;

/// Lists of what stands in a folder, see io::replace_folder: a result and scenes may stand in the same one.
constexpr const char* result_list = ".taut-files";
constexpr const char* vtk_list = ".taut-vtk-files";

/// What /dev/stdin and /dev/fd/63 stand for: the shell has opened it, as for `taut run <(generate)`.
std::optional<int> descriptor_of(std::string_view path) {
  if (path == "/dev/stdin") return STDIN_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (code == std::errc{} && end == digits.data() + digits.size() && number >= 0) return number;
  }
  return std::nullopt;
}

/// Files as name and text, into the folder `place`; their names.
Written write_all(const std::vector<std::pair<std::string, std::string>>& files, const std::string& place) {
  std::vector<std::string> names;
  for (const auto& [name, text] : files) {
    errno = 0;
    std::ofstream file(fs::path(place) / name, std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) {
      return tl::unexpected(
          fmt::format("can't write {}: {}", name, errno != 0 ? std::strerror(errno) : "unknown reason"));
    }
    names.push_back(name);
  }
  return names;
}

Written write_result(const Result& result, const std::string& place, const FileOptions& options) {
  const Display display = display_of(result);
  const bool si = options.units == FileUnits::si;
  const auto csv = [&](const Table& t) { return si ? io::to_csv(t) : io::to_csv(t, display); };
  const report::HtmlOptions html{.appendix = options.appendix,
                                 .paper = options.a3 ? report::Paper::a3 : report::Paper::a4};
  std::vector<std::pair<std::string, std::string>> files = {
      {"result.json", io::to_json(result, si ? io::SeriesFiles::named_si : io::SeriesFiles::named)},
      {"report.html", report::to_html(result, html)},
      {"report.md", report::to_markdown(result)}};
  for (const Table& t : result.tables) files.emplace_back(t.name + ".csv", csv(t));
  for (const Figure& f : result.figures) {
    if (const auto* plot = std::get_if<Plot>(&f); plot != nullptr && !plot->name.empty())
      files.emplace_back(plot->name + ".csv", csv(io::series_table(*plot)));
    if (const auto* profile = std::get_if<Profile>(&f))
      files.emplace_back(profile->name + ".csv", csv(io::series_table(*profile)));
  }
  for (const Attachment& a : result.attachments) files.emplace_back(a.name, a.text);
  if (!result.comparisons.empty())
    files.emplace_back("comparison.csv", io::to_csv(si ? comparison_table(result.comparisons)
                                                       : comparison_table(result.comparisons, display)));
  auto written = write_all(files, place);
  if (!written || result.series.empty()) return written;
  for (const Table& t : result.series) {
    if (t.detail) continue;
    errno = 0;
    std::ofstream file(fs::path(place) / (t.name + ".csv"), std::ios::binary | std::ios::trunc);
    io::to_csv(t, [&](const std::string& text) { file.write(text.data(), static_cast<std::streamsize>(text.size())); });
    file.close();
    if (!file) {
      return tl::unexpected(
          fmt::format("can't write {}.csv: {}", t.name, errno != 0 ? std::strerror(errno) : "unknown reason"));
    }
    written->push_back(t.name + ".csv");
  }
  if (const auto done = io::write_hdf5(result.series, (fs::path(place) / "series.h5").string()); !done) {
    return tl::unexpected(fmt::format("can't write series.h5: {}", done.error()));
  }
  written->emplace_back("series.h5");
  return written;
}

/// Names of the files that versions of taut without a list of them have written: those that the result there names.
std::vector<std::string> earlier_files(const std::string& folder) {
  std::error_code failed;
  if (fs::exists(fs::path(folder) / result_list, failed)) return {};
  const auto text = io::read_file((fs::path(folder) / "result.json").string());
  if (!text || !text->starts_with("{\n \"taut\":")) return {};
  std::vector<std::string> names = {"result.json", "report.html", "report.md", "series.h5", "comparison.csv"};
  const auto result = nlohmann::json::parse(*text, nullptr, false);
  if (!result.is_object()) return names;  // too long to be read
  for (const char* part : {"tables", "series"}) {
    const auto found = result.find(part);
    if (found == result.end() || !found->is_object()) continue;
    for (const auto& [name, _] : found->items()) names.push_back(name + ".csv");
  }
  return names;
}

tl::expected<std::vector<std::string>, FileError> or_file_error(Written written) {
  if (!written) return tl::unexpected(FileError{std::move(written.error())});
  return std::move(*written);
}

}  // namespace

tl::expected<Job, FileError> read_job(const std::string& path) {
  const auto open_already = path == "-" ? std::optional<int>(STDIN_FILENO) : descriptor_of(path);
  const std::string name = path == "-" ? "<stdin>" : path;
  auto text = open_already ? io::read_open(*open_already, name) : io::read_file(path);
  if (!text) return tl::unexpected(FileError{std::move(text.error().message)});
  return Job{.text = std::move(*text), .name = name, .set = {}, .progress = {}};
}

tl::expected<void, FileError> check_folder(const std::string& folder) {
  auto done = io::check_replaceable(folder);
  if (!done) return tl::unexpected(FileError{std::move(done.error())});
  return {};
}

tl::expected<std::vector<std::string>, FileError> write_files(const Result& result, const std::string& folder,
                                                              const FileOptions& options) {
  if (!io::named_apart(result)) {
    Result apart = result;
    io::name_apart(apart);
    return write_files(apart, folder, options);
  }
  const auto fill = [&](const std::string& place) {
    Written names = write_result(result, place, options);
    if (!names || !options.more) return names;
    for (std::string& name : options.more(place)) names->push_back(std::move(name));
    return names;
  };
  return or_file_error(io::replace_folder(folder, result_list, fill, earlier_files(folder)));
}

tl::expected<std::vector<std::string>, FileError> write_vtk(const Result& result, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const Scene& scene : result.scenes) {
    for (auto& file : io::to_vtk(scene)) files.push_back(std::move(file));
  }
  if (files.empty()) return std::vector<std::string>();
  return or_file_error(
      io::replace_folder(folder, vtk_list, [&](const std::string& place) { return write_all(files, place); }));
}

}  // namespace taut::app
