#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mechanism/load.hpp"
#include "mechanism/source.hpp"
#include "processor_time.hpp"

namespace alembert {
namespace {

/// A folder that is removed at the end of a test.
struct TemporaryFolder {
  std::filesystem::path path;
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "alembert_source_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
};

std::string error_of_reading(const std::string& path) {
  try {
    read_source(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ReadSource, GivesTheBytesOfAFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path / "a.yaml";
  const std::string text = "alembert: 1\r\n# \xC3\xA9\n";
  std::ofstream(path, std::ios::binary) << text;
  const auto source = read_source(path);
  EXPECT_EQ(source->text, text);
  EXPECT_EQ(source->name, path);
}

TEST(ReadSource, RefusesAMissingFile) {
  EXPECT_EQ(error_of_reading("/nonexistent/a.yaml"),
            "/nonexistent/a.yaml:1:1: error: cannot be read: No such file or directory");
}

TEST(ReadSource, RefusesADirectory) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of_reading(folder.path),
            folder.path.string() + ":1:1: error: is a directory; expected a mechanism description");
}

TEST(ReadSource, RefusesAnUnreadableFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "everything is readable to root";
  const TemporaryFolder folder;
  const std::string path = folder.path / "secret.yaml";
  std::ofstream(path) << "alembert: 1\n";
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_EQ(error_of_reading(path), path + ":1:1: error: cannot be read: Permission denied");
}

TEST(ReadSource, RefusesAnEmptyFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path / "empty.yaml";
  std::ofstream(path).flush();
  EXPECT_EQ(error_of_reading(path), path + ":1:1: error: is empty; expected a mechanism description");
}

TEST(ReadSource, RefusesAFileOf100MegabytesAtOnce) {
  const TemporaryFolder folder;
  const std::string path = folder.path / "large.yaml";
  std::ofstream(path).flush();
  std::filesystem::resize_file(path, 100'000'000);
  const test::ProcessorTime time;
  EXPECT_EQ(error_of_reading(path),
            path + ":1:1: error: has 100000000 bytes; the limit for a mechanism description is 16 MiB");
  EXPECT_LT(time.seconds(), 1);
}

TEST(ReadSource, StopsReadingAnEndlessDevice) {
  EXPECT_EQ(error_of_reading("/dev/zero"),
            "/dev/zero:1:1: error: is larger than 16 MiB, the limit for a mechanism description");
}

}  // namespace
}  // namespace alembert
