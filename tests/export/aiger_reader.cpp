// AIGER: header, latches, marked literals, gates as pairs of differences or as lines, symbols, comment.
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tests/export/bit_reader.hpp"

namespace rungproof::test {
namespace {

class Aiger {
 public:
  explicit Aiger(const std::string& text) : text_(text) {}

  AigerShape read() {
    readHeader();
    // Variable 0 is the constant. In the binary format inputs and latches are those that follow it, in order.
    isDefined_.assign(most_ + 1, false);
    isDefined_[0] = true;
    for (std::size_t i = 0; i < shape_.inputs; ++i) {
      if (isBinary_)
        define(2 * (i + 1));
      else
        define(lineOf(1)[0]);
    }
    for (std::size_t i = 0; i < shape_.latches; ++i) readLatch(2 * (shape_.inputs + i + 1));
    for (std::size_t i = 0; i < outputs_ + shape_.bads + shape_.constraints; ++i) used_.push_back(lineOf(1)[0]);
    for (std::size_t i = 0; i < shape_.gates; ++i) readGate(2 * (shape_.inputs + shape_.latches + i + 1));
    for (const std::size_t literal : used_)
      expect(literal / 2 <= most_ && isDefined_[literal / 2], "literal not defined");
    expectNoCircle();
    readSymbols();
    return shape_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("AIGER: " + what + " at byte " + std::to_string(at_));
  }
  void expect(bool condition, const char* what) const {
    if (!condition) fail(what);
  }

  std::string line() {
    const std::size_t end = text_.find('\n', at_);
    expect(end != std::string::npos, "a line has no end");
    const std::string content = text_.substr(at_, end - at_);
    at_ = end + 1;
    return content;
  }
  /// The numbers of a line, with one blank between two of them and no needless zeros.
  std::vector<std::size_t> numbers(const std::string& words) const {
    std::vector<std::size_t> all;
    for (std::size_t begin = 0; begin <= words.size();) {
      const std::size_t end = std::min(words.find(' ', begin), words.size());
      const std::string word = words.substr(begin, end - begin);
      expect(
          !word.empty() && word.size() < 10 && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; }),
          "no number");
      expect(word == "0" || word[0] != '0', "a number begins with 0");
      all.push_back(std::stoul(word));
      begin = end + 1;
    }
    return all;
  }
  std::vector<std::size_t> lineOf(std::size_t count) {
    const std::vector<std::size_t> all = numbers(line());
    expect(all.size() == count, "another count of numbers in a line");
    return all;
  }

  void readHeader() {
    const std::string head = line();
    isBinary_ = head.starts_with("aig ");
    expect(isBinary_ || head.starts_with("aag "), "no header");
    std::vector<std::size_t> counts = numbers(head.substr(4));
    expect(counts.size() >= 5 && counts.size() <= 9, "a header has five to nine counts");
    counts.resize(9);
    most_ = counts[0];
    shape_.inputs = counts[1];
    shape_.latches = counts[2];
    outputs_ = counts[3];
    shape_.gates = counts[4];
    shape_.bads = counts[5];
    shape_.constraints = counts[6];
    expect(counts[7] == 0 && counts[8] == 0, "justice and fairness are not expected");
    const std::size_t sum = shape_.inputs + shape_.latches + shape_.gates;
    expect(isBinary_ ? most_ == sum : most_ >= sum, "the greatest variable is not the sum of all");
  }

  void define(std::size_t literal) {
    expect(literal % 2 == 0, "what is defined must not be negated");
    expect(literal / 2 <= most_, "variable above the greatest one");
    expect(!isDefined_[literal / 2], "variable defined twice");
    isDefined_[literal / 2] = true;
  }

