// A certificate carries its program: one instruction of it is changed so that the property breaks, and what was proved
// of the old program does not hold of the new one - the old invariant, put into the obligations of the changed program,
// is refused. A certificate that says nothing of the program would still be accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>

#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/proof/as_written.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace rungproof::test {
namespace {

constexpr std::size_t leastPrograms = 30;
constexpr std::size_t mostChanges = 12;  ///< tried on a program for one that breaks a property
constexpr std::size_t mostInstructions = 150;

/// A program on both sides: simplified, and as it is written.
struct Encoded {
  Encoded(const Program& program, const PropertySet& set, const std::vector<Property>& goals,
          const ProverOptions& options) {
    EncoderOptions encoding = encoderOptionsOf(options);
    encoding.trail = std::make_shared<Trail>();
    simplified = std::make_unique<QuestionSystem>(program, set, goals, encoding, CheckGroups{});
    encoding.trail->isFollowed = true;
    written = std::make_unique<AsWritten>(
        *simplified, std::make_unique<QuestionSystem>(program, set, goals, encoding, CheckGroups{}));
  }
  std::vector<QuestionAnswer> answers() const {
    PortfolioOptions options;
    options.effort = Effort::Together;
    options.seconds = 0.5;
    options.jobs = 1;
    return answerQuestions(simplified->system(), options);
  }
  std::unique_ptr<QuestionSystem> simplified;
  std::unique_ptr<AsWritten> written;
};

/// Nodes of one system over the variables of the other that have the same names.
class Transport {
 public:
  Transport(const TransitionSystem& from, const TransitionSystem& to) : from_(*from.graph), to_(*to.graph) {
    for (const Variable& variable : to_.variables()) named_.emplace(variable.name, variable.node);
  }
  bool isWhole = true;
  std::vector<Node> operator()(const std::vector<Node>& roots) {
    for (const Node n : coneOf(from_, roots)) {
      const NodeData& node = from_[n];
      if (node.op == Op::Constant) {
        known_[indexOf(n)] = to_.constantNode(node.value, node.width);
      } else if (node.op == Op::Variable) {
        const auto found = named_.find(from_.variables()[node.value].name);
        isWhole = isWhole && found != named_.end() && to_[found->second].width == node.width;
        known_[indexOf(n)] = isWhole ? found->second : to_.constantNode(0, node.width);
      } else {
        std::array<Node, 3> child = node.child;
        for (Node& c : child) c = c == noNode ? c : known_.at(indexOf(c));
        known_[indexOf(n)] = to_.make(node.op, node.width, child[0], child[1], child[2], node.value);
      }
    }
    std::vector<Node> result;
    for (const Node n : roots) result.push_back(known_.at(indexOf(n)));
    return result;
  }

 private:
  const Graph& from_;
  Graph& to_;
  std::unordered_map<std::string, Node> named_;
  std::unordered_map<std::uint32_t, Node> known_;
};

CheckResult checked(const TransitionSystem& system, const Question& question, const WordCertificate& certificate) {
  CertificateWriter writer(system);
  writer.add(question, certificate);
  return writer.check({})[0];
}

/// The instruction that does the opposite, or nullptr.
const Desc* opposite(const Instruction& instruction) {
  static const std::array<std::pair<const char*, const char*>, 6> pairs = {
      {{"LD", "LDN"}, {"A", "AN"}, {"O", "ON"}, {"S", "R"}, {"ALD", "OLD"}, {"EU", "ED"}}};
  for (const auto& [one, other] : pairs) {
    if (instruction.desc->stl == one) return s7200Instructions().named(other);
    if (instruction.desc->stl == other) return s7200Instructions().named(one);
  }
  return nullptr;
}

/// Number of properties whose old certificate was put to a program that breaks them; each must be refused.
std::size_t refused(const std::filesystem::path& path) {
  ProgramInput input = corpusInput(path);
  const std::vector<Property> goals = goalsOf(input.properties);
  const bool isPlain = std::none_of(goals.begin(), goals.end(), [](const Property& p) { return p.atEveryInstruction; });
  if (goals.empty() || !isPlain || hasReadErrors(input.program) || input.program.instructionCount() > mostInstructions)
    return 0;
  const ProverOptions options = proverOptions(path);
  const Encoded old(input.program, input.properties, goals, options);
  const std::vector<QuestionAnswer> answers = old.answers();
  std::vector<Instruction*> changeable;
  for (Pou& pou : input.program.pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) {
        if (opposite(instruction) != nullptr) changeable.push_back(&instruction);
      }
    }
  }
  const std::size_t step = std::max<std::size_t>(1, changeable.size() / mostChanges);
  for (std::size_t at = 0; at < changeable.size(); at += step) {
    const Desc* const before = changeable[at]->desc;
    changeable[at]->desc = opposite(*changeable[at]);
    const Encoded changed(input.program, input.properties, goals, options);
    const std::vector<QuestionAnswer> now = changed.answers();
    std::size_t count = 0;
    for (std::size_t q = 0; q < goals.size(); ++q) {
      if (!answers[q].certificate || now[q].answer != Answer::Violated) continue;
      const auto certificate = old.written->translated(q, false, *answers[q].certificate, AsWritten::Purpose::Text);
      if (!certificate) continue;
      const TransitionSystem &from = old.written->system(q, false), &to = changed.written->system(q, false);
      EXPECT_EQ(checked(from, old.written->question(q, false), *certificate), CheckResult::Valid)
          << path << ": " << goals[q].name;
      Transport transport(from, to);
      WordCertificate moved;
      moved.k = certificate->k;
      moved.simplePath = certificate->simplePath;
      moved.invariant = transport(certificate->invariant);
      moved.immediate = transport(certificate->immediate);
      moved.pathBits = transport(certificate->pathBits);
      if (!transport.isWhole || !certificate->differences.empty()) continue;
      EXPECT_EQ(checked(to, changed.written->question(q, false), moved), CheckResult::Invalid)
          << path << ": " << goals[q].name << " with " << changeable[at]->desc->stl << " for " << before->stl;
      ++count;
    }
    changeable[at]->desc = before;
    if (count > 0) return count;
  }
  return 0;
}

TEST(Certificate, DoesNotFitAProgramThatBreaksTheProperty) {
  std::size_t programs = 0, properties = 0;
  const std::vector<std::filesystem::path> files = corpusFiles();
  for (std::size_t i = 0; i < files.size(); i += 2) {
    const std::size_t count = refused(files[i]);
    programs += count > 0 ? 1 : 0;
    properties += count;
  }
  EXPECT_GE(programs, leastPrograms);
  std::printf("%zu programs were changed; %zu certificates do not fit any more\n", programs, properties);
}

}  // namespace
}  // namespace rungproof::test
