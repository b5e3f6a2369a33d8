// References in expressions: speeds of coordinates, quantities of frames, lengths of paths.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/expression_reader.hpp"
#include "mechanism/section.hpp"

namespace alembert {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A quantity of a frame as it is called and what its parts are called.
struct FrameWord {
  FrameQuantity quantity;
  std::string_view word;
  std::vector<std::string_view> parts;
  bool of_speeds;
};

const std::array<FrameWord, 4>& frame_words() {
  static const std::vector<std::string_view> vector = {"x", "y", "z"};
  static const std::array<FrameWord, 4> words = {
      FrameWord{FrameQuantity::position, "position", vector, false},
      {FrameQuantity::velocity, "velocity", vector, true},
      {FrameQuantity::rotation, "rotation", {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"}, false},
      {FrameQuantity::angular_velocity, "angular_velocity", vector, true}};
  return words;
}

const FrameWord& word_of(FrameQuantity quantity) {
  return *std::ranges::find(frame_words(), quantity, &FrameWord::quantity);
}

}  // namespace

Quantity ExpressionReader::reference(const Reading& reading, const PostfixToken& token) {
  const std::string_view text = reading.node.text;
  const std::string_view word = text.substr(token.begin, token.end - token.begin);
  const bool two = word == "distance";
  if (two != (token.second != 0))
    throw error(reading, two ? token.referent : token.second,
                two ? "distance() takes two frames" : fmt::format("{}() takes one name", word));
  if (word == "d") return speed(reading, token);
  const auto* of_frames = std::ranges::find(frame_words(), word, &FrameWord::word);
  if (of_frames != frame_words().end()) return of_frame(reading, token, of_frames->quantity);
  check_reference(reading, token, word == "rate" || word == "tension");
  if (token.part != 0) throw error(reading, token.part, fmt::format("{}() has no parts", word));
  if (!two) return of_path(reading, token, word);
  const int from = frame_called(reading, token.referent, token.referent_end);
  const int to = frame_called(reading, token.second, token.second_end);
  return {distance(from, to), kUnknown, Dependence::coordinate, nullptr};
}

void ExpressionReader::check_reference(const Reading& reading, const PostfixToken& token, bool speeds) const {
  const std::string_view word =
      std::string_view(reading.node.text).substr(token.begin, token.end - token.begin);
  if (reading.allowed == Allowed::force || (reading.allowed == Allowed::potential && !speeds)) return;
  if (reading.allowed == Allowed::holonomic && word == "position") return;
  if (reading.allowed == Allowed::potential)
    throw error(reading, token.begin,
                fmt::format("{} may not depend on speeds, as {}() does", reading.what, word));
  if (word == "position")
    throw error(
        reading, token.begin, fmt::format("{} may not depend on the position of a frame", reading.what),
        "positions stand in equations of holonomic constraints, forces, outputs and rates of states only");
  throw error(reading, token.begin, fmt::format("{} may not depend on {}()", reading.what, word),
              fmt::format("{}() stands in forces, outputs and rates of states only", word));
}

void ExpressionReader::declare_last_frame() {
  frames_.emplace(mechanism_.frames.back().name, static_cast<int>(mechanism_.frames.size()) - 1);
}

int ExpressionReader::frame_called(const Reading& reading, std::size_t begin, std::size_t end) const {
  const std::string_view name = std::string_view(reading.node.text).substr(begin, end - begin);
  const auto found = frames_.find(name);
  if (found != frames_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, frame] : frames_) names.push_back(known);
  const bool body = std::ranges::find(mechanism_.bodies, name, &Body::name) != mechanism_.bodies.end();
  throw error(reading, begin, fmt::format("unknown frame '{}'{}", printable(name), did_you_mean(name, names)),
              body || name == "world"
                  ? fmt::format("to use the origin of a body, add a frame: {{name: {0}, body: {0}}}", name)
                  : "");
}

int ExpressionReader::expect_frame(const YamlNode& name, std::string_view what) {
  const std::string& text = expect_text(document_, name, fmt::format("the name of a frame as {}", what));
  return frame_called({name, Allowed::force, what}, 0, text.size());
}

const std::vector<Expr>& ExpressionReader::frame_symbols(int frame, FrameQuantity quantity) {
  for (const FrameSymbols& known : mechanism_.frame_symbols)
    if (known.frame == frame && known.quantity == quantity) return known.symbols;
  FrameSymbols symbols{quantity, frame, {}};
  const std::string& name = mechanism_.frames[static_cast<std::size_t>(frame)].name;
  const FrameWord& word = word_of(quantity);
  for (const std::string_view part : word.parts)
    symbols.symbols.push_back(graph_.symbol(fmt::format("{}({}).{}", word.word, name, part)));
  return mechanism_.frame_symbols.emplace_back(std::move(symbols)).symbols;
}

Vec3 ExpressionReader::vector_of(int frame, FrameQuantity quantity) {
  return vec3(frame_symbols(frame, quantity));
}

Mat3 ExpressionReader::rotation_of(int frame) {
  Mat3 R;
  std::ranges::copy(frame_symbols(frame, FrameQuantity::rotation), R.entries.begin());
  return R;
}

Quantity ExpressionReader::of_frame(const Reading& reading, const PostfixToken& token,
                                    FrameQuantity quantity) {
  const std::string_view text = reading.node.text;
  const FrameWord& word = word_of(quantity);
  check_reference(reading, token, word.of_speeds);
  const int frame = frame_called(reading, token.referent, token.referent_end);
  const std::string& name = mechanism_.frames[static_cast<std::size_t>(frame)].name;
  const std::string_view part =
      token.part == 0 ? std::string_view() : text.substr(token.part, token.close - token.part);
  const auto found = std::ranges::find(word.parts, part);
  if (found == word.parts.end())
    throw error(
        reading, token.begin,
        quantity == FrameQuantity::rotation
            ? fmt::format("the rotation of frame '{0}' has the parts rotation({0}).xx, .xy, ... .zz: row "
                          "and column of its matrix",
                          name)
            : fmt::format("the {1} of frame '{0}' has the parts {2}({0}).x, .y and .z", name,
                          quantity == FrameQuantity::angular_velocity ? "angular velocity" : word.word,
                          word.word));
  const std::vector<Expr>& symbols = frame_symbols(frame, quantity);
  return {symbols[static_cast<std::size_t>(found - word.parts.begin())], kUnknown,
          word.of_speeds ? Dependence::coordinate | Dependence::speed : Dependence::coordinate, nullptr};
}

Expr ExpressionReader::distance(int from, int to) {
  if (from > to) std::swap(from, to);
  for (const FrameDistance& known : mechanism_.distances)
    if (known.from == from && known.to == to) return known.symbol;
  const auto name = [&](int frame) -> const std::string& {
    return mechanism_.frames[static_cast<std::size_t>(frame)].name;
  };
  const Expr symbol = graph_.symbol(fmt::format("distance({}, {})", name(from), name(to)));
  mechanism_.distances.push_back({from, to, symbol});
  return symbol;
}

void ExpressionReader::declare_path(const std::string& name, Expr length, Expr rate) {
  paths_.emplace(name, Path{length, rate});
}

void ExpressionReader::set_tension(const std::string& name, const Quantity& tension) {
  paths_.at(name).tension = tension;
}

Quantity ExpressionReader::of_path(const Reading& reading, const PostfixToken& token,
                                   std::string_view word) const {
  const std::string_view name =
      std::string_view(reading.node.text).substr(token.referent, token.referent_end - token.referent);
  const auto found = paths_.find(name);
  if (found == paths_.end()) {
    std::vector<std::string> names;
    for (const auto& [known, path] : paths_) names.push_back(known);
    throw error(reading, token.referent,
                fmt::format("unknown path '{}'{}", printable(name), did_you_mean(name, names)),
                "paths are the forces with 'between', 'path' or 'along'; a condition of a path may use the "
                "paths before it");
  }
  const Path& path = found->second;
  if (word == "rate") return {path.rate, kUnknown, Dependence::coordinate | Dependence::speed, nullptr};
  if (word == "tension") {
    if (!path.tension)
      throw error(reading, token.begin,
                  fmt::format("'{}' has no tension, or none that is known before its force is read", name),
                  "tension() stands in forces that come later, in rates of states and in outputs");
    return *path.tension;
  }
  return {path.length, kUnknown, Dependence::coordinate, nullptr};
}

}  // namespace alembert
