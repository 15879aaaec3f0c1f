#include "taut/io/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "taut/io/deck/deck.hpp"
#include "test/support/scratch_folder.hpp"

namespace taut::io::file_test {

namespace fs = std::filesystem;

class File : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(top_ / name, std::ios::binary) << text;
    return (top_ / name).string();
  }
  /// The mistakes of a deck that includes that file.
  Diagnostics including(const std::string& name, const std::string& head = "taut: 1\nmethod: m\n") const {
    Diagnostics mistakes;
    const std::string deck = head + "include: " + name + "\n";
    read_deck(deck, (top_ / "deck.yaml").string(), {}, {"m"}, mistakes);
    return mistakes;
  }

  taut_test::ScratchFolder scratch_;
  fs::path top_ = scratch_.path();
};

TEST_F(File, ReadsAFileWhole) {
  const std::string text = std::string("a\0b\n", 4) + std::string(200000, 'x');
  EXPECT_EQ(read_file(write("a", text)), text);
  EXPECT_EQ(read_file(write("empty", "")), "");
  EXPECT_EQ(read_file(write("large", std::string(largest_deck + 9, 'x')))->size(), largest_deck + 1);
}

TEST_F(File, WhatWasWrittenBesideIsPutInItsPlace) {
  const std::string beside = write("new", "new"), path = write("there", "old");
  ASSERT_TRUE(put_in_place(beside, path));
  EXPECT_EQ(read_file(path), "new");
  EXPECT_FALSE(fs::exists(beside));
  const auto missing = put_in_place(beside, path);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error(), "No such file or directory");
  EXPECT_EQ(read_file(path), "new") << "nothing is lost";
}

TEST_F(File, RefusesAllElseWithoutOpeningIt) {
  const std::string fifo = (top_ / "fifo").string(), socket_file = (top_ / "socket").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const int s = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, socket_file.c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(s, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  fs::create_symlink("fifo", top_ / "link");
  const std::vector<std::pair<std::string, std::string>> all = {{fifo, "a pipe"},
                                                                {(top_ / "link").string(), "a pipe"},
                                                                {socket_file, "a socket"},
                                                                {"/dev/zero", "a device"},
                                                                {top_.string(), "a folder"}};
  for (const auto& [path, kind] : all) {
    const auto text = read_file(path);
    ASSERT_FALSE(text) << path;
    EXPECT_NE(text.error().message.find("is not a file, it is " + kind), std::string::npos) << text.error().message;
    EXPECT_FALSE(text.error().missing);
  }
  close(s);
  EXPECT_TRUE(read_file((top_ / "nowhere").string()).error().missing);
  const Diagnostics mistakes = including("fifo");
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_TRUE(only_unreadable_files(mistakes));
  EXPECT_EQ(mistakes[0].place, (Place{3, 10}));
  EXPECT_FALSE(only_unreadable_files(including("nowhere"))) << "a name that is not there is a mistake of the deck";
}

TEST_F(File, ReadsWhatIsOpenAlready) {
  int ends[2] = {};
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "a: 1\n", 5), 5);
  close(ends[1]);
  EXPECT_EQ(read_open(ends[0], "x"), "a: 1\n");
  close(ends[0]);
  const auto closed = read_open(ends[0], "x");
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().message, "'x' can't be read: Bad file descriptor");
}

/// What a deck makes taut read may be anything on the machine: its text is in no message.
TEST_F(File, MessagesTellNothingOfNamedFiles) {
  const std::vector<std::string> files = {"root:$6$hidden:19000:0:99999\nhidden2:x:1:1\n",
                                          "hidden: hidden2\n",
                                          "taut: hidden\nmethod: hidden2\n",
                                          "a: [hidden\n",
                                          "hidden: 1\nhidden: 2\n",
                                          "a: 'hidden\n",
                                          "- hidden\n",
                                          "a: &hidden 1\n",
                                          "display: {force: hidden}\n",
                                          "display: hidden\n",
                                          "title: {hidden: 1}\n",
                                          "method: |\n  hidden\n  hidden2\n",
                                          "method: >\n  hidden\n  hidden2 words\n",
                                          "method: \"hid\\\n   den\"",
                                          "hidden\n",
                                          "method: 'hidden''s'\n",
                                          "hidden\x01: 1\n",
                                          "\thidden: 1\n"};
  for (const std::string& text : files) {
    write("part", text);
    const Diagnostics mistakes = including("part", "taut: 1\n");
    ASSERT_FALSE(mistakes.empty()) << text;
    const std::string reported = to_text(mistakes);
    EXPECT_EQ(reported.find("hidden"), std::string::npos) << reported;
    EXPECT_NE(reported.find("part"), std::string::npos) << reported;
  }
}

TEST_F(File, MessagesOfNamedFilesStillHelp) {
  write("part", "disply: {}\nmethod: m\n");
  const Diagnostics mistakes = including("part");
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_EQ(mistakes[0].message, "'...' is not a key of a deck; did you mean 'display'?");
  EXPECT_EQ(mistakes[0].place, (Place{1, 1}));
  const Diagnostic rows = without_text({.file = "ropes.csv",
                                        .place = {.line = 2, .column = 3},
                                        .message = "'-5' is below 0 in column 'd_mm'",
                                        .source_line = "x",
                                        .width = 2},
                                       "id,d_mm\na,-5\n");
  EXPECT_EQ(rows.message, "'...' is below 0 in column 'd_mm'");
  EXPECT_EQ(rows.source_line, "");
  // the quotes of two words of taut's own are not around a text of the file
  const Diagnostic columns = without_text({.file = "g.csv",
                                           .place = {.line = 1, .column = 1},
                                           .message = "columns 'x', 'y' and 'z' are expected, not 'x,elevation'",
                                           .source_line = "x",
                                           .width = 1},
                                          "x,elevation\n0,0\n");
  EXPECT_EQ(columns.message, "columns 'x', 'y' and 'z' are expected, not '...'");
}

TEST_F(File, NotesWhatItHasRead) {
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "title: t\n");
  write("c.csv", "x,z\n");
  Diagnostics mistakes;
  const auto deck = read_deck("taut: 1\nmethod: m\ninput: {file: c.csv}\ninclude: a.yaml\n", (top_ / "d").string(), {},
                              {"m"}, mistakes);
  ASSERT_TRUE(mistakes.empty());
  const auto file = read_named(*deck->input.find("file"), "c.csv", mistakes);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->path, (top_ / "c.csv").string());
  EXPECT_EQ(deck->reading->texts, (std::vector<std::string>{"include: b.yaml\n", "title: t\n", "x,z\n"}));
}

}  // namespace taut::io::file_test
