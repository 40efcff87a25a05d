// From the measurements to figures: ratios, medians, spreads, what is lost and what is left open; as text for people,
// as the Markdown table that README quotes, and as a line of the history.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/peers/contender.hpp"

namespace rungproof::peers {

struct Row {
  Obligation obligation;
  std::string verdict;  ///< ours
  Measured ours;
  std::vector<Measured> peers;  ///< as peerTable()

  /// Processor time of the quickest peer that settles it; negative if none does.
  double best() const;
};

struct PeerFigures {
  std::string name;
  std::size_t settled = 0;
  double seconds = 0;      ///< over what anybody settles; what it leaves open counts as the limit, or more
  double ratio = 0;        ///< of the totals, ours to its own, over what anybody settles
  double ratioOfBoth = 0;  ///< of the totals over what both settle
  double median = 0, lowQuartile = 0, highQuartile = 0;  ///< of the ratios of single obligations, which both settle
};

struct Figures {
  std::size_t obligations = 0, settled = 0, settledAlone = 0;
  double seconds = 0;  ///< ours, over what anybody settles
  std::vector<PeerFigures> peers;
  std::size_t bestPeer = 0;              ///< index of the peer with the least total
  std::size_t within = 0;                ///< at most 1.5 times the quickest peer and 15 ms more
  std::vector<const Row*> lost;          ///< the others that we settle, worst ratio first
  std::vector<const Row*> leftOpen;      ///< a peer settles them, we do not
  std::vector<const Row*> contradicted;  ///< a peer or what is stated says otherwise

  double withinShare() const {
    return obligations == 0 ? 0 : static_cast<double>(within) / static_cast<double>(obligations);
  }
};

/// When and how it was measured.
struct Conditions {
  std::string version, date;
  double limit = 0;     ///< s of processor time
  double patience = 0;  ///< Measurement::patience
};

/// The rows must outlive the figures.
Figures figuresOf(const std::vector<Row>& rows);

/// Ratios, medians, spreads, and the obligations lost and left open, one a line.
std::string textOf(const Figures& figures);
/// The table of README, with the date and what it was measured on.
std::string markdownOf(const Figures& figures, const Conditions& conditions);
/// One line with the names of the columns, and one of figures.
std::string historyHead();
std::string historyLine(const Figures& figures, const Conditions& conditions);
/// Each obligation with all its times, as comma-separated values.
std::string rowsAsCsv(const std::vector<Row>& rows);

}  // namespace rungproof::peers
