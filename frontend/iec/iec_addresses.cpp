// Places of located variables, and addresses that name the same bytes on some controllers.
#include <tuple>

#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

namespace {
/// The bits that an address names, counted in bytes or in units of its own size; nothing: it has another form.
std::optional<std::pair<std::int64_t, std::int64_t>> bitsOf(const std::string& address, bool inBytes) {
  static const std::map<char, std::int64_t> sizes = {{'X', 1}, {'B', 8}, {'W', 16}, {'D', 32}, {'L', 64}};
  const bool hasSize = address.size() > 3 && sizes.contains(address[2]);
  const std::size_t first = hasSize ? 3 : 2;
  const std::int64_t size = hasSize ? sizes.at(address[2]) : 1;
  const std::size_t point = address.find('.');
  const std::string number = address.substr(first, point == std::string::npos ? point : point - first);
  if (number.empty() || number.size() > 6 || number.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const std::int64_t unit = std::stoll(number);
  if (size > 1)
    return point != std::string::npos ? std::nullopt : std::optional(std::pair(unit * (inBytes ? 8 : size), size));
  if (point == std::string::npos) return std::pair(unit, size);
  const bool isBit = point + 2 == address.size() && address[point + 1] >= '0' && address[point + 1] <= '7';
  return isBit ? std::optional(std::pair(unit * 8 + address[point + 1] - '0', size)) : std::nullopt;
}
}  // namespace

/// Addresses whose bits meet where words are counted in bytes, or in words.
void Lowering::findSharedAddresses() {
  std::set<std::string> all;
  const auto add = [&](const std::string& address) {
    if (address.size() > 2 && address[0] == '%') all.insert(foldedName(address));
  };
  for (const VariableSyntax& variable : project_.globals) add(variable.address);
  for (const BlockSyntax& block : project_.blocks) {
    for (const VariableSyntax& variable : block.variables) add(variable.address);
    eachStatementOf(block, [&](const Statement& one, const Statements&, std::size_t) {
      eachExpression(one, [&](const Expr& expr) {
        if (!expr.parts.empty()) add(expr.parts[0].name);
      });
    });
  }
  for (const bool inBytes : {false, true}) {
    std::vector<std::tuple<char, std::int64_t, std::int64_t, std::string>> ranges;
    for (const std::string& address : all) {
      if (const auto bits = bitsOf(address, inBytes))
        ranges.emplace_back(address[1], bits->first, bits->first + bits->second, address);
    }
    std::ranges::sort(ranges);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const auto& [area, begin, end, address] = ranges[i];
      for (std::size_t k = i + 1; k < ranges.size(); ++k) {
        const auto& [otherArea, otherBegin, otherEnd, other] = ranges[k];
        if (otherArea != area || otherBegin >= end) break;
        if (address[2] == other[2]) continue;  // nobody who counts in bytes lets his words overlap
        sharedAddresses_.insert({address, other});
      }
    }
  }
}

/// The place of an address; the same address is the same place. Nothing if it is none.
std::optional<std::uint32_t> Lowering::located(const VariableSyntax& syntax, const Type& type) {
  const std::string address = foldedName(syntax.address);
  const bool isLegal = address.size() >= 3 && (address[1] == 'I' || address[1] == 'Q' || address[1] == 'M');
  if (!isLegal) return std::nullopt;
  const bool isIncomplete = address.find('*') != std::string::npos;
  const bool hasSize =
      address[2] == 'X' || address[2] == 'B' || address[2] == 'W' || address[2] == 'D' || address[2] == 'L';
  const std::string key = isIncomplete ? fmt::format("{}{}", address, places_.size())
                          : hasSize    ? address
                                       : fmt::format("{}X{}", address.substr(0, 2), address.substr(2));
  const auto [at, isNew] = places_.emplace(key, next_);
  if (!isNew) return at->second;
  at->second = allocate(type.bytes);
  if (!isIncomplete) {
    addressNames_.emplace_back(key.substr(1), at->second);
    if (key[2] == 'X') addressNames_.emplace_back(key.substr(1, 1) + key.substr(3), at->second);
  }
  if (address[1] == 'I') freeVariable(type, at->second, syntax.span);
  if (sharedAddresses_.contains(address)) shared_.insert(at->second);
  return at->second;
}

}  // namespace rungproof::iec
