#include "taut/app/cases/study/study_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "taut/base/version.hpp"
#include "taut/io/file.hpp"
#include "taut/io/hdf5.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t least_per_part = 64;
constexpr std::uint64_t most_parts = 256;
constexpr const char* manifest_name = "study.json";
constexpr const char* unfinished = ".unfinished-";  ///< in the name of a file that is being written

/// The HDF5 library of a distribution is not made for threads.
std::mutex& hdf5_turn() {
  static std::mutex one;
  return one;
}

FileError no(const std::string& path, const std::string& why) {
  return {.message = fmt::format("'{}': {}", path, why)};
}

/// Writes a text beside and puts it in its place.
tl::expected<void, FileError> write_whole(const fs::path& path, const std::string& text) {
  const fs::path beside = path.string() + unfinished + std::to_string(::getpid());
  errno = 0;
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) return tl::unexpected(no(path.string(), fmt::format("can't be written: {}", std::strerror(errno))));
  if (const auto put = io::put_in_place(beside.string(), path.string()); !put) {
    return tl::unexpected(no(path.string(), "can't be written: " + put.error()));
  }
  return {};
}

Json manifest_of(const Job& job, const Study& study, const StudyParts& parts) {
  std::error_code failed;
  const bool file = job.name != "<stdin>";
  const std::string name = file ? fs::absolute(job.name, failed).string() : job.name;
  return {{"taut", std::string(version)},
          {"study", study.hash},
          {"cases", parts.cases},
          {"per_part", parts.per_part},
          {"deck", name},
          {"set", job.set},
          {"text", job.text}};
}

tl::expected<Json, FileError> read_manifest(const fs::path& folder) {
  const fs::path path = folder / manifest_name;
  const auto text = io::read_file(path.string());
  if (!text) return tl::unexpected(FileError{text.error().message});
  Json manifest = Json::parse(*text, nullptr, false);
  const auto has = [&](const char* key, bool (Json::*is)() const noexcept) {
    return manifest.is_object() && manifest.contains(key) && (manifest[key].*is)();
  };
  const bool whole = has("study", &Json::is_string) && has("text", &Json::is_string) && has("deck", &Json::is_string) &&
                     has("set", &Json::is_array) && has("cases", &Json::is_number_unsigned) &&
                     has("per_part", &Json::is_number_unsigned);
  if (!whole) {
    return tl::unexpected(no(path.string(), "is not the file of a study"));
  }
  return manifest;
}

/// Also tells by which program the cases were calculated: one that knew fewer kinds of flaws called it "weaker".
constexpr const char* last_column = "weaker_parts";
constexpr std::size_t columns_beside = 5;  ///< beside inputs and outputs: case, status, reason, flaws, weaker

const char* word_of(CaseFlaw::Kind kind) {
  switch (kind) {
    case CaseFlaw::Kind::unsafe:
      return "unsafe";
    case CaseFlaw::Kind::unmade:
      return "unmade";
    case CaseFlaw::Kind::unlimited:
      return "unlimited";
    case CaseFlaw::Kind::chooses:
      return "chooses";
    case CaseFlaw::Kind::fails:
      break;
  }
  return "fails";
}

const char* word_of(Sense sense) { return sense == Sense::at_least ? "at_least" : "at_most"; }

