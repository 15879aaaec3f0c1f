#include "taut/io/folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "test/support/scratch_folder.hpp"

namespace taut::io::folder_test {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

class Folder : public ::testing::Test {
 protected:
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  /// All files below, but for the lists.
  static Files files_in(const fs::path& folder) {
    Files files;
    for (const auto& e : fs::recursive_directory_iterator(folder)) {
      const bool list = e.path().filename().string().starts_with(".taut-");
      if (!e.is_directory() && !list) files[e.path().lexically_relative(folder).string()] = text_of(e.path());
    }
    return files;
  }
  static FillFolder filled(const Files& files) {
    return [files](const std::string& place) {
      std::vector<std::string> names;
      for (const auto& [name, text] : files) {
        write(fs::path(place) / name, text);
        names.push_back(name);
      }
      return names;
    };
  }
  static std::string put(const fs::path& folder, const Files& files, Swap swap = Swap::at_once) {
    const auto done = replace_folder(folder.string(), ".taut-files", filled(files), {}, swap);
    return done ? std::string() : done.error();
  }
  /// Nothing but `names` in the top folder: no folder beside is left.
  void expect_top(const std::set<std::string>& names) const {
    std::set<std::string> found;
    for (const auto& e : fs::directory_iterator(top_)) found.insert(e.path().filename().string());
    EXPECT_EQ(found, names);
  }

