// The stages of a portfolio on one system, from what is cheap for all questions to a race of the engines on each.
// Tested by tests/solver/portfolio_test.cpp.
#pragma once

#include <vector>

#include "analysis/portfolio/portfolio.hpp"

namespace rungproof {

/// Answers about the system as it is, by question; others than `questions` are not looked at. Certificates are not
/// checked yet.
std::vector<QuestionAnswer> runStages(const TransitionSystem& system, const Questions& questions,
                                      const PortfolioOptions& options);

}  // namespace rungproof
