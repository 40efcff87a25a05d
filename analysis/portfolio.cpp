// Order of work: blast all questions at once; simulate; short inductions; then cones and the race. What the engines
// found on their bits is turned into runs and certificates of the given system, and certificates are checked.
#include "analysis/portfolio.hpp"

#include <algorithm>

#include "analysis/bit_cone.hpp"
#include "analysis/portfolio_race.hpp"
#include "analysis/portfolio_shared.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

constexpr int simulatedScans = 256;
constexpr int shortInduction = 3;

class Portfolio {
 public:
  Portfolio(const TransitionSystem& system, const PortfolioOptions& options)
      : system_(system), options_(options), answers_(system.questions.size()) {}

  std::vector<QuestionAnswer> run() {
    if (system_.questions.empty()) return {};
    std::vector<std::size_t> all;
    for (std::size_t q = 0; q < system_.questions.size(); ++q) all.push_back(q);
    blast_ = std::make_unique<BitBlast>(system_, all);
    const Budget budget = Budget::seconds(options_.seconds * static_cast<double>(all.size()), options_.cancel);
    SharedSearch shared(blast_->bits(), options_.seed);
    shared.simulate(simulatedScans, budget.slice(options_.seconds * 0.1));
    const int most = options_.bound > 0 ? std::min(shortInduction, options_.bound) : shortInduction;
    shared.induce(most, {}, budget.slice(options_.seconds * 0.5 * static_cast<double>(all.size())));
    const double sharedSeconds = since() / static_cast<double>(all.size());
    std::vector<std::size_t> open;
    for (std::size_t q = 0; q < all.size(); ++q) {
      answers_[q].seconds = sharedSeconds;
      const Verdict& verdict = shared.answers()[q].verdict;
      if (verdict.answer == Answer::Unknown) open.push_back(q);
      take(q, verdict, nullptr);
    }
    raceFor(open);
    if (options_.check) checkCertificates();
    return std::move(answers_);
  }

 private:
  double since() const { return std::chrono::duration<double>(Budget::Clock::now() - begin_).count(); }

  void raceFor(const std::vector<std::size_t>& open) {
    std::vector<BitCone> cones;
    for (const std::size_t q : open) cones.push_back(makeCone(blast_->bits(), blast_->bits().bads[q], blast_->isTotal()));
    std::vector<RaceQuestion> questions(open.size());
    for (std::size_t i = 0; i < open.size(); ++i) {
      questions[i].system = &cones[i].system;
      questions[i].verdict.depth = answers_[open[i]].depth;
    }
    race(questions, {options_.seconds, options_.jobs, options_.seed, options_.bound, options_.cancel});
    for (std::size_t i = 0; i < open.size(); ++i) {
      answers_[open[i]].seconds += questions[i].seconds / std::max(options_.jobs, 1);
      if (questions[i].verdict.answer == Answer::Unknown) questions[i].verdict.method = "BMC, k-induction, IC3, simulation, explicit search";
      take(open[i], questions[i].verdict, &cones[i]);
    }
  }

  /// Turns a verdict about the cone (nullptr: about the whole bit system) into the answer of question q.
  void take(std::size_t q, const Verdict& verdict, const BitCone* cone) {
    QuestionAnswer& answer = answers_[q];
    answer.answer = verdict.answer;
    answer.depth = verdict.depth;
    answer.method = verdict.method;
    if (verdict.answer == Answer::Violated) {
      std::optional<BitTrace> trace = cone == nullptr ? verdict.trace : completeTrace(blast_->bits(), *cone, *verdict.trace);
      CHECK(trace.has_value(), "constraints outside the cone can always be met");
      answer.trace = blast_->wordTrace(*trace);
      answer.usesFreeReals = !blast_->unmodelled().empty();
    }
    if (verdict.answer == Answer::Proved) answer.certificate = wordCertificate(*verdict.certificate, cone);
  }

  /// A proof whose certificate Z3 does not confirm is not reported as one.
  void checkCertificates() {
    CertificateWriter writer(system_);
    std::vector<std::size_t> certified;
    for (std::size_t q = 0; q < answers_.size(); ++q) {
      if (!answers_[q].certificate) continue;
      certified.push_back(q);
      writer.add(system_.questions[q], *answers_[q].certificate);
    }
    if (certified.empty()) return;
    const std::vector<CheckResult> results = writer.check(std::max(options_.seconds, 10.0));
    for (std::size_t i = 0; i < certified.size(); ++i) {
      CHECK(results[i] != CheckResult::Invalid, "a certificate is wrong");
      if (results[i] == CheckResult::Valid) continue;
      QuestionAnswer& answer = answers_[certified[i]];
      answer.answer = Answer::Unknown;
      answer.method += " (certificate not checked in time)";
      answer.certificate.reset();
    }
  }

  WordCertificate wordCertificate(const Certificate& certificate, const BitCone* cone) {
    Graph& graph = *system_.graph;
    const auto latchNode = [&](std::uint32_t latch) { return blast_->nodeOf(positive(blast_->bits().latches[latch].variable)); };
    WordCertificate result;
    result.k = certificate.k;
    result.simplePath = certificate.simplePath;
    const BitSystem& bits = cone == nullptr ? blast_->bits() : cone->system;
    const auto original = [&](std::uint32_t latch) { return cone == nullptr ? latch : cone->latches[latch]; };
    std::vector<Node> gateNodes;
    const auto literal = [&](Lit l) {
      const std::uint32_t v = variableOf(l);
      Node n = noNode;
      if (v >= bits.variableCount()) {
        n = gateNodes[v - bits.variableCount()];
      } else if (bits.kind[v] == BitSystem::Kind::Latch) {
        n = latchNode(original(bits.position[v]));
      } else {
        CHECK(v == 0, "certificates are over latches");
        n = graph.constantNode(0, 1);
      }
      return isNegative(l) ? graph.make(Op::Not, 1, n) : n;
    };
    for (const AndGate& gate : certificate.gates) gateNodes.push_back(graph.make(Op::And, 1, literal(gate.left), literal(gate.right)));
    for (const std::vector<Lit>& clause : certificate.clauses) {
      Node n = graph.constantNode(0, 1);
      for (const Lit l : clause) n = graph.make(Op::Or, 1, n, literal(l));
      result.invariant.push_back(n);
    }
    if (certificate.simplePath) {
      for (std::uint32_t latch = 0; latch < bits.latches.size(); ++latch) result.pathBits.push_back(latchNode(original(latch)));
    }
    return result;
  }

  const TransitionSystem& system_;
  const PortfolioOptions options_;
  const Budget::Clock::time_point begin_ = Budget::Clock::now();
  std::unique_ptr<BitBlast> blast_;
  std::vector<QuestionAnswer> answers_;
};

}  // namespace

std::vector<QuestionAnswer> answerQuestions(const TransitionSystem& system, const PortfolioOptions& options) {
  return Portfolio(system, options).run();
}

}  // namespace rungproof
