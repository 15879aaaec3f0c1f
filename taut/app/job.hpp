#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"

namespace taut::io {
struct Unreadable;  // of taut/io/file_reader.hpp: needed by whoever gives files himself, and by no one else
}

namespace taut::app {

/// One calculation: the text of a deck, its name in messages, and values set from outside.
struct Job {
  std::string text;              ///< the deck
  std::string name = "deck";     ///< path of the deck, or "<stdin>"; messages name it, `include:` is resolved beside it
  std::vector<std::string> set;  ///< "input.span=200 m": replaces the value in the deck; later entries win
  /// Called from time to time by long calculations, from the thread that runs the job. When it returns false the
  /// calculation ends; the result then holds what was computed until then and is marked as interrupted. May be empty.
  std::function<bool(const Progress&)> progress = {};
  /// Gives the files that the deck names, in place of the disk: a door that takes decks of others says here which files
  /// they may have. May be empty.
  std::function<tl::expected<std::string, io::Unreadable>(const std::string& path)> read = {};
};

/// Reads the deck, runs its method or machine, and returns everything a report needs. The program calls it for every
/// deck. Its `study` and `calibrate` are checked, and not calculated.
/// Returns status bad_deck with `errors` for mistakes of the deck, and infeasible or not_converged where there is no
/// answer. Throws ContractViolation only for a bug of taut.
Result run(const Job& job);

/// Reads and checks the deck without calculating. Returns the mistakes for which `run` refuses it; empty when there is
/// none.
Diagnostics check(const Job& job);

/// Why a file could not be read or written: exit code 5.
struct FileError {
  std::string message;
};

/// Reads a deck from disk, or from standard input when `path` is "-". Folders, pipes, sockets and devices are refused
/// with a FileError, except those that the shell has opened itself ("/dev/stdin", "/dev/fd/63"): these are read like
/// standard input. A file above 16 MB is not a FileError: its text is cut after that size, and `run` reports it as a
/// mistake of the deck.
tl::expected<Job, FileError> read_job(const std::string& path);

/// Units of the CSV files of tables, plots and comparisons: those of the report, or SI.
enum class FileUnits { display, si };

/// Makes more files of those that stand in the folder `place`; returns the names of the files made.
using MoreFiles = std::function<std::vector<std::string>(const std::string& place)>;

/// How the files of a result are written.
struct FileOptions {
  FileUnits units = FileUnits::display;
  bool appendix = false;  ///< all values and tables of report.html are unfolded, and printed
  bool a3 = false;        ///< its pages are A3 in place of A4
  MoreFiles more = {};    ///< called when the other files are there
};

/// Writes into `folder`: result.json, report.html, report.md, one CSV for each table, plot and series, all series
/// together as series.h5 (HDF5), and the attachments of the result; then what `more` makes of them. Each column of a
/// CSV names its unit; result.json and the series are SI whatever `units` says. Makes the folder when it is missing.
/// The files replace those of an earlier result all at once; files that taut did not write are kept
/// (io::replace_folder). Returns the paths written, or a FileError.
tl::expected<std::vector<std::string>, FileError> write_files(const Result& result, const std::string& folder,
                                                              const FileOptions& options = {});

/// Whether write_files and write_vtk can use that folder. Call it before a long calculation.
tl::expected<void, FileError> check_folder(const std::string& folder);

/// Writes the machine in space as VTK files for ParaView: for each scene NAME_0000.vtp and so on, one for each time,
/// and NAME.pvd over all times. The files replace earlier ones all at once, as in write_files. Returns the paths
/// written; the last one is the file to open. Returns an empty list when the result has nothing in space.
tl::expected<std::vector<std::string>, FileError> write_vtk(const Result& result, const std::string& folder);

}  // namespace taut::app
