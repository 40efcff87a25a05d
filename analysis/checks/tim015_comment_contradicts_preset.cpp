// TIM015: a duration or a time base in a comment, a symbol or the head of a block that is not what the timer does:
// preset times the resolution of its number. A text is silent where one of its durations agrees. Tested by its examples
// and tests/rules/duration_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "analysis/comment/duration_text.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

struct TimerPlace {
  const Instruction* instruction;
  std::uint32_t number;
  int resolutionMs;
  std::optional<std::int64_t> presetUs;  ///< of a constant preset
};

std::string timeText(std::int64_t us) {
  const auto inUnit = [&](std::int64_t unit, std::string_view name) {
    return fmt::format("{:g} {}", static_cast<double>(us) / static_cast<double>(unit), name);
  };
  if (us >= 3600'000'000LL && us % 36'000'000 == 0) return inUnit(3600'000'000LL, "h");
  if (us >= 60'000'000 && us % 600'000 == 0) return inUnit(60'000'000, "min");
  return us >= 1'000'000 ? inUnit(1'000'000, "s") : inUnit(1000, "ms");
}

/// Numbers of the timers that a text names, each with its place: "T37".
std::vector<std::pair<std::uint32_t, std::size_t>> timersIn(std::string_view text) {
  std::vector<std::pair<std::uint32_t, std::size_t>> timers;
  const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((text[i] != 'T' && text[i] != 't') || (i > 0 && isWord(text[i - 1]))) continue;
    std::size_t end = i + 1;
    std::uint32_t number = 0;
    while (end < text.size() && end - i <= 3 && text[end] >= '0' && text[end] <= '9')
      number = number * 10 + static_cast<std::uint32_t>(text[end++] - '0');
    if (end > i + 1 && (end == text.size() || !isWord(text[end]))) timers.emplace_back(number, i);
  }
  return timers;
}

/// Properties and expectations speak of the whole machine.
bool isDirective(std::string_view text) { return text.starts_with("//@") || text.starts_with("//!"); }

/// The times of clock bits that a network asks: on, and from one edge to the next; in us.
std::vector<std::int64_t> clockTimesIn(const Network& network) {
  std::vector<std::int64_t> times;
  for (const Instruction& instruction : network.instructions) {
    for (const Operand& o : instruction.operands) {
      const bool isClock = o.kind == OperandKind::Direct && o.area == Area::SM && o.width == Width::Bit &&
                           o.offset == 0 && (o.bit == 4 || o.bit == 5);
      if (!isClock) continue;
      const std::int64_t on = o.bit == 4 ? 30'000'000 : 500'000;
      times.insert(times.end(), {on, 2 * on});
    }
  }
  return times;
}

class Comparison {
 public:
  Comparison(const Facts& facts, FindingSink& sink)
      : facts_(facts), sink_(sink), timers_(facts.idsOf([](const Desc& desc) {
          return desc.role == Role::Ton || desc.role == Role::Tof || desc.role == Role::Tonr;
        })) {
    std::erase_if(timers_, [&](std::uint32_t id) {
      const Operands& operands = facts.instruction(id).operands;
      return operands.size() < 2 || operands[0].kind != OperandKind::Direct || resolutionOf(operands[0]) == 0;
    });
  }

  void run() {
    const Program& program = facts_.program();
    for (const Pou& pou : program.pous) {
      for (const Comment& comment : pou.comments) ofBlock(comment);
      for (const Network& network : pou.networks) ofNetwork(network);
    }
    for (const std::uint32_t id : timers_) {
      const Symbol* symbol = facts_.symbolOf(facts_.instruction(id).operands[0]);
      if (symbol == nullptr) continue;
      const TimerPlace timer = timerAt(id);
      judge(timer, durationsInName(symbol->name), fmt::format("its name {}", symbol->name), timer.instruction->span);
      judge(timer, durationsIn(symbol->comment), "the comment of its symbol", timer.instruction->span);
    }
  }

 private:
  static int resolutionOf(const Operand& timer) { return timerResolution(static_cast<int>(timer.offset)); }
  TimerPlace timerAt(std::uint32_t id) const {
    const Instruction& box = facts_.instruction(id);
    const Operand &timer = box.operands[0], &preset = box.operands[1];
    TimerPlace place{&box, timer.offset, resolutionOf(timer), std::nullopt};
    if (preset.kind == OperandKind::Constant) place.presetUs = preset.value * place.resolutionMs * 1000;
    return place;
  }

  /// The list of timers in the head of a block: one timer a line.
  void ofBlock(const Comment& comment) {
    const std::string_view text = facts_.program().sources->text(comment.span);
    if (isDirective(text)) return;
    const auto named = timersIn(text);
    if (named.size() != 1) return;
    for (const std::uint32_t id : timers_) {
      const TimerPlace timer = timerAt(id);
      if (timer.number == named.front().first) judge(timer, durationsIn(text), "the head of the block", comment.span);
    }
  }

