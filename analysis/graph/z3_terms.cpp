// Translation of nodes to Z3 terms, children first, without recursion.
#include "analysis/graph/z3_terms.hpp"

#include <fmt/format.h>
#include <z3++.h>

#include "analysis/graph/evaluate.hpp"
#include "ir/check.hpp"

namespace rungproof {

class Z3Terms::Impl {
 public:
  Impl(z3::context& context, const Graph& graph) : c(context), g(graph) {}

  z3::expr term(Node root) {
    grow();
    if (!terms_[indexOf(root)]) {
      const Node roots[] = {root};
      for (const Node n : coneOf(g, roots)) {
        if (!terms_[indexOf(n)]) terms_[indexOf(n)] = std::make_unique<z3::expr>(build(n));
      }
    }
    return *terms_[indexOf(root)];
  }

  z3::context& c;
  const Graph& g;

 private:
  void grow() {
    if (terms_.size() < g.size()) terms_.resize(g.size());
  }
  const z3::expr& at(Node n) const { return *terms_[indexOf(n)]; }
  z3::expr bit(const z3::expr& truth) { return z3::ite(truth, c.bv_val(1, 1), c.bv_val(0, 1)); }
  z3::expr real(const z3::expr& pattern) { return pattern.mk_from_ieee_bv(c.fpa_sort<32>()); }
  /// NaN has one pattern, that of Concrete::pattern().
  z3::expr pattern(const z3::expr& value) {
    return z3::ite(value.mk_is_nan(), c.bv_val(0x7FC00000U, 32), value.mk_to_ieee_bv());
  }
  z3::expr build(Node n);
  z3::expr toInteger(const z3::expr& pattern, bool round);

