#include "web/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

#include "taut/io/deck/source.hpp"
#include "taut/io/file.hpp"

namespace taut::web {
namespace {

namespace fs = std::filesystem;
using Kind = FolderError::Kind;

tl::unexpected<FolderError> error(Kind kind, const std::string& name, std::string_view why) {
  return tl::unexpected(FolderError{.kind = kind, .message = fmt::format("{} {}", io::in_quotes(name), why)});
}

bool inside(const fs::path& folder, const fs::path& path) {
  const auto [end, _] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

bool is_deck_or_table(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".yaml" || ending == ".yml" || ending == ".csv";
}

bool hidden(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part.string().starts_with("."); });
}

tl::expected<void, FolderError> check_kind(const std::string& name) {
  const fs::path plain = fs::path(name).lexically_normal();
  if (hidden(plain)) return error(Kind::no_deck, name, "is hidden");
  if (!is_deck_or_table(plain)) return error(Kind::no_deck, name, "is no deck (.yaml, .yml) and no table (.csv)");
  return {};
}

/// A file that is written whole, or is not there.
class Unfinished {
 public:
  explicit Unfinished(fs::path path) : path_(std::move(path)) {
    number_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
  }
  ~Unfinished() {
    if (number_ < 0) return;
    ::close(number_);
    if (!moved_) ::unlink(path_.c_str());
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  bool write(std::string_view text) const {
    while (number_ >= 0 && !text.empty()) {
      const ssize_t written = ::write(number_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return number_ >= 0 && ::fsync(number_) == 0;
  }
  bool keep_mode_of(const fs::path& other) const {
    struct stat found = {};
    return ::stat(other.c_str(), &found) != 0 || ::fchmod(number_, found.st_mode & 0777U) == 0;
  }
  bool move_to(const fs::path& other) {
    moved_ = ::rename(path_.c_str(), other.c_str()) == 0;
    return moved_;
  }

 private:
  fs::path path_;
  int number_ = -1;
  bool moved_ = false;
};

}  // namespace

Folder::Folder(const fs::path& path) : path_(fs::canonical(path)) {
  if (!fs::is_directory(path_)) {
    throw fs::filesystem_error("no folder", path, std::make_error_code(std::errc::not_a_directory));
  }
}

Folder::Listing Folder::list() const {
  Listing found;
  std::error_code failed;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(path_, options, failed), end; !failed && at != end; at.increment(failed)) {
    const fs::path name = at->path().lexically_relative(path_);
    std::error_code ignored;
    if (hidden(name.filename()) || at.depth() >= deepest_listed) at.disable_recursion_pending();
    if (hidden(name.filename()) || !is_deck_or_table(name) || !at->is_regular_file(ignored)) continue;
    if (at->is_symlink(ignored) && !place_of(name.string())) continue;
    if (found.names.size() == most_listed) {
      found.whole = false;
      break;
    }
    found.names.push_back(name.string());
  }
  std::sort(found.names.begin(), found.names.end());
  return found;
}

/// Where a name leads, all links followed. The last part may be missing.
tl::expected<fs::path, FolderError> Folder::place_of(const std::string& name) const {
  if (name.empty() || name.find('\0') != std::string::npos) return error(Kind::missing, name, "is no name of a file");
  // an absolute path takes the place of the folder; the check below refuses it unless it leads into it
  const fs::path asked = path_ / name;
  std::error_code failed;
  const fs::path parent = fs::canonical(asked.parent_path(), failed);
  // said alike of what is there and what is not: it is nobody's business what stands outside
  if (!inside(path_, asked.lexically_normal()) || (!failed && !inside(path_, parent))) {
    return error(Kind::outside, name, "is outside the folder that taut serves");
  }
  if (failed) return error(Kind::missing, name, "can't be read: No such file or directory");
  fs::path place = parent / asked.filename();
  if (!fs::is_symlink(place, failed)) return place;
  fs::path target = fs::canonical(place, failed);
  if (failed || !inside(path_, target))
    return error(Kind::outside, name, "is a link out of the folder that taut serves");
  return target;
}

tl::expected<std::string, FolderError> Folder::read(const std::string& name) const {
  const auto place = place_of(name);
  if (!place) return tl::unexpected(place.error());
  auto text = io::read_file(place->string());
  if (!text && text.error().missing) return error(Kind::missing, name, "can't be read: No such file or directory");
  if (!text) return error(Kind::failed, name, "can't be read: it is no file, or not yours to read");
  if (text->size() > io::largest_deck) return error(Kind::too_large, name, "has more than 16 MB");
  return std::move(*text);
}

tl::expected<std::string, FolderError> Folder::open(const std::string& name) const {
  const auto place = place_of(name);
  if (!place) return tl::unexpected(place.error());
  if (const auto good = check_kind(name); !good) return tl::unexpected(good.error());
  return read(name);
}

tl::expected<void, FolderError> Folder::save(const std::string& name, const std::string& text) const {
  const auto place = place_of(name);
  if (!place) return tl::unexpected(place.error());
  if (const auto good = check_kind(name); !good) return good;
  if (text.size() > io::largest_deck) return error(Kind::too_large, name, "would have more than 16 MB");
  std::error_code failed;
  const fs::file_status there = fs::status(*place, failed);
  if (fs::exists(there) && !fs::is_regular_file(there)) return error(Kind::no_deck, name, "is no file");
  static std::atomic<int> count = 0;
  Unfinished file(place->parent_path() / fmt::format(".taut-{}-{}", ::getpid(), ++count));
  errno = 0;
  if (!file.write(text) || !file.keep_mode_of(*place) || !file.move_to(*place)) {
    return error(Kind::failed, name, fmt::format("can't be written: {}", std::strerror(errno)));
  }
  return {};
}

}  // namespace taut::web
