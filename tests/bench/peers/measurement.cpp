// Rounds over the provers, each beginning with another one.
#include "tests/bench/peers/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace rungproof::peers {

namespace {

constexpr double soonSeconds = 0.5;  ///< a run as short as this is repeated

void keepBetter(Measured& kept, const Measured& again) {
  if (again.answer != Answer::Open && again.seconds < kept.seconds) kept = again;
}

/// A peer that only searches gets the time in which another one has proved the obligation, and is charged the limit.
Measured askWithin(const Peer& peer, const Exported& exported, const Row& row, double limit) {
  const bool isProved = std::ranges::any_of(row.peers, [](const Measured& m) { return m.answer == Answer::Safe; });
  const double own = peer.searchesOnly && isProved ? std::clamp(row.best(), 1.0, limit) : limit;
  Measured measured = askPeer(peer, exported, own);
  if (measured.answer == Answer::Open) measured.seconds = std::max(measured.seconds, limit);
  return measured;
}

}  // namespace

std::optional<Row> measure(const Obligation& obligation, const Measurement& measurement) {
  const Exported exported =
      exportObligation(obligation, measurement.rungproof, (measurement.folder / "obligation.aig").string());
  if (exported.file.empty()) return std::nullopt;
  const std::span<const Peer> peers = peerTable();
  Row row;
  row.obligation = obligation;
  row.ours = proveObligation(obligation, measurement.rungproof, measurement.limit, row.verdict);
  double limit = measurement.limit;
  if (measurement.patience > 0 && row.ours.answer != Answer::Open)
    limit = std::min(limit, std::max(1.0, std::ceil(measurement.patience * row.ours.seconds)));
  for (const Peer& peer : peers) row.peers.push_back(askWithin(peer, exported, row, limit));
  for (int round = 1; round < measurement.rounds; ++round) {
    for (std::size_t turn = 0; turn <= peers.size(); ++turn) {
      const std::size_t next = (turn + static_cast<std::size_t>(round)) % (peers.size() + 1);
      Measured& kept = next == peers.size() ? row.ours : row.peers[next];
      if (kept.seconds > soonSeconds) continue;
      std::string verdict;
      keepBetter(kept, next == peers.size()
                           ? proveObligation(obligation, measurement.rungproof, measurement.limit, verdict)
                           : askPeer(peers[next], exported, limit));
    }
  }
  return row;
}

}  // namespace rungproof::peers
