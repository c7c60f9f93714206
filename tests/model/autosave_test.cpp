#include "editor/model/autosave.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "editor/model/edits_scene.h"
#include "engine/core/files.h"
#include "engine/project/project_file.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

using namespace std::chrono_literals;

// A document on disk, and the folder of autosaves.
class AutosaveOf : public testing::Test {
 protected:
  AutosaveOf() {
    test::write_model(home_.path() / "shoe.glb");
    folder_ = state_dir() / "autosave";
  }
  Document open() { return Document(open_scene(home_.path() / "shoe.glb").value(), home_.path() / "shoe.vampproj"); }
  static void change(Document& document, float ev) { document.edit(set_exposure(*document.project(), ev)); }

  // Documents that lie in the folder.
  size_t documents() const {
    size_t count = 0;
    std::error_code code;
    for (const auto& item : fs::directory_iterator(folder_, code)) count += item.path().extension() == ".json";
    return count;
  }
  // Waits until as many lie there; false after half a minute.
  bool wait_for(size_t count) const {
    for (int i = 0; i < 3000 && documents() != count; ++i) std::this_thread::sleep_for(10ms);
    return documents() == count;
  }

  test::TemporaryHome home_;
  fs::path folder_;
};

TEST_F(AutosaveOf, AnEditedDocumentIsWrittenWithoutBeingAsked) {
  Document document = open();
  Autosave autosave({{}, 1ms});
  autosave.update(document);
  EXPECT_EQ(documents(), 0u);
  change(document, 1);
  autosave.update(document);
  EXPECT_TRUE(wait_for(1));
}

TEST_F(AutosaveOf, ARunningSessionIsNotOffered) {
  Document document = open();
  Autosave autosave;
  change(document, 1);
  autosave.update(document);
  ASSERT_TRUE(autosave.flush());
  EXPECT_EQ(documents(), 1u);
  EXPECT_TRUE(find_leftovers().empty());
}

TEST_F(AutosaveOf, ASavedDocumentAndACleanEndLeaveNothing) {
  {
    Document document = open();
    Autosave autosave({{}, 1ms});
    change(document, 1);
    autosave.update(document);
    EXPECT_TRUE(wait_for(1));
    document.mark_saved(document.path());
    autosave.update(document);
    EXPECT_TRUE(wait_for(0));
    change(document, 2);
    autosave.update(document);
    ASSERT_TRUE(autosave.flush());
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(AutosaveOf, ADocumentIsRecoveredAsItWasAfterTheProcessWasKilled) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // What a session does until it is killed; nothing of the test program may run here afterwards.
    Document document = open();
    Autosave autosave({{}, 1ms});
    document.edit(set_mirror(*document.project(), 1, 0.25f));
    autosave.update(document);
    change(document, 1.25f);
    autosave.update(document);
    const bool written = autosave.flush().has_value();
    [[maybe_unused]] const ssize_t told = ::write(ready[1], written ? "y" : "n", 1);
    for (;;) ::pause();
  }
  ::close(ready[1]);  // a child that dies early ends the reading
  char answer = '?';
  ASSERT_EQ(::read(ready[0], &answer, 1), 1);
  EXPECT_EQ(answer, 'y');
  EXPECT_TRUE(find_leftovers().empty());
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);

  const auto leftovers = find_leftovers();
  ASSERT_EQ(leftovers.size(), 1u);
  EXPECT_EQ(leftovers[0].problem, "");
  EXPECT_EQ(leftovers[0].document, home_.path() / "shoe.vampproj");
  EXPECT_EQ(leftovers[0].model, "shoe.glb");
  EXPECT_GT(leftovers[0].saved_at, 0);
  const auto project = recover(leftovers[0]);
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->display.exposure, 1.25f);
  EXPECT_EQ(project->parts[1].mirror_f0, 0.25f);
  EXPECT_EQ(find_leftovers().size(), 1u);
  discard(leftovers[0]);
  EXPECT_TRUE(find_leftovers().empty());
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(AutosaveOf, AnAbandonedSessionIsOffered) {
  Document document = open();
  {
    Autosave autosave;
    change(document, 3);
    autosave.update(document);
    autosave.abandon();
  }
  const auto leftovers = find_leftovers();
  ASSERT_EQ(leftovers.size(), 1u);
  EXPECT_EQ(recover(leftovers[0]).value().display.exposure, 3);
}

TEST_F(AutosaveOf, DamagedLeftoversAreListedWithWhatIsWrong) {
  Document document = open();
  {
    Autosave autosave;
    change(document, 3);
    autosave.update(document);
    autosave.abandon();
  }
  const fs::path file = find_leftovers().at(0).file;
  const std::string whole = read_text(file, 1 << 20).value();
  ASSERT_TRUE(write_text_atomically(file, whole.substr(0, whole.size() / 2)));
  ASSERT_TRUE(write_text_atomically(folder_ / "x.json", "[1, 2"));
  ASSERT_TRUE(write_text_atomically(folder_ / "y.json", std::string("\0\xff\xfe", 3)));
  const auto leftovers = find_leftovers();
  EXPECT_EQ(leftovers.size(), 3u);
  for (const Leftover& leftover : leftovers) {
    EXPECT_NE(leftover.problem, "");
    EXPECT_FALSE(recover(leftover));
    discard(leftover);
  }
  EXPECT_TRUE(find_leftovers().empty());
}

TEST_F(AutosaveOf, AModelThatIsGoneIsAnErrorAndNothingIsLost) {
  Document document = open();
  {
    Autosave autosave;
    change(document, 3);
    autosave.update(document);
    autosave.abandon();
  }
  fs::remove(home_.path() / "shoe.glb");
  const auto leftovers = find_leftovers();
  ASSERT_EQ(leftovers.size(), 1u);
  EXPECT_FALSE(recover(leftovers[0]));
  EXPECT_EQ(find_leftovers().size(), 1u);
}

TEST_F(AutosaveOf, AFolderThatCannotBeWrittenIsToldOnceAndStopsNothing) {
  ASSERT_TRUE(write_text_atomically(home_.path() / "file", "no folder"));
  Document document = open();
  Autosave autosave({home_.path() / "file", 1ms});
  EXPECT_NE(autosave.take_problem(), "");
  EXPECT_EQ(autosave.take_problem(), "");
  change(document, 1);
  autosave.update(document);
  EXPECT_FALSE(autosave.flush() && autosave.take_problem().empty());
}

}  // namespace
}  // namespace vamp
