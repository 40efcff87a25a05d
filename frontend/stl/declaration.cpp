// Declarations of local variables.
#include "frontend/stl/declaration.hpp"

#include <fmt/format.h>

#include "frontend/stl/local_layout.hpp"
#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

void readDeclaration(std::string_view text, std::uint32_t begin, std::uint32_t end, VarSection section,
                     SyntaxSink& sink, std::vector<LocalVariable>& locals) {
  const std::string_view line = text.substr(begin, end - begin);
  const Span place = sink.span(begin, end);
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos)
    return sink.report(Syntax::Declaration, place, fmt::format("declaration \"{}\" has no type", excerpt(line)));
  std::string_view typeText = line.substr(colon + 1);
  if (const std::size_t initial = typeText.find(":="); initial != std::string_view::npos) {
    sink.report(Syntax::Declaration, place, "local variables have no initial value; it was left out");
    typeText = typeText.substr(0, initial);
  }
  typeText = trimmed(typeText);
  const std::optional<DataType> type = dataTypeNamed(typeText);
  if (!type) return sink.report(Syntax::Declaration, place, fmt::format("unknown type \"{}\"", excerpt(typeText)));
  std::size_t at = 0;
  while (at <= colon) {
    const std::size_t next = std::min(line.find(',', at), colon);
    const std::string_view name = trimmed(line.substr(at, next - at));
    const std::size_t offset = name.empty() ? begin + at : begin + static_cast<std::size_t>(name.data() - line.data());
    at = next + 1;
    const std::string_view plain = !name.empty() && name[0] == '#' ? name.substr(1) : name;
    if (!isName(plain)) {
      sink.report(Syntax::Declaration, place, fmt::format("\"{}\" is not a name", excerpt(name)));
      continue;
    }
    if (section == VarSection::Input && locals.empty() && *type == DataType::Bool && equalsIgnoringCase(plain, "EN"))
      continue;
    LocalVariable local;
    local.name = plain;
    local.section = section;
    local.type = *type;
    local.span = sink.span(offset, offset + name.size());
    locals.push_back(std::move(local));
  }
}

}  // namespace rungproof
