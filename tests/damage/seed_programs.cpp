// Slips as people, editors and disks make them.
#include "tests/damage/seed_programs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "analysis/rule.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof::test {

namespace {

std::string textOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Slips {
 public:
  Slips(std::string text, bool isXml, std::mt19937_64& random)
      : text_(std::move(text)), isXml_(isXml), random_(random) {}

  std::string run() {
    for (std::size_t left = 1 + below(3); left > 0 && !text_.empty(); --left) one();
    return std::move(text_);
  }

 private:
  struct Word {
    std::size_t begin, length;
  };

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }
  template <std::size_t n>
  std::string oneOf(const std::array<const char*, n>& list) {
    return list[below(n)];
  }

  void one() {
    static const std::array<void (Slips::*)(), 6> ofLists = {&Slips::character, &Slips::line,     &Slips::number,
                                                             &Slips::operand,   &Slips::mnemonic, &Slips::network};
    static const std::array<void (Slips::*)(), 4> ofXml = {&Slips::character, &Slips::number, &Slips::attribute,
                                                           &Slips::element};
    (this->*(isXml_ ? ofXml[below(ofXml.size())] : ofLists[below(ofLists.size())]))();
  }

  /// All pieces made of characters that `isPart` takes.
  std::vector<Word> words(const std::function<bool(char)>& isPart) const {
    std::vector<Word> found;
    for (std::size_t at = 0; at < text_.size();) {
      std::size_t end = at;
      while (end < text_.size() && isPart(text_[end])) ++end;
      if (end > at) found.push_back({at, end - at});
      at = end + 1;
    }
    return found;
  }
  void replaceOne(const std::vector<Word>& found, const std::string& by) {
    if (found.empty()) return;
    const Word word = found[below(found.size())];
    text_.replace(word.begin, word.length, by);
  }

  void character() {
    const std::size_t at = below(text_.size());
    const char any = static_cast<char>(below(6) == 0 ? random_() % 256 : 32 + random_() % 95);
    switch (below(4)) {
      case 0: text_.erase(at, 1); break;
      case 1: text_.insert(at, 1, any); break;
      case 2: text_[at] = any; break;
      default: text_.resize(at == 0 ? 1 : at); break;
    }
  }

  void line() {
    std::vector<std::string> lines;
    std::istringstream stream(text_);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    if (lines.size() < 2) return;
    const std::size_t a = below(lines.size()), b = below(lines.size());
    switch (below(3)) {
      case 0: std::swap(lines[a], lines[b]); break;
      case 1: lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(a)); break;
      default: lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(a), lines[b]); break;
    }
    text_.clear();
    for (const std::string& line : lines) text_ += line + "\n";
  }

  void number() {
    static const std::array<const char*, 16> numbers = {"0",     "1",     "7",      "8",          "9",   "63",
                                                        "64",    "255",   "256",    "300",        "999", "32767",
                                                        "65535", "99999", "-32769", "99999999999"};
    replaceOne(words([](char c) { return c >= '0' && c <= '9'; }), oneOf(numbers));
  }

  void operand() {
    static const std::array<const char*, 30> operands = {
        "Foo",  "&Foo",  "*VD10",    "*AC1",   "&VB0", "&I0.0", "AC9",  "T256", "C300", "VW20000",
        "I0.9", "Q99.0", "16#FFFFF", "1.5",    "'AB'", "\"x\"", "HC0",  "AIW1", "AQW0", "SM0.5",
        "LB63", "L60.0", "SBR9",     "INT200", "*LD4", "T32",   "????", "S0.0", "VD0",  "-1"};
    replaceOne(words([](char c) {
                 return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '*' || c == '&' ||
                        c == '#';
               }),
               oneOf(operands));
  }

  /// The first word of a line becomes another instruction.
  void mnemonic() {
    std::vector<Word> found;
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      const std::size_t word = std::min(text_.find_first_of(" \t\r\n", at), end);
      if (word > at) found.push_back({at, word - at});
      at = end + 1;
    }
    const auto all = s7200Instructions().all();
    replaceOne(found, std::string(all[below(all.size())].stl));
  }

  void network() {
    std::vector<std::size_t> begins;
    for (std::size_t at = text_.find("Network"); at != std::string::npos; at = text_.find("Network", at + 7))
      begins.push_back(at);
    if (begins.size() < 3) return line();
    const std::size_t i = below(begins.size() - 2);
    const std::string first = text_.substr(begins[i], begins[i + 1] - begins[i]);
    const std::string second = text_.substr(begins[i + 1], begins[i + 2] - begins[i + 1]);
    text_.replace(begins[i], first.size() + second.size(), second + first);
  }

  void attribute() {
    static const std::array<const char*, 14> values = {"sideways", "maybe", "sometimes", "banana", "",  "true", "false",
                                                       "rising",   "set",   "1",         "99999",  "x", "Bool", "LD"};
    std::vector<Word> found;
    for (std::size_t at = text_.find("=\""); at != std::string::npos; at = text_.find("=\"", at + 2)) {
      const std::size_t end = text_.find('"', at + 2);
      if (end == std::string::npos) break;
      std::size_t name = at;
      while (name > 0 && text_[name - 1] != ' ' && text_[name - 1] != '<') --name;
      switch (below(3)) {
        case 0: found.push_back({name, at - name}); break;
        case 1: found.push_back({name, end + 1 - name}); break;
        default: found.push_back({at + 2, end - at - 2}); break;
      }
    }
    replaceOne(found, oneOf(values));
  }

  /// An element without content is left out, or stands there twice.
  void element() {
    std::vector<Word> found;
    for (std::size_t at = text_.find("/>"); at != std::string::npos; at = text_.find("/>", at + 2)) {
      const std::size_t begin = text_.rfind('<', at);
      if (begin != std::string::npos) found.push_back({begin, at + 2 - begin});
    }
    if (found.empty()) return;
    const Word word = found[below(found.size())];
    const std::string content = text_.substr(word.begin, word.length);
    text_.replace(word.begin, word.length, below(2) == 0 ? "" : content + content);
  }

  std::string text_;
  bool isXml_;
  std::mt19937_64& random_;
};

}  // namespace

std::vector<SeedProgram> ruleExamples() {
  std::vector<SeedProgram> programs;
  for (const Rule* rule : allRules()) {
    for (const std::string_view text : {rule->bad, rule->good}) {
      if (text.empty()) continue;
      programs.push_back({std::string(rule->id) + (text == rule->bad ? "_bad.awl" : "_good.awl"), std::string(text),
                          std::string(rule->exampleSymbols), std::string(rule->exampleCpu)});
    }
  }
  return programs;
}

std::vector<SeedProgram> corpusPrograms() {
  std::vector<SeedProgram> programs;
  const std::filesystem::path folder = std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".awl" || ending == ".stl" || ending == ".xml")
      programs.push_back({entry.path().filename().string(), textOf(entry.path()), "", "226"});
  }
  std::sort(programs.begin(), programs.end(),
            [](const SeedProgram& a, const SeedProgram& b) { return a.name < b.name; });
  return programs;
}

std::string damaged(const SeedProgram& program, std::mt19937_64& random) {
  return Slips(program.text, program.name.ends_with(".xml"), random).run();
}

}  // namespace rungproof::test
