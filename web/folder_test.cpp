#include "web/folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "test/support/scratch_folder.hpp"

namespace taut::web::folder_test {

namespace fs = std::filesystem;
using Kind = FolderError::Kind;

/// A served folder in another one that nobody may reach.
class FolderTest : public testing::Test {
 protected:
  FolderTest() {
    fs::create_directories(top_ / "decks" / "parts");
    write(top_ / "secret.yaml", "secret");
    write(top_ / "decks" / "a.yaml", "a");
    write(top_ / "decks" / "parts" / "b.yml", "b");
    write(top_ / "decks" / "profile.csv", "x,z");
    write(top_ / "decks" / "state.json", "{}");
    write(top_ / "decks" / ".hidden.yaml", "h");
  }
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  Folder folder() const { return Folder(top_ / "decks"); }

  const taut_test::ScratchFolder scratch_;
  const fs::path top_ = scratch_.path();
};

template <class T>
Kind kind_of(const tl::expected<T, FolderError>& done) {
  return done ? Kind::failed : done.error().kind;
}

TEST_F(FolderTest, ListsDecksAndTables) {
  EXPECT_EQ(folder().list().names, (std::vector<std::string>{"a.yaml", "parts/b.yml", "profile.csv"}));
  EXPECT_TRUE(folder().list().whole);
}

TEST_F(FolderTest, ReadsWhatADeckMayNameAndOpensDecksAlone) {
  EXPECT_EQ(folder().open("a.yaml"), "a");
  EXPECT_EQ(folder().open("parts/../a.yaml"), "a");
  EXPECT_EQ(folder().open((top_ / "decks" / "a.yaml").string()), "a");
  EXPECT_EQ(folder().read("state.json"), "{}");
  EXPECT_EQ(kind_of(folder().open("state.json")), Kind::no_deck);
  EXPECT_EQ(kind_of(folder().open(".hidden.yaml")), Kind::no_deck);
  EXPECT_EQ(kind_of(folder().open("nowhere.yaml")), Kind::missing);
  EXPECT_EQ(kind_of(folder().open("nowhere/a.yaml")), Kind::missing);
  EXPECT_FALSE(folder().read("parts"));
}

TEST_F(FolderTest, NoNameLeadsOut) {
  fs::create_symlink(top_ / "secret.yaml", top_ / "decks" / "link.yaml");
  fs::create_symlink("../secret.yaml", top_ / "decks" / "near.yaml");
  fs::create_symlink(top_, top_ / "decks" / "up");
  fs::create_symlink(top_ / "new.yaml", top_ / "decks" / "dangling.yaml");
  fs::create_directory(top_ / "decks2");
  write(top_ / "decks2" / "a.yaml", "secret");
  const std::vector<std::string> names = {"../secret.yaml",   "parts/../../secret.yaml",
                                          "./../secret.yaml", "..",
                                          "/etc/passwd",      (top_ / "secret.yaml").string(),
                                          "link.yaml",        "near.yaml",
                                          "up/secret.yaml",   "up/decks2/a.yaml",
                                          "../decks2/a.yaml", "dangling.yaml"};
  for (const std::string& name : names) {
    EXPECT_EQ(kind_of(folder().read(name)), Kind::outside) << name;
    EXPECT_EQ(kind_of(folder().open(name)), Kind::outside) << name;
    EXPECT_EQ(kind_of(folder().save(name, "changed")), Kind::outside) << name;
  }
  for (const std::string& name : {std::string(), std::string("a.yaml\0.csv", 11)}) {
    EXPECT_FALSE(folder().read(name));
    EXPECT_FALSE(folder().save(name, "changed"));
  }
  EXPECT_EQ(text_of(top_ / "secret.yaml"), "secret");
  EXPECT_FALSE(fs::exists(top_ / "new.yaml"));
  EXPECT_EQ(folder().list().names, (std::vector<std::string>{"a.yaml", "parts/b.yml", "profile.csv"}));
}

TEST_F(FolderTest, LinksInTheFolderAreFollowed) {
  fs::create_symlink("parts/b.yml", top_ / "decks" / "inner.yaml");
  EXPECT_EQ(folder().open("inner.yaml"), "b");
  ASSERT_TRUE(folder().save("inner.yaml", "c"));
  EXPECT_TRUE(fs::is_symlink(top_ / "decks" / "inner.yaml"));
  EXPECT_EQ(text_of(top_ / "decks" / "parts" / "b.yml"), "c");
}

TEST_F(FolderTest, SavesWholeFilesAndKeepsTheirModes) {
  fs::permissions(top_ / "decks" / "a.yaml", fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(folder().save("a.yaml", "new"));
  EXPECT_EQ(text_of(top_ / "decks" / "a.yaml"), "new");
  EXPECT_EQ(fs::status(top_ / "decks" / "a.yaml").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(folder().save("parts/new.yaml", "n"));
  EXPECT_EQ(text_of(top_ / "decks" / "parts" / "new.yaml"), "n");
  EXPECT_EQ(kind_of(folder().save("nowhere/new.yaml", "n")), Kind::missing);
  for (const char* name : {"script.sh", ".bashrc", ".config/x.yaml", "parts", "state.json"}) {
    EXPECT_FALSE(folder().save(name, "n")) << name;
  }
  EXPECT_EQ(kind_of(folder().save("a.yaml", std::string((16U << 20U) + 1, ' '))), Kind::too_large);
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(top_ / "decks")) files += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(files, 6) << "something unfinished was left";
}

TEST_F(FolderTest, PipesAndFoldersAreNoDecks) {
  ASSERT_EQ(::mkfifo((top_ / "decks" / "pipe.yaml").c_str(), 0600), 0);
  fs::create_directory(top_ / "decks" / "folder.yaml");
  for (const char* name : {"pipe.yaml", "folder.yaml"}) {
    EXPECT_FALSE(folder().open(name)) << name;
    EXPECT_FALSE(folder().save(name, "n")) << name;
  }
}

TEST_F(FolderTest, MustBeThere) {
  EXPECT_THROW(Folder(top_ / "nowhere"), fs::filesystem_error);
  EXPECT_THROW(Folder(top_ / "secret.yaml"), fs::filesystem_error);
}

}  // namespace taut::web::folder_test
