// What happens at one place of a scan where interrupts can come (scan_interrupts.cpp).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "analysis/encoding/scan_encoding.hpp"

namespace rungproof {

struct ScanEncoding::Round {
  BoundarySite where;
  bool isEnd = false;  ///< after the program
  bool isLastPass = false;
  std::vector<int> events{};         ///< that can be noticed here, by priority
  std::map<Place, Node> before{};    ///< what routines can change, as it was in front of the place
  Graph::Bool hasChanged{};          ///< the last pass has changed something
  Graph::Bool mustGoOn{};            ///< more runs come than are followed
  Graph::Bool mayGoOn{};             ///< they may come whether or not anything has changed
  std::set<int> ran{};               ///< routines
  std::map<Place, ValueSet> kept{};  ///< what all runs keep of cells here, whether or not one comes
  /// Where one event alone can come: it did in the pass before. To come in the second only is to come in the first.
  std::optional<Graph::Bool> cameBefore{};
};

}  // namespace rungproof