  void ofNetwork(const Network& network) {
    if (network.instructions.empty()) return;
    std::vector<TimerPlace> here;
    const auto first = std::ranges::lower_bound(timers_, network.instructions.front().id);
    for (auto id = first; id != timers_.end() && *id <= network.instructions.back().id; ++id)
      here.push_back(timerAt(*id));
    if (here.empty()) return;
    clockTimes_ = clockTimesIn(network);
    const SourceSet& sources = *facts_.program().sources;
    for (const Comment& comment : network.comments) {
      const auto line = sources.position(comment.span).line;
      const auto beside = std::ranges::find_if(here, [&](const TimerPlace& timer) {
        return timer.instruction->span.file == comment.span.file &&
               sources.position(timer.instruction->span).line == line;
      });
      ofText(sources.text(comment.span), here, beside == here.end() ? nullptr : &*beside, comment.span);
    }
    ofText(network.title, here, nullptr, here.front().instruction->span);
  }

  /// A comment in a network with these timers; `beside`: it stands on the line of that one.
  void ofText(std::string_view text, std::span<const TimerPlace> here, const TimerPlace* beside, Span span) {
    std::vector<WrittenDuration> durations = durationsIn(text);
    const auto named = timersIn(text);
    // A text about the whole network may speak of its clock bit.
    if (named.empty() && beside == nullptr) {
      std::erase_if(durations, [&](const WrittenDuration& d) {
        return std::ranges::find(clockTimes_, d.us) != clockTimes_.end();
      });
    }
    if (durations.empty() || isDirective(text)) return;
    if (named.empty()) {
      const auto claims = std::ranges::count_if(durations, [](const WrittenDuration& d) { return !d.isTimeBase; });
      if (beside != nullptr)
        judge(*beside, durations, "the comment", span);
      else if (here.size() == 1 && claims <= 1)
        judge(here.front(), durations, "the comment", span);
      return;
    }
    for (std::size_t i = 0; i < named.size(); ++i) {
      const std::size_t from = i == 0 && named.size() == 1 ? 0 : named[i].second;
      const std::size_t to = i + 1 < named.size() ? named[i + 1].second : text.size();
      std::vector<WrittenDuration> own;
      std::ranges::copy_if(durations, std::back_inserter(own),
                           [&](const WrittenDuration& d) { return from <= d.offset && d.offset < to; });
      for (const TimerPlace& timer : here) {
        if (timer.number == named[i].first) judge(timer, own, "the comment", span);
      }
    }
  }

  /// Reports what no reading of the durations agrees with. A text may name the time and its base side by side.
  void judge(const TimerPlace& timer, const std::vector<WrittenDuration>& durations, const std::string& source,
             Span span) {
    const std::int64_t base = timer.resolutionMs * 1000;
    const WrittenDuration* wrongBase = nullptr;
    const WrittenDuration* wrongTime = nullptr;
    bool agrees = false;
    for (const WrittenDuration& duration : durations) {
      if (duration.isTimeBase) {
        if (duration.us != base && wrongBase == nullptr) wrongBase = &duration;
        continue;
      }
      if (!timer.presetUs) continue;
      // PV + 1 is written where a time is guaranteed at least (001:6590).
      if (std::abs(duration.us - *timer.presetUs) <= base)
        agrees = true;
      else if (duration.us != base && duration.us != 0 && wrongTime == nullptr)
        wrongTime = &duration;
    }
    if (wrongTime != nullptr && !agrees)
      report(timer, *wrongTime, source, span, false);
    else if (wrongBase != nullptr)
      report(timer, *wrongBase, source, span, true);
  }

  void report(const TimerPlace& timer, const WrittenDuration& said, const std::string& source, Span span, bool isBase) {
    const std::string name = fmt::format("T{}", timer.number);
    if (!reported_.emplace(timer.instruction->id, said.text + source).second) return;
    const std::string fact = isBase ? fmt::format("{} counts steps of {} ms", name, timer.resolutionMs)
                                    : fmt::format("{} runs for {} ({} steps of {} ms)", name, timeText(*timer.presetUs),
                                                  *timer.presetUs / (timer.resolutionMs * 1000), timer.resolutionMs);
    Finding& finding =
        sink_.report(timer.instruction->span, fmt::format("{}, but {} says {}", fact, source, said.text));
    finding.address = name;
    finding.help = "the number of a timer decides its resolution (001:6595-6603): mend the preset or the text";
    if (span.offset != timer.instruction->span.offset) finding.related.push_back({span, "this is what is said of it"});
  }

  const Facts& facts_;
  FindingSink& sink_;
  std::vector<std::uint32_t> timers_;     ///< ids of their boxes
  std::vector<std::int64_t> clockTimes_;  ///< of the network that is looked at
  std::set<std::pair<std::uint32_t, std::string>> reported_;
};

void checkTim015(const Facts& facts, FindingSink& sink) { Comparison(facts, sink).run(); }

}  // namespace

extern constexpr Rule tim015_comment_contradicts_preset = {
    .id = "TIM015",
    .title = "Comment and preset disagree",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "a duration, a time base or a resolution named in a comment, a symbol or the head of a block that is not "
        "preset "
        "times the resolution of the timer; units in English, German, Russian and Chinese",
    .why =
        "the next engineer believes the comment; the resolution depends on the number of the timer alone, so a timer "
        "that was renumbered runs ten times too fast or too slow",
    .manual = "001:6595-6603",
    .bad = "Network 1\nLD I0.0\nTON T36, 50 // 5 s (50x100ms)\n",
    .good = "Network 1\nLD I0.0\nTON T37, 50 // 5 s (50x100ms)\n",
    .falsePositives = "a comment in a network with one timer that speaks of another time: name the timer that is meant",
    .peers = "none has it",
    .dialects = dialect::S7200,
    .check = checkTim015,
};

}  // namespace rungproof
