// Stage `load`, first step: a path in, its text out, or an error at 1:1.
#include "mechanism/source.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "mechanism/load.hpp"

namespace alembert {
namespace {

constexpr std::size_t kMaximumBytes = std::size_t{16} << 20;

/// Closes a descriptor that this file opened; standard input stays open.
struct OpenFile {
  int descriptor;
  bool owned;
  OpenFile(int d, bool o) : descriptor(d), owned(o) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (owned && descriptor >= 0) ::close(descriptor);
  }
};

}  // namespace

std::shared_ptr<const SourceText> read_source(const std::string& path) {
  auto source = std::make_shared<SourceText>();
  source->name = path == "-" ? "<stdin>" : path;
  const auto fail = [&](const std::string& message) { return InputError({source, 1, 1}, message); };

  const OpenFile file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC), path != "-");
  if (file.descriptor < 0) throw fail(fmt::format("cannot be read: {}", std::strerror(errno)));
  struct stat status {};
  if (::fstat(file.descriptor, &status) == 0) {
    if (S_ISDIR(status.st_mode)) throw fail("is a directory; expected a mechanism description");
    if (S_ISREG(status.st_mode) && status.st_size > static_cast<off_t>(kMaximumBytes))
      throw fail(
          fmt::format("has {} bytes; the limit for a mechanism description is 16 MiB", status.st_size));
  }
  // The size of a pipe or device is not known beforehand: stop one block past the limit.
  std::string& text = source->text;
  char block[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.descriptor, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      text.clear();
      throw fail(fmt::format("cannot be read: {}", std::strerror(errno)));
    }
    if (count == 0) break;
    text.append(block, static_cast<std::size_t>(count));
    if (text.size() > kMaximumBytes) {
      text.clear();
      throw fail("is larger than 16 MiB, the limit for a mechanism description");
    }
  }
  if (text.empty()) throw fail("is empty; expected a mechanism description");
  return source;
}

}  // namespace alembert
