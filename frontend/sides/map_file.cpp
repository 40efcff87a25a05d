// Lines to pairs.
#include "frontend/sides/map_file.hpp"

#include <fmt/format.h>

#include <charconv>

#include "frontend/input/program_input.hpp"
#include "frontend/stl/missing_address.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\xEF\xBB\xBF");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// What one side of a line names: its first address and how many there are.
struct Named {
  Address first;
  std::uint32_t count = 0;
};

class LineReader {
 public:
  LineReader(std::string place, std::vector<Failure>& failures) : place_(std::move(place)), failures_(failures) {}

  std::optional<Named> named(std::string_view text, const Program& program, std::string_view side) {
    const std::size_t dots = text.find("..");
    const auto first = operand(trimmed(text.substr(0, dots)), program, side);
    const auto last = dots == std::string_view::npos ? first : operand(trimmed(text.substr(dots + 2)), program, side);
    if (!first || !last) return std::nullopt;
    const Address from = addressOf(*first), to = addressOf(*last);
    if (from.area != to.area || to.index < from.index || first->width != last->width) {
      fail(fmt::format("'{}' is no range", text),
           "a range goes up from one address to another of the same area and size");
      return std::nullopt;
    }
    return Named{from, to.index + extentOf(*last) - from.index};
  }
  /// What causes an interrupt in a program of that family: "event 8". Another family would name it otherwise.
  std::optional<int> event(std::string_view text, const Program& program, std::string_view side) {
    constexpr std::string_view help = "write 'event 8 = event 25': the S7-200 numbers its interrupt events 0 to 33";
    const std::size_t first = text.find_first_of("0123456789");
    if (!isEvent(text)) {
      const bool isBlock = text.size() > 2 && (text.starts_with("OB") || text.starts_with("ob"));
      fail(isBlock ? fmt::format("{} is an S7-200 program, which has no {}", side, text)
                   : fmt::format("'{}' names no interrupt event of {}", text, side),
           std::string(help));
      return std::nullopt;
    }
    int number = -1;
    const auto end = text.data() + text.size();
    const auto [stop, error] =
        std::from_chars(first == std::string_view::npos ? end : text.data() + first, end, number);
    if (error != std::errc{} || stop != end || number >= eventCount || !eventExists(program.target, number)) {
      fail(fmt::format("'{}' is no interrupt event of CPU {}, which is {}'s", text, cpuName(program.target.cpu), side),
           std::string(help));
      return std::nullopt;
    }
    return number;
  }
  static bool isEvent(std::string_view text) { return text.starts_with("event ") || text.starts_with("EVENT "); }
  void fail(std::string message, std::string help) {
    failures_.push_back({std::move(message), place_, std::move(help)});
  }

 private:
  std::optional<Operand> operand(std::string_view text, const Program& program, std::string_view side) {
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    const std::optional<Operand> found = lookupIn(program)(text);
    const std::optional<std::string> missing = found ? missingFrom(program.target, *found) : std::nullopt;
    if (missing) {
      fail(fmt::format("{} of {}: {}", text, side, *missing),
           "mend the address, or choose the CPU of that side: --cpu old:CPU, --cpu new:CPU");
      return std::nullopt;
    }
    if (!found) {
      fail(text.empty() ? fmt::format("an address of {} is missing", side)
                        : fmt::format("'{}' is neither an address nor a symbol of {}", text, side),
           "write OLD-address = NEW-address, such as I0.0 = I1.0 or VB10..VB19 = VB30..VB39");
    }
    return found;
  }

  std::string place_;
  std::vector<Failure>& failures_;
};

}  // namespace

std::vector<MapLine> readMap(const std::string& name, std::string_view text, const Program& before,
                             const Program& after, std::vector<Failure>& failures) {
  std::vector<MapLine> lines;
  std::uint32_t number = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    LineReader reader(fmt::format("{}:{}", name, number), failures);
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) {
      reader.fail(fmt::format("'{}' is no pair", line), "write OLD-address = NEW-address");
      continue;
    }
    const std::string_view one = trimmed(line.substr(0, sign)), other = trimmed(line.substr(sign + 1));
    if (LineReader::isEvent(one) || LineReader::isEvent(other)) {
      const auto old = reader.event(one, before, "OLD"), now = reader.event(other, after, "NEW");
      if (old && now && !areAlikeEvents(*old, *now))
        reader.fail(
            fmt::format("event {} is '{}', event {} is '{}'", *old, eventInfo(*old).text, *now, eventInfo(*now).text),
            "pair events that come from the same cause");
      else if (old && now)
        lines.push_back({number, {}, {}, 0, std::pair(*old, *now)});
      continue;
    }
    const auto left = reader.named(one, before, "OLD");
    const auto right = reader.named(other, after, "NEW");
    if (!left || !right) continue;
    if (left->count != right->count || isWholeValue(left->first.area) != isWholeValue(right->first.area)) {
      reader.fail(fmt::format("the two sides of '{}' are not of one size", line), "pair as many bits of OLD as of NEW");
      continue;
    }
    lines.push_back({number, left->first, right->first, left->count});
  }
  return lines;
}

}  // namespace rungproof
