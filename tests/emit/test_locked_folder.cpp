// Runs that are killed at every one of their system calls, moves that fail, and runs at the same time: after
// the next run the folder is as one of them left it, with nothing besides.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <functional>
#include <optional>
#include <vector>

#include "emit/files/locked_folder.hpp"
#include "emit/written_tree.hpp"

namespace {
int moves_left = -1;  // moves that succeed before one fails; negative: all succeed
}  // namespace

// Stands before the C library's, so that the test can let a move fail.
extern "C" int rename(const char* from, const char* to) noexcept {
  if (moves_left == 0) {
    moves_left = -1;
    errno = EIO;
    return -1;
  }
  if (moves_left > 0) --moves_left;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace alembert {
namespace {

using Contents = std::map<std::string, std::string>;

const std::vector<EmittedFile> kOld{{"include/a/a.hpp", "// a\nold\n"},
                                    {"src/a_part1.cpp", "// a\nold 1\n"},
                                    {"src/a_part2.cpp", "// a\nold 2\n"},
                                    {"src/same.cpp", "// a\nsame\n"}};
const std::vector<EmittedFile> kNew{{"include/a/a.hpp", "// a\nnew\n"},
                                    {"include/b/b.hpp", "// a\nnew b\n"},
                                    {"src/a_part1.cpp", "// a\nnew 1\n"},
                                    {"src/same.cpp", "// a\nsame\n"}};
const std::vector<EmittedFile> kOther{{"other.hpp", "// other\n"}};

/// Runs `work` in a process of its own and kills it when it has entered or left `stops` system calls. \return
/// whether it was killed before its end; nothing if no process can be watched here.
std::optional<bool> killed_after(int stops, const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(2);
    ::raise(SIGSTOP);
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSTOPPED(status)) return std::nullopt;
  for (int i = 0; i < stops; ++i) {
    ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status)) return false;
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  return true;
}

class LockedFolders : public WrittenTree {
 protected:
  void reset() {
    fs::remove_all(root_ / "x");
    write(kOld, "old");
  }
  void write(const std::vector<EmittedFile>& files, const std::string& stamp) {
    const std::vector<RunFile> run{{folder("stamp"), stamp}};
    write_files(files, folder("x"), WriteMode::write, run);
  }
  Contents after(const std::vector<EmittedFile>& files, const std::string& stamp) {
    reset();
    write(files, stamp);
    write_files(kOther, folder("x"));
    return contents();
  }
};

TEST_F(LockedFolders, AKilledRunIsCompletedOrTakenBackByTheNext) {
  const Contents all_old = after(kOld, "old"), all_new = after(kNew, "new");
  ASSERT_NE(all_old, all_new);
  int olds = 0, news = 0, mixed = 0;
  for (int stops = 1;; ++stops) {
    reset();
    const std::optional<bool> killed = killed_after(stops, [&] { write(kNew, "new"); });
    if (!killed) GTEST_SKIP() << "no process can be watched here";
    if (!*killed) break;
    // What is of two runs is known as such.
    const bool first = contents().at("x/include/a/a.hpp") == kNew[0].text;
    const bool last = contents().at("stamp") == "new";
    if (first != last) {
      ++mixed;
      EXPECT_FALSE(up_to_date(write_files(kNew, folder("x"), WriteMode::dry_run))) << stops;
      EXPECT_FALSE(up_to_date(write_files(kOld, folder("x"), WriteMode::dry_run))) << stops;
    }
    write_files(kOther, folder("x"));
    const Contents now = contents();
    ASSERT_TRUE(now == all_old || now == all_new) << stops;
    ++(now == all_old ? olds : news);
  }
  EXPECT_GT(olds, 10);
  EXPECT_GT(news, 10);
  EXPECT_GT(mixed, 2);
}

TEST_F(LockedFolders, ClearingUpMayBeKilledToo) {
  const Contents all_old = after(kOld, "old"), all_new = after(kNew, "new");
  bool more = true;
  for (int first = 1; more; first += 19) {
    for (int second = 1;; second += 5) {
      reset();
      const std::optional<bool> killed = killed_after(first, [&] { write(kNew, "new"); });
      if (!killed) GTEST_SKIP() << "no process can be watched here";
      more = *killed;
      const std::optional<bool> again = killed_after(second, [&] { write_files(kOther, folder("x")); });
      write_files(kOther, folder("x"));
      const Contents now = contents();
      ASSERT_TRUE(now == all_old || now == all_new) << first << ' ' << second;
      if (!*again || !more) break;
    }
  }
}

TEST_F(LockedFolders, AMoveThatFailsTakesAllBack) {
  reset();
  const Contents before = contents();
  int failures = 0;
  for (int moves = 0; moves < 10; ++moves) {
    moves_left = moves;
    std::string error = "none";
    try {
      write(kNew, "new");
    } catch (const InputError& failure) {
      error = failure.what();
    }
    moves_left = -1;
    if (error == "none") break;
    ++failures;
    EXPECT_THAT(error, testing::HasSubstr("Input/output error"));
    EXPECT_EQ(contents(), before) << moves;
  }
  EXPECT_EQ(failures, 5);  // the journal, a.hpp, b.hpp, a_part1.cpp and the stamp
}

/// Runs each of `works` in a process of its own, at the same time.
void in_parallel(const std::vector<std::function<void()>>& works, const std::function<void()>& meanwhile) {
  std::vector<pid_t> children;
  for (const auto& work : works) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(0);
    }
    children.push_back(child);
  }
  meanwhile();
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
}

TEST_F(LockedFolders, RunsAtTheSameTimeDoNotMix) {
  std::vector<EmittedFile> other = kOld;
  for (EmittedFile& file : other) file.text += "other\n";
  reset();
  const Contents all_old = contents();
  write(other, "other");
  const Contents all_other = contents();
  const auto again_and_again = [&](const std::vector<EmittedFile>& files, const std::string& stamp) {
    return [&files, stamp, this] {
      for (int i = 0; i < 60; ++i) write(files, stamp);
    };
  };
  in_parallel({again_and_again(kOld, "old"), again_and_again(other, "other"), again_and_again(kOld, "old"),
               again_and_again(other, "other")},
              [&] {
                for (int i = 0; i < 100; ++i) {
                  const LockedFolder reader(folder("x"), LockedFolder::Access::read);
                  const Contents now = contents();
                  EXPECT_TRUE(now == all_old || now == all_other);
                }
              });
  const Contents now = contents();
  EXPECT_TRUE(now == all_old || now == all_other);
}

TEST_F(LockedFolders, AFolderThatAFailingRunTakesAwayIsMadeAgain) {
  const auto fail = [this] {
    const std::vector<RunFile> run{{folder("none/stamp"), ""}};
    for (int i = 0; i < 20; ++i)
      EXPECT_THROW(write_files(kOld, folder("x"), WriteMode::write, run), InputError);
  };
  for (int round = 0; round < 20; ++round) {
    fs::remove_all(root_ / "x");
    in_parallel({fail, fail, [this] { write(kOld, "old"); }}, [] {});
    const Contents now = contents();
    reset();
    ASSERT_EQ(now, contents());
  }
}

}  // namespace
}  // namespace alembert
