// Errors with places. In: a source text and a position in it. Out: exceptions whose message is
// `file:line:column: error: ...`, the line, a caret, what was expected and the nearest known name.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace alembert {

/// A text that was read, kept alive by every location that points into it.
struct SourceText {
  std::string name;  ///< as shown in messages: the path given on the command line, or `<stdin>`
  std::string text;
};

/// A place in a source text. Lines and columns count from 1; columns count bytes.
struct SourceLocation {
  std::shared_ptr<const SourceText> source;
  int line = 1;
  int column = 1;
};

/// Something is wrong with what the user gave (exit code 1). `what()` is the whole diagnostic:
/// `FILE:LINE:COL: error: MESSAGE`, then the source line and a caret when the text is known, then the note.
class InputError : public std::runtime_error {
 public:
  InputError(SourceLocation where, std::string message, std::string note = {});
  const SourceLocation& where() const { return where_; }
  const std::string& message() const { return message_; }
  const std::string& note() const { return note_; }

 private:
  SourceLocation where_;
  std::string message_, note_;
};

/// What is doubtful but no reason to stop: it does not change the equations, or is used as it stands.
struct Warning {
  SourceLocation where;
  std::string message;
  std::string note = {};
  std::string kind = {};  ///< the same for warnings that differ in their places only; empty: its own kind
};
using Warnings = std::vector<Warning>;

/// A diagnostic as that of InputError: `FILE:LINE:COL: warning: MESSAGE` and so on.
std::string warning_text(const SourceLocation& where, const std::string& message,
                         const std::string& note = {});

/// By place, the first of each kind, with a note of the lines of the others.
Warnings one_of_each_kind(Warnings warnings);

/// Writes a text to standard error. If that cannot be written, nothing happens: the exit code tells the
/// result.
void tell(std::string_view text);

/// An invariant of the generator is broken (exit code 2): a defect to be reported, never the user's fault.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The candidate closest to `name` by edit distance, or empty if none is near enough to be a likely slip.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// ` (did you mean 'X'?)` or nothing; appended to messages about unknown names.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

/// `text` with control characters and quotes escaped and its length bounded, safe to show in a one-line
/// message.
std::string printable(std::string_view text, std::size_t limit = 60);

}  // namespace alembert
