// A folder of its own for tests of writing, and what is in it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <string>

#include "emit/files/write_files.hpp"
#include "support/error.hpp"

namespace alembert {

namespace fs = std::filesystem;

class WrittenTree : public testing::Test {
 protected:
  WrittenTree() {
    std::string pattern = (fs::temp_directory_path() / "alembert_write_XXXXXX").string();
    root_ = ::mkdtemp(pattern.data());
  }
  ~WrittenTree() override {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(root_, error))
      if (entry.is_directory()) fs::permissions(entry.path(), fs::perms::owner_all, error);
    fs::permissions(root_, fs::perms::owner_all, error);
    fs::remove_all(root_, error);
  }

  /// Every file below the root with its text.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(root_)) {
      const std::string name = fs::relative(entry.path(), root_).string();
      std::ifstream stream(entry.path(), std::ios::binary);
      out[name] = entry.is_directory() ? "(folder)" : std::string(std::istreambuf_iterator<char>(stream), {});
    }
    return out;
  }
  std::string folder(const std::string& name) const { return (root_ / name).string(); }

  std::string error_of(std::span<const EmittedFile> files, const std::string& directory) {
    try {
      write_files(files, directory);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path root_;
};

}  // namespace alembert
