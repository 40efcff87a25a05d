// Whether the parts are all there, and which form they have.
#include "frontend/merging/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

}  // namespace

std::variant<std::vector<std::size_t>, Failure> orderOfParts(const std::vector<PartFile>& files,
                                                             const std::vector<std::optional<PartMark>>& marks) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!marks[i])
      return Failure{
          fmt::format("'{}' is no part of a report", files[i].name), {}, "parts are made with prove --shard"};
    if (order.empty()) order.assign(marks[i]->of, nobody);
    if (marks[i]->of != order.size())
      return Failure{
          fmt::format("'{}' is a part of {}, '{}' one of {}", files[0].name, order.size(), files[i].name, marks[i]->of),
          {},
          "join the parts of one run"};
    std::size_t& place = order[marks[i]->part - 1];
    if (place != nobody)
      return Failure{
          fmt::format("part {} is there twice: '{}' and '{}'", marks[i]->part, files[place].name, files[i].name),
          {},
          "give each part once"};
    place = i;
    const NamedPart first{files[0].name, marks[0]->programs}, other{files[i].name, marks[i]->programs};
    if (auto failure = i == 0 ? std::nullopt : differenceOfRuns(first, other)) return *failure;
  }
  const auto missing = std::ranges::find(order, nobody);
  if (missing != order.end())
    return Failure{fmt::format("part {} of {} is missing", missing - order.begin() + 1, order.size()),
                   {},
                   "what it would have found is not known"};
  return order;
}

std::optional<PartMark> markOf(const Json& mark) {
  const auto number = [&](std::string_view key) -> std::uint64_t {
    const Json* const value = mark.find(key);
    return value == nullptr ? 0 : value->natural().value_or(0);
  };
  const Json* const programs = mark.find("programs");
  const PartMark result{static_cast<std::uint32_t>(number("part")), static_cast<std::uint32_t>(number("of")),
                        static_cast<int>(number("exit")), programs == nullptr ? Json::array() : *programs};
  const bool isGood = result.part >= 1 && result.part <= result.of && result.of <= 10000 && result.exit <= 3;
  return isGood ? std::optional(result) : std::nullopt;
}

Exit worstExit(const std::vector<std::optional<PartMark>>& marks) {
  Exit worst = Exit::Clean;
  for (const std::optional<PartMark>& mark : marks) {
    if (mark) worst = worse(worst, static_cast<Exit>(mark->exit));
  }
  return worst;
}

JoinResult joinParts(const std::vector<PartFile>& files) {
  const std::string_view text = files.front().text;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return Failure{fmt::format("'{}' is empty", files.front().name), {}, {}};
  if (text[first] == '<') return joinJunit(files);
  return text.find("\"$schema\"") < text.find("\"tool\"") ? joinSarif(files) : joinJson(files);
}

}  // namespace rungproof
