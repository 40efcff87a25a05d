// The names of goals that are taken while the statements of a program and its files are read: each is looked up once,
// however many there are. Tested by tests/property/language_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "frontend/property/property_reader.hpp"

namespace rungproof {

class GoalNames {
 public:
  bool isTaken(const std::string& name, const PropertySet& set) {
    for (; seen_ < set.properties.size(); ++seen_) {
      if (set.properties[seen_].isGoal()) names_.insert(set.properties[seen_].name);
    }
    return names_.contains(name);
  }

 private:
  std::size_t seen_ = 0;  ///< properties of the set, which only grows
  std::unordered_set<std::string> names_;
};

/// readPropertyText() for one of several texts of a set.
void readPropertyText(std::uint32_t file, std::string_view text, std::uint32_t offset, const OperandLookup& lookup,
                      PropertySet& set, std::vector<Finding>& findings, const Target* target, GoalNames& names);

}  // namespace rungproof
