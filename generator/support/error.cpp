// Errors with places, as text. In: a location, a message and candidates. Out: the diagnostic that the user
// sees.
#include "support/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <utility>

namespace alembert {
namespace {

constexpr std::size_t kShownWidth =
    120;  // of a source line; longer lines are shown as a window around the column

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}
bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}  // of a UTF-8 sequence

std::string_view line_of(std::string_view text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return {};
    begin = end + 1;
  }
  std::string_view found = text.substr(begin, text.find('\n', begin) - begin);
  if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
  return found;
}

// The source line and, under it, a caret; tabs are kept in both so that they line up.
std::string excerpt(std::string_view line, int column) {
  std::size_t at = std::min(line.size(), static_cast<std::size_t>(std::max(column, 1) - 1));
  std::string shown, pointer;
  std::size_t begin = at > kShownWidth * 2 / 3 ? at - kShownWidth * 2 / 3 : 0;
  while (begin > 0 && is_continuation(line[begin])) --begin;
  std::size_t end = std::min(line.size(), begin + kShownWidth);
  while (end < line.size() && is_continuation(line[end])) ++end;
  if (begin > 0) shown = "...", pointer = "   ";
  for (std::size_t i = begin; i < end; ++i) {
    const char c = line[i];
    shown += is_control(c) && c != '\t' ? '?' : c;
    if (i < at && !is_continuation(c)) pointer += c == '\t' ? '\t' : ' ';
  }
  if (end < line.size()) shown += "...";
  return "  " + shown + "\n  " + pointer + "^";
}

std::string diagnostic(const SourceLocation& where, std::string_view severity, const std::string& message,
                       const std::string& note) {
  std::string out;
  if (where.source) {
    for (const char c : where.source->name) out += is_control(c) ? '?' : c;
  } else {
    out = "<unknown>";
  }
  out += ':' + std::to_string(where.line) + ':' + std::to_string(where.column) + ": ";
  out += severity;
  out += ": " + message;
  if (where.source && !where.source->text.empty()) {
    out += '\n' + excerpt(line_of(where.source->text, where.line), where.column);
  }
  if (!note.empty()) out += "\nnote: " + note;
  return out;
}

// Edit distance with exchanges of neighbours (optimal string alignment).
std::size_t edit_distance(std::string_view x, std::string_view y) {
  std::vector<std::size_t> before(y.size() + 1), last(y.size() + 1), row(y.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= x.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= y.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x[i - 1] == y[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[y.size()];
}

/// `3 more like this one, in lines 8, 12`.
std::string more_in_lines(std::vector<int> lines) {
  constexpr std::size_t kListed = 8;
  const std::size_t count = lines.size();
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const std::size_t listed = std::min(lines.size(), kListed);
  return fmt::format("{} more like this one, in line{} {}{}", count, lines.size() == 1 ? "" : "s",
                     fmt::join(std::span(lines).first(listed), ", "), lines.size() > listed ? ", ..." : "");
}

}  // namespace

InputError::InputError(SourceLocation where, std::string message, std::string note)
    : std::runtime_error(diagnostic(where, "error", message, note)),
      where_(std::move(where)),
      message_(std::move(message)),
      note_(std::move(note)) {}

std::string warning_text(const SourceLocation& where, const std::string& message, const std::string& note) {
  return diagnostic(where, "warning", message, note);
}

Warnings one_of_each_kind(Warnings warnings) {
  std::ranges::stable_sort(warnings, {},
                           [](const Warning& w) { return std::pair(w.where.line, w.where.column); });
  Warnings firsts;
  std::vector<std::vector<int>> lines;          // of the others
  std::map<std::string, std::size_t> place_of;  // of a kind
  constexpr std::size_t kShown = 100;
  std::size_t not_shown = 0;
  for (Warning& warning : warnings) {
    const std::size_t next = firsts.size();
    const std::size_t place =
        warning.kind.empty() ? next : place_of.try_emplace(warning.kind, next).first->second;
    if (place < next) {
      lines[place].push_back(warning.where.line);
      continue;
    }
    if (next == kShown) {
      ++not_shown;
      continue;
    }
    firsts.push_back(std::move(warning));
    lines.emplace_back();
  }
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    if (lines[i].empty()) continue;
    std::string& note = firsts[i].note;
    note += (note.empty() ? "" : "\nnote: ") + more_in_lines(lines[i]);
  }
  if (not_shown > 0) {
    std::string& note = firsts.back().note;
    note += fmt::format("{}{} more are not shown", note.empty() ? "" : "\nnote: ", not_shown);
  }
  return firsts;
}

void tell(std::string_view text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stderr);
  static_cast<void>(written);
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  constexpr std::size_t kLongest =
      200;  // no name of that length is a slip, and the distance costs its square
  if (name.empty() || name.size() > kLongest) return {};
  std::string best;
  std::size_t best_distance = name.size() < 3 ? 1 : std::max<std::size_t>(1, name.size() / 3);
  ++best_distance;
  for (const std::string& candidate : candidates) {
    const std::size_t difference =
        candidate.size() > name.size() ? candidate.size() - name.size() : name.size() - candidate.size();
    if (candidate.empty() || difference >= best_distance) continue;
    const std::size_t distance = edit_distance(name, candidate);
    // Nothing is a likely slip if every character was changed.
    if (distance < best_distance && distance < std::max(name.size(), candidate.size())) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? std::string() : " (did you mean '" + printable(nearest) + "'?)";
}

std::string printable(std::string_view text, std::size_t limit) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (out.size() >= limit && !is_continuation(c)) return out + "...";
    if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c == '\r') {
      out += "\\r";
    } else if (c == '\'' || c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (is_control(c)) {
      out += "\\x";
      out += kHex[static_cast<unsigned char>(c) >> 4];
      out += kHex[static_cast<unsigned char>(c) & 15];
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace alembert
