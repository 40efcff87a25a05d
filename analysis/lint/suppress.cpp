// Allow-comments: reading them, and the silence they bring.
#include "analysis/lint/suppress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "analysis/rule.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

namespace {

constexpr std::string_view marker = "rungproof:";
constexpr std::string_view blanks = " \t\r\n";

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool looksLikeId(std::string_view word) {
  return word.size() == 6 && std::all_of(word.begin(), word.begin() + 3, isLetter) &&
         std::all_of(word.begin() + 3, word.end(), isDigit);
}

std::string inCapitals(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::string_view trimmed(std::string_view text, std::string_view what) {
  const std::size_t begin = text.find_first_not_of(what);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(what) - begin + 1);
}

/// Text of a comment without its signs: "// x", "(* x *)", "{ x }".
std::string_view bareText(std::string_view comment) { return trimmed(comment, " \t\r\n/*(){}"); }

enum class Verb : std::uint8_t { Allow, Begin, End, Other };

/// The word in front of the ids: "allow ADR001", "allow(ADR001)", "begin ADR001", "begin allow ADR001", "end".
Verb takeVerb(std::string_view& text) {
  const auto take = [&](std::string_view word) {
    const bool isThere = text.starts_with(word) && (text.size() == word.size() || !isLetter(text[word.size()]));
    if (isThere) text.remove_prefix(word.size());
    return isThere;
  };
  if (take("end")) return Verb::End;
  if (take("allow")) return Verb::Allow;
  if (!take("begin")) return Verb::Other;
  text = trimmed(text, blanks);
  take("allow");
  return Verb::Begin;
}

/// Ids and reason behind the verb; the problem says what is missing.
void readAllow(std::string_view text, Verb verb, Allow& allow) {
  if (verb == Verb::Other) {
    allow.problem = "the comment does not say 'allow'";
    return;
  }
  while (true) {
    text = text.substr(std::min(text.find_first_not_of(" \t,()"), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(" \t,:()"));
    if (!looksLikeId(word)) break;
    allow.ids.push_back(inCapitals(word));
    text.remove_prefix(word.size());
  }
  allow.reason = std::string(trimmed(text, " \t:-()"));
  if (allow.ids.empty()) allow.problem = "the suppression names no rule";
  if (!allow.ids.empty() && allow.reason.empty()) allow.problem = "the suppression gives no reason";
}

class AllowCollector {
 public:
  explicit AllowCollector(const Program& program) : program_(program) {}

  std::vector<Allow> collect() {
    for (const Pou& pou : program_.pous) {
      for (const Comment& comment : pou.comments) add(comment, pou, nullptr);
      for (const Network& network : pou.networks) {
        for (const Comment& comment : network.comments) add(comment, pou, &network);
      }
    }
    endRanges();
    return std::move(allows_);
  }

 private:
  void add(const Comment& comment, const Pou& pou, const Network* network) {
    const std::string_view text = bareText(program_.sources->text(comment.span));
    if (!text.starts_with(marker)) return;
    Allow allow;
    allow.comment = comment.span;
    allow.pou = &pou;
    allow.network = network;
    std::string_view rest = trimmed(text.substr(marker.size()), blanks);
    const Verb verb = takeVerb(rest);
    if (verb == Verb::End) {
      ends_.push_back(std::move(allow));
      return;
    }
    readAllow(rest, verb, allow);
    setScope(allow);
    if (verb == Verb::Begin) allow.scope = AllowScope::Range;
    allows_.push_back(std::move(allow));
  }

  /// Each end ends the last range that is open in its file.
  void endRanges() {
    std::ranges::sort(ends_, {}, [](const Allow& end) { return std::pair(end.comment.file, end.comment.offset); });
    for (Allow& end : ends_) {
      Allow* last = nullptr;
      for (Allow& allow : allows_) {
        const bool isOpen = allow.scope == AllowScope::Range && allow.until == 0 &&
                            allow.comment.file == end.comment.file && allow.comment.offset < end.comment.offset;
        if (isOpen && (last == nullptr || allow.comment.offset > last->comment.offset)) last = &allow;
      }
      if (last != nullptr) {
        last->until = end.comment.offset;
        continue;
      }
      end.problem = "the comment ends no range";
    }
    for (Allow& allow : allows_) {
      if (allow.scope == AllowScope::Range && allow.until == 0 && allow.problem.empty())
        allow.problem = "the range has no 'rungproof: end'";
    }
    std::erase_if(ends_, [](const Allow& end) { return end.problem.empty(); });
    std::ranges::move(ends_, std::back_inserter(allows_));
  }

  void setScope(Allow& allow) const {
    allow.scope = AllowScope::Block;
    if (allow.network == nullptr && program_.syntax != nullptr) return setScopeInText(allow);
    if (allow.network == nullptr) return;
    const auto& instructions = allow.network->instructions;
    allow.line = program_.sources->position(allow.comment).line;
    allow.scope = AllowScope::Line;
    // What became of a statement says little of where its words stand.
    if (allow.network->isStructured && isBehindCode(allow.comment)) return;
    const auto next = std::find_if(instructions.begin(), instructions.end(), [&](const Instruction& instruction) {
      return instruction.span.file == allow.comment.file &&
             program_.sources->position(instruction.span).line >= allow.line;
    });
    const bool besideOne = next != instructions.end() && program_.sources->position(next->span).line == allow.line;
    if (!besideOne && next == instructions.begin()) {
      allow.scope = AllowScope::Network;
      return;
    }
    if (!besideOne && next != instructions.end()) allow.line = program_.sources->position(next->span).line;
  }

  /// A text without networks: its lines of code are what comments stand beside.
  void setScopeInText(Allow& allow) const {
    allow.scope = AllowScope::Line;
    allow.line = program_.sources->position(allow.comment).line;
    const auto holder =
        std::ranges::find_if(program_.pous, [&](const Pou& pou) { return allow.comment.beginsIn(pou.span); });
    allow.pou = holder == program_.pous.end() ? nullptr : &*holder;
    if (isBehindCode(allow.comment)) return;
    const std::uint32_t code = codeBehind(allow.comment);
    for (const iec::BlockSyntax& block : program_.syntax->blocks) {
      if (!allow.comment.beginsIn(block.span)) continue;
      const bool hasBody = !block.body.empty() && block.body.front().span.file == allow.comment.file;
      if (hasBody && block.body.front().span.offset <= code) continue;
      allow.scope = AllowScope::Block;
      allow.block = block.span;
      return;
    }
    allow.line = program_.sources->position({allow.comment.file, code, 0}).line;
  }
  /// Whether anything stands before the comment on its line.
  bool isBehindCode(Span comment) const {
    const std::string_view before = program_.sources->file(comment.file).text().substr(0, comment.offset);
    return !trimmed(before.substr(before.find_last_of('\n') + 1), blanks).empty();
  }
  /// Where the next thing stands that is no comment.
  std::uint32_t codeBehind(Span comment) const {
    const std::string_view text = program_.sources->file(comment.file).text();
    std::size_t at = comment.offset + comment.length;
    for (;;) {
      at = std::min(text.find_first_not_of(blanks, at), text.size());
      const std::string_view sign = text.substr(at, 2);
      const std::string_view end = sign == "//" ? "\n" : sign == "(*" ? "*)" : sign == "/*" ? "*/" : "";
      if (end.empty()) return static_cast<std::uint32_t>(at);
      const std::size_t found = text.find(end, at + 2);
      at = found == std::string_view::npos ? text.size() : found + end.size();
    }
  }

  const Program& program_;
  std::vector<Allow> allows_, ends_;
};

/// Whether the place of a finding lies where the comment speaks.
bool covers(const Allow& allow, const Finding& finding, const ProgramPlace& place, std::uint32_t line) {
  if (finding.span.file != allow.comment.file) return false;
  if (allow.scope == AllowScope::Line) return line == allow.line;
  if (allow.scope == AllowScope::Range)
    return allow.comment.offset < finding.span.offset && finding.span.offset < allow.until;
  if (allow.block) return finding.span.beginsIn(*allow.block);
  return allow.scope == AllowScope::Network ? place.network == allow.network : place.pou == allow.pou;
}

Finding suppressionFinding(const Allow& allow, std::string_view id, std::string message, std::string help) {
  Finding finding;
  finding.rule = std::string(id);
  finding.severity = Severity::Warning;
  finding.message = std::move(message);
  finding.help = std::move(help);
  finding.span = allow.comment;
  if (allow.pou != nullptr) finding.pou = allow.pou->name;
  finding.network = allow.network == nullptr ? 0 : allow.network->number;
  return finding;
}

}  // namespace

std::vector<Allow> allowsOf(const Program& program) { return AllowCollector(program).collect(); }

std::size_t applySuppressions(const Program& program, const KnownRules& rules, std::vector<Finding>& findings) {
  std::vector<Allow> allows = allowsOf(program);
  if (allows.empty()) return 0;
  // By rule and comment, so that each id of a comment must earn its place.
  std::multimap<std::string, Allow*, std::less<>> byId;
  std::map<std::pair<const Allow*, std::string>, bool> used;
  for (Allow& allow : allows) {
    if (!allow.problem.empty()) continue;
    for (const std::string& id : allow.ids) byId.emplace(id, &allow);
  }

  const PlaceIndex places(program);
  const std::size_t before = findings.size();
  const auto isReadersError = [](const Finding& finding) {
    return finding.severity == Severity::Error && finding.rule.starts_with("SYN");
  };
  // Rules that hold back because of what could not be read say nothing about their comments either.
  const bool isWhole = std::ranges::none_of(findings, isReadersError);
  std::erase_if(findings, [&](const Finding& finding) {
    if (isReadersError(finding)) return false;
    const auto [first, last] = byId.equal_range(finding.rule);
    if (first == last) return false;
    const ProgramPlace place = places.at(finding.span);
    const std::uint32_t line = program.sources->position(finding.span).line;
    bool silenced = false;
    for (auto candidate = first; candidate != last; ++candidate) {
      if (!covers(*candidate->second, finding, place, line)) continue;
      used[{candidate->second, finding.rule}] = true;
      silenced = true;
    }
    return silenced;
  });
  const std::size_t removed = before - findings.size();

  for (const Allow& allow : allows) {
    if (!allow.problem.empty()) {
      findings.push_back(suppressionFinding(allow, "SUP002", allow.problem + " and silences nothing",
                                            "write '// rungproof: allow ADR001 why it is safe here'"));
      continue;
    }
    for (const std::string& id : allow.ids) {
      if (!rules.exists(id)) {
        findings.push_back(suppressionFinding(allow, "SUP001", fmt::format("no rule is called {}", id),
                                              "'rungproof rules' lists them"));
      } else if (isWhole && rules.ran(id) && !used[{&allow, id}]) {
        findings.push_back(suppressionFinding(allow, "SUP001",
                                              fmt::format("{} is allowed here, but nothing reports it", id),
                                              "remove it from the comment"));
      }
    }
  }
  return removed;
}

}  // namespace rungproof
