// Small numbers go by their decimals, large ones by their leading digits.
#include "analysis/testing/rounded_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rungproof {

namespace {

constexpr int mostDecimals = 3;
constexpr TraceNumber largeFrom = 1e6;

/// As the controller holds it.
TraceNumber asHeld(TraceNumber value, const TraceSignal& signal) {
  return numberOf(valueOf(value, signal.type, signal.width()), signal.type, signal.width());
}

TraceNumber roundedTo(TraceNumber value, int decimals, bool isUp) {
  const TraceNumber size = std::abs(value);
  const int lead = size < largeFrom ? 0 : static_cast<int>(std::floor(std::log10(size)));
  const TraceNumber unit = std::pow(TraceNumber{10}, static_cast<TraceNumber>(lead - decimals));
  return (isUp ? std::ceil(value / unit) : std::floor(value / unit)) * unit;
}

}  // namespace

std::size_t digitsOf(TraceNumber value, const TraceSignal& signal) {
  const std::string text = numberText(value, signal.type);
  const std::size_t mark = std::min(text.find('e'), text.size());
  std::string digits;
  std::size_t decimals = 0;
  for (std::size_t i = 0; i < mark; ++i) {
    const bool isDigit = text[i] >= '0' && text[i] <= '9';
    if (isDigit && (!digits.empty() || text[i] != '0')) digits += text[i];
    if (isDigit && text.find('.') < i) ++decimals;
  }
  const int exponent = mark < text.size() ? std::stoi(text.substr(mark + 1)) : 0;
  if (exponent < 0) decimals += static_cast<std::size_t>(-exponent);
  while (!digits.empty() && digits.back() == '0' && decimals == 0) digits.pop_back();
  return std::max(digits.size(), decimals);
}

bool canBeSet(const BenchTest& steps, const TestSignals& signals) {
  return std::ranges::all_of(steps, [&](const BenchStep& step) {
    return std::ranges::all_of(step.changes, [&](const auto& change) {
      const TraceSignal& signal = signals.inputs[change.first].signal;
      return !signal.isReal() || digitsOf(change.second, signal) <= mostDigits;
    });
  });
}

std::vector<BenchTest> roundedSteps(const BenchTest& steps, const TestSignals& signals) {
  std::vector<BenchTest> results;
  for (int decimals = 0; decimals <= mostDecimals; ++decimals) {
    for (const bool isUp : {false, true}) {
      BenchTest easy = steps;
      bool isOther = false;
      for (BenchStep& step : easy) {
        for (auto& [input, value] : step.changes) {
          const TraceSignal& signal = signals.inputs[input].signal;
          if (!signal.isReal() || !std::isfinite(value) || digitsOf(value, signal) <= easyDigits) continue;
          value = asHeld(roundedTo(value, decimals, isUp), signal);
          isOther = true;
        }
      }
      if (isOther) results.push_back(std::move(easy));
    }
  }
  return results;
}

}  // namespace rungproof
