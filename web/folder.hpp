#pragma once
#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace taut::web {

/// Why a file of the folder is not given or not taken.
struct FolderError {
  enum class Kind { outside, missing, no_deck, too_large, failed };
  Kind kind = Kind::failed;
  std::string message;
};

/// The files of one folder and of those in it. A name is a path from the folder, with '/'. A name or a symbolic link
/// that leads out of it is refused, and so is what is no regular file.
class Folder {
 public:
  /// The folder must be there; throws std::filesystem::filesystem_error.
  explicit Folder(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }

  struct Listing {
    std::vector<std::string> names;  ///< decks (.yaml, .yml) and tables (.csv), sorted
    bool whole = true;               ///< false: there are more than most_listed
  };
  /// Without hidden files and folders; folders behind symbolic links are not looked into.
  Listing list() const;

  /// The text of any file of the folder, as an included deck, a table or a state is; at most largest_deck bytes.
  tl::expected<std::string, FolderError> read(const std::string& name) const;

  /// The text of a deck or table that is not hidden.
  tl::expected<std::string, FolderError> open(const std::string& name) const;

  /// Writes a deck or table, which may be new, in a folder that is there: whoever reads it meanwhile, and whenever this
  /// is killed, finds the old text or the new one, whole. At most largest_deck bytes.
  tl::expected<void, FolderError> save(const std::string& name, const std::string& text) const;

  static constexpr int most_listed = 2000;
  static constexpr int deepest_listed = 8;

 private:
  tl::expected<std::filesystem::path, FolderError> place_of(const std::string& name) const;

  std::filesystem::path path_;  ///< canonical
};

}  // namespace taut::web
