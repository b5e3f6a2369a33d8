// Written beside its place and moved there (see the header).
#include "emit/files/waiting_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "support/error.hpp"

namespace alembert {

namespace fs = std::filesystem;

bool is_replaceable(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  return type == fs::file_type::not_found || type == fs::file_type::regular;
}

void check_distinct(std::span<const NamedFile> written, std::span<const NamedFile> read) {
  const auto place = [](const NamedFile& file) {
    std::error_code error;
    return fs::weakly_canonical(file.path, error);
  };
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (!is_replaceable(written[i].path)) continue;
    const auto refuse = [&](const NamedFile& other) {
      if (place(other) != place(written[i])) return;
      fail_at_path(written[i].path, other.name + " and " + written[i].name + " are the same file");
    };
    for (const NamedFile& other : written.first(i)) refuse(other);
    for (const NamedFile& other : read) refuse(other);
  }
}

fs::path waiting_path(const fs::path& path) {
  return path.string() + ".alembert-new";
}

int create_file(const fs::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  std::size_t done = 0;
  int error = 0;
  while (done < text.size() && error == 0) {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n > 0) done += static_cast<std::size_t>(n);
    if (n < 0 && errno != EINTR) error = errno;
  }
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

void fail_at_path(const std::string& path, const std::string& message) {
  throw InputError({std::make_shared<const SourceText>(SourceText{path, ""}), 1, 1}, message);
}

void fail_to_write_file(const std::string& path, int error) {
  fail_at_path(path, "cannot write it: " + reason_of(error));
}

WaitingFile::WaitingFile(std::string path) : path_(std::move(path)) {
  if (is_replaceable(path_)) waiting_ = waiting_path(path_).string();
  open();
}

WaitingFile::~WaitingFile() {
  if (stream_ && !waiting_.empty()) ::unlink(waiting_.c_str());
}

void WaitingFile::open() {
  const std::string& name = waiting_.empty() ? path_ : waiting_;
  for (;;) {
    const int begin = waiting_.empty() ? O_TRUNC : 0;
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | begin, 0666);
    if (descriptor < 0) fail_to_write_file(path_, errno);
    stream_.reset(::fdopen(descriptor, "wb"));
    if (waiting_.empty()) return;
    while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
    }
    // Whoever wrote it meanwhile has moved it away.
    struct stat mine {
    }, now{};
    if (::fstat(descriptor, &mine) == 0 && ::stat(name.c_str(), &now) == 0 && mine.st_ino == now.st_ino) {
      if (::ftruncate(descriptor, 0) != 0) fail_to_write_file(path_, errno);
      return;
    }
  }
}

void WaitingFile::put(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size())
    fail_to_write_file(path_, errno);
}

void WaitingFile::publish() {
  if (std::fflush(stream_.get()) != 0) fail_to_write_file(path_, errno);
  if (!waiting_.empty() && std::rename(waiting_.c_str(), path_.c_str()) != 0)
    fail_to_write_file(path_, errno);
  stream_.reset();
}

}  // namespace alembert
