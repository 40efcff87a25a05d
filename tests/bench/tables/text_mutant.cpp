// Lines are matched by expressions; what a reader does not take is left out by whoever reads the mutant.
#include "tests/bench/tables/text_mutant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <regex>
#include <set>
#include <sstream>

namespace rungproof::tables {

namespace {

struct Slip {
  std::regex pattern;
  std::string replacement;
};

const std::vector<Slip>& slips() {
  static const std::vector<Slip> all = [] {
    std::vector<Slip> list;
    const auto add = [&](const char* pattern, const char* replacement) {
      list.push_back({std::regex(pattern), replacement});
    };
    // Lists of all families.
    add(R"(^(\s*)(LD|A|O)(\s+[IQMSTVC]))", "$1$2N$3");
    add(R"(^(\s*)(LD|A|O)N(\s+))", "$1$2$3");
    add(R"(^(\s*)A(N?\s+[IQMSTVC]))", "$1O$2");
    add(R"(^(\s*)O(N?\s+[IQMSTVC]))", "$1A$2");
    add(R"(^(\s*)S(\s+[QMSV]))", "$1R$2");
    add(R"(^(\s*)R(\s+[QMSV]))", "$1S$2");
    add(R"(>=)", ">");
    add(R"(<=)", "<");
    // Expressions.
    add(R"(\bAND\b)", "OR");
    add(R"(\bOR\b)", "AND");
    add(R"(\bNOT\b)", "");
    add(R"(\bTRUE\b)", "FALSE");
    add(R"( < )", " <= ");
    add(R"( > )", " >= ");
    return list;
  }();
  return all;
}

std::string withoutComment(const std::string& line) { return line.substr(0, std::min(line.find("//"), line.size())); }

}  // namespace

std::vector<TextMutant> textMutantsOf(const std::string& text, std::size_t count, std::uint64_t seed) {
  if (text.find("<?xml") != std::string::npos) return {};
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const std::regex address(R"([IQM]\d+\.\d)"), number(R"(([ ,#+])(\d+)(\s*[;)]?\s*|s\s*[;)\],].*|ms.*)$)");
  std::set<std::string> addresses;
  for (const std::string& line : lines) {
    const std::string code = withoutComment(line);
    for (std::sregex_iterator i(code.begin(), code.end(), address), end; i != end; ++i) addresses.insert(i->str());
  }
  std::vector<TextMutant> all;
  const auto joined = [&](std::size_t at, const std::string& changed) {
    std::string result;
    for (std::size_t i = 0; i < lines.size(); ++i) result += (i == at ? changed : lines[i]) + "\n";
    return result;
  };
  const auto plant = [&](std::size_t at, const std::string& changed) {
    if (changed != lines[at])
      all.push_back({fmt::format("line {}: {} for {}", at + 1, changed, lines[at]), joined(at, changed)});
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string code = withoutComment(lines[i]);
    for (const Slip& slip : slips())
      plant(i, std::regex_replace(code, slip.pattern, slip.replacement, std::regex_constants::format_first_only));
    std::smatch found;
    if (std::regex_search(code, found, address)) {
      auto other = addresses.upper_bound(found.str());
      if (other == addresses.end()) other = addresses.begin();
      plant(i, found.prefix().str() + *other + found.suffix().str());
    }
    if (std::regex_search(code, found, number) && found[2].length() < 9) {
      const long given = std::stol(found[2]);
      for (const long value : {given + 1, given * 2})
        plant(i, found.prefix().str() + found[1].str() + std::to_string(value) + found[3].str());
    }
    const bool isCode = code.find_first_not_of(" \t\r") != std::string::npos;
    if (isCode && i + 1 < lines.size() &&
        withoutComment(lines[i + 1]).find_first_not_of(" \t\r") != std::string::npos) {
      std::swap(lines[i], lines[i + 1]);
      all.push_back({fmt::format("lines {} and {} in the other order", i + 1, i + 2), joined(lines.size(), "")});
      std::swap(lines[i], lines[i + 1]);
    }
  }
  std::mt19937_64 random(seed);
  std::ranges::shuffle(all, random);
  if (all.size() > count) all.resize(count);
  return all;
}

}  // namespace rungproof::tables
