// Proofs on the surface of a property: found where the reason is near, with certificates that Z3 accepts; not found
// where the state decides.
#include "analysis/portfolio/local_proof.hpp"

#include <gtest/gtest.h>

#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "families.hpp"

namespace rungproof {
namespace {

using families::Family;

std::optional<std::vector<Node>> prove(const Family& f, std::size_t question = 0) {
  return proveLocally(f.system, f.system.questions[question].bad, Budget::seconds(10));
}

/// A long sum decides a truth value; the property is about what is made of that.
struct Deep : Family {
  Node sum, deep;
  Deep() {
    sum = state("x", 16);
    for (int i = 0; i < 40; ++i) {
      const Node in = input("in" + std::to_string(i), 16);
      sum = graph->make(Op::Xor, 16, graph->make(Op::Add, 16, sum, in), graph->make(Op::Mul, 16, sum, number(3, 16)));
    }
    deep = atLeast(sum, 1000);
  }
};

TEST(LocalProof, LooksNoDeeperThanNeeded) {
  Deep f;
  const Node a = f.input("a"), b = f.input("b");
  // first = deep & a, second = !first & b: never both.
  const Node first = f.both(f.deep, f.either(a, f.both(b, f.deep)));
  f.ask("both", f.both(f.both(first, b), f.both(f.no(first), f.either(a, b))));
  f.ask("mixed", f.both(f.choose(first, a, b), f.both(first, f.no(a))));
  for (std::size_t q = 0; q < 2; ++q) {
    if (f.system.questions[q].bad == f.number(0, 1)) continue;
    const std::optional<std::vector<Node>> open = prove(f, q);
    ASSERT_TRUE(open.has_value()) << q;
    WordCertificate certificate;
    certificate.open = *open;
    CertificateWriter writer(f.system);
    writer.add(f.system.questions[q], certificate);
    EXPECT_EQ(writer.check({}), std::vector<CheckResult>{CheckResult::Valid});
    // The sum is not part of it.
    EXPECT_EQ(writer.text().find("bvmul"), std::string::npos);
  }
}

TEST(LocalProof, WrongSurfaceIsRefused) {
  Family f;
  const Node x = f.state("x", 8), in = f.input("in", 8);
  const Node low = f.graph->make(Op::And, 8, x, in);
  f.ask("larger", f.graph->make(Op::Ult, 1, x, low));
  ASSERT_TRUE(prove(f).has_value());  // x & in is never above x
  WordCertificate certificate;
  certificate.open = {low};
  CertificateWriter writer(f.system);
  writer.add(f.system.questions[0], certificate);
  EXPECT_EQ(writer.check({}), std::vector<CheckResult>{CheckResult::Invalid});
}

TEST(LocalProof, StateIsNotItsBusiness) {
  Family f;
  const Node x = f.state("x"), y = f.state("y"), in = f.input("in");
  f.next(x, in);
  f.next(y, in);
  f.ask("differ", f.differ(x, y));
  EXPECT_FALSE(prove(f).has_value());
  EXPECT_EQ(answerQuestions(f.system, {})[0].answer, Answer::Proved);
}

TEST(LocalProof, ManyOrderedTimersOfAChainEachAtOnce) {
  // After a scan, the bit of a timer is on only if that of the timer before is: it is its input.
  Family f;
  Node running = f.input("start");
  std::vector<Node> after;
  for (int i = 0; i < 40; ++i) {
    const Node before = running;
    const Node value = f.state("v" + std::to_string(i), 16);
    const Node now = f.counted(value, before, 32767);
    f.next(value, now);
    running = f.both(before, f.atLeast(now, 100 + static_cast<std::uint64_t>(i)));
    after.push_back(running);
    if (i > 0) f.ask("order", f.both(after[static_cast<std::size_t>(i)], f.no(after[static_cast<std::size_t>(i) - 1])));
  }
  for (const QuestionAnswer& answer : answerQuestions(f.system, {})) EXPECT_EQ(answer.method, "one scan");
}

}  // namespace
}  // namespace rungproof
