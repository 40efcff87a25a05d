// Linear equations that sampled states suggest: what is left of the space of all combinations after elimination, modulo
// a large prime, with coefficients turned back into small integers. They are candidates and no more: each is proved by
// the engine or not used.
#include <algorithm>
#include <cstdlib>

#include "analysis/schedule/schedule.hpp"
#include "analysis/words/terms.hpp"

namespace rungproof {

namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t prime = (1ULL << 61) - 1;

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>(static_cast<Wide>(a) * b % prime);
}
std::uint64_t minus(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + prime - b; }
std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t exponent = prime - 2; exponent != 0; exponent >>= 1U, a = times(a, a)) {
    if ((exponent & 1U) != 0) result = times(result, a);
  }
  return result;
}
std::int64_t asSigned(std::uint64_t value, int width) {
  const std::uint64_t sign = 1ULL << (width - 1);
  return static_cast<std::int64_t>((value ^ sign) - sign);
}
std::uint64_t residue(std::int64_t value) {
  return value >= 0 ? static_cast<std::uint64_t>(value) % prime : minus(0, static_cast<std::uint64_t>(-value) % prime);
}

/// Rows in echelon form, each with a leading 1 in its pivot column and zeros there in all other rows.
class Echelon {
 public:
  explicit Echelon(std::size_t columns) : rowOf_(columns, -1) {}
  void add(std::vector<std::uint64_t> row) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (row[c] != 0 && rowOf_[c] >= 0) subtract(row, rows_[static_cast<std::size_t>(rowOf_[c])], row[c]);
    }
    const auto lead = std::ranges::find_if(row, [](std::uint64_t v) { return v != 0; });
    if (lead == row.end()) return;
    const std::size_t pivot = static_cast<std::size_t>(lead - row.begin());
    const std::uint64_t scale = inverse(*lead);
    for (std::uint64_t& v : row) v = times(v, scale);
    for (std::vector<std::uint64_t>& other : rows_) {
      if (other[pivot] != 0) subtract(other, row, other[pivot]);
    }
    rowOf_[pivot] = static_cast<int>(rows_.size());
    rows_.push_back(std::move(row));
  }
  /// The combination with coefficient 1 for `column` that is 0 on all rows; none if the column has a pivot.
  std::optional<std::vector<std::uint64_t>> kernel(std::size_t column) const {
    if (rowOf_[column] >= 0) return std::nullopt;
    std::vector<std::uint64_t> result(rowOf_.size(), 0);
    result[column] = 1;
    for (std::size_t c = 0; c < rowOf_.size(); ++c) {
      if (rowOf_[c] >= 0) result[c] = minus(0, rows_[static_cast<std::size_t>(rowOf_[c])][column]);
    }
    return result;
  }

 private:
  static void subtract(std::vector<std::uint64_t>& row, const std::vector<std::uint64_t>& other, std::uint64_t factor) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = minus(row[i], times(factor, other[i]));
  }
  std::vector<std::vector<std::uint64_t>> rows_;
  std::vector<int> rowOf_;  ///< by column: the row with its pivot there, -1: none
};

/// The combination times the smallest number that makes all coefficients small integers.
std::optional<std::vector<std::int64_t>> integers(const std::vector<std::uint64_t>& combination) {
  for (std::uint64_t scale = 1; scale <= schedule::denominatorLimit; ++scale) {
    std::vector<std::int64_t> result;
    for (const std::uint64_t v : combination) {
      const std::uint64_t scaled = times(v, scale);
      const std::int64_t value =
          scaled <= prime / 2 ? static_cast<std::int64_t>(scaled) : -static_cast<std::int64_t>(prime - scaled);
      if (std::abs(value) > schedule::coefficientLimit) break;
      result.push_back(value);
    }
    if (result.size() == combination.size()) return result;
  }
  return std::nullopt;
}

/// sum of positive terms = sum of negated negative terms + constant, modulo 2^width.
Node equation(WordCone& cone, const std::vector<std::size_t>& words, const std::vector<std::int64_t>& coefficients,
              std::int64_t constant) {
  Graph& graph = cone.graph();
  int width = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (coefficients[i] != 0) width = std::max<int>(width, graph[cone.system().states[words[i]].node].width);
  }
  Node sides[2] = {noNode, noNode};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (coefficients[i] == 0) continue;
    Node term = cone.system().states[words[i]].node;
    if (graph[term].width < width) term = graph.make(Op::Sext, width, term);
    const std::uint64_t factor = static_cast<std::uint64_t>(std::abs(coefficients[i])) & Graph::maskOf(width);
    if (factor != 1) term = graph.make(Op::Mul, width, term, graph.constantNode(factor, width));
    Node& side = sides[coefficients[i] < 0 ? 1 : 0];
    side = side == noNode ? term : graph.make(Op::Add, width, side, term);
  }
  const Node number = graph.constantNode(static_cast<std::uint64_t>(constant) & Graph::maskOf(width), width);
  if (sides[0] == noNode) return noNode;
  const Node right = sides[1] == noNode ? number
                     : constant == 0    ? sides[1]
                                        : graph.make(Op::Add, width, sides[1], number);
  return graph.make(Op::Equal, 1, sides[0], right);
}

}  // namespace

std::vector<Node> linearPredicates(WordCone& cone, const std::vector<WordState>& samples) {
  std::vector<Node> result;
  if (samples.size() < schedule::leastSamples) return result;
  const Graph& graph = cone.graph();
  std::vector<std::size_t> words;
  for (std::size_t i = 0; i < cone.system().states.size() && words.size() < schedule::eliminationLimit; ++i) {
    const int width = graph[cone.system().states[i].node].width;
    const bool varies = std::ranges::any_of(samples, [&](const WordState& s) { return s[i] != samples[0][i]; });
    if (width >= 8 && width <= 32 && varies) words.push_back(i);
  }
  const auto valueOf = [&](const WordState& s, std::size_t i) {
    return asSigned(s[words[i]], graph[cone.system().states[words[i]].node].width);
  };
  Echelon echelon(words.size());
  for (const WordState& sample : samples) {
    std::vector<std::uint64_t> row;
    for (std::size_t i = 0; i < words.size(); ++i) row.push_back(residue(valueOf(sample, i) - valueOf(samples[0], i)));
    echelon.add(std::move(row));
  }
  for (std::size_t column = 0; column < words.size(); ++column) {
    const auto combination = echelon.kernel(column);
    if (!combination) continue;
    const auto coefficients = integers(*combination);
    if (!coefficients || static_cast<std::size_t>(std::ranges::count_if(
                             *coefficients, [](std::int64_t c) { return c != 0; })) > schedule::termLimit)
      continue;
    std::int64_t constant = 0;
    for (std::size_t i = 0; i < words.size(); ++i) constant += (*coefficients)[i] * valueOf(samples[0], i);
    if (const Node n = equation(cone, words, *coefficients, constant); n != noNode && graph[n].op != Op::Constant)
      result.push_back(n);
  }
  return result;
}

}  // namespace rungproof
