// The writer: only what changed, all or nothing.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "emit/files/waiting_file.hpp"
#include "emit/written_tree.hpp"

namespace alembert {
namespace {

using testing::HasSubstr;

using WriteFiles = WrittenTree;

const std::vector<EmittedFile> kFiles{
    {"include/a/a.hpp", "first\n"}, {"src/a.cpp", "second\n"}, {"src/b.cpp", "third\n"}};

TEST_F(WriteFiles, CreatesFoldersAndFiles) {
  const auto result = write_files(kFiles, folder("x/y"));
  ASSERT_EQ(result.size(), 3u);
  EXPECT_EQ(result[0].state, FileState::created);
  const std::map<std::string, std::string> expected{{"x", "(folder)"},
                                                    {"x/y", "(folder)"},
                                                    {"x/y/include", "(folder)"},
                                                    {"x/y/include/a", "(folder)"},
                                                    {"x/y/src", "(folder)"},
                                                    {"x/y/src/a.cpp", "second\n"},
                                                    {"x/y/src/b.cpp", "third\n"},
                                                    {"x/y/include/a/a.hpp", "first\n"}};
  EXPECT_EQ(contents(), expected);
}

TEST_F(WriteFiles, TouchesOnlyWhatChanges) {
  write_files(kFiles, folder("x"));
  const timespec old[2] = {{1000, 0}, {1000, 0}};
  for (const EmittedFile& file : kFiles)
    ASSERT_EQ(::utimensat(AT_FDCWD, (folder("x/") + file.path).c_str(), old, 0), 0);
  std::vector<EmittedFile> files = kFiles;
  files[1].text = "other\n";
  const auto result = write_files(files, folder("x"));
  EXPECT_EQ(result[0].state, FileState::unchanged);
  EXPECT_EQ(result[1].state, FileState::changed);
  EXPECT_FALSE(up_to_date(result));
  const auto seconds = [&](const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat((folder("x/") + path).c_str(), &status), 0);
    return status.st_mtime;
  };
  EXPECT_EQ(seconds("include/a/a.hpp"), 1000);
  EXPECT_NE(seconds("src/a.cpp"), 1000);
  EXPECT_EQ(seconds("src/b.cpp"), 1000);
  EXPECT_EQ(contents().at("x/src/a.cpp"), "other\n");
  EXPECT_TRUE(up_to_date(write_files(files, folder("x"))));
}

TEST_F(WriteFiles, DryRunSaysAndDoesNothing) {
  EXPECT_FALSE(up_to_date(write_files(kFiles, folder("x"), WriteMode::dry_run)));
  EXPECT_TRUE(contents().empty());
  write_files(kFiles, folder("x"));
  EXPECT_TRUE(up_to_date(write_files(kFiles, folder("x"), WriteMode::dry_run)));
}

TEST_F(WriteFiles, AFailureChangesNothing) {
  write_files(kFiles, folder("x"));
  fs::create_directory(root_ / "x/src/c.cpp");  // in the way of a file
  const auto before = contents();
  std::vector<EmittedFile> files = kFiles;
  files[0].text = "new\n";
  files.insert(files.begin(), {"fresh/d.cpp", "new\n"});
  files.push_back({"src/c.cpp", "new\n"});
  EXPECT_THAT(error_of(files, folder("x")), HasSubstr(folder("x") + ":1:1: error: "));
  EXPECT_EQ(contents(), before);
}

TEST_F(WriteFiles, AFileWhereAFolderShouldBe) {
  std::ofstream(root_ / "file") << "text";
  EXPECT_THAT(error_of(kFiles, folder("file")), HasSubstr(folder("file") + ":1:1: error: "));
  EXPECT_THAT(error_of(kFiles, folder("file/below")), HasSubstr(":1:1: error: "));
  EXPECT_EQ(contents().size(), 1u);
}

TEST_F(WriteFiles, ReadOnlyFolder) {
  if (::geteuid() == 0) {
    // The superuser may write anywhere but where nobody may.
    EXPECT_THAT(error_of(kFiles, "/proc/alembert"), HasSubstr("/proc/alembert:1:1: error: "));
    return;
  }
  write_files(kFiles, folder("x"));
  const auto before = contents();
  fs::permissions(root_ / "x/src", fs::perms::owner_read | fs::perms::owner_exec);
  std::vector<EmittedFile> files = kFiles;
  for (EmittedFile& file : files) file.text += "more\n";
  EXPECT_THAT(error_of(files, folder("x")), HasSubstr("Permission denied"));
  EXPECT_EQ(contents(), before);
}

TEST_F(WriteFiles, FullDisk) {
  // A limit on the size of files makes write() fail midway, as a full disk does.
  write_files(kFiles, folder("x"));
  const auto before = contents();
  std::vector<EmittedFile> files = kFiles;
  files[0].text = "small\n";
  files.push_back({"new/c.cpp", "small\n"});
  files.push_back({"new/d.cpp", std::string(1 << 20, 'x')});
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1 << 16, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = error_of(files, folder("x"));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(error, HasSubstr(folder("x") + ":1:1: error: cannot write"));
  EXPECT_THAT(error, HasSubstr("File too large"));
  EXPECT_EQ(contents(), before);
}

TEST_F(WriteFiles, PartsThatAreLeftOverGo) {
  const std::vector<EmittedFile> three{{"src/a_part1.cpp", "// banner\n1"},
                                       {"src/a_part2.cpp", "// banner\n2"},
                                       {"src/a_part3.cpp", "// banner\n3"}};
  const std::vector<EmittedFile> one{{"src/a_part1.cpp", "// banner\nall"}};
  write_files(three, folder("x"));
  std::ofstream(root_ / "x/src/a_part4.cpp") << "// the user's own\n";
  const auto dry = write_files(one, folder("x"), WriteMode::dry_run);
  EXPECT_EQ(dry.size(), 3u);
  EXPECT_FALSE(up_to_date(dry));
  write_files(one, folder("x"));
  const std::map<std::string, std::string> expected{{"x", "(folder)"},
                                                    {"x/src", "(folder)"},
                                                    {"x/src/a_part1.cpp", "// banner\nall"},
                                                    {"x/src/a_part4.cpp", "// the user's own\n"}};
  EXPECT_EQ(contents(), expected);
}

TEST_F(WriteFiles, FilesOfTheRunAreWrittenWithTheOthersOrNotAtAll) {
  const std::vector<RunFile> run{{folder("x.d"), "x: y\n"}, {folder("x.stamp"), ""}};
  write_files(kFiles, folder("x"), WriteMode::write, run);
  EXPECT_EQ(contents().at("x.d"), "x: y\n");
  const timespec old[2] = {{1000, 0}, {1000, 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, run[1].path.c_str(), old, 0), 0);
  write_files(kFiles, folder("x"), WriteMode::write, run);
  struct stat status {};
  ASSERT_EQ(::stat(run[1].path.c_str(), &status), 0);
  EXPECT_NE(status.st_mtime, 1000);

  const auto before = contents();
  std::vector<EmittedFile> files = kFiles;
  files[1].text = "other\n";
  for (const std::string& bad : {folder("none/x.stamp"), folder("x"), std::string("/dev/full")}) {
    const std::vector<RunFile> failing{{folder("x.d"), "new\n"}, {bad, "new\n"}};
    try {
      write_files(files, folder("x"), WriteMode::write, failing);
      ADD_FAILURE() << "no error for " << bad;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(bad + ":1:1: error: cannot write it: "));
    }
    EXPECT_EQ(contents(), before) << bad;
    try {
      write_files(files, folder("fresh"), WriteMode::write, failing);
      ADD_FAILURE() << "no error for " << bad;
    } catch (const InputError&) {
    }
    EXPECT_EQ(contents(), before) << bad;
  }
}

