// Suggestions for words that were not understood.
#include "frontend/property/property_meant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/files/closest_word.hpp"
#include "frontend/property/property_message.hpp"
#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

namespace {

/// Signs of C, of TIA and of formal logic.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> foreignSigns = {{{"&&", "and"},
                                                                                         {"&", "and"},
                                                                                         {"||", "or"},
                                                                                         {"|", "or"},
                                                                                         {"^", "xor"},
                                                                                         {"!", "not"},
                                                                                         {"~", "not"},
                                                                                         {"->", "implies"},
                                                                                         {"=>", "implies"},
                                                                                         {"!=", "<>"},
                                                                                         {"/=", "<>"}}};

std::string meantName(const Program& program, std::string_view written) {
  if (const std::string mended = mendedOperand(written, Spelling::International, false); !mended.empty()) return mended;
  std::vector<std::string_view> names;
  for (const Symbol& symbol : program.symbols) names.emplace_back(symbol.name);
  const bool isQuoted = written.size() > 1 && written.front() == '"' && written.back() == '"';
  const std::string_view name = closest(isQuoted ? written.substr(1, written.size() - 2) : written, names);
  return name.empty() || !isQuoted ? std::string(name) : fmt::format("\"{}\"", name);
}

/// With a blank where the sign touches its neighbours.
std::string wordWithBlanks(std::string_view word, std::string_view text, std::size_t begin, std::size_t end) {
  const auto isBlank = [&](std::size_t at) { return at >= text.size() || text[at] == ' ' || text[at] == '\t'; };
  return fmt::format("{}{}{}", begin == 0 || isBlank(begin - 1) || text[begin - 1] == '(' ? "" : " ", word,
                     isBlank(end) ? "" : " ");
}

}  // namespace

void suggestMeant(Program& program, std::size_t first) {
  for (std::size_t i = first; i < program.findings.size(); ++i) {
    Finding& finding = program.findings[i];
    if (finding.fix || finding.span.length == 0) continue;
    const SourceFile& file = program.sources->file(finding.span.file);
    const std::string_view written = file.text(finding.span);
    const auto sign = std::ranges::find(foreignSigns, written, &decltype(foreignSigns)::value_type::first);
    std::string meant, replacement;
    if (finding.rule == propertyMessages[0].id && sign != foreignSigns.end()) {
      meant = sign->second;
      replacement = wordWithBlanks(meant, file.text(), finding.span.offset, finding.span.offset + finding.span.length);
    } else if (finding.rule == propertyMessages[1].id && !finding.help.view().starts_with("write ")) {
      replacement = meant = meantName(program, written);
    }
    if (meant.empty() || meant == written) continue;
    finding.help = fmt::format("did you mean '{}'?", meant);
    finding.fix = Shared<Fix>({finding.span, replacement, false});
  }
}

}  // namespace rungproof