  std::vector<std::unique_ptr<z3::expr>> terms_;
};

z3::expr Z3Terms::Impl::toInteger(const z3::expr& bits, bool round) {
  const z3::expr value = real(bits);
  // Halves away from zero: nearest, ties to away. Beyond 9.0e18 the engine saturates.
  const z3::expr mode(c, round ? Z3_mk_fpa_round_nearest_ties_to_away(c) : Z3_mk_fpa_round_toward_zero(c));
  const z3::expr converted(c, Z3_mk_fpa_to_sbv(c, mode, value, 64));
  const z3::expr limit = c.fpa_val(9.0e18F);
  const z3::expr inside = -limit < value && value < limit;
  const z3::expr negative = value < c.fpa_val(0.0F);
  const z3::expr least = c.bv_val(std::uint64_t{1} << 63, 64), most = c.bv_val((std::uint64_t{1} << 63) - 1, 64);
  return z3::ite(inside, converted, z3::ite(negative, least, most));
}

z3::expr Z3Terms::Impl::build(Node node) {
  const NodeData& n = g[node];
  const unsigned width = n.width;
  const auto arg = [&](std::size_t i) -> const z3::expr& { return at(n.child[i]); };
  const auto argWidth = [&](std::size_t i) { return static_cast<unsigned>(g[n.child[i]].width); };
  switch (n.op) {
    case Op::Constant: return c.bv_val(static_cast<std::uint64_t>(n.value), width);
    case Op::Variable: return c.bv_const(fmt::format("v{}", n.value).c_str(), width);
    case Op::Not: return ~arg(0);
    case Op::And: return arg(0) & arg(1);
    case Op::Or: return arg(0) | arg(1);
    case Op::Xor: return arg(0) ^ arg(1);
    case Op::Add: return arg(0) + arg(1);
    case Op::Sub: return arg(0) - arg(1);
    case Op::Mul: return arg(0) * arg(1);
    case Op::Udiv: return z3::udiv(arg(0), arg(1));
    case Op::Urem: return z3::urem(arg(0), arg(1));
    case Op::Sdiv: return arg(0) / arg(1);
    case Op::Srem: return z3::srem(arg(0), arg(1));
    case Op::Shl: return z3::shl(arg(0), arg(1));
    case Op::Lshr: return z3::lshr(arg(0), arg(1));
    case Op::Equal: return bit(arg(0) == arg(1));
    case Op::Ult: return bit(z3::ult(arg(0), arg(1)));
    case Op::Ule: return bit(z3::ule(arg(0), arg(1)));
    case Op::Slt: return bit(arg(0) < arg(1));
    case Op::Sle: return bit(arg(0) <= arg(1));
    case Op::Ite: return z3::ite(arg(0) == c.bv_val(1, 1), arg(1), arg(2));
    case Op::Concat: return z3::concat(arg(0), arg(1));
    case Op::Extract: return arg(0).extract(static_cast<unsigned>(n.value) + width - 1, static_cast<unsigned>(n.value));
    case Op::Zext: return z3::zext(arg(0), width - argWidth(0));
    case Op::Sext: return z3::sext(arg(0), width - argWidth(0));
    case Op::RealAdd: return pattern(real(arg(0)) + real(arg(1)));
    case Op::RealSub: return pattern(real(arg(0)) - real(arg(1)));
    case Op::RealMul: return pattern(real(arg(0)) * real(arg(1)));
    case Op::RealDiv: return pattern(real(arg(0)) / real(arg(1)));
    case Op::RealFunction: {
      if (static_cast<RealFunction>(n.value) == RealFunction::Sqrt) {
        const z3::expr mode(c, Z3_mk_fpa_round_nearest_ties_to_even(c));
        return pattern(z3::expr(c, Z3_mk_fpa_sqrt(c, mode, real(arg(0)))));
      }
      // No theory for the others: an unknown function of the argument.
      const z3::func_decl f = c.function(fmt::format("real{}", n.value).c_str(), c.bv_sort(32), c.bv_sort(32));
      return f(arg(0));
    }
    case Op::RealEqual: return bit(z3::expr(c, Z3_mk_fpa_eq(c, real(arg(0)), real(arg(1)))));
    case Op::RealLess: return bit(real(arg(0)) < real(arg(1)));
    case Op::RealLegal: {
      const z3::expr value = real(arg(0));
      return bit(!value.mk_is_nan() && !value.mk_is_inf());
    }
    case Op::RealFromInt: return pattern(z3::sbv_to_fpa(arg(0), c.fpa_sort<32>()));
    case Op::RealToInt: return toInteger(arg(0), n.value != 0);
    case Op::LongReal: {  // an unknown function of the numbers
      z3::sort_vector sorts(c);
      z3::expr_vector numbers(c);
      for (std::size_t i = 0; i < 2 && n.child[i] != noNode; ++i) {
        numbers.push_back(arg(i));
        sorts.push_back(arg(i).get_sort());
      }
      return c.function(fmt::format("lreal{}_{}", n.value, width).c_str(), sorts, c.bv_sort(width))(numbers);
    }
  }
  CHECK(false, "operation without a term");
  return c.bv_val(0, 1);
}

Z3Terms::Z3Terms(z3::context& context, const Graph& graph) : impl_(std::make_unique<Impl>(context, graph)) {}
Z3Terms::~Z3Terms() = default;
z3::expr Z3Terms::term(Node node) { return impl_->term(node); }
z3::expr Z3Terms::truth(Node node) { return impl_->term(node) == impl_->c.bv_val(1, 1); }

std::optional<bool> satisfiable(const Graph& graph, std::span<const Node> conditions, unsigned milliseconds,
                                std::span<const Node> wanted, std::vector<std::uint64_t>* witness, unsigned steps) {
  try {
    z3::context context;
    Z3Terms terms(context, graph);
    z3::solver solver(context);
    z3::params parameters(context);
    parameters.set("timeout", milliseconds);
    if (steps != 0) parameters.set("rlimit", steps);
    solver.set(parameters);
    for (const Node condition : conditions) solver.add(terms.truth(condition));
    switch (solver.check()) {
      case z3::unsat: return false;
      case z3::unknown: return std::nullopt;
      case z3::sat: break;
    }
    if (witness == nullptr) return true;
    const z3::model model = solver.get_model();
    witness->clear();
    for (const Node n : wanted) {
      std::uint64_t value = 0;
      if (!model.eval(terms.term(n), true).is_numeral_u64(value)) return std::nullopt;
      witness->push_back(value);
    }
    return true;
  } catch (const z3::exception&) {
    return std::nullopt;
  }
}

std::string smtLibText(const Graph& graph, std::span<const Node> conditions) {
  try {
    z3::context context;
    Z3Terms terms(context, graph);
    z3::solver solver(context);
    for (const Node condition : conditions) solver.add(terms.truth(condition));
    return solver.to_smt2();
  } catch (const z3::exception&) {
    return {};
  }
}

}  // namespace rungproof