  taut_test::ScratchFolder scratch_;
  fs::path top_ = scratch_.path();
};

TEST_F(Folder, HoldsTheLastResultAlone) {
  const fs::path out = top_ / "new" / "out";
  for (const Swap swap : {Swap::at_once, Swap::in_two_steps}) {
    EXPECT_EQ(put(out, {{"a.csv", "1"}, {"old.csv", "1"}}, swap), "");
    EXPECT_EQ(files_in(out), (Files{{"a.csv", "1"}, {"old.csv", "1"}}));
    EXPECT_EQ(put(out.string() + "/", {{"a.csv", "2"}, {"b.csv", "2"}}, swap), "");
    EXPECT_EQ(files_in(out), (Files{{"a.csv", "2"}, {"b.csv", "2"}}));
    fs::remove_all(out);
  }
  expect_top({"new"});
  EXPECT_TRUE(fs::is_empty(top_ / "new"));
}

TEST_F(Folder, ReturnsThePathsWritten) {
  const auto done = replace_folder((top_ / "out").string(), ".taut-files", filled({{"a", ""}, {"b", ""}}));
  ASSERT_TRUE(done);
  EXPECT_EQ(*done, (std::vector<std::string>{top_ / "out" / "a", top_ / "out" / "b"}));
}

TEST_F(Folder, KeepsWhatOthersWrote) {
  const fs::path out = top_ / "out";
  fs::create_directories(out / "photos" / "2026");
  write(out / "notes.txt", "mine");
  write(out / "photos" / "2026" / "mast.jpg", "mine");
  fs::create_symlink("notes.txt", out / "link");
  chmod(out.c_str(), 0750);
  for (const Swap swap : {Swap::at_once, Swap::in_two_steps, Swap::at_once}) {
    EXPECT_EQ(put(out, {{"a.csv", "1"}, {swap == Swap::at_once ? "b" : "c", "2"}}, swap), "");
    Files all = files_in(out);
    EXPECT_EQ(all.size(), 5U);
    EXPECT_EQ(all["notes.txt"], "mine");
    EXPECT_EQ(all["photos/2026/mast.jpg"], "mine");
    EXPECT_EQ(fs::read_symlink(out / "link"), "notes.txt");
  }
  EXPECT_EQ(fs::status(out).permissions(), static_cast<fs::perms>(0750));
  expect_top({"out"});
}

TEST_F(Folder, OverwritesNoFileOfOthers) {
  const fs::path out = top_ / "out";
  fs::create_directory(out);
  write(out / "report.html", "mine");
  const std::string why = put(out, {{"report.html", "taut's"}, {"a", ""}});
  EXPECT_NE(why.find("report.html in it is not of an earlier run"), std::string::npos) << why;
  EXPECT_EQ(files_in(out), (Files{{"report.html", "mine"}}));
  expect_top({"out"});
  // what an earlier version wrote without a list counts as listed
  const auto done =
      replace_folder(out.string(), ".taut-files", filled({{"a", "x"}}), {"report.html", "never_there.csv"});
  EXPECT_TRUE(done);
  EXPECT_EQ(files_in(out), (Files{{"a", "x"}}));
}

TEST_F(Folder, TwoListsLeaveEachOther) {
  const fs::path out = top_ / "out";
  ASSERT_EQ(put(out, {{"result.json", "1"}}), "");
  ASSERT_TRUE(replace_folder(out.string(), ".taut-vtk-files", filled({{"s.vtp", "1"}, {"s.pvd", "1"}})));
  ASSERT_EQ(put(out, {{"result.json", "2"}}), "");
  EXPECT_EQ(files_in(out), (Files{{"result.json", "2"}, {"s.pvd", "1"}, {"s.vtp", "1"}}));
  ASSERT_TRUE(replace_folder(out.string(), ".taut-vtk-files", filled({{"s.vtp", "2"}})));
  EXPECT_EQ(files_in(out), (Files{{"result.json", "2"}, {"s.vtp", "2"}}));
}

TEST_F(Folder, AFailureLeavesTheOldResult) {
  const fs::path out = top_ / "out";
  ASSERT_EQ(put(out, {{"a", "old"}}), "");
  const auto done = replace_folder(out.string(), ".taut-files", [](const std::string& place) {
    write(fs::path(place) / "a", "half");
    return tl::expected<std::vector<std::string>, std::string>(tl::unexpect, "the disk is full");
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error(), "the disk is full");
  EXPECT_EQ(files_in(out), (Files{{"a", "old"}}));
  expect_top({"out"});
}

TEST_F(Folder, FollowsALinkToAFolder) {
  fs::create_directory(top_ / "real");
  fs::create_directory_symlink("real", top_ / "link");
  ASSERT_EQ(put(top_ / "link", {{"a", "1"}}), "");
  ASSERT_EQ(put(top_ / "link", {{"b", "2"}}), "");
  EXPECT_TRUE(fs::is_symlink(top_ / "link"));
  EXPECT_EQ(files_in(top_ / "real"), (Files{{"b", "2"}}));
  fs::create_directory_symlink("nowhere", top_ / "dangling");
  EXPECT_NE(put(top_ / "dangling", {{"a", "1"}}).find("a link to what is not there"), std::string::npos);
  expect_top({"real", "link", "dangling"});
}

TEST_F(Folder, RefusesWhatCannotBeReplacedAsAWhole) {
  const auto refused = [&](const fs::path& folder, const std::string& why) {
    const std::string reported = put(folder, {{"a", "1"}});
    EXPECT_NE(reported.find(why), std::string::npos) << reported;
    const auto before = check_replaceable(folder.string());
    ASSERT_FALSE(before);
    EXPECT_EQ(before.error(), reported);
  };
  write(top_ / "file", "x");
  refused(top_ / "file", "it is a file");
  refused("", "has no name");
  refused("/proc", "a file system is mounted there");
  refused("/", "");
  fs::create_directory(top_ / "shared");
  chmod((top_ / "shared").c_str(), 01777);
  refused(top_ / "shared", "shared with other users");
  fs::create_directories(top_ / "here" / "below");
  const fs::path before = fs::current_path();
  fs::current_path(top_ / "here" / "below");
  for (const char* name : {".", "..", "../../here"}) refused(name, "started in it; give a folder of its own, such as ");
  EXPECT_EQ(put("out", {{"a", "1"}}), "");
  fs::current_path(before);
  const char* home = std::getenv("HOME");
  const std::string kept = home != nullptr ? home : "";
  fs::create_directories(top_ / "home" / "me");
  setenv("HOME", (top_ / "home" / "me").c_str(), 1);
  refused(top_ / "home", "it holds your home folder");
  setenv("HOME", kept.c_str(), 1);
  EXPECT_TRUE(check_replaceable((top_ / "not" / "yet").string()));
  EXPECT_FALSE(fs::exists(top_ / "not")) << "asking makes no folder";
}

TEST_F(Folder, RemovesWhatKilledRunsLeft) {
  const fs::path out = top_ / "out";
  ASSERT_EQ(put(out, {{"a", "1"}}), "");
  write(out / "notes.txt", "mine");
  // killed while it wrote
  fs::create_directory(top_ / ".out.taut-1-0");
  write(top_ / ".out.taut-1-0" / ".taut-unfinished", "");
  write(top_ / ".out.taut-1-0" / "half.csv", "half");
  // killed when it had put the new files in place, with one of somebody else's that came in between
  fs::create_directory(top_ / ".out.taut-1-1");
  write(top_ / ".out.taut-1-1" / ".taut-files", "# x\nolder.csv\n");
  write(top_ / ".out.taut-1-1" / "older.csv", "older");
  write(top_ / ".out.taut-1-1" / "notes.txt", "an earlier one");
  write(top_ / ".out.taut-1-1" / "late.txt", "mine too");
  // of another folder
  fs::create_directory(top_ / ".out2.taut-1-0");
  ASSERT_EQ(put(out, {{"b", "2"}}), "");
  EXPECT_EQ(files_in(out), (Files{{"b", "2"}, {"late.txt", "mine too"}, {"notes.txt", "mine"}}));
  expect_top({"out", ".out2.taut-1-0"});
}

TEST_F(Folder, PutsBackWhatWaitedForItsSuccessor) {
  fs::create_directory(top_ / ".out.taut-1-0.old");
  write(top_ / ".out.taut-1-0.old" / ".taut-files", "# x\na\n");
  write(top_ / ".out.taut-1-0.old" / "a", "old");
  write(top_ / ".out.taut-1-0.old" / "notes.txt", "mine");
  ASSERT_EQ(put(top_ / "out", {{"b", "2"}}), "");
  EXPECT_EQ(files_in(top_ / "out"), (Files{{"b", "2"}, {"notes.txt", "mine"}}));
  expect_top({"out"});
}

TEST_F(Folder, LeavesAloneWhatARunStillWrites) {
  const fs::path out = top_ / "out";
  fs::path other;
  const auto done = replace_folder(out.string(), ".taut-files", [&](const std::string& place) {
    other = place;
    write(other / "slow", "1");
    EXPECT_EQ(put(out, {{"quick", "1"}}), "");
    EXPECT_EQ(files_in(out), (Files{{"quick", "1"}}));
    EXPECT_TRUE(fs::exists(other / "slow"));
    return tl::expected<std::vector<std::string>, std::string>(std::vector<std::string>{"slow"});
  });
  EXPECT_TRUE(done);
  EXPECT_EQ(files_in(out), (Files{{"slow", "1"}}));
  expect_top({"out"});
}

/// Processes that write the same folder again and again, one of them killed at any time: what is there is always one
/// whole result, and what is not taut's stays.
TEST_F(Folder, IsWholeWhoeverIsKilled) {
  const fs::path out = top_ / "out";
  fs::create_directory(out);
  write(out / "notes.txt", "mine");
  const auto set_of = [](int run) {
    Files files;
    for (int i = 0; i < 4 + run % 3; ++i) files[std::string(1, static_cast<char>('a' + i))] = std::to_string(run);
    return files;
  };
  constexpr int kills = 40;
  for (int i = 0; i < kills; ++i) {
    std::vector<pid_t> children;
    for (int k = 0; k < 2; ++k) {
      const pid_t child = fork();
      if (child == 0) {
        for (int run = 0; run < 1000; ++run) put(out, set_of(run % 7));
        _exit(0);
      }
      children.push_back(child);
    }
    usleep(static_cast<useconds_t>(500 + 137 * i));
    for (const pid_t child : children) kill(child, SIGKILL);
    for (const pid_t child : children) waitpid(child, nullptr, 0);
    Files found = files_in(out);
    EXPECT_EQ(found["notes.txt"], "mine");
    found.erase("notes.txt");
    if (found.empty()) continue;
    EXPECT_EQ(found, set_of(std::stoi(found.begin()->second))) << i;
  }
  ASSERT_EQ(put(out, set_of(2)), "");
  expect_top({"out"});
}

}  // namespace taut::io::folder_test
