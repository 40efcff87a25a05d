// Totals, shares and quartiles, and how they are printed.
#include "tests/bench/peers/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof::peers {

namespace {

constexpr double allowedRatio = 1.5, allowedSeconds = 0.015;
constexpr std::size_t shownRows = 60;  ///< of a list in the text

/// The value below which `share` of them lie; 0 of none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double at = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const double above = low + 1 < values.size() ? values[low + 1] : values[low];
  return values[low] + (at - static_cast<double>(low)) * (above - values[low]);
}

bool isSettledByPeers(const Row& row) { return row.best() >= 0; }
bool isSettledByUs(const Row& row) { return row.ours.answer != Answer::Open; }

PeerFigures figuresOfPeer(const std::vector<Row>& rows, std::size_t peer) {
  PeerFigures figures;
  figures.name = peerTable()[peer].name;
  double ours = 0, oursOfBoth = 0, ownOfBoth = 0;
  std::vector<double> ratios;
  for (const Row& row : rows) {
    if (!isSettledByUs(row) && !isSettledByPeers(row)) continue;
    const Measured& own = row.peers[peer];
    ours += row.ours.seconds;
    figures.seconds += own.seconds;
    if (own.answer == Answer::Open) continue;
    ++figures.settled;
    if (!isSettledByUs(row)) continue;
    oursOfBoth += row.ours.seconds;
    ownOfBoth += own.seconds;
    ratios.push_back(row.ours.seconds / own.seconds);
  }
  figures.ratio = figures.seconds == 0 ? 0 : ours / figures.seconds;
  figures.ratioOfBoth = ownOfBoth == 0 ? 0 : oursOfBoth / ownOfBoth;
  figures.median = quantile(ratios, 0.5);
  figures.lowQuartile = quantile(ratios, 0.25);
  figures.highQuartile = quantile(ratios, 0.75);
  return figures;
}

bool isContradicted(const Row& row) {
  std::vector<Answer> answers{row.ours.answer, answerOfVerdict(row.obligation.stated)};
  for (const Measured& peer : row.peers) answers.push_back(peer.answer);
  return std::ranges::count(answers, Answer::Safe) > 0 && std::ranges::count(answers, Answer::Unsafe) > 0;
}

std::string lineOf(const Row& row) {
  std::string line = fmt::format("  {:8.3f} s", row.ours.seconds);
  for (std::size_t i = 0; i < row.peers.size(); ++i) {
    line += row.peers[i].answer == Answer::Open ? fmt::format("  {:>10}", "-")
                                                : fmt::format("  {:8.3f} s", row.peers[i].seconds);
  }
  return line + fmt::format("  {:<12} {} ({})\n", row.verdict, row.obligation.name(), row.obligation.group);
}

std::string listOf(const std::string& title, const std::vector<const Row*>& rows) {
  std::string text = fmt::format("{}: {}\n", title, rows.size());
  for (std::size_t i = 0; i < std::min(rows.size(), shownRows); ++i) text += lineOf(*rows[i]);
  return text;
}

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? "\"\"" : std::string(1, c);
  return all + "\"";
}

std::string_view nameOf(Answer answer) {
  return answer == Answer::Safe ? "safe" : answer == Answer::Unsafe ? "unsafe" : "open";
}

}  // namespace

double Row::best() const {
  double least = -1;
  for (const Measured& peer : peers) {
    if (peer.answer != Answer::Open && (least < 0 || peer.seconds < least)) least = peer.seconds;
  }
  return least;
}

Figures figuresOf(const std::vector<Row>& rows) {
  Figures figures;
  figures.obligations = rows.size();
  for (const Row& row : rows) {
    const bool isOurs = isSettledByUs(row), isTheirs = isSettledByPeers(row);
    if (isContradicted(row)) figures.contradicted.push_back(&row);
    if (isOurs || isTheirs) figures.seconds += row.ours.seconds;
    figures.settled += isOurs ? 1 : 0;
    figures.settledAlone += isOurs && !isTheirs ? 1 : 0;
    if (!isOurs && isTheirs) figures.leftOpen.push_back(&row);
    const bool isWithin = !isTheirs || (isOurs && row.ours.seconds <= allowedRatio * row.best() + allowedSeconds);
    figures.within += isWithin ? 1 : 0;
    if (isOurs && !isWithin) figures.lost.push_back(&row);
  }
  std::ranges::stable_sort(figures.lost, [](const Row* a, const Row* b) {
    return a->ours.seconds / a->best() > b->ours.seconds / b->best();
  });
  for (std::size_t i = 0; i < peerTable().size(); ++i) {
    figures.peers.push_back(figuresOfPeer(rows, i));
    if (figures.peers[i].seconds < figures.peers[figures.bestPeer].seconds) figures.bestPeer = i;
  }
  return figures;
}

