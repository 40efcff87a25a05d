// Files are read again for their hashes: what counts is the bytes, not the text that a reader made of them.
#include "frontend/acceptance/record_of.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "analysis/read_errors.hpp"
#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/sha256.hpp"
#include "frontend/linting/lint_run.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/picture/timing_diagram.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/text/text_stream.hpp"
#include "frontend/trace_format.hpp"
#include "ir/iec/cpu.hpp"

namespace rungproof {

namespace {

constexpr std::size_t drawnBytes = 6'000'000;     // networks without a run; what a browser still takes lightly
constexpr std::size_t stimulusBytes = 1'000'000;  // of one run
constexpr std::size_t scansInWave = 60;           // before stretches without a change are shortened

FileRead fileRead(const std::string& path, const std::string& name, std::string kind, std::string_view fallback) {
  const std::optional<std::string> bytes = bytesOfInput(path);
  const std::string_view content = bytes ? std::string_view(*bytes) : fallback;
  return {name, std::move(kind), content.size(), sha256(content)};
}

std::vector<FileRead> filesOf(const Settings& settings, const Program& program,
                              const std::vector<std::string>& propertyFiles) {
  const auto isNamed = [&](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::any_of(names,
                               [&](const std::string& given) { return nameInProject(given, settings.root()) == name; });
  };
  std::vector<FileRead> files;
  for (std::uint32_t i = 0; i < program.sources->size(); ++i) {
    const SourceFile& source = program.sources->file(i);
    const bool holdsBlock = std::ranges::any_of(program.pous, [&](const Pou& pou) { return pou.span.file == i; });
    const bool isProperty = isNamed(propertyFiles, source.name()) || isNamed(settings.propertyFiles(), source.name());
    const std::string kind = isProperty                                         ? "property file"
                             : isNamed(settings.list(Opt::Tags), source.name()) ? "tag list"
                             : holdsBlock                                       ? "program"
                                                                                : "symbols and data";
    files.push_back(fileRead(pathInProject(source.name(), settings.root()), source.name(), kind, source.text()));
  }
  const bool isConfigured = !settings.root().empty();
  const std::string config = settings.isSet(Opt::Config) ? std::string(settings.text(Opt::Config))
                             : isConfigured              ? pathName(settings.root() / "rungproof.toml")
                                                         : "";
  if (!config.empty() && isConfigured)
    files.push_back(fileRead(config, nameInProject(config, settings.root()), "configuration", ""));
  return files;
}

std::vector<OptionInForce> optionsOf(const Settings& settings) {
  std::vector<OptionInForce> options;
  for (const OptionInfo& info : optionTable()) {
    const bool matters = (info.group & (option_group::Reading | option_group::Running | option_group::Hidden)) != 0;
    const bool isTold = info.id == Opt::Cpu || info.id == Opt::Edition || info.id == Opt::ChoiceOf;
    if (!matters || isTold || !settings.isSet(info.id)) continue;
    std::vector<std::string> values = settings.list(info.id);
    const bool namesFile = info.value == "FILE";
    if (namesFile) {
      for (std::string& value : values) value = nameInProject(value, settings.root());
    }
    options.push_back({std::string(info.name), fmt::format("{}", fmt::join(values, ", ")), settings.origin(info.id)});
  }
  return options;
}

std::vector<ChoiceInForce> choicesOf(const Settings& settings, const Program& program) {
  const Choices choices = settings.choices();
  std::vector<ChoiceInForce> list;
  for (const ChoiceInfo& info : choiceTable) {
    if ((info.choice >= Choice::IecDivZero) != (formOf(program.target) == StatementForm::Expressions))
      continue;  // of another family
    list.push_back({std::string(info.key), std::string(choices.valueName(info.choice)),
                    choices.isChosen(info.choice) ? settings.choiceOrigin(info.choice) : "",
                    info.kind == ChoiceKind::Fact, std::string(info.why)});
  }
  return list;
}

std::vector<NamedAddress> symbolsOf(const Program& program) {
  std::vector<NamedAddress> names;
  if (dialectOf(program.target).memory.isOfVariables) return names;  // variables have no other name
  for (const Symbol& symbol : program.symbols) {
    if (!symbol.address.isMemory()) continue;
    names.push_back({toString(symbol.address), symbol.name, symbol.comment});
  }
  return names;
}

std::vector<NetworkPicture> picturesOf(const Program& program) {
  std::vector<NetworkPicture> pictures;
  std::size_t bytes = 0;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      if (network.instructions.empty()) continue;
      ViewOptions options;
      options.form = formAsRead(network);
      const NetworkView view = networkView(program, pou, network, options);
      NetworkPicture& picture = pictures.emplace_back(
          NetworkPicture{pou.name, network.number, fmt::format("{}, {}", pou.name, view.heading), {}});
      if (bytes < drawnBytes) picture.svg = pictureSvg(view);
      bytes += picture.svg.size();
    }
  }
  return pictures;
}

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