TEST_F(WriteFiles, LinksAreFollowedForFilesOfTheRun) {
  std::ofstream(root_ / "real") << "before";
  fs::create_symlink(root_ / "real", root_ / "link");
  write_files(kFiles, folder("x"), WriteMode::write, std::vector<RunFile>{{folder("link"), "after"}});
  EXPECT_TRUE(fs::is_symlink(root_ / "link"));
  EXPECT_EQ(contents().at("real"), "after");
}

TEST_F(WriteFiles, AWaitingFileIsWholeOrNotThere) {
  std::ofstream(root_ / "table") << "before";
  {
    WaitingFile file(folder("table"));
    file.put("half");
    EXPECT_EQ(contents().at("table"), "before");
  }
  EXPECT_EQ(contents(), (std::map<std::string, std::string>{{"table", "before"}}));
  std::ofstream(root_ / "table.alembert-new") << "of a run that was killed";
  WaitingFile file(folder("table"));
  file.put("all");
  file.publish();
  EXPECT_EQ(contents(), (std::map<std::string, std::string>{{"table", "all"}}));
}

TEST_F(WriteFiles, SingleFile) {
  write_file(folder("stamp"), "");
  write_file(folder("stamp"), "text");
  EXPECT_EQ(contents().at("stamp"), "text");
  try {
    write_file(folder("none/stamp"), "");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(folder("none/stamp") + ":1:1: error: "));
  }
}

TEST(Depfile, PathsAreEscapedForMake) {
  const std::vector<std::string> dependencies{"/my files/arm.yaml", "/a#b", "/c$d", "/plain"};
  EXPECT_EQ(depfile_text("/out dir/arm.stamp", dependencies),
            "/out\\ dir/arm.stamp: \\\n  /my\\ files/arm.yaml \\\n  /a\\#b \\\n  /c$$d \\\n  /plain\n");
  // A blank after backslashes needs twice as many and its own; elsewhere they stand for themselves.
  const std::vector<std::string> backslashes{"/a\\b", "/a\\ b", "/a\\\\\tb", "/end\\"};
  EXPECT_EQ(depfile_text("t", backslashes),
            "t: \\\n  /a\\b \\\n  /a\\\\\\ b \\\n  /a\\\\\\\\\\\tb \\\n  /end\\\\\n");
  EXPECT_EQ(depfile_text("t", {}), "t:\n");
  EXPECT_THROW(depfile_text("a\nb", {}), InputError);
}

}  // namespace
}  // namespace alembert
