// Property files and the statements in comments of a program, read as one set.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "engine/real_places.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/encoding.hpp"
#include "frontend/property/goal_names.hpp"
#include "frontend/property/property_meant.hpp"
#include "frontend/property/property_message.hpp"
#include "ir/dialect.hpp"

namespace rungproof {

namespace {

bool declaresNothing(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && line[first] != '#') return false;
  }
  return true;
}

void report(Program& program, std::uint32_t file, std::string message, std::string help) {
  Finding finding;
  finding.rule = std::string(propertyMessages[0].id);
  finding.span = {file, 0, 0};
  finding.message = std::move(message);
  finding.help = std::move(help);
  program.findings.push_back(std::move(finding));
}

}  // namespace

void readPropertyText(std::uint32_t file, std::string_view text, std::uint32_t offset, const OperandLookup& lookup,
                      PropertySet& set, std::vector<Finding>& findings, const Target* target) {
  GoalNames names;
  readPropertyText(file, text, offset, lookup, set, findings, target, names);
}

OperandLookup withReals(const Program& program, OperandLookup lookup) {
  if (dialectOf(program.target).memory.isOfVariables) return lookup;  // which are what they are declared as
  return [&program, lookup = std::move(lookup),
          reals = std::shared_ptr<const RealPlaces>()](std::string_view text) mutable -> std::optional<Operand> {
    std::optional<Operand> found = lookup(text);
    if (!found || found->width != Width::DWord || found->kind != OperandKind::Direct) return found;
    if (reals == nullptr) reals = std::make_shared<const RealPlaces>(program);
    switch (reals->useOf(*found)) {
      case NumberUse::Real: found->form = ConstantForm::Real; break;
      case NumberUse::Whole: found->form = ConstantForm::SignedDecimal; break;
      case NumberUse::Unknown: break;
    }
    return found;
  };
}

PropertySet readProperties(Program& program, const std::vector<std::string>& files, const OperandLookup& untyped,
                           const std::filesystem::path& root) {
  const OperandLookup lookup = withReals(program, untyped);
  PropertySet set;
  GoalNames names;
  const std::size_t before = program.findings.size();
  for (const Directive& directive : program.directives) {
    // The comment's sign stands before the statement.
    const std::size_t sign = program.sources->text(directive.span).find(directive.text);
    const std::size_t begin = directive.span.offset + (sign == std::string_view::npos ? 0 : sign);
    readPropertyText(directive.span.file, directive.text, static_cast<std::uint32_t>(begin), lookup, set,
                     program.findings, &program.target, names);
  }
  for (const std::string& name : files) {
    const auto& [content, problem] = inputBytes(name, longestProgram);
    if (!content) {
      report(program, program.sources->add(name, ""),
             fmt::format("cannot open the property file '{}': {}", name, problem),
             "check the name given to --props, and that it is a file");
      set.unread.push_back({fmt::format("all of '{}'", name), program.findings.back().span});
      continue;
    }
    const std::uint32_t file =
        program.sources->add(nameInProject(name, root), decode(*content, TextEncoding::Auto).text);
    const std::string_view text = program.sources->file(file).text();
    if (declaresNothing(text))
      report(program, file, fmt::format("the property file '{}' declares nothing", name),
             "write for example: prove no_shoot_through: never Q0.0 and Q0.1");
    readPropertyText(file, text, 0, lookup, set, program.findings, &program.target, names);
  }
  suggestMeant(program, before, lookup);
  return set;
}

}  // namespace rungproof