ProgramRecord basisRecord(const Settings& settings, const ProgramInput& input, const std::vector<std::string>& files,
                          const std::vector<std::string>& propertyFiles) {
  const Program& program = input.program;
  ProgramRecord record;
  record.name = nameInProject(files.front(), settings.root());
  if (const Pou* main = program.main(); main != nullptr) record.title = main->title;
  if (dialectOf(program.target).text.hasProducts) record.cpu = cpuName(program.target.cpu);
  record.edition = editionText(program.target.edition);
  record.files = filesOf(settings, program, propertyFiles);
  record.options = optionsOf(settings);
  record.choices = choicesOf(settings, program);
  return record;
}

void addRecord(Report& report, const Settings& settings, const ProgramInput& input,
               const std::vector<std::string>& files, const std::vector<std::string>& propertyFiles) {
  ProgramRecord record = basisRecord(settings, input, files, propertyFiles);
  record.symbols = symbolsOf(input.program);
  record.networks = picturesOf(input.program);
  report.programs.push_back(std::move(record));

  report.lintFindings = lintProgram(settings, input, files).findings;
  std::erase_if(report.lintFindings, isReadError);
}

void addEvidence(PropertyResult& row, const Program& program, const Choices& choices, const ProofResult& result,
                 const Trace* shown) {
  PropertyEvidence& evidence = row.evidence;
  evidence.networks = result.networks;
  if (!result.builtin && row.span) {
    const SourceFile& file = program.sources->file(row.span->file);
    evidence.requirement = requirementAbove(file, file.position(row.span->offset).line);
  }
  if (shown == nullptr) return;
  evidence.wave = timingDiagram(*shown, "", scansInWave);
  const Trace whole = traceOf(program, choices, *result.witness, touchedSignals(program));
  TextStream text;
  traceFormatOf("run.csv")->write(whole, result.property.name, text);
  if (text.view().size() <= stimulusBytes) evidence.stimulus = text.str();
}

std::string requirementAbove(const SourceFile& file, std::uint32_t line) {
  const auto at = [&](std::uint32_t number) { return withoutBlanks(file.line(number)); };
  const bool isInProgram = at(line).starts_with("//");
  const std::string_view marker = isInProgram ? "//" : "#";
  const auto isStatement = [&](std::string_view text) {
    return isInProgram ? text.starts_with("//@") || text.starts_with("//!") : !text.empty() && text.front() != '#';
  };
  const auto isComment = [&](std::string_view text) { return text.starts_with(marker) && !isStatement(text); };
  const auto words = [&](std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(marker.front()), text.size()));
    return std::string(withoutBlanks(text));
  };
  std::uint32_t above = line - 1;
  std::string text;
  const std::uint32_t last = above;
  for (; above > 0 && isComment(at(above)); --above) {
    const std::string part = words(at(above));
    if (!part.empty()) text = text.empty() ? part : part + " " + text;
  }
  // In a program the lines below a heading describe the block, not the statement below them.
  const bool isOfBlock = isInProgram && (above == 0 || (!at(above).empty() && !isStatement(at(above))));
  if (above == last || isOfBlock) text.clear();
  if (isInProgram) return text;
  const std::size_t behind = file.line(line).find(" #");
  if (behind == std::string_view::npos) return text;
  const std::string own = words(file.line(line).substr(behind + 1));
  return text.empty() ? own : text + ": " + own;
}

}  // namespace rungproof
