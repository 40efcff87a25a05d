// BTOR2: one numbered line for each sort, variable, operation and mark; operands are numbers of earlier lines. One
// blank between two words, nothing behind the last; constants fit their sort; what a state begins with stands before
// the state and has no input in it; no two variables have one name.
#include <set>
#include <sstream>
#include <stdexcept>

#include "tests/export/word_reader.hpp"

namespace rungproof::test {
namespace {

std::int64_t asSigned(std::uint64_t v, int width) {
  const std::uint64_t sign = 1ULL << (width - 1);
  return static_cast<std::int64_t>(((v & mask(width)) ^ sign) - sign);
}

class Btor2 {
 public:
  Btor2(const std::vector<std::uint64_t>* states, const std::vector<std::uint64_t>* inputs)
      : states_(states), inputs_(inputs) {}

  void read(const std::string& text) {
    std::istringstream lines(text);
    if (!text.empty() && text.back() != '\n') fail("the last line has no end");
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line[0] == ';') continue;
      line_ = line;
      expect(line.find("  ") == std::string::npos && line.find('\t') == std::string::npos && line.back() != ' ',
             "one blank between two words");
      readLine();
    }
    for (const std::size_t state : stateIds_) {
      if (!next_.contains(state)) fail("state without next");
      step.next.push_back(next_[state]);
      step.init.push_back(init_.contains(state) ? init_[state] : 0);
    }
  }

  WordStep step;
  WordFileShape shape;