  void readLatch(std::size_t implied) {
    std::vector<std::size_t> words = numbers(line());
    if (isBinary_) words.insert(words.begin(), implied);
    expect(words.size() == 2 || words.size() == 3, "another count of numbers in a latch");
    define(words[0]);
    used_.push_back(words[1]);
    expect(words.size() == 2 || words[2] <= 1 || words[2] == words[0], "a latch starts with 0, 1 or itself");
  }

  void readGate(std::size_t implied) {
    if (isBinary_) {
      const std::size_t first = difference(), second = difference();
      expect(first > 0 && first <= implied, "a gate is greater than its operands");
      expect(second <= implied - first, "the second operand is at most the first");
      define(implied);
      gates_.push_back({implied, implied - first, implied - first - second});
    } else {
      const std::vector<std::size_t> words = lineOf(3);
      define(words[0]);
      gates_.push_back({words[0], words[1], words[2]});
    }
    used_.insert(used_.end(), {gates_.back()[1], gates_.back()[2]});
  }
  /// Seven bits a byte, lowest first; the last byte has its highest bit clear, and is not 0 unless it is the only one.
  std::size_t difference() {
    std::size_t value = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {
      expect(at_ < text_.size(), "the file ends in a gate");
      const auto byte = static_cast<unsigned char>(text_[at_++]);
      value |= static_cast<std::size_t>(byte & 0x7FU) << shift;
      if ((byte & 0x80U) != 0) continue;
      expect(byte != 0 || shift == 0, "a difference is longer than needed");
      return value;
    }
    fail("a difference is too long");
  }

  void expectNoCircle() const {
    std::vector<std::size_t> gateOf(most_ + 1, gates_.size());
    for (std::size_t i = 0; i < gates_.size(); ++i) gateOf[gates_[i][0] / 2] = i;
    enum class Mark : unsigned char { New, Open, Done };
    std::vector<Mark> marks(gates_.size(), Mark::New);
    std::vector<std::size_t> stack;
    for (std::size_t root = 0; root < gates_.size(); ++root) {
      stack.push_back(root);
      while (!stack.empty()) {
        const std::size_t gate = stack.back();
        if (marks[gate] != Mark::New) {
          marks[gate] = Mark::Done;
          stack.pop_back();
          continue;
        }
        marks[gate] = Mark::Open;
        for (const std::size_t operand : {gates_[gate][1], gates_[gate][2]}) {
          const std::size_t below = gateOf[operand / 2];
          if (below == gates_.size()) continue;
          expect(marks[below] != Mark::Open, "gates in a circle");
          if (marks[below] == Mark::New) stack.push_back(below);
        }
      }
    }
  }

  void readSymbols() {
    std::set<std::string> positions;
    while (at_ < text_.size()) {
      const std::string entry = line();
      if (entry == "c") return;  // a comment up to the end of the file
      const std::size_t blank = entry.find(' ');
      expect(blank != std::string::npos && blank > 1, "no symbol");
      const std::size_t index = numbers(entry.substr(1, blank - 1)).at(0);
      const std::size_t count = entry[0] == 'i'   ? shape_.inputs
                                : entry[0] == 'l' ? shape_.latches
                                : entry[0] == 'o' ? outputs_
                                : entry[0] == 'b' ? shape_.bads
                                : entry[0] == 'c' ? shape_.constraints
                                                  : 0;
      expect(index < count, "symbol of nothing");
      expect(positions.insert(entry.substr(0, blank)).second, "two symbols of one");
      const std::string name = entry.substr(blank + 1);
      expect(!name.empty() && std::ranges::all_of(name, [](unsigned char c) { return c >= 32; }), "no name");
      expect(shape_.names.insert(name).second, "one name for two");
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  bool isBinary_ = false;
  std::size_t most_ = 0, outputs_ = 0;
  AigerShape shape_;
  std::vector<bool> isDefined_;
  std::vector<std::size_t> used_;
  std::vector<std::array<std::size_t, 3>> gates_;
};

}  // namespace

AigerShape readAiger(const std::string& text) { return Aiger(text).read(); }

}  // namespace rungproof::test
