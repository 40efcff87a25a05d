// The child writes one byte for each formula; the parent reads them as long as the limits allow, then ends it.
#include "analysis/recheck/z3_check.hpp"

#include <fmt/format.h>
#include <z3++.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

#include "analysis/schedule/schedule.hpp"
#include "engine/platform/child_process.hpp"

namespace rungproof {

namespace {

using Clock = std::chrono::steady_clock;

z3::solver quickSolver(z3::context& context) {
  const auto step = [&](const char* name) { return z3::tactic(context, name); };
  return (step("simplify") & step("propagate-values") & step("solve-eqs") & step("simplify") & step("bit-blast") &
          step("simplify") & step("solve-eqs") & step("smt"))
      .mk_solver();
}

CheckResult checkFormula(z3::context& context, const z3::expr& formula, double seconds) {
  for (const bool quick : {true, false}) {
    const double limit = quick ? std::min(seconds, schedule::plainCheckSeconds) : seconds;
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

/// The formula up to the names of its variables: each node as its operation and the numbers of its arguments, nodes and
/// variables numbered as they are met first. Formulas with one form are satisfiable or not together.
std::vector<unsigned> formOf(z3::context& context, const z3::expr& formula) {
  std::vector<unsigned> form;
  std::unordered_map<unsigned, unsigned> number;
  std::vector<Z3_ast> stack{formula};
  while (!stack.empty()) {
    const Z3_ast top = stack.back();
    const unsigned id = Z3_get_ast_id(context, top);
    if (number.contains(id)) {
      stack.pop_back();
      continue;
    }
    const Z3_app app = Z3_to_app(context, top);
    const unsigned count = Z3_get_app_num_args(context, app);
    const std::size_t before = stack.size();
    for (unsigned i = count; i-- > 0;) {
      const Z3_ast argument = Z3_get_app_arg(context, app, i);
      if (!number.contains(Z3_get_ast_id(context, argument))) stack.push_back(argument);
    }
    if (stack.size() > before) continue;
    stack.pop_back();
    const Z3_func_decl operation = Z3_get_app_decl(context, app);
    if (count == 0 && Z3_get_decl_kind(context, operation) == Z3_OP_UNINTERPRETED) {
      form.insert(form.end(), {0, Z3_get_ast_id(context, Z3_sort_to_ast(context, Z3_get_sort(context, top)))});
    } else {
      form.insert(form.end(), {count + 1, Z3_get_ast_id(context, Z3_func_decl_to_ast(context, operation))});
      for (unsigned i = 0; i < count; ++i)
        form.push_back(number.at(Z3_get_ast_id(context, Z3_get_app_arg(context, app, i))));
    }
    number.emplace(id, static_cast<unsigned>(number.size()));
  }
  return form;
}

/// Whether it equates words that are no numbers: a theorem about sums, which is easy once one side has been put in
/// place of the other, and hard as a part of a disjunction, where it cannot.
bool equatesWords(const z3::expr& formula) {
  if (!formula.is_and()) return false;
  for (unsigned i = 0; i < formula.num_args(); ++i) {
    const z3::expr part = formula.arg(i);
    if (part.is_eq() && part.arg(0).is_bv() && !part.arg(0).is_numeral() && !part.arg(1).is_numeral()) return true;
  }
  return false;
}

/// Whether it multiplies words with each other, or divides: time limits do not hold while that is written out in gates.
bool multiplies(const z3::expr& formula) {
  std::unordered_set<unsigned> seen;
  std::vector<z3::expr> stack{formula};
  while (!stack.empty()) {
    const z3::expr top = stack.back();
    stack.pop_back();
    if (!seen.insert(top.id()).second) continue;
    const Z3_decl_kind kind = top.decl().decl_kind();
    if (kind == Z3_OP_BUDIV || kind == Z3_OP_BSDIV || kind == Z3_OP_BUREM || kind == Z3_OP_BSREM) return true;
    int words = 0;
    for (unsigned i = 0; i < top.num_args(); ++i) {
      words += top.arg(i).is_numeral() ? 0 : 1;
      stack.push_back(top.arg(i));
    }
    if (kind == Z3_OP_BMUL && words > 1) return true;
  }
  return false;
}

/// The formulas by their forms: properties of equal parts of a program lead to equal forms.
class GateForms {
 public:
  /// `formulas`: an application to true and the formulas.
  GateForms(z3::context& context, const z3::expr& formulas) : context_(context), formulas_(formulas) {
    for (unsigned i = 0; i + 1 < formulas.num_args(); ++i)
      forms_.push_back(known_.try_emplace(formOf(context, formulas.arg(i + 1))).first);
  }

  CheckResult& result(std::size_t i) { return forms_[i]->second.result; }

  /// A solver's start takes longer than many a formula. So small ones, from the i-th on, are asked for together: if
  /// their disjunction is unsatisfiable, each of them is.
  void checkWithNext(std::size_t i) {
    if (!isOpen(i)) return;
    z3::expr_vector together(context_);
    std::vector<Known*> taken;
    std::size_t size = 0;
    for (; i < forms_.size() && size < schedule::jointFormulas; ++i) {
      if (!isOpen(i)) continue;
      const z3::expr formula = formulas_.arg(static_cast<unsigned>(i) + 1);
      forms_[i]->second.isTried = true;
      if (equatesWords(formula) || multiplies(formula)) continue;
      size += forms_[i]->first.size();
      together.push_back(formula);
      taken.push_back(&forms_[i]->second);
    }
    if (taken.size() < 2 || checkFormula(context_, z3::mk_or(together), schedule::jointSeconds) != CheckResult::Valid)
      return;
    for (Known* known : taken) known->result = CheckResult::Valid;
  }

 private:
  struct Known {
    CheckResult result = CheckResult::Unknown;
    bool isTried = false;
  };
  bool isOpen(std::size_t i) const {
    return !forms_[i]->second.isTried && forms_[i]->first.size() <= schedule::smallFormula;
  }

  z3::context& context_;
  const z3::expr formulas_;
  std::map<std::vector<unsigned>, Known> known_;
  std::vector<std::map<std::vector<unsigned>, Known>::iterator> forms_;  ///< by formula
};

/// What the child gets: seconds for each owner, the number of owners, the owner of each formula, then the text.
std::string formulaRequest(const std::string& text, const std::vector<std::size_t>& owners, std::size_t ownerCount,
                           const CheckLimits& limits) {
  std::string request = fmt::format("{} {} {}", std::min(limits.each, 1e9), ownerCount, owners.size());
  for (const std::size_t owner : owners) request += fmt::format(" {}", owner);
  return request + '\n' + text;
}

/// The child's whole life.
int checkRequested(const std::string& request, const GiveBytes& give) {
  const std::size_t headEnd = request.find('\n');
  if (headEnd == std::string::npos) return 1;
  std::istringstream head(request.substr(0, headEnd));
  double each = 0;
  std::size_t ownerCount = 0, count = 0;
  head >> each >> ownerCount >> count;
  std::vector<std::size_t> owners(head ? count : 0);
  for (std::size_t& owner : owners) head >> owner;
  if (!head || std::ranges::any_of(owners, [&](std::size_t owner) { return owner >= ownerCount; })) return 1;
  z3::context context;
  const z3::expr_vector assertions = context.parse_string(request.c_str() + headEnd + 1);
  if (assertions.size() != 1 || assertions[0].num_args() != owners.size() + 1) return 1;
  const z3::expr formulas = assertions[0];
  std::vector<double> left(ownerCount, each);
  GateForms known(context, formulas);
  for (unsigned i = 0; i < owners.size(); ++i) {
    const Clock::time_point begin = Clock::now();
    known.checkWithNext(i);
    CheckResult& result = known.result(i);
    if (result == CheckResult::Unknown) result = checkFormula(context, formulas.arg(i + 1), left[owners[i]]);
    left[owners[i]] -= std::chrono::duration<double>(Clock::now() - begin).count();
    const char byte = static_cast<char>(result);
    if (!give({&byte, 1})) return 1;
  }
  return 0;
}

/// The results as they come.
class ComingResults {
 public:
  explicit ComingResults(ByteSource& source) : source_(source) {}

  /// The next result; nothing at the end of the child or of the time.
  bool read(CheckResult& result, Clock::time_point deadline, const std::atomic<bool>* cancel) {
    while (Clock::now() < deadline && (cancel == nullptr || !cancel->load(std::memory_order_relaxed))) {
      if (!come_.empty()) {
        result = static_cast<CheckResult>(come_.front());
        come_.erase(0, 1);
        return true;
      }
      const Waitable* const waited = &source_;
      if (waitForAny({&waited, 1}, 10).front() && source_.take(come_) == ByteSource::Taken::End) return false;
    }
    return false;
  }

 private:
  ByteSource& source_;
  std::string come_;
};

}  // namespace

constinit const Worker formulaWorker = {"formulas", checkRequested};

std::vector<CheckResult> checkApart(const std::string& text, const std::vector<std::size_t>& owners,
                                    std::size_t ownerCount, const CheckLimits& limits) {
  std::vector<CheckResult> results(ownerCount, CheckResult::Unknown);
  ChildProcess child(formulaWorker, formulaRequest(text, owners, ownerCount, limits), ChildKind::Check, limits.memory);
  if (!child.hasBegun()) return results;
  ComingResults come(child.output());
  const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                        std::chrono::duration<double>(std::min(limits.total, 1e6)));
  std::vector<CheckResult> found(ownerCount, CheckResult::Valid);
  std::vector<std::size_t> open(ownerCount, 0);
  for (const std::size_t owner : owners) ++open[owner];
  for (const std::size_t owner : owners) {
    CheckResult result = CheckResult::Unknown;
    if (!come.read(result, deadline, limits.cancel)) break;
    --open[owner];
    if (found[owner] == CheckResult::Valid || result == CheckResult::Invalid) found[owner] = result;
  }
  for (std::size_t i = 0; i < ownerCount; ++i)
    results[i] = open[i] == 0 || found[i] == CheckResult::Invalid ? found[i] : CheckResult::Unknown;
  return results;
}

}  // namespace rungproof
