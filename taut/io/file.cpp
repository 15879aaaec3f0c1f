#include "taut/io/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace taut::io {
namespace {

namespace fs = std::filesystem;

/// Closes what it was given.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

/// Waits until a file or folder is on the disk. False: it is not, see errno; file systems that know no such thing for
/// folders say EINVAL.
bool sync_to_disk(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  return file.get() >= 0 && (::fsync(file.get()) == 0 || errno == EINVAL);
}

const char* kind_of_file(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

tl::unexpected<Unreadable> refused(const std::string& name, mode_t mode) {
  return tl::unexpected(
      Unreadable{.message = fmt::format("{} is not a file, it is {}", in_quotes(name), kind_of_file(mode))});
}

tl::unexpected<Unreadable> unreadable(const std::string& name) {
  const int reason = errno;
  return tl::unexpected(
      Unreadable{.message = fmt::format("{} can't be read: {}", in_quotes(name), std::strerror(reason)),
                 .missing = reason == ENOENT || reason == ENOTDIR});
}

}  // namespace

tl::expected<std::string, Unreadable> read_open(int descriptor, const std::string& name) {
  std::string text;
  constexpr std::size_t piece = std::size_t{64} * 1024;
  while (text.size() <= largest_deck) {
    const std::size_t have = text.size();
    text.resize(have + std::min(piece, largest_deck + 1 - have));
    const ssize_t got = ::read(descriptor, text.data() + have, text.size() - have);
    text.resize(have + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) break;
    if (got < 0 && errno != EINTR) return unreadable(name);
  }
  return text;
}

tl::expected<std::string, Unreadable> read_file(const std::string& path) {
  // Looked at before it is opened, as opening a device may do something, and after it, as it may be another one by
  // then.
  struct stat found = {};
  if (::stat(path.c_str(), &found) != 0) return unreadable(path);
  if (!S_ISREG(found.st_mode)) return refused(path, found.st_mode);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.get() < 0 || fstat(file.get(), &found) != 0) return unreadable(path);
  if (!S_ISREG(found.st_mode)) return refused(path, found.st_mode);
  return read_open(file.get(), path);
}

tl::expected<void, std::string> put_in_place(const std::string& written, const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  const bool done = sync_to_disk(written) && std::rename(written.c_str(), path.c_str()) == 0 &&
                    sync_to_disk(folder.empty() ? "." : folder);
  if (done) return {};
  return tl::unexpected(std::string(std::strerror(errno)));
}

tl::expected<std::string, Unreadable> read_beside(const Source& source, const std::string& path) {
  if (source.reading && source.reading->read) return source.reading->read(path);
  return read_file(path);
}

std::optional<NamedFile> read_named(const Node& node, const std::string& name, Diagnostics& mistakes) {
  const fs::path deck = node.spot.source ? fs::path(node.spot.source->name) : fs::path();
  NamedFile file{.path = (deck.parent_path() / name).string(), .text = {}};
  auto text = node.spot.source ? read_beside(*node.spot.source, file.path) : read_file(file.path);
  if (!text) {
    Diagnostic mistake = at(node.spot, text.error().message);
    mistake.unreadable_file = !text.error().missing;
    add(mistakes, std::move(mistake));
    return std::nullopt;
  }
  file.text = std::move(*text);
  if (node.spot.source && node.spot.source->reading) node.spot.source->reading->texts.push_back(file.text);
  return file;
}

}  // namespace taut::io