std::string textOf(const Figures& figures) {
  std::string text = fmt::format("{} obligations; ours settles {} ({} of them no peer does) in {:.2f} s\n",
                                 figures.obligations, figures.settled, figures.settledAlone, figures.seconds);
  text += fmt::format("{:<12} {:>8} {:>10} {:>8} {:>12} {:>8} {:>17}\n", "peer", "settles", "seconds", "ratio",
                      "both settle", "median", "quartiles");
  for (const PeerFigures& peer : figures.peers) {
    text +=
        fmt::format("{:<12} {:>8} {:>8.2f} s {:>8.3f} {:>12.3f} {:>8.3f} {:>8.3f} {:>8.3f}\n", peer.name, peer.settled,
                    peer.seconds, peer.ratio, peer.ratioOfBoth, peer.median, peer.lowQuartile, peer.highQuartile);
  }
  text += fmt::format("total against the best single peer ({}): {:.3f}\n", figures.peers[figures.bestPeer].name,
                      figures.peers[figures.bestPeer].ratio);
  text += fmt::format("within {} times the quickest peer and {:.0f} ms: {} of {} ({:.1f} %)\n", allowedRatio,
                      1000 * allowedSeconds, figures.within, figures.obligations, 100 * figures.withinShare());
  std::string columns = fmt::format("  {:>10}", "ours");
  for (const PeerFigures& peer : figures.peers) columns += fmt::format("  {:>10}", peer.name);
  text += columns + "\n" + listOf("lost", figures.lost) + listOf("left open where a peer settles", figures.leftOpen) +
          listOf("contradictions", figures.contradicted);
  return text;
}

std::string markdownOf(const Figures& figures, const Conditions& conditions) {
  const std::string cut = conditions.patience > 0
                              ? fmt::format(", peers cut at {:g} times our time and charged that", conditions.patience)
                              : "";
  std::string text = fmt::format(
      "Measured {}: {} obligations, processor time of whole processes in one run, at most {:g} s each{}. rungproof "
      "settles {} in {:.1f} s, {} of them alone; a ratio below 1 means that it is quicker.\n\n",
      conditions.date, figures.obligations, conditions.limit, cut, figures.settled, figures.seconds,
      figures.settledAlone);
  text += "| berkeley-abc | settles | seconds | ratio of the totals | where both settle | median | middle half |\n";
  text += "|---|---|---|---|---|---|---|\n";
  for (const PeerFigures& peer : figures.peers) {
    text +=
        fmt::format("| `{}` | {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} to {:.2f} |\n", peer.name, peer.settled,
                    peer.seconds, peer.ratio, peer.ratioOfBoth, peer.median, peer.lowQuartile, peer.highQuartile);
  }
  text += fmt::format(
      "\nWithin {} times the quickest peer and {:.0f} ms: {:.1f} %. Lost: {}. Left open where a peer settles: {}.\n",
      allowedRatio, 1000 * allowedSeconds, 100 * figures.withinShare(), figures.lost.size(), figures.leftOpen.size());
  return text;
}

std::string historyHead() {
  return "version,date,limit,patience,obligations,settled,alone,seconds,best_peer,best_peer_seconds,ratio,ratio_both_"
         "settle,"
         "median,within,lost,left_open\n";
}

std::string historyLine(const Figures& figures, const Conditions& conditions) {
  const PeerFigures& best = figures.peers[figures.bestPeer];
  return fmt::format("{},{},{:g},{:g},{},{},{},{:.2f},{},{:.2f},{:.3f},{:.3f},{:.3f},{:.4f},{},{}\n",
                     conditions.version, conditions.date, conditions.limit, conditions.patience, figures.obligations,
                     figures.settled, figures.settledAlone, figures.seconds, best.name, best.seconds, best.ratio,
                     best.ratioOfBoth, best.median, figures.withinShare(), figures.lost.size(),
                     figures.leftOpen.size());
}

std::string rowsAsCsv(const std::vector<Row>& rows) {
  std::string text = "group,program,property,stated,verdict,ours";
  for (const Peer& peer : peerTable()) text += fmt::format(",{0} answer,{0}", peer.name);
  text += "\n";
  for (const Row& row : rows) {
    text += fmt::format("{},{},{},{},{},{:.4f}", row.obligation.group, row.obligation.program.stem().string(),
                        quoted(row.obligation.property), row.obligation.stated, row.verdict, row.ours.seconds);
    for (const Measured& peer : row.peers) text += fmt::format(",{},{:.4f}", nameOf(peer.answer), peer.seconds);
    text += "\n";
  }
  return text;
}

}  // namespace rungproof::peers
