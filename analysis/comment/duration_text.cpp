// A hand-written scanner: numbers with a unit behind them, and products of a number and such.
#include "analysis/comment/duration_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rungproof {

namespace {

struct Unit {
  std::string_view word;  ///< in small letters
  double us;
};
constexpr double ms = 1e3, s = 1e6, minute = 60e6, hour = 3600e6;
/// Longer words in front of those that they begin with.
constexpr std::array<Unit, 53> units = {{
    {"milliseconds", ms},
    {"millisecond", ms},
    {"millisekunden", ms},
    {"millisekunde", ms},
    {"msec", ms},
    {"ms", ms},
    {"миллисекунды", ms},
    {"миллисекунда", ms},
    {"миллисекунд", ms},
    {"мсек", ms},
    {"мс", ms},
    {"毫秒", ms},
    {"seconds", s},
    {"second", s},
    {"sekunden", s},
    {"sekunde", s},
    {"secs", s},
    {"sec", s},
    {"sek", s},
    {"s", s},
    {"секунды", s},
    {"секунда", s},
    {"секунду", s},
    {"секунд", s},
    {"сек", s},
    {"с", s},
    {"秒钟", s},
    {"秒", s},
    {"minutes", minute},
    {"minute", minute},
    {"minuten", minute},
    {"mins", minute},
    {"min", minute},
    {"минуты", minute},
    {"минута", minute},
    {"минуту", minute},
    {"минут", minute},
    {"мин", minute},
    {"分钟", minute},
    {"分", minute},
    {"hours", hour},
    {"hour", hour},
    {"stunden", hour},
    {"stunde", hour},
    {"std", hour},
    {"hrs", hour},
    {"hr", hour},
    {"h", hour},
    {"часов", hour},
    {"часа", hour},
    {"час", hour},
    {"小时", hour},
    {"ч", hour},
}};

/// Words beside a duration that make it the resolution of a timer. Those of one syllable stand beside it directly.
constexpr std::array<std::string_view, 17> baseWords = {
    "time base",  "timebase",    "timer base", "base",   "resolution", "zeitbasis",
    "basis",      "auflösung",   "zeitraster", "raster", "база",       "базой",
    "разрешение", "разрешением", "时基",       "分辨率", "基准"};
constexpr std::size_t nearby = 24;  ///< bytes between such a word and the duration

/// Latin and Cyrillic letters in small form; the length in bytes stays.
std::string small(std::string_view text) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto c = static_cast<unsigned char>(result[i]);
    if (c >= 'A' && c <= 'Z') result[i] = static_cast<char>(c - 'A' + 'a');
    if (c != 0xD0 || i + 1 == result.size()) continue;
    const auto next = static_cast<unsigned char>(result[i + 1]);
    if (next >= 0x90 && next <= 0x9F) result[i + 1] = static_cast<char>(next + 0x20);
    if (next >= 0xA0 && next <= 0xAF) {
      result[i] = static_cast<char>(0xD1);
      result[i + 1] = static_cast<char>(next - 0x20);
    }
    ++i;
  }
  return result;
}

bool isFigure(char c) { return c >= '0' && c <= '9'; }
bool isLatin(char c) { return c >= 'a' && c <= 'z'; }
/// The first byte of a Cyrillic letter, or of an accented Latin one.
bool isLetterLead(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0xC3 && byte <= 0xD1;
}
bool continuesWord(std::string_view text, std::size_t at) {
  return at < text.size() && (isLatin(text[at]) || isFigure(text[at]) || text[at] == '_' || isLetterLead(text[at]));
}

class Scanner {
 public:
  Scanner(std::string_view text, bool isName) : original_(text), text_(small(text)), isName_(isName) {}

  std::vector<WrittenDuration> run() {
    while (at_ < text_.size()) {
      if (isFigure(text_[at_])) {
        readDuration();
      } else if (!isName_ && (isLatin(text_[at_]) || isLetterLead(text_[at_]) || text_[at_] == '_')) {
        skipWord();
      } else {
        ++at_;
      }
    }
    if (!isName_) markTimeBases();
    return std::move(found_);
  }

 private:
  /// A word and what hangs on it: "T37", "VW0.5", "S7-200".
  void skipWord() {
    while (at_ < text_.size() &&
           (continuesWord(text_, at_) || static_cast<unsigned char>(text_[at_]) >= 0x80 || text_[at_] == '.')) {
      const bool isChinese = static_cast<unsigned char>(text_[at_]) >= 0xE0;
      if (isChinese) return;
      ++at_;
    }
  }

  /// "PT=20", "PV = 20": a number of steps.
  bool isBehindPreset(std::size_t at) const {
    const auto skip = [&] {
      while (at > 0 && text_[at - 1] == ' ') --at;
    };
    skip();
    if (at == 0 || (text_[at - 1] != '=' && text_[at - 1] != ':')) return false;
    --at;
    skip();
    if (at < 2) return false;
    const std::string_view word = std::string_view(text_).substr(at - 2, 2);
    return (word == "pt" || word == "pv") && (at == 2 || !isLatin(text_[at - 3]));
  }

