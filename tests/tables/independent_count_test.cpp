// Coverage figures of random networks against a count from the inputs of the trace alone: the network is drawn here as
// a tree, written as STL, and evaluated over the rows of the stimulus by nothing of the product.
#include <functional>
#include <memory>
#include <random>
#include <set>

#include "test_command.hpp"

namespace rungproof::test {
namespace {

constexpr int inputs = 6;

/// A series or parallel circuit of contacts.
struct Circuit {
  int input = -1;  ///< of a contact
  bool isNegated = false, isSeries = false;
  std::size_t contact = 0;  ///< its number, from 0 in the order of the text
  std::unique_ptr<Circuit> left, right;
};

class Drawing {
 public:
  explicit Drawing(std::mt19937& random) : random_(random), root_(draw(3)) {}

  std::string text(int output) const { return written(*root_) + "= Q0." + std::to_string(output) + "\n"; }
  std::size_t contacts() const { return contacts_.size(); }
  const Circuit& contact(std::size_t i) const { return *contacts_[i]; }
  /// The power flow, with one contact's bit turned round.
  bool flows(const std::vector<bool>& row, std::size_t turned) const { return flows(*root_, row, turned); }

 private:
  std::unique_ptr<Circuit> draw(int depth) {
    auto circuit = std::make_unique<Circuit>();
    if (depth == 0 || random_() % 3 == 0) {
      circuit->input = static_cast<int>(random_() % inputs);
      circuit->isNegated = random_() % 3 == 0;
      circuit->contact = contacts_.size();
      contacts_.push_back(circuit.get());
      return circuit;
    }
    circuit->isSeries = random_() % 2 == 0;
    circuit->left = draw(depth - 1);
    circuit->right = draw(depth - 1);
    return circuit;
  }
  std::string written(const Circuit& c) const {
    if (c.input >= 0) return std::string(c.isNegated ? "LDN" : "LD") + " I0." + std::to_string(c.input) + "\n";
    return written(*c.left) + written(*c.right) + (c.isSeries ? "ALD\n" : "OLD\n");
  }
  bool flows(const Circuit& c, const std::vector<bool>& row, std::size_t turned) const {
    if (c.input >= 0) return (row[static_cast<std::size_t>(c.input)] != (c.contact == turned)) != c.isNegated;
    const bool a = flows(*c.left, row, turned), b = flows(*c.right, row, turned);
    return c.isSeries ? a && b : a || b;
  }

  std::mt19937& random_;
  std::vector<const Circuit*> contacts_;
  std::unique_ptr<Circuit> root_;
};

struct Counts {
  int networks = 0, contacts = 0, pairs = 0, contactsOfAll = 0;
};

/// A pair: as 0 and as 1 the contact decided the power flow, once it was 1 and once 0.
Counts countOf(const std::vector<Drawing>& drawings, const std::vector<std::vector<bool>>& rows) {
  Counts counts;
  for (const Drawing& drawing : drawings) {
    bool isReached = false;
    for (const std::vector<bool>& row : rows) isReached = isReached || drawing.flows(row, drawing.contacts());
    counts.networks += isReached ? 1 : 0;
    for (std::size_t i = 0; i < drawing.contacts(); ++i) {
      ++counts.contactsOfAll;
      std::set<bool> seen;
      std::set<std::pair<bool, bool>> decided;  // bit and power flow
      for (const std::vector<bool>& row : rows) {
        const bool bit = row[static_cast<std::size_t>(drawing.contact(i).input)];
        const bool flow = drawing.flows(row, drawing.contacts());
        seen.insert(bit);
        if (drawing.flows(row, i) != flow) decided.insert({bit, flow});
      }
      counts.contacts += seen.size() == 2 ? 1 : 0;
      const auto has = [&](bool bit, bool flow) { return decided.contains({bit, flow}); };
      counts.pairs += (has(false, false) && has(true, true)) || (has(false, true) && has(true, false)) ? 1 : 0;
    }
  }
  return counts;
}

class IndependentCount : public TestCommand {};

TEST_F(IndependentCount, AgreesOnRandomNetworks) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::vector<Drawing> drawings;
    drawings.reserve(4);
    std::string program;
    for (int output = 0; output < 4; ++output) {
      drawings.emplace_back(random);
      program += "Network " + std::to_string(output + 1) + "\n" + drawings.back().text(output);
    }
    std::string stimulus = "scan";
    for (int i = 0; i < inputs; ++i) stimulus += ",I0." + std::to_string(i);
    stimulus += "\n";
    std::vector<std::vector<bool>> rows;
    for (unsigned scan = 1; scan <= 3 + seed % 20; ++scan) {
      std::vector<bool>& row = rows.emplace_back();
      stimulus += std::to_string(scan);
      for (int i = 0; i < inputs; ++i) {
        row.push_back(random() % 2 == 0);
        stimulus += row.back() ? ",1" : ",0";
      }
      stimulus += "\n";
    }
    const Counts counts = countOf(drawings, rows);
    const nlohmann::json c =
        json({write("p.awl", program), "--stimulus", write("s.csv", stimulus), "--coverage"}, 0)["coverage"];
    EXPECT_EQ(c["networks"]["covered"], counts.networks) << program << stimulus;
    EXPECT_EQ(c["networks"]["total"], 4);
    EXPECT_EQ(c["contacts"]["covered"], counts.contacts) << program << stimulus;
    EXPECT_EQ(c["contacts"]["total"], counts.contactsOfAll);
    EXPECT_EQ(c["mcdc"]["covered"], counts.pairs) << program << stimulus;
    EXPECT_EQ(c["mcdc"]["total"], counts.contactsOfAll);
  }
}

}  // namespace
}  // namespace rungproof::test