/// What is said against a case as one text; empty: nothing.
std::string text_of(const std::vector<CaseFlaw>& flaws) {
  if (flaws.empty()) return {};
  Json all = Json::array();
  for (const CaseFlaw& one : flaws) {
    all.push_back({{"kind", word_of(one.kind)},
                   {"check", one.check},
                   {"words", one.words},
                   {"fact", one.fact},
                   {"sense", word_of(one.sense)},
                   {"analysis", one.analysis}});
  }
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same back; empty where it is no such text.
std::optional<std::vector<CaseFlaw>> flaws_in(const std::string& text) {
  std::vector<CaseFlaw> flaws;
  if (text.empty()) return flaws;
  const Json all = Json::parse(text, nullptr, false);
  if (!all.is_array()) return std::nullopt;
  for (const Json& one : all) {
    if (!one.is_object() || !one.contains("sense")) return std::nullopt;  // before it had one: of another program
    CaseFlaw flaw{.kind = CaseFlaw::Kind::unsafe,
                  .check = one.value("check", ""),
                  .words = one.value("words", ""),
                  .fact = one.value("fact", false),
                  .sense = one.value("sense", "") == word_of(Sense::at_least) ? Sense::at_least : Sense::at_most,
                  .analysis = one.value("analysis", "")};
    const std::string kind = one.value("kind", "");
    using Kind = CaseFlaw::Kind;
    for (const auto known : {Kind::unmade, Kind::fails, Kind::unlimited, Kind::chooses}) {
      if (kind == word_of(known)) flaw.kind = known;
    }
    flaws.push_back(std::move(flaw));
  }
  return flaws;
}

/// Strengths by part as one text; empty: there are none.
std::string text_of(const std::map<std::string, double>& weaker) {
  return weaker.empty() ? std::string{} : Json(weaker).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same back; empty where it is no such text.
std::optional<std::map<std::string, double>> weaker_in(const std::string& text) {
  std::map<std::string, double> weaker;
  if (text.empty()) return weaker;
  const Json all = Json::parse(text, nullptr, false);
  if (!all.is_object()) return std::nullopt;
  for (const auto& [part, strength] : all.items()) {
    if (!strength.is_number()) return std::nullopt;
    weaker[part] = strength.get<double>();
  }
  return weaker;
}

/// Whether that table has the cases of a part, as this program writes them.
bool holds(const Table& t, const CaseBlock& block) {
  if (t.columns.size() < columns_beside || t.columns.back().name != last_column || t.rows.size() != block.count) {
    return false;
  }
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (t.rows[i].size() != t.columns.size()) return false;
    const auto* number = std::get_if<double>(&t.rows[i].front());
    if (number == nullptr || *number != static_cast<double>(block.first + i)) return false;
  }
  return true;
}

/// The table of a part's file. The error: it can't be read.
tl::expected<Table, std::string> table_in(const std::string& path, const CaseBlock& block) {
  const auto tables = [&] {
    const std::lock_guard turn(hdf5_turn());
    return io::read_hdf5(path);
  }();
  if (!tables) return tl::unexpected(tables.error());
  if (tables->size() != 1 || !holds(tables->front(), block)) {
    return tl::unexpected(std::string("is not a part of this study"));
  }
  return tables->front();
}

/// The parts' rows as one table of numbers and reasons.
Table table_of(const Study& study, const std::vector<KeptCase>& rows) {
  Table t;
  t.name = "cases";
  t.title = "Cases";
  t.columns.push_back({.name = "case", .unit = si::one});
  for (const CaseInput& one : study.model.inputs) t.columns.push_back({.name = one.path, .unit = one.unit});
  for (const CaseOutput& one : study.model.outputs) t.columns.push_back({.name = one.name, .unit = one.unit});
  t.columns.push_back({.name = "status", .unit = si::one});
  t.columns.push_back({.name = "reason", .unit = si::one});
  t.columns.push_back({.name = "flaws", .unit = si::one});
  t.columns.push_back({.name = last_column, .unit = si::one});
  for (const KeptCase& row : rows) {
    std::vector<Cell>& cells = t.rows.emplace_back();
    cells.emplace_back(static_cast<double>(row.index));
    for (const double x : row.values) cells.emplace_back(x);
    for (const double x : row.answer.outputs) cells.emplace_back(x);
    cells.emplace_back(std::string(to_text(row.answer.outcome.status)));
    cells.emplace_back(row.answer.outcome.message);
    cells.emplace_back(text_of(row.answer.flaws));
    cells.emplace_back(text_of(row.answer.weaker));
  }
  return t;
}

Status status_of(const std::string& text) {
  for (const Status s : {Status::ok, Status::infeasible, Status::not_converged}) {
    if (text == to_text(s)) return s;
  }
  return Status::not_converged;
}

}  // namespace

CaseBlock StudyParts::of(std::uint64_t part) const {
  const std::uint64_t first = part * per_part;
  return {.first = first, .count = std::min(per_part, cases - first)};
}

StudyParts parts_of(std::uint64_t cases) {
  const std::uint64_t grain = least_per_part * most_parts;
  return {.cases = cases, .per_part = least_per_part * std::max<std::uint64_t>(1, (cases + grain - 1) / grain)};
}

tl::expected<StudyFolder, FileError> StudyFolder::make(const std::string& folder, const Job& job, const Study& study) {
  StudyFolder made(folder, parts_of(study.size()));
  std::error_code failed;
  const fs::path manifest = fs::path(folder) / manifest_name;
  if (fs::exists(manifest, failed)) {
    const auto there = read_manifest(folder);
    if (!there) return tl::unexpected(there.error());
    if (there->value("study", "") != study.hash) {
      return tl::unexpected(no(folder,
                               "holds another study, or one whose deck has changed since; choose another "
                               "folder"));
    }
    if (there->value("taut", "") != version) {
      return tl::unexpected(no(folder, fmt::format("holds a study of taut {}; this is {}: choose another folder",
                                                   there->value("taut", ""), version)));
    }
  }
  fs::create_directories(fs::path(folder) / "parts", failed);
  if (failed) return tl::unexpected(no(folder, "can't be made: " + failed.message()));
  if (!fs::exists(manifest, failed)) {
    const auto written = write_whole(manifest, manifest_of(job, study, made.parts_).dump(1) + "\n");
    if (!written) return tl::unexpected(written.error());
  }
  return made;
}

