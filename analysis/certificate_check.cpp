// The child writes one byte for each formula; the parent reads them as long as the limits allow, then ends it.
#include "analysis/certificate_check.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <z3++.h>

#include <algorithm>
#include <chrono>
#include <csignal>

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double quickSeconds = 0.3;  ///< for a plain strategy that starts fast, before Z3's own for QF_BV

z3::solver quickSolver(z3::context& context) {
  const auto step = [&](const char* name) { return z3::tactic(context, name); };
  return (step("simplify") & step("propagate-values") & step("solve-eqs") & step("simplify") & step("bit-blast") & step("simplify") & step("smt")).mk_solver();
}

CheckResult checkFormula(z3::context& context, const z3::expr& formula, double seconds) {
  for (const bool quick : {true, false}) {
    const double limit = quick ? std::min(seconds, quickSeconds) : seconds;
    if (limit <= 0) return CheckResult::Unknown;
    z3::solver solver = quick ? quickSolver(context) : z3::solver(context, "QF_BV");
    z3::params params(context);
    params.set("timeout", static_cast<unsigned>(std::max(1.0, limit * 1000)));
    solver.set(params);
    solver.add(formula);
    const z3::check_result result = solver.check();
    if (result == z3::unsat) return CheckResult::Valid;
    if (result == z3::sat) return CheckResult::Invalid;
  }
  return CheckResult::Unknown;
}

void writeResult(int pipe, CheckResult result) {
  const auto byte = static_cast<unsigned char>(result);
  if (write(pipe, &byte, 1) != 1) _exit(1);
}

/// The child's whole life.
[[noreturn]] void work(int pipe, const std::string& text, const std::vector<std::size_t>& owners, std::size_t ownerCount, const CheckLimits& limits) {
  if (limits.memory > 0) {
    const rlimit limit{limits.memory, limits.memory};
    setrlimit(RLIMIT_DATA, &limit);
  }
  std::signal(SIGINT, SIG_IGN);  // the parent decides what an interruption means
  try {
    z3::context context;
    const z3::expr_vector formulas = context.parse_string(text.c_str());
    if (formulas.size() != owners.size()) _exit(1);
    std::vector<double> left(ownerCount, limits.each);
    for (unsigned i = 0; i < formulas.size(); ++i) {
      const Clock::time_point begin = Clock::now();
      const CheckResult result = checkFormula(context, formulas[static_cast<int>(i)], left[owners[i]]);
      left[owners[i]] -= std::chrono::duration<double>(Clock::now() - begin).count();
      writeResult(pipe, result);
    }
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

/// The child's process and the end of its pipe that is read.
class Child {
 public:
  Child(pid_t process, int pipe) : process_(process), pipe_(pipe) {}
  ~Child() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(pipe_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The next result; nothing at the end of the child or of the time.
  bool read(CheckResult& result, Clock::time_point deadline, const std::atomic<bool>* cancel) const {
    while (Clock::now() < deadline && (cancel == nullptr || !cancel->load(std::memory_order_relaxed))) {
      pollfd waited{pipe_, POLLIN, 0};
      if (poll(&waited, 1, 10) <= 0) continue;
      unsigned char byte = 0;
      if (::read(pipe_, &byte, 1) != 1) return false;
      result = static_cast<CheckResult>(byte);
      return true;
    }
    return false;
  }

 private:
  pid_t process_;
  int pipe_;
};

}  // namespace

std::vector<CheckResult> checkApart(const std::string& text, const std::vector<std::size_t>& owners, std::size_t ownerCount, const CheckLimits& limits) {
  std::vector<CheckResult> results(ownerCount, CheckResult::Unknown);
  int pipes[2];
  if (pipe(pipes) != 0) return results;
  const pid_t process = fork();
  if (process == 0) work(pipes[1], text, owners, ownerCount, limits);
  close(pipes[1]);
  if (process < 0) {
    close(pipes[0]);
    return results;
  }
  const Child child(process, pipes[0]);
  const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(limits.total, 1e6)));
  std::vector<CheckResult> found(ownerCount, CheckResult::Valid);
  std::vector<std::size_t> open(ownerCount, 0);
  for (const std::size_t owner : owners) ++open[owner];
  for (const std::size_t owner : owners) {
    CheckResult result = CheckResult::Unknown;
    if (!child.read(result, deadline, limits.cancel)) break;
    --open[owner];
    if (found[owner] == CheckResult::Valid || result == CheckResult::Invalid) found[owner] = result;
  }
  for (std::size_t i = 0; i < ownerCount; ++i) results[i] = open[i] == 0 || found[i] == CheckResult::Invalid ? found[i] : CheckResult::Unknown;
  return results;
}

}  // namespace rungproof
