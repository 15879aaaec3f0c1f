#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"

namespace taut::app {

/// One calculation to do: a deck's text, what to call it in messages, and overrides from outside.
struct Job {
  std::string text;              ///< the deck
  std::string name = "deck";     ///< its path, or "<stdin>": messages name it, and `include:` is looked for beside it
  std::vector<std::string> set;  ///< "input.span=200 m": values put over those of the deck, in order
  /// Called now and then by long calculations, from the thread that runs the job; false ends them: what is there until
  /// then is the result, marked as interrupted. May be empty.
  std::function<bool(const Progress&)> progress = {};
};

/// The one funnel of all doors: reads the deck, runs its method, returns everything a report needs.
/// Mistakes of the deck come back as status bad_deck with `errors`, physical impossibilities as infeasible or
/// not_converged. Throws ContractViolation for our own bugs only.
Result run(const Job& job);

/// Reads and checks the deck without calculating: the mistakes, empty when it is fine.
Diagnostics check(const Job& job);

/// Why a file could not be read or written: exit code 5.
struct FileError {
  std::string message;
};

/// A deck from disk, or from standard input when `path` is "-". Folders, pipes, sockets and devices are refused, but
/// for what the shell has opened itself ("/dev/stdin", "/dev/fd/63"), which is read like standard input. Files above 16
/// MB are a mistake of the deck, not of the file: their text is cut behind that size and refused by `run` at once.
tl::expected<Job, FileError> read_job(const std::string& path);

/// Writes result.json, report.html, report.md, one CSV per table, plot and series, all series together as series.h5
/// (HDF5), and the result's own files into `folder`, which is made when missing. The folder holds one result: all files
/// are put there at once, those of an earlier result are gone, files that taut did not write are kept; see
/// io::replace_folder. Returns the paths written.
tl::expected<std::vector<std::string>, FileError> write_files(const Result& result, const std::string& folder);

/// Whether write_files and write_vtk may use that folder, to be asked before a long calculation.
tl::expected<void, FileError> check_folder(const std::string& folder);

/// Writes the result's machines in space as VTK files for ParaView: for each scene and time NAME_0000.vtp, and NAME.pvd
/// over all times, all at once as write_files does. Returns the paths written, the last one what to open; none when the
/// result has nothing in space.
tl::expected<std::vector<std::string>, FileError> write_vtk(const Result& result, const std::string& folder);

}  // namespace taut::app