tl::expected<StudyFolder, FileError> StudyFolder::open(const std::string& folder) {
  const auto manifest = read_manifest(folder);
  if (!manifest) return tl::unexpected(manifest.error());
  const StudyParts parts{.cases = manifest->value("cases", std::uint64_t{0}),
                         .per_part = manifest->value("per_part", std::uint64_t{0})};
  if (parts.cases == 0 || parts.per_part == 0) return tl::unexpected(no(folder, "its study.json lacks the cases"));
  return StudyFolder(folder, parts);
}

tl::expected<Job, FileError> StudyFolder::job_in(const std::string& folder) {
  const auto manifest = read_manifest(folder);
  if (!manifest) return tl::unexpected(manifest.error());
  Job job;
  job.text = manifest->value("text", "");
  job.name = manifest->value("deck", "");
  job.set = manifest->value("set", std::vector<std::string>{});
  return job;
}

std::string StudyFolder::path_of(std::uint64_t part) const {
  return (fs::path(folder_) / "parts" / fmt::format("{:05}.h5", part)).string();
}

std::vector<bool> StudyFolder::done() const {
  std::vector<bool> all;
  all.reserve(parts_.count());
  std::error_code failed;
  for (std::uint64_t part = 0; part < parts_.count(); ++part) {
    const std::string path = path_of(part);
    all.push_back(fs::exists(path, failed) && table_in(path, parts_.of(part)).has_value());
  }
  return all;
}

tl::expected<void, FileError> StudyFolder::write(std::uint64_t part, const Study& study,
                                                 const std::vector<KeptCase>& rows) const {
  const std::string path = path_of(part), beside = path + unfinished + std::to_string(::getpid());
  const Table table = table_of(study, rows);
  const auto written = [&] {
    const std::lock_guard turn(hdf5_turn());
    return io::write_hdf5({table}, beside);
  }();
  if (!written) return tl::unexpected(no(beside, written.error()));
  if (const auto put = io::put_in_place(beside, path); !put) {
    return tl::unexpected(no(path, "can't be written: " + put.error()));
  }
  return {};
}

tl::expected<std::vector<KeptCase>, FileError> StudyFolder::read(std::uint64_t part, const Study& study) const {
  const std::string path = path_of(part);
  const auto table = table_in(path, parts_.of(part));
  if (!table) return tl::unexpected(no(path, table.error() + "; 'taut study resume' calculates it anew"));
  const FileError foreign = no(path, "is a part of another study; delete it and run 'taut study resume'");
  const std::size_t inputs = study.model.inputs.size(), outputs = study.model.outputs.size();
  if (table->columns.size() != inputs + outputs + columns_beside) return tl::unexpected(foreign);
  std::vector<KeptCase> rows;
  rows.reserve(table->rows.size());
  for (const std::vector<Cell>& cells : table->rows) {
    KeptCase& row = rows.emplace_back();
    const auto number = [&](std::size_t i) {
      const auto* x = std::get_if<double>(&cells[i]);
      return x != nullptr ? *x : std::nan("");
    };
    const auto text = [&](std::size_t i) {
      const auto* x = std::get_if<std::string>(&cells[i]);
      return x != nullptr ? *x : std::string{};
    };
    row.index = static_cast<std::uint64_t>(number(0));
    for (std::size_t i = 0; i < inputs; ++i) row.values.push_back(number(1 + i));
    for (std::size_t i = 0; i < outputs; ++i) row.answer.outputs.push_back(number(1 + inputs + i));
    row.answer.outcome.status = status_of(text(1 + inputs + outputs));
    row.answer.outcome.message = text(2 + inputs + outputs);
    auto flaws = flaws_in(text(3 + inputs + outputs));
    auto weaker = weaker_in(text(4 + inputs + outputs));
    if (!flaws || !weaker) return tl::unexpected(foreign);
    row.answer.flaws = std::move(*flaws);
    row.answer.weaker = std::move(*weaker);
  }
  return rows;
}

void StudyFolder::tidy() const {
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(fs::path(folder_) / "parts", failed)) {
    std::error_code gone;
    if (entry.path().filename().string().find(unfinished) != std::string::npos) fs::remove(entry.path(), gone);
  }
}

}  // namespace taut::app
