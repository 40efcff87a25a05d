// The naive interpreter: REAL numbers and the PID loop.
#include <bit>
#include <cmath>

#include "naive.hpp"

namespace rungproof::naive {

namespace {
float asReal(std::uint32_t v) { return std::bit_cast<float>(v); }
}  // namespace

/// After SM1.1 zero and negative mean nothing; the default for such bits is 0.
void Interpreter::storeReal(const Operand& to, float result, bool bad) {
  status(1, bad);
  status(0, !bad && result == 0);
  status(2, !bad && result < 0);
  if (bad)
    fail("SM1.1");
  else
    write(to, 4, std::bit_cast<std::uint32_t>(result));
}

bool Interpreter::realArithmetic(const Instruction& i, const std::string& name) {
  if (name.size() != 2 || name[1] != 'R') return false;
  const float a = asReal(read(i.operands[1], 4)), b = asReal(read(i.operands[0], 4));
  if (name[0] == '/') {
    status(3, b == 0);
    if (b == 0) return fail("SM1.3");
  }
  const float r = name[0] == '+' ? a + b : name[0] == '-' ? a - b : name[0] == '*' ? a * b : a / b;
  storeReal(i.operands[1], r, !std::isfinite(r) || !std::isfinite(a) || !std::isfinite(b));
  return true;
}

/// SQRT to EXP, and ROUND, TRUNC: what is no legal number or has no result sets SM1.1 (001:4976, 001:3499).
bool Interpreter::realFunction(const Instruction& i, const std::string& name) {
  if (name == "ROUND" || name == "TRUNC") {
    const double x = asReal(read(i.operands[0], 4));
    const double whole = name == "TRUNC" ? std::trunc(x) : x < 0 ? std::ceil(x - 0.5) : std::floor(x + 0.5);
    const bool bad = !std::isfinite(x) || whole > 2147483647.0 || whole < -2147483648.0;
    status(1, bad);
    if (bad) return fail("SM1.1");
    write(i.operands[1], 4, static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
    return true;
  }
  static const std::map<std::string, double (*)(double)> functions = {
      {"SQRT", std::sqrt}, {"SIN", std::sin},     {"COS", std::cos},     {"TAN", std::tan},    {"LN", std::log},
      {"EXP", std::exp},   {"ARCSIN", std::asin}, {"ARCCOS", std::acos}, {"ARCTAN", std::atan}};
  const auto function = functions.find(name);
  if (function == functions.end()) return false;
  const double x = asReal(read(i.operands[0], 4));
  const auto rounded = static_cast<float>(function->second(x));
  storeReal(i.operands[1], rounded, !std::isfinite(x) || !std::isfinite(rounded));
  return true;
}

/// PID TBL, LOOP: fields at 0 PV, 4 SP, 8 M, 12 Kc, 16 Ts, 20 Ti, 24 Td, 28 MX, 32 PV of the time before. Ts is in
/// seconds, Ti and Td in minutes (001:5315-5325).
void Interpreter::pid(const Instruction& i) {
  const auto loop = static_cast<std::size_t>(i.operands[1].value);
  const bool flow = power(), rises = flow && !pidHistory[loop];
  pidHistory[loop] = flow;
  eno = flow;
  if (!flow) return;
  std::array<double, 9> field{};
  for (int k = 0; k < 9; ++k) field[static_cast<std::size_t>(k)] = asReal(read(i.operands[0], 4, k));
  auto& [pv, sp, m, kc, ts, ti, td, mx, before] = field;
  const auto put = [&](int at, double value) {
    write(i.operands[0], 4, std::bit_cast<std::uint32_t>(static_cast<float>(value)), at);
  };
  const auto within = [](double x) { return x < 0 ? 0 : x > 1 ? 1 : x; };
  if (rises) {  // bumpless (001:5289)
    sp = before = pv;
    mx = m;
  }
  const double gain = kc == 0 ? 1 : kc;
  const double proportional = kc * (sp - pv), integral = gain * ts / (ti * 60) * (sp - pv) + mx;
  const double differential = gain * td * 60 / ts * (before - pv), sum = proportional + integral + differential;
  const bool bad = !std::isfinite(static_cast<float>(sum));
  status(1, bad);
  if (bad) {
    fail("SM1.1");
    return;
  }
  if (rises) put(1, sp);
  put(2, within(sum));
  put(7, within(sum > 1 ? 1 - (proportional + differential) : sum < 0 ? -(proportional + differential) : integral));
  put(8, pv);
}

}  // namespace rungproof::naive
