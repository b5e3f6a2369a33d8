// The scheduler, see the header.
#include "registers/list_schedule.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "registers/statement_layout.hpp"
#include "support/error.hpp"
#include "support/no_index.hpp"

namespace alembert {
namespace {

// So many statements since the last use of an operand count at most.
constexpr int kLongAgo = 100;

class ListScheduler {
 public:
  ListScheduler(const std::vector<ScheduledStatement>& statements, std::uint32_t leading,
                std::vector<std::uint32_t> left, const ScheduleWeights& weights, std::uint32_t look_ahead)
      : statements_(statements),
        leading_(leading),
        weights_(weights),
        look_ahead_(look_ahead),
        left_(std::move(left)),
        used_at_(left_.size(), kNoIndex),
        written_(statements.size(), false) {
    for (std::uint32_t s = 0; s < statements.size(); ++s) {
      unknown_.push_back(statements[s].before);
      if (unknown_[s] == 0) ready_.push_back(s);
    }
  }

  std::vector<std::uint32_t> sequence() {
    std::uint32_t next = 0;  // the first that is not written
    for (; next < leading_; ++next) write(next);
    while (next < statements_.size()) {
      write(best(next));
      while (next < statements_.size() && written_[next]) ++next;
    }
    return std::move(sequence_);
  }

 private:
  bool in_register(std::uint32_t v) const { return used_at_[v] != kNoIndex; }

  int score(const ScheduledStatement& s) const {
    int score = weights_.height * s.height, age = kLongAgo;
    for (const std::uint32_t v : s.reads) {
      if (!in_register(v)) {
        score -= weights_.missing;
        continue;
      }
      if (left_[v] == 1) score += weights_.freed;
      age = std::min(age, static_cast<int>(time_ - used_at_[v]));
    }
    return score - age;
  }

  std::uint32_t best(std::uint32_t first) const {
    std::optional<std::pair<int, std::uint32_t>> found;
    for (const std::uint32_t s : ready_) {
      if (s >= first + look_ahead_) continue;
      const int value = score(statements_[s]);
      if (!found || value > found->first || (value == found->first && s < found->second)) found = {value, s};
    }
    if (!found) throw InternalError("emit: no statement can be next");
    return found->second;
  }

  void write(std::uint32_t number) {
    const ScheduledStatement& s = statements_[number];
    sequence_.push_back(number);
    written_[number] = true;
    std::erase(ready_, number);
    ++time_;
    for (const std::uint32_t v : s.reads) {
      use(v);
      if (--left_[v] == 0) give_up(v);
    }
    // Sines and cosines wait in memory, as inputs do.
    if (!s.readers.empty() && number >= leading_) use(s.members.back());
    while (registers_.size() > weights_.registers)
      give_up(*std::ranges::min_element(registers_, {}, [&](std::uint32_t v) { return used_at_[v]; }));
    for (const std::uint32_t reader : s.readers)
      if (--unknown_[reader] == 0) ready_.push_back(reader);
  }

  void use(std::uint32_t v) {
    if (!in_register(v)) registers_.push_back(v);
    used_at_[v] = time_;
  }

  void give_up(std::uint32_t v) {
    registers_.erase(std::ranges::find(registers_, v));
    used_at_[v] = kNoIndex;
  }

  const std::vector<ScheduledStatement>& statements_;
  std::uint32_t leading_;
  ScheduleWeights weights_;
  std::uint32_t look_ahead_, time_ = 0;  // statements written
  std::vector<std::uint32_t> left_;      // of a value: statements that will read it
  std::vector<std::uint32_t> used_at_;   // of a value in a register: the time of its last use
  std::vector<std::uint32_t> registers_, ready_, unknown_, sequence_;
  std::vector<bool> written_;
};

}  // namespace

std::vector<std::uint32_t> list_schedule(const std::vector<ScheduledStatement>& statements,
                                         std::uint32_t leading, std::vector<std::uint32_t> left,
                                         const ScheduleWeights& weights, std::uint32_t look_ahead) {
  return ListScheduler(statements, leading, std::move(left), weights, look_ahead).sequence();
}

}  // namespace alembert
