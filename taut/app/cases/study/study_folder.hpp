#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/app/cases/study/study.hpp"
#include "taut/app/job.hpp"

namespace taut::app {

/// One case as it is kept.
struct KeptCase {
  std::uint64_t index = 0;
  chance::Point values;  ///< of the inputs, SI
  CaseAnswer answer;
};

/// The cases of a study are calculated and kept in parts of consecutive numbers: a part is there whole, or it is not.
struct StudyParts {
  std::uint64_t cases = 0;     ///< in all
  std::uint64_t per_part = 0;  ///< the last part may have fewer
  std::uint64_t count() const { return (cases + per_part - 1) / per_part; }
  CaseBlock of(std::uint64_t part) const;
};

/// A function of the number of cases alone: at most 256 parts, or of 64 cases each.
StudyParts parts_of(std::uint64_t cases);

/// What stands in a study's folder beside its results: the deck as it was, in `study.json`, and the parts that are
/// done, in `parts`.
class StudyFolder {
 public:
  /// Makes a folder of a study, or opens the one that is there already. An error: another study is in it, it can't be
  /// written, or it is not what it seems.
  static tl::expected<StudyFolder, FileError> make(const std::string& folder, const Job& job, const Study& study);

  /// A folder that has a study, for its state; the deck is not read.
  static tl::expected<StudyFolder, FileError> open(const std::string& folder);

  /// The job of the study in a folder.
  static tl::expected<Job, FileError> job_in(const std::string& folder);

  const StudyParts& parts() const { return parts_; }
  /// By part. One that can't be read, as a power cut may leave it, is not done. Reads all of them.
  std::vector<bool> done() const;

  /// Writes a part, all of it at once: a program that is killed meanwhile leaves none, nor does a power cut. From any
  /// thread.
  tl::expected<void, FileError> write(std::uint64_t part, const Study& study, const std::vector<KeptCase>& rows) const;
  tl::expected<std::vector<KeptCase>, FileError> read(std::uint64_t part, const Study& study) const;

  /// Removes what killed programs have left.
  void tidy() const;

 private:
  StudyFolder(std::string folder, StudyParts parts) : folder_(std::move(folder)), parts_(parts) {}
  std::string path_of(std::uint64_t part) const;

  std::string folder_;
  StudyParts parts_;
};

}  // namespace taut::app
