#include "taut/io/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

namespace taut::io {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;
using Done = tl::expected<void, std::string>;

/// In a folder beside until it is whole: nothing in it is anybody's yet.
constexpr const char* unfinished = ".taut-unfinished";
/// A folder that waits for its successor, see Swap::in_two_steps.
constexpr std::string_view waiting = ".old";
/// A folder that is being removed: a kill may leave some of its files, without the list that says whose they are.
constexpr std::string_view discarded = ".gone";

tl::unexpected<std::string> refuse(const fs::path& folder, std::string_view why) {
  return tl::unexpected(fmt::format("can't replace the folder {}: {}", folder.string(), why));
}
std::string reason() { return std::strerror(errno); }

bool is_there(const fs::path& path) {
  std::error_code failed;
  return fs::exists(fs::symlink_status(path, failed));
}

/// `inner` is `outer` or lies in it; both canonical.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

/// Why a folder that is there can't change its name as a whole; empty when it can.
std::string obstacle(const fs::path& folder) {
  std::error_code failed;
  const fs::path here = fs::current_path(failed);
  if (!failed && lies_in(here, folder)) return "the program was started in it";
  const char* home = std::getenv("HOME");
  const fs::path home_folder = home != nullptr ? fs::canonical(home, failed) : fs::path();
  if (!failed && !home_folder.empty() && lies_in(home_folder, folder)) return "it holds your home folder";
  struct stat own = {}, above = {};
  if (lstat(folder.c_str(), &own) != 0 || lstat(folder.parent_path().c_str(), &above) != 0) return reason();
  if (own.st_dev != above.st_dev) return "a file system is mounted there";
  if ((own.st_mode & S_ISVTX) != 0) return "it is shared with other users";
  return {};
}

/// The folder that a path means, without the slashes behind it.
fs::path bare_path(const std::string& folder) {
  fs::path path = folder;
  while (!path.has_filename() && path.has_relative_path()) path = path.parent_path();
  return path;
}

/// The folder without links and dots where it is there; otherwise as it was given.
tl::expected<fs::path, std::string> found(const std::string& folder) {
  fs::path path = bare_path(folder);
  if (path.empty()) return tl::unexpected(std::string("the folder has no name"));
  std::error_code failed;
  if (fs::exists(path, failed)) {
    if (!fs::is_directory(path, failed)) return refuse(folder, "it is a file");
    path = fs::canonical(path, failed);
    if (failed) return refuse(folder, failed.message());
    if (const std::string why = obstacle(path); !why.empty()) {
      return refuse(folder, fmt::format("{}; give a folder of its own, such as {}", why, (path / "result").string()));
    }
    return path;
  }
  if (fs::is_symlink(fs::symlink_status(path, failed))) return refuse(folder, "it is a link to what is not there");
  return path;
}

fs::path parent_of(const fs::path& path) { return path.parent_path().empty() ? fs::path(".") : path.parent_path(); }

/// The same with its parents made where missing.
tl::expected<fs::path, std::string> with_parents(const std::string& folder) {
  auto path = found(folder);
  std::error_code failed;
  if (!path || fs::exists(*path, failed)) return path;
  fs::path parent = parent_of(*path);
  fs::create_directories(parent, failed);
  if (!failed) parent = fs::canonical(parent, failed);
  if (failed) return tl::unexpected(fmt::format("can't make the folder {}: {}", folder, failed.message()));
  return parent / path->filename();
}

/// How the names of the folders beside this one begin.
std::string beside_name(const fs::path& folder) {
  constexpr std::size_t longest = 150;  // of 255 bytes that a name may have
  return fmt::format(".{}.taut-", folder.filename().string().substr(0, longest));
}

/// An open folder, and the lock that shows others that its owner lives.
class OpenFolder {
 public:
  explicit OpenFolder(const fs::path& path) : number_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {}
  ~OpenFolder() { release(); }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  OpenFolder(OpenFolder&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  OpenFolder& operator=(OpenFolder&&) = delete;

  bool locked() const { return number_ >= 0 && flock(number_, LOCK_EX | LOCK_NB) == 0; }
  void wait_for_lock() const {
    while (number_ >= 0 && flock(number_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  /// It is still what `path` names.
  bool is_at(const fs::path& path) const {
    struct stat own = {}, there = {};
    return fstat(number_, &own) == 0 && lstat(path.c_str(), &there) == 0 && own.st_dev == there.st_dev &&
           own.st_ino == there.st_ino;
  }
  void release() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

Names listed(const fs::path& folder, const std::string& list) {
  Names names;
  std::ifstream file(folder / list);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.front() != '#') names.insert(line);
  }
  if (!names.empty()) names.insert(list);
  return names;
}

/// Of every list in a folder.
Names all_listed(const fs::path& folder) {
  Names names;
  std::error_code failed;
  for (const fs::directory_entry& e : fs::directory_iterator(folder, failed)) {
    const std::string name = e.path().filename().string();
    if (name.starts_with(".taut-")) names.merge(listed(folder, name));
  }
  return names;
}

/// Moves what `from` alone has to `to`; folders that both have are gone through.
void rescue(const fs::path& from, const fs::path& to, const Names& but) {
  std::error_code failed;
  std::vector<fs::path> all;
  for (const fs::directory_entry& e : fs::directory_iterator(from, failed)) all.push_back(e.path());
  for (const fs::path& one : all) {
    const fs::path there = to / one.filename();
    if (but.contains(one.filename().string())) continue;
    if (!is_there(there)) {
      fs::rename(one, there, failed);
    } else if (fs::is_directory(fs::symlink_status(one, failed)) &&
               fs::is_directory(fs::symlink_status(there, failed))) {
      rescue(one, there, {});
    }
  }
}

/// Removes a folder in two steps: its new name says that nothing in it is wanted.
void discard(const fs::path& folder) {
  std::error_code failed;
  const fs::path gone = folder.string() + std::string(discarded);
  fs::remove_all(gone, failed);
  fs::rename(folder, gone, failed);
  fs::remove_all(failed ? folder : gone, failed);
}

/// Removes a folder that has been replaced; what it alone has and `ours` does not name goes to its successor first.
void remove_replaced(const fs::path& old, const fs::path& successor, const Names& ours) {
  if (!is_there(old / unfinished)) rescue(old, successor, ours);
  discard(old);
}

/// Removes what runs that were killed have left beside the folder.
void clean_up(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> left;
  const std::string begin = beside_name(folder);
  for (const fs::directory_entry& e : fs::directory_iterator(folder.parent_path(), failed)) {
    if (e.path().filename().string().starts_with(begin)) left.push_back(e.path());
  }
  for (const fs::path& one : left) {
    struct stat found = {};
    const bool own = lstat(one.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid();
    const OpenFolder open_one(one);
    if (!own || !open_one.locked() || !open_one.is_at(one)) continue;
    if (one.string().ends_with(discarded)) {
      fs::remove_all(one, failed);
    } else if (one.string().ends_with(waiting) && !is_there(folder)) {
      fs::rename(one, folder, failed);
    } else {
      remove_replaced(one, folder, all_listed(one));
    }
  }
}

/// A new folder beside `folder`, locked; removed at the end where it is still there.
class Beside {
 public:
  static tl::expected<Beside, std::string> make(const fs::path& folder) {
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
      const fs::path path = folder.parent_path() / fmt::format("{}{}-{}", beside_name(folder), getpid(), i);
      if (mkdir(path.c_str(), S_IRWXU | S_IRWXG | S_IRWXO) != 0) {
        if (errno == EEXIST) continue;
        return tl::unexpected(
            fmt::format("can't write {}: a folder beside it can't be made: {}", folder.string(), reason()));
      }
      OpenFolder opened(path);
      // between making and locking it another run may have taken it for a left one; without locks none is removed
      if (opened.is_at(path) && (opened.locked() || errno != EWOULDBLOCK)) return Beside(path, std::move(opened));
    }
    return tl::unexpected(fmt::format("can't write {}: no folder beside it can be made", folder.string()));
  }
  ~Beside() {
    if (!path_.empty()) discard(path_);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  Beside(Beside&& other) noexcept : path_(std::exchange(other.path_, {})), opened_(std::move(other.opened_)) {}
  Beside& operator=(Beside&&) = delete;

  const fs::path& path() const { return path_; }
  /// It has its place, under `path_` stands something else now.
  void has_moved() {
    path_.clear();
    opened_.release();
  }

 private:
  Beside(fs::path path, OpenFolder opened) : path_(std::move(path)), opened_(std::move(opened)) {}
  fs::path path_;
  OpenFolder opened_;
};

/// A file or tree under a second name as well: the files themselves are shared, folders are made anew.
Done link_tree(const fs::path& from, const fs::path& to, int& count) {
  if (++count > most_kept) return tl::unexpected(fmt::format("it holds more than {} other files", most_kept));
  const auto failure = [&] { return tl::unexpected(fmt::format("{} can't be kept: {}", from.string(), reason())); };
  struct stat found = {};
  if (lstat(from.c_str(), &found) != 0) return errno == ENOENT ? Done() : Done(failure());
  if (!S_ISDIR(found.st_mode)) {
    return ::link(from.c_str(), to.c_str()) == 0 || errno == ENOENT ? Done() : Done(failure());
  }
  if (mkdir(to.c_str(), S_IRWXU) != 0) return failure();
  std::error_code failed;
  for (fs::directory_iterator e(from, failed); !failed && e != fs::directory_iterator(); e.increment(failed)) {
    if (const Done done = link_tree(e->path(), to / e->path().filename(), count); !done) return done;
  }
  if (failed) return tl::unexpected(fmt::format("{} can't be kept: {}", from.string(), failed.message()));
  return chmod(to.c_str(), found.st_mode & 07777U) == 0 ? Done() : Done(failure());
}

/// What is not ours in `folder` stands in `place` too afterwards.
Done keep_others(const fs::path& folder, const fs::path& place, const Names& ours) {
  int count = 0;
  std::error_code failed;
  for (fs::directory_iterator e(folder, failed); !failed && e != fs::directory_iterator(); e.increment(failed)) {
    const fs::path name = e->path().filename();
    if (ours.contains(name.string())) continue;
    if (is_there(place / name)) {
      return refuse(folder,
                    fmt::format("{} in it is not of an earlier run; move it, or give another folder", name.string()));
    }
    if (const Done done = link_tree(e->path(), place / name, count); !done) return refuse(folder, done.error());
  }
  if (failed) return refuse(folder, failed.message());
  struct stat found = {};
  if (stat(folder.c_str(), &found) == 0) {
    // its group as far as one may; a failure leaves the folder's files where they are
    [[maybe_unused]] const int group = chown(place.c_str(), static_cast<uid_t>(-1), found.st_gid);
    if (chmod(place.c_str(), found.st_mode & 07777U) != 0) return refuse(folder, reason());
  }
  return {};
}

/// Two folders change names in one step; ENOSYS or EINVAL where this can't be.
bool exchange([[maybe_unused]] const fs::path& one, [[maybe_unused]] const fs::path& other) {
#if defined(__linux__) && defined(SYS_renameat2)
  constexpr unsigned rename_exchange = 2;
  return syscall(SYS_renameat2, AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), rename_exchange) == 0;
#else
  errno = ENOSYS;
  return false;
#endif
}

/// `place` becomes `folder`. Returns where the former `folder` is now; empty when there was none.
tl::expected<fs::path, std::string> put_in_place(const fs::path& place, const fs::path& folder, Swap swap) {
  constexpr int tries = 100;  // another run may change what is there between two steps
  for (int i = 0; i < tries; ++i) {
    // succeeds where there is nothing yet, or an empty folder
    if (std::rename(place.c_str(), folder.c_str()) == 0) return fs::path();
    if (errno != ENOTEMPTY && errno != EEXIST) break;
    if (swap == Swap::at_once && exchange(place, folder)) return place;
    if (swap == Swap::at_once && errno == ENOENT) continue;
    if (swap == Swap::at_once && errno != EINVAL && errno != ENOSYS) break;
    fs::path old = place.string() + std::string(waiting);
    if (std::rename(folder.c_str(), old.c_str()) != 0 && errno != ENOENT) break;
    if (std::rename(place.c_str(), folder.c_str()) == 0) return old;
  }
  return refuse(folder, reason());
}

Done write_list(const fs::path& place, const std::string& list, const std::vector<std::string>& names) {
  std::ofstream file(place / list);
  file << "# What taut wrote into this folder. The next run into it takes these files away and keeps all others.\n";
  for (const std::string& name : names) file << name << '\n';
  file.close();
  return file ? Done() : Done(tl::unexpected(fmt::format("can't write {}: {}", list, reason())));
}

}  // namespace

Done check_replaceable(const std::string& folder) {
  const auto path = found(folder);
  if (!path) return tl::unexpected(path.error());
  std::error_code failed;
  fs::path parent = parent_of(*path);
  while (!fs::exists(parent, failed) && parent_of(parent) != parent) parent = parent_of(parent);
  if (!fs::is_directory(parent, failed)) return refuse(folder, fmt::format("{} is no folder", parent.string()));
  if (access(parent.c_str(), W_OK | X_OK) != 0) {
    return refuse(folder, fmt::format("it is written beside its place, in {}: {}", parent.string(), reason()));
  }
  return {};
}

tl::expected<std::vector<std::string>, std::string> replace_folder(const std::string& folder, const std::string& list,
                                                                   const FillFolder& fill,
                                                                   const std::vector<std::string>& unlisted,
                                                                   Swap swap) {
  const auto path = with_parents(folder);
  if (!path) return tl::unexpected(path.error());
  clean_up(*path);
  auto beside = Beside::make(*path);
  if (!beside) return tl::unexpected(beside.error());
  const fs::path place = beside->path();
  const fs::path mark = place / unfinished;
  std::ofstream(mark).close();
  auto names = fill(place.string());
  if (!names) return names;
  if (const Done done = write_list(place, list, *names); !done) return tl::unexpected(done.error());
  // Of two runs the second one looks at the folder when the first one has changed it.
  const OpenFolder parent(path->parent_path());
  parent.wait_for_lock();
  Names ours = listed(*path, list);
  if (ours.empty()) ours.insert(unlisted.begin(), unlisted.end());
  if (is_there(*path)) {
    if (const Done done = keep_others(*path, place, ours); !done) return tl::unexpected(done.error());
  }
  // The former folder comes to stand beside: locked, as nobody else may rescue from there or take its name meanwhile.
  const OpenFolder former(*path);
  former.wait_for_lock();
  std::error_code failed;
  fs::remove(mark, failed);
  const auto old = put_in_place(place, *path, swap);
  if (!old) return tl::unexpected(old.error());
  beside->has_moved();
  if (!old->empty()) {
    ours.merge(all_listed(*old));
    remove_replaced(*old, *path, ours);
  }
  for (std::string& name : *names) name = (fs::path(folder) / name).string();
  return names;
}

}  // namespace taut::io