 private:
  struct Value {
    int width;
    std::uint64_t value;
    bool restsOnInput = false;
    bool isState = false;
  };
  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(what + ": " + line_); }
  void expect(bool condition, const char* what) const {
    if (!condition) fail(what);
  }
  std::uint64_t number(std::istringstream& words) const {
    std::uint64_t n = 0;
    expect(static_cast<bool>(words >> n), "a number is missing");
    return n;
  }
  int sort(std::istringstream& words) const {
    const auto found = sorts_.find(number(words));
    expect(found != sorts_.end(), "no such sort");
    return found->second;
  }
  Value operand(std::istringstream& words) const {
    const auto found = values_.find(number(words));
    expect(found != values_.end(), "operand not defined before its use");
    lastOperand_ = found->first;
    restsOnInput_ = restsOnInput_ || found->second.restsOnInput;
    return found->second;
  }

  void readLine() {
    std::istringstream words(line_);
    const std::size_t id = number(words);
    expect(id > last_, "numbers must grow");
    last_ = id;
    std::string tag;
    words >> tag;
    if (tag == "sort") {
      std::string kind;
      words >> kind;
      expect(kind == "bitvec", "unknown sort");
      sorts_[id] = static_cast<int>(number(words));
      expect(sorts_[id] > 0, "a sort without bits");
    } else if (tag == "constraint" || tag == "bad") {
      const Value v = operand(words);
      expect(v.width == 1, "must have one bit");
      (tag == "bad" ? step.bads : step.constraints).push_back(v.value != 0);
    } else if (tag == "init" || tag == "next") {
      const int width = sort(words);
      const std::size_t state = number(words);
      const Value v = operand(words);
      expect(values_.contains(state) && values_[state].isState, "no state");
      expect(values_[state].width == width && v.width == width, "sorts differ");
      expect(tag == "next" || (lastOperand_ < state && !v.restsOnInput), "what a state begins with stands before it");
      expect((tag == "init" ? init_ : next_).emplace(state, v.value).second, "given twice");
    } else {
      const int width = sort(words);
      restsOnInput_ = tag == "input";
      const std::uint64_t value = result(tag, width, words, id);
      expect(tag != "constd" || (value & ~mask(width)) == 0, "a constant does not fit its sort");
      values_[id] = {width, value & mask(width), restsOnInput_, tag == "state"};
    }
    const bool mayHaveName = tag != "sort" && tag.rfind("const", 0) != 0;
    std::string name, rest;
    if (!(words >> name)) return;
    expect(mayHaveName && !(words >> rest), "text behind a line");
    expect((tag != "state" && tag != "input") || names_.insert(name).second, "one name for two variables");
  }

  std::uint64_t result(const std::string& tag, int width, std::istringstream& words, std::size_t id) {
    if (tag == "state" || tag == "input") {
      const auto* given = tag == "state" ? states_ : inputs_;
      auto& widths = tag == "state" ? shape.states : shape.inputs;
      if (tag == "state") stateIds_.push_back(id);
      widths.push_back(width);
      return given != nullptr && widths.size() <= given->size() ? (*given)[widths.size() - 1] : 0;
    }
    if (tag == "constd") return number(words);
    const Value a = operand(words);
    if (tag == "not") return expect(a.width == width, "sorts differ"), ~a.value;
    if (tag == "slice") {
      const std::uint64_t high = number(words), low = number(words);
      expect(high < static_cast<std::uint64_t>(a.width) && low <= high && static_cast<int>(high - low) + 1 == width,
             "slice outside its operand");
      return a.value >> low;
    }
    if (tag == "uext" || tag == "sext") {
      expect(a.width + static_cast<int>(number(words)) == width, "extension to another width");
      return tag == "uext" ? a.value : static_cast<std::uint64_t>(asSigned(a.value, a.width));
    }
    const Value b = operand(words);
    if (tag == "ite") {
      const Value c = operand(words);
      expect(a.width == 1 && b.width == width && c.width == width, "sorts differ");
      return a.value != 0 ? b.value : c.value;
    }
    if (tag == "concat") return expect(a.width + b.width == width, "sorts differ"), a.value << b.width | b.value;
    expect(a.width == b.width, "sorts differ");
    const int w = a.width;
    const std::int64_t x = asSigned(a.value, w), y = asSigned(b.value, w);
    if (tag == "eq" || tag == "ult" || tag == "ulte" || tag == "slt" || tag == "slte") {
      expect(width == 1, "a comparison has one bit");
      return tag == "eq"     ? a.value == b.value
             : tag == "ult"  ? a.value < b.value
             : tag == "ulte" ? a.value <= b.value
             : tag == "slt"  ? x < y
                             : x <= y;
    }
    expect(w == width, "sorts differ");
    if (tag == "and") return a.value & b.value;
    if (tag == "or") return a.value | b.value;
    if (tag == "xor") return a.value ^ b.value;
    if (tag == "add") return a.value + b.value;
    if (tag == "sub") return a.value - b.value;
    if (tag == "mul") return a.value * b.value;
    if (tag == "udiv") return b.value == 0 ? ~0ULL : a.value / b.value;
    if (tag == "urem") return b.value == 0 ? a.value : a.value % b.value;
    if (tag == "sdiv")
      return b.value == 0 ? (x < 0 ? 1 : ~0ULL) : y == -1 ? 0 - a.value : static_cast<std::uint64_t>(x / y);
    if (tag == "srem") return b.value == 0 ? a.value : y == -1 ? 0 : static_cast<std::uint64_t>(x % y);
    if (tag == "sll") return b.value >= static_cast<std::uint64_t>(w) ? 0 : a.value << b.value;
    if (tag == "srl") return b.value >= static_cast<std::uint64_t>(w) ? 0 : a.value >> b.value;
    fail("unknown operation");
  }

  const std::vector<std::uint64_t>* states_;
  const std::vector<std::uint64_t>* inputs_;
  std::string line_;
  std::size_t last_ = 0;
  std::map<std::size_t, int> sorts_;
  std::map<std::size_t, Value> values_;
  std::map<std::size_t, std::uint64_t> init_, next_;
  std::vector<std::size_t> stateIds_;
  std::set<std::string> names_;  ///< of states and inputs
  mutable std::size_t lastOperand_ = 0;
  mutable bool restsOnInput_ = false;  ///< an operand of this line does
};

}  // namespace

WordFileShape btor2Shape(const std::string& text) {
  Btor2 file(nullptr, nullptr);
  file.read(text);
  return file.shape;
}

WordStep btor2Step(const std::string& text, const std::vector<std::uint64_t>& states,
                   const std::vector<std::uint64_t>& inputs) {
  Btor2 file(&states, &inputs);
  file.read(text);
  return file.step;
}

}  // namespace rungproof::test
