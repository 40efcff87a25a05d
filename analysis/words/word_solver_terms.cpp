// Words as Z3 terms. Literals are Boolean constants, each equal to its node by an assertion; clauses are assertions, a
// temporary clause lives under a constant that is assumed once.
#include <fmt/format.h>
#include <z3++.h>

#include <unordered_map>
#include <unordered_set>

#include "analysis/graph/z3_terms.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/words/word_solver.hpp"

namespace rungproof {

namespace {

class TermSolver final : public WordSolver {
 public:
  explicit TermSolver(const Graph& graph) : graph_(graph), terms_(context_, graph), solver_(context_) {}

  int literal(Node truth) override {
    const auto known = literals_.find(indexOf(truth));
    if (known != literals_.end()) return known->second;
    const int l = newLiteral();
    try {
      solver_.add(of(l) == terms_.truth(truth));
    } catch (const z3::exception&) {
      isBroken_ = true;
    }
    literals_.emplace(indexOf(truth), l);
    return l;
  }
  int newLiteral() override {
    constants_.push_back(context_.bool_const(fmt::format("l{}", constants_.size() + 1).c_str()));
    return static_cast<int>(constants_.size());
  }
  void add(std::span<const int> clause) override {
    z3::expr_vector parts(context_);
    for (const int l : clause) parts.push_back(of(l));
    solver_.add(z3::mk_or(parts));
  }
  Sat::Outcome solve(std::span<const int> assumptions, const Budget& budget, std::span<const int> temporary) override {
    if (isBroken_) return Sat::Outcome::Unknown;
    try {
      z3::expr_vector assumed(context_);
      for (const int l : assumptions) assumed.push_back(of(l));
      int switched = 0;
      if (!temporary.empty()) {
        switched = newLiteral();
        std::vector<int> clause(temporary.begin(), temporary.end());
        clause.push_back(-switched);
        add(clause);
        assumed.push_back(of(switched));
      }
      const Sat::Outcome outcome = check(assumed, budget);
      if (switched != 0) solver_.add(!of(switched));
      return outcome;
    } catch (const z3::exception&) {
      return Sat::Outcome::Unknown;
    }
  }
  bool failed(int literal) const override { return core_.contains(literal); }
  std::uint64_t value(Node variable) override {
    std::uint64_t result = 0;
    try {
      if (!model_->eval(terms_.term(variable), true).is_numeral_u64(result)) return 0;
    } catch (const z3::exception&) {
      isBroken_ = true;
    }
    return result;
  }
  void fix(Node variable, std::uint64_t value, std::vector<int>& literals) override {
    const std::string key = fmt::format("{} {}", indexOf(variable), value);
    const auto known = values_.find(key);
    if (known != values_.end()) {
      literals.push_back(known->second);
      return;
    }
    const int l = newLiteral();
    solver_.add(of(l) == (terms_.term(variable) == context_.bv_val(value, graph_[variable].width)));
    values_.emplace(key, l);
    literals.push_back(l);
  }

 private:
  z3::expr of(int literal) const {
    const z3::expr& constant = constants_[static_cast<std::size_t>(literal > 0 ? literal : -literal) - 1];
    return literal > 0 ? constant : !constant;
  }
  /// In slices that double, because Z3 does not ask whether it is still wanted.
  Sat::Outcome check(const z3::expr_vector& assumed, const Budget& budget) {
    core_.clear();
    model_.reset();
    for (double slice = schedule::firstTermSlice; !budget.isExhausted(); slice *= 2) {
      z3::params parameters(context_);
      parameters.set("timeout", static_cast<unsigned>(slice * 1000));
      solver_.set(parameters);
      z3::expr_vector asked = assumed;
      const z3::check_result result = solver_.check(asked);
      if (result == z3::sat) {
        model_ = std::make_unique<z3::model>(solver_.get_model());
        return Sat::Outcome::Satisfiable;
      }
      if (result == z3::unsat) {
        std::unordered_set<unsigned> failed;
        for (const z3::expr& part : solver_.unsat_core()) failed.insert(Z3_get_ast_id(context_, part));
        for (const auto& part : assumed) {
          if (!failed.contains(Z3_get_ast_id(context_, part))) continue;
          const bool isNegated = part.is_not();
          const std::string name = (isNegated ? part.arg(0) : part).decl().name().str();
          core_.insert((isNegated ? -1 : 1) * std::stoi(name.substr(1)));
        }
        return Sat::Outcome::Unsatisfiable;
      }
      if (slice > 1) break;
    }
    return Sat::Outcome::Unknown;
  }

  const Graph& graph_;
  z3::context context_;
  Z3Terms terms_;
  z3::solver solver_;
  std::vector<z3::expr> constants_;
  std::unordered_map<std::uint32_t, int> literals_;
  std::unordered_map<std::string, int> values_;
  std::unordered_set<int> core_;
  std::unique_ptr<z3::model> model_;
  bool isBroken_ = false;  ///< Z3 refused a term: nothing can be concluded any more
};

}  // namespace

std::unique_ptr<WordSolver> makeTermSolver(const Graph& graph) { return std::make_unique<TermSolver>(graph); }

}  // namespace rungproof
