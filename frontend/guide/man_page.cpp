// Manual pages in the macros of man(7).
#include "frontend/guide/man_page.hpp"

#include <fmt/format.h>

#include "frontend/acceptance/page_text.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/cli/help.hpp"

namespace rungproof {

namespace {

std::string titleLine(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(".TH {} 1 \"{}\" \"rungproof {}\" \"rungproof\"\n.ad l\n.nh\n", name, pageDate().substr(0, 10),
                     programVersion());
}

/// Of a long list of words a line may end behind each.
std::string breakable(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 1))
    text.insert(at + 1, "\\:");
  return text;
}

std::string sentence(std::string_view text) {
  std::string result = roffText(text) + ".";
  result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  return result;
}

void addRoffRows(std::string& text, const std::vector<TextRow>& rows) {
  for (const TextRow& row : rows)
    text += fmt::format(".TP\n.B {}\n{}\n", breakable(roffText(row.left)), roffText(row.right));
}

/// Paragraphs are filled; lines that are indented stay as they are; a line such as "Examples:" is a heading.
void addDetails(std::string& text, std::string_view details) {
  bool isVerbatim = false;
  const auto setVerbatim = [&](bool now) {
    if (now != isVerbatim) text += now ? ".PP\n.RS 2\n.nf\n" : ".fi\n.RE\n.PP\n";
    isVerbatim = now;
  };
  while (!details.empty()) {
    const std::size_t end = std::min(details.find('\n'), details.size());
    std::string_view line = details.substr(0, end);
    details.remove_prefix(std::min(end + 1, details.size()));
    if (line.empty()) {
      if (!isVerbatim && !details.empty()) text += ".PP\n";
      continue;
    }
    setVerbatim(line.front() == ' ');
    if (line == "Examples:") {
      if (text.ends_with(".PP\n")) text.resize(text.size() - 4);
      text += ".SH EXAMPLES\n";
      continue;
    }
    if (isVerbatim) line.remove_prefix(std::min<std::size_t>(4, line.find_first_not_of(' ')));
    text += roffText(line) + "\n";
  }
  setVerbatim(false);
  if (text.ends_with(".PP\n")) text.resize(text.size() - 4);
}

std::string exitStatus() {
  std::string text = ".SH EXIT STATUS\n";
  addRoffRows(text, exitCodeRows());
  return text;
}

std::string programPage() {
  std::string text = titleLine("rungproof");
  text +=
      ".SH NAME\nrungproof \\- checks, runs and proves programs of S7\\-200, S7\\-300/400 and IEC 61131\\-3\n"
      ".SH SYNOPSIS\n.B rungproof\n.I COMMAND\n[\\fIOPTIONS\\fR] \\fIFILE\\fR...\n"
      ".SH DESCRIPTION\nrungproof reads statement lists, ladder and FBD programs of Siemens controllers, reports what "
      "is "
      "wrong in them, proves properties or shows the run that breaks them, and compares simulated with expected "
      "traces.\n"
      ".PP\nEach command has a manual page of its own.\n.SH COMMANDS\n";
  for (const Command* command : allCommands())
    text += fmt::format(".TP\n.BR rungproof\\-{} (1)\n{}\n", roffText(command->name), roffText(command->summary));
  text += ".SH OPTIONS\n";
  addRoffRows(text, {{"-h, --help", "the list of commands, or the help of a command"},
                     {"-V, --version", "version of the program"}});
  text += exitStatus();
  text += ".SH ENVIRONMENT\n";
  addRoffRows(text, {{"NO_COLOR", "if set to anything, no colours are used"},
                     {"SOURCE_DATE_EPOCH", "seconds since 1970 that pages bear as their date"}});
  text += ".SH FILES\n";
  addRoffRows(text, {{"rungproof.toml", "options of a project, in its folder or above; see rungproof-config(1)"}});
  return text;
}

std::string commandPage(const Command& command) {
  ArgumentTable table;
  const Action action = command.setup(table);
  std::string text = titleLine(fmt::format("rungproof-{}", command.name));
  text +=
      fmt::format(".SH NAME\nrungproof\\-{} \\- {}\n.SH SYNOPSIS\n.B rungproof {}\n[\\fIOPTIONS\\fR] {}\n",
                  roffText(command.name), roffText(command.summary), roffText(command.name), roffText(command.usage));
  text += fmt::format(".SH DESCRIPTION\n{}\n", sentence(command.summary));
  std::string details;
  addDetails(details, command.details);
  const std::size_t examples = details.find(".SH EXAMPLES\n");
  const std::string before = details.substr(0, examples);
  if (!before.empty()) text += (before.starts_with(".PP") ? "" : ".PP\n") + before;
  for (const HelpSection& section : helpSections(command, table)) {
    text += section.title == "Arguments" || section.title == "Options"
                ? (section.title == "Arguments" ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n")
                : fmt::format(".SS {}\n", roffText(section.title));
    addRoffRows(text, section.rows);
  }
  if (examples != std::string::npos) text += details.substr(examples);
  text += exitStatus();
  text += ".SH SEE ALSO\n.BR rungproof (1)\n";
  return text;
}

}  // namespace

std::string roffText(std::string_view text) {
  std::string result;
  if (text.starts_with(".") || text.starts_with("'")) result = "\\&";
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '\'')
      result += "\\(aq";
    else if (c == '"')
      result += "\\(dq";
    else
      result += c;
  }
  return result;
}

std::vector<GuideFile> manPages() {
  std::vector<GuideFile> pages = {{"rungproof.1", programPage()}};
  for (const Command* command : allCommands())
    pages.push_back({fmt::format("rungproof-{}.1", command->name), commandPage(*command)});
  return pages;
}

}  // namespace rungproof
