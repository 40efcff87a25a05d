// Lines of comments in front of a proof.
#include "frontend/explain/certificate_head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/cli/cli.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/sha256.hpp"

namespace rungproof {

namespace {

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32; }, ' ');
  return text;
}

}  // namespace

std::string certificateHead(const CertifiedStatement& statement, const std::string& file) {
  std::string text;
  const auto add = [&](std::string_view what, const std::string& value) {
    text += fmt::format("; {}: {}\n", what, oneLine(value));
  };
  add("rungproof", fmt::format("{}, certificate of a proof in SMT-LIB 2", programVersion()));
  add("check", fmt::format("cvc5 --incremental {}", file));
  add("holds if", "every answer is unsat");
  add(statement.kind, statement.text);
  for (const Program* program : statement.programs) {
    for (std::uint32_t i = 0; i < program->sources->size(); ++i) {
      const SourceFile& source = program->sources->file(i);
      const std::optional<std::string> bytes = bytesOfInput(pathInProject(source.name(), statement.root));
      add("program",
          fmt::format("{}, SHA-256 {}", source.name(), sha256(bytes ? std::string_view(*bytes) : source.text())));
    }
  }
  for (const std::string& assumption : statement.assumptions) add("assumes", assumption);
  for (const std::string& note : statement.notes) add("note", note);
  return text;
}

std::string certificateHead(const Program& program, const std::vector<std::string>& assumptions,
                            const ProofResult& result, const std::string& file, const std::filesystem::path& root) {
  const Property& property = result.property;
  const std::string text = property.text.empty() ? property.name : fmt::format("{}: {}", property.name, property.text);
  return certificateHead({"property", text, {&program}, assumptions, result.notes, root}, file);
}

}  // namespace rungproof
