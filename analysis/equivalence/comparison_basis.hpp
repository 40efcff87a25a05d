// What a comparison assumes, why unread code leaves an output open, and which outputs a joined system asks about, all
// together or one by one.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/equivalence/both_runs.hpp"
#include "analysis/equivalence/product.hpp"
#include "analysis/portfolio/portfolio.hpp"

namespace rungproof {

/// The surroundings of both programs and how they are compared, one text each.
std::vector<std::string> assumptionTexts(const Side& before, const Side& after, const EquivalenceOptions& options);
/// Why unread code may decide the place; without one: why it may decide anything.
std::vector<std::string> reasonsFor(const UnreadCode& unread, const std::optional<Address>& address);
/// The outputs of the open questions.
std::vector<ObservedBit> observedOf(const JoinedSystem& merged, const std::vector<std::size_t>& open);
/// Whether an open question is whether both programs stop.
bool comparesStops(const JoinedSystem& merged, const std::vector<std::size_t>& open);
/// Whether any of the open questions is answered.
Node anyOf(Graph& graph, const std::vector<Question>& questions, const std::vector<std::size_t>& open);

/// One answer for each question of the system; Unknown where `broken` is told.
std::vector<QuestionAnswer> askedApart(const TransitionSystem& system,
                                       const std::function<QuestionAnswer(const TransitionSystem&)>& ask,
                                       const std::function<void(std::size_t, const std::exception&)>& broken);
/// whyBrokenOff(), and that it leaves the comparison open.
std::string defectText(const std::exception& error);

}  // namespace rungproof
