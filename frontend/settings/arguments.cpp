// The kinds of rows that a command can declare: what each makes of the texts on the command line.
#include "frontend/settings/arguments.hpp"

#include <fmt/ranges.h>

#include <charconv>

namespace rungproof {

namespace {

using Texts = std::vector<std::string>;

auto lastInto(std::string& target) {
  return [&target](const Texts& texts) -> std::optional<Failure> {
    target = texts.back();
    return std::nullopt;
  };
}

auto allInto(Texts& target) {
  return [&target](const Texts& texts) -> std::optional<Failure> {
    target = texts;
    return std::nullopt;
  };
}

}  // namespace

void ArgumentTable::argument(std::string_view name, std::string& target, std::string_view help) {
  rows_.push_back({name, {}, help, true, false, false, lastInto(target)});
}

void ArgumentTable::arguments(std::string_view name, Texts& target, std::string_view help, bool optional) {
  rows_.push_back({name, {}, help, !optional, true, false, allInto(target)});
}

void ArgumentTable::flag(std::string_view names, bool& target, std::string_view help) {
  rows_.push_back({names, {}, help, false, false, false, [&target](const Texts&) -> std::optional<Failure> {
                     target = true;
                     return std::nullopt;
                   }});
}

void ArgumentTable::option(std::string_view names, std::string& target, std::string_view value, std::string_view help) {
  rows_.push_back({names, value, help, false, false, false, lastInto(target)});
}

void ArgumentTable::option(std::string_view names, Texts& target, std::string_view value, std::string_view help) {
  rows_.push_back({names, value, help, false, true, false, allInto(target)});
}

void ArgumentTable::list(std::string_view names, Texts& target, std::string_view value, std::string_view help) {
  rows_.push_back({names, value, help, false, true, true, allInto(target)});
}

void ArgumentTable::word(std::string_view names, std::string& target, std::vector<std::string_view> words,
                         std::string_view value, std::string_view help) {
  const auto take = [names, &target, words = std::move(words)](const Texts& texts) -> std::optional<Failure> {
    const std::string& text = texts.back();
    if (std::find(words.begin(), words.end(), text) == words.end()) {
      return Failure{
          fmt::format("'{}' is no value for {}", text, names), {}, fmt::format("it can be {}", fmt::join(words, ", "))};
    }
    target = text;
    return std::nullopt;
  };
  rows_.push_back({names, value, help, false, false, false, take});
}

void ArgumentTable::numberInto(std::string_view names, std::function<void(std::int64_t)> keep, std::string_view value,
                               std::string_view help, std::int64_t low, std::int64_t high) {
  const auto take = [names, keep = std::move(keep), low, high](const Texts& texts) -> std::optional<Failure> {
    const std::string& text = texts.back();
    const char* const end = text.data() + text.size();
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || number < low || number > high) {
      return Failure{fmt::format("'{}' is no value for {}", text, names),
                     {},
                     fmt::format("it takes a whole number from {} to {}", low, high)};
    }
    keep(number);
    return std::nullopt;
  };
  rows_.push_back({names, value, help, false, false, false, take});
}

}  // namespace rungproof