  std::optional<double> number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && isFigure(text_[at_])) ++at_;
    const bool isPreset = isBehindPreset(begin);  // whole steps: a comma behind them begins something else
    const bool hasPoint = !(isPreset && at_ < text_.size() && text_[at_] == ',') && at_ + 1 < text_.size() &&
                          (text_[at_] == '.' || text_[at_] == ',') && isFigure(text_[at_ + 1]);
    if (hasPoint) {
      ++at_;
      while (at_ < text_.size() && isFigure(text_[at_])) ++at_;
    }
    if (at_ - begin > 9) return std::nullopt;
    std::string figures = text_.substr(begin, at_ - begin);
    std::replace(figures.begin(), figures.end(), ',', '.');
    return std::strtod(figures.c_str(), nullptr);
  }

  void skipBlanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (text_.compare(at_, 2, "\xC2\xA0") == 0) at_ += 2;
  }

  /// "x", "*", "×" between two numbers.
  bool readTimes() {
    for (const std::string_view sign : {"x", "*", "\xC3\x97", "\xD1\x85"}) {
      if (text_.compare(at_, sign.size(), sign) != 0) continue;
      at_ += sign.size();
      return true;
    }
    return false;
  }

  /// Whether a Russian "с" that ends there is "with" or "from" and not "s": a word follows that is none of those which
  /// cannot stand behind a preposition.
  bool isPreposition(std::size_t end) const {
    if (end >= text_.size() || text_[end] != ' ') return false;
    while (end < text_.size() && text_[end] == ' ') ++end;
    if (end >= text_.size() || !isLetterLead(text_[end])) return false;
    constexpr std::string_view behindTimes[] = {"после", "до",  "и",  "или", "на",  "при", "в",     "во",
                                                "по",    "для", "от", "из",  "без", "не",  "через", "если"};
    return std::ranges::none_of(behindTimes, [&](std::string_view word) {
      return text_.compare(end, word.size(), word) == 0 && !continuesWord(text_, end + word.size());
    });
  }

  std::optional<double> unit() {
    for (const Unit& unit : units) {
      if (text_.compare(at_, unit.word.size(), unit.word) != 0) continue;
      const std::size_t end = at_ + unit.word.size();
      const bool isChinese = static_cast<unsigned char>(unit.word.front()) >= 0xE0;
      if (!isChinese && !isName_ && continuesWord(text_, end)) continue;
      if (isName_ && end < text_.size() && text_[end] != '_') continue;
      if (unit.word == "с" && isPreposition(end)) continue;
      at_ = end;
      return unit.us;
    }
    return std::nullopt;
  }

  void readDuration() {
    const std::size_t begin = at_;
    // "0.5" behind an address such as I0.5 or a date is no number of its own.
    const bool hangs = begin > 0 && (text_[begin - 1] == '.' || text_[begin - 1] == '#' || text_[begin - 1] == '/');
    auto value = number();
    double product = 1;
    std::size_t behind = at_;
    skipBlanks();
    if (value && readTimes()) {
      skipBlanks();
      if (at_ < text_.size() && isFigure(text_[at_])) {
        product = *value;
        value = number();
        behind = at_;
        skipBlanks();
      }
    }
    const auto length = value ? unit() : std::nullopt;
    if (!length || hangs) {
      at_ = std::max(behind, begin + 1);
      if (continuesWord(text_, at_)) skipWord();
      return;
    }
    // "5 m/s" is a speed, "3 s/cycle" a rate: what a unit is divided by makes it another.
    if (at_ < text_.size() && text_[at_] == '/') return;
    WrittenDuration& duration = found_.emplace_back();
    duration.us = std::llround(product * *value * *length);
    duration.text = original_.substr(begin, at_ - begin);
    duration.offset = begin;
  }

  /// A word of the time base names the nearest duration behind it or in front of it.
  void markTimeBases() {
    for (const std::string_view word : baseWords) {
      for (std::size_t at = text_.find(word); at != std::string::npos; at = text_.find(word, at + 1)) {
        WrittenDuration* nearest = nullptr;
        std::size_t distance = nearby;
        for (WrittenDuration& duration : found_) {
          const std::size_t end = duration.offset + duration.text.size();
          const std::size_t gap = duration.offset >= at + word.size() ? duration.offset - at - word.size()
                                  : end <= at                         ? at - end
                                                                      : nearby;
          if (gap < distance) {
            distance = gap;
            nearest = &duration;
          }
        }
        if (nearest != nullptr) nearest->isTimeBase = true;
      }
    }
    // "10 ms timer", "100ms-Timer".
    for (WrittenDuration& duration : found_) {
      std::size_t end = duration.offset + duration.text.size();
      while (end < text_.size() && (text_[end] == ' ' || text_[end] == '-')) ++end;
      const bool isResolution = duration.us == 1000 || duration.us == 10000 || duration.us == 100000;
      for (const std::string_view word : {"timer", "таймер", "定时器"}) {
        if (isResolution && text_.compare(end, word.size(), word) == 0) duration.isTimeBase = true;
      }
    }
  }

  std::string_view original_;
  std::string text_;
  bool isName_;
  std::size_t at_ = 0;
  std::vector<WrittenDuration> found_;
};

}  // namespace

std::vector<WrittenDuration> durationsIn(std::string_view text) { return Scanner(text, false).run(); }
std::vector<WrittenDuration> durationsInName(std::string_view name) { return Scanner(name, true).run(); }

}  // namespace rungproof
