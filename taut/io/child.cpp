#include "taut/io/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <thread>

extern char** environ;  // NOLINT(readability-redundant-declaration): not every C library declares it

namespace taut::io {
namespace {

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr std::chrono::milliseconds between_looks{20};

/// Texts as a C list of pointers, valid as long as the texts are.
std::vector<char*> pointers(Words& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

Words environment_with(const Words& changes) {
  Words all;
  const auto name_of = [](const std::string& entry) { return entry.substr(0, entry.find('=')); };
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string name = name_of(*entry);
    const bool changed = std::any_of(changes.begin(), changes.end(), [&](const auto& c) { return name_of(c) == name; });
    if (!changed) all.emplace_back(*entry);
  }
  all.insert(all.end(), changes.begin(), changes.end());
  return all;
}

/// Attributes and file actions of posix_spawn, freed at the end.
class Settings {
 public:
  Settings(short flags, const std::string& output) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    constexpr mode_t own_file = 0600;
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, own_file);
    posix_spawn_file_actions_adddup2(&files_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    // signals that this program ignores are not ignored by others
    sigset_t defaults;
    sigemptyset(&defaults);
    for (const int number : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) sigaddset(&defaults, number);
    posix_spawnattr_setsigdefault(&attributes_, &defaults);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, static_cast<short>(flags | POSIX_SPAWN_SETSIGDEF));
  }
  ~Settings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  Settings(const Settings&) = delete;
  Settings& operator=(const Settings&) = delete;

  tl::expected<pid_t, std::string> start(Words words, Words environment) const {
    pid_t number = 0;
    const std::string program = words.front();
    const int failure = posix_spawn(&number, program.c_str(), &files_, &attributes_, pointers(words).data(),
                                    pointers(environment).data());
    if (failure != 0) return tl::unexpected(fmt::format("can't start {}: {}", program, std::strerror(failure)));
    return number;
  }

 private:
  posix_spawn_file_actions_t files_ = {};
  posix_spawnattr_t attributes_ = {};
};

int exit_code_of(int status) {
  constexpr int of_signals = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : of_signals + WTERMSIG(status);
}

/// Its exit code once it has ended; a process that cannot be waited for counts as failed.
std::optional<int> ended(pid_t number) {
  int status = 0;
  const pid_t found = waitpid(number, &status, WNOHANG);
  if (found == number) return exit_code_of(status);
  if (found < 0 && errno != EINTR) return -1;
  return std::nullopt;
}

/// Its exit code if it ends within the time.
std::optional<int> ended_within(pid_t number, std::chrono::milliseconds time) {
  const auto begin = Clock::now();
  auto code = ended(number);
  while (!code && Clock::now() - begin < time) {
    std::this_thread::sleep_for(between_looks);
    code = ended(number);
  }
  return code;
}

/// Ends a process group, gently first.
void end_group(pid_t number) {
  constexpr std::chrono::seconds patience{2};
  kill(-number, SIGTERM);
  const bool gone = ended_within(number, patience).has_value();
  kill(-number, SIGKILL);
  int status = 0;
  while (!gone && waitpid(number, &status, 0) < 0 && errno == EINTR) {
  }
}

bool can_run(const std::string& path) {
  struct stat found = {};
  return stat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

tl::expected<ChildResult, std::string> run_child(const Child& child) {
  const auto number =
      Settings(POSIX_SPAWN_SETPGROUP, child.output).start(child.words, environment_with(child.environment));
  if (!number) return tl::unexpected(number.error());
  const auto begin = Clock::now();
  while (true) {
    if (const auto code = ended(*number)) {
      kill(-*number, SIGKILL);  // what it has left running
      return ChildResult{.end = ChildEnd::ended, .code = *code};
    }
    const bool stopped = child.go_on && !child.go_on();
    if (stopped || Clock::now() - begin > child.limit) {
      end_group(*number);
      return ChildResult{.end = stopped ? ChildEnd::stopped : ChildEnd::too_long, .code = -1};
    }
    std::this_thread::sleep_for(between_looks);
  }
}

tl::expected<std::optional<int>, std::string> start_apart(const Words& words, std::chrono::milliseconds watched) {
  const auto number = Settings(POSIX_SPAWN_SETSID, "/dev/null").start(words, environment_with({}));
  if (!number) return tl::unexpected(number.error());
  const auto code = ended_within(*number, watched);
  return code && *code != 0 ? code : std::nullopt;
}

std::optional<std::string> program_path(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (name.find('/') != std::string::npos) return can_run(name) ? std::optional(name) : std::nullopt;
  const char* folders = std::getenv("PATH");
  std::string_view left = folders == nullptr ? "/usr/local/bin:/usr/bin:/bin" : folders;
  while (true) {
    const std::size_t end = left.find(':');
    const std::string_view folder = left.substr(0, end);
    std::string path = fmt::format("{}/{}", folder.empty() ? "." : folder, name);
    if (can_run(path)) return path;
    if (end == std::string_view::npos) return std::nullopt;
    left.remove_prefix(end + 1);
  }
}

}  // namespace taut::io
