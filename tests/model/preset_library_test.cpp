#include "editor/model/preset_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/files.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

using test::small_preset;

class Library : public testing::Test {
 protected:
  Library() {
    fs::create_directories(shipped_);
    EXPECT_TRUE(save_preset(small_preset("Calf"), shipped_ / "calf.vamp"));
  }
  PresetLibrary open() { return PresetLibrary({shipped_, {}, {}}); }
  static std::vector<std::string> names(const PresetLibrary& library) {
    std::vector<std::string> list;
    for (const LibraryEntry& entry : library.entries()) list.push_back(entry.info.name);
    return list;
  }

  test::TemporaryHome home_;
  fs::path shipped_ = home_.path() / "shipped";
};

TEST_F(Library, ListsShippedAndOwnPresetsAndSaysWhichMayBeChanged) {
  PresetLibrary library = open();
  ASSERT_TRUE(library.save_new(small_preset("Twill")));
  EXPECT_EQ(names(library), (std::vector<std::string>{"Twill", "Calf"}));
  EXPECT_TRUE(library.entries()[0].writable);
  EXPECT_FALSE(library.entries()[1].writable);
  EXPECT_EQ(library.entries()[0].reference, "library:twill.vamp");
  EXPECT_EQ(library.entries()[0].info.tags, (std::vector<std::string>{"leather", "test"}));
}

TEST_F(Library, GivesEveryNewPresetAFileOfItsOwn) {
  PresetLibrary library = open();
  EXPECT_EQ(library.save_new(small_preset("Calf, cognac")).value().filename(), "calf-cognac.vamp");
  EXPECT_EQ(library.save_new(small_preset("Calf/cognac")).value().filename(), "calf-cognac-2.vamp");
  EXPECT_EQ(library.save_new(small_preset("../../etc")).value().parent_path(), library.own_folder());
  EXPECT_EQ(library.save_new(small_preset("")).value().filename(), "preset.vamp");
  EXPECT_LT(library.save_new(small_preset(std::string(250, 'x'))).value().filename().string().size(), 100u);
  EXPECT_EQ(library.entries().size(), 6u);
}

TEST_F(Library, FindsByNameAndTagWhateverTheCase) {
  PresetLibrary library = open();
  ASSERT_TRUE(library.save_new(small_preset("Wool twill")));
  EXPECT_EQ(library.search("").size(), 2u);
  EXPECT_EQ(library.search("LEATHER").size(), 2u);
  ASSERT_EQ(library.search("twill leather").size(), 1u);
  EXPECT_EQ(library.search("twill leather")[0]->info.name, "Wool twill");
  EXPECT_TRUE(library.search("suede").empty());
}

TEST_F(Library, NeverChangesWhatWasShipped) {
  PresetLibrary library = open();
  const std::string before = read_text(shipped_ / "calf.vamp", 1 << 20).value();
  EXPECT_FALSE(library.overwrite(shipped_ / "calf.vamp", small_preset("Mine")));
  EXPECT_FALSE(library.rename(shipped_ / "calf.vamp", "Mine"));
  EXPECT_FALSE(library.remove(shipped_ / "calf.vamp"));
  EXPECT_FALSE(library.overwrite(library.own_folder() / ".." / "x.vamp", small_preset("Mine")));
  EXPECT_EQ(read_text(shipped_ / "calf.vamp", 1 << 20).value(), before);
}

TEST_F(Library, DuplicatesAnyPresetAmongTheUsersOwn) {
  PresetLibrary library = open();
  const auto copy = library.duplicate(shipped_ / "calf.vamp");
  ASSERT_TRUE(copy) << copy.error().message();
  EXPECT_EQ(copy->parent_path(), library.own_folder());
  EXPECT_EQ(load_preset(*copy).value().name, "Calf copy");
  EXPECT_EQ(names(library), (std::vector<std::string>{"Calf copy", "Calf"}));
  EXPECT_FALSE(library.duplicate(shipped_ / "none.vamp"));
}

TEST_F(Library, RenamesWithoutMovingTheFile) {
  PresetLibrary library = open();
  const fs::path path = library.save_new(small_preset("Twill")).value();
  ASSERT_TRUE(library.rename(path, "Twill, navy"));
  EXPECT_EQ(load_preset(path).value().name, "Twill, navy");
  EXPECT_FALSE(library.rename(path, ""));
}

TEST_F(Library, DeletesToATrashFromWhichItComesBack) {
  PresetLibrary library = open();
  const fs::path path = library.save_new(small_preset("Twill")).value();
  const auto trashed = library.remove(path);
  ASSERT_TRUE(trashed) << trashed.error().message();
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(names(library), std::vector<std::string>{"Calf"});
  EXPECT_EQ(library.restore(*trashed).value(), path);
  EXPECT_EQ(library.entries().size(), 2u);
}

TEST_F(Library, ListsDamagedPresetsWithWhatIsWrong) {
  PresetLibrary library = open();
  const fs::path path = library.save_new(small_preset("Twill")).value();
  ASSERT_TRUE(write_text_atomically(path, "no zip"));
  ASSERT_TRUE(write_text_atomically(library.own_folder() / "notes.txt", "not a preset"));
  library.rescan();
  ASSERT_EQ(library.entries().size(), 2u);
  EXPECT_EQ(library.entries()[0].info.name, "twill");
  EXPECT_NE(library.entries()[0].problem, "");
  EXPECT_EQ(library.entries()[1].problem, "");
}

TEST_F(Library, WithoutFoldersIsEmpty) {
  fs::remove_all(shipped_);
  EXPECT_TRUE(open().entries().empty());
}

}  // namespace
}  // namespace vamp
