// Reports of one run that several machines shared (prove --shard K/N), joined: each form from its text and back. What
// parts have in common stands once; what each found stands beside it. Tested by tests/cli/merge_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "frontend/files/exit.hpp"
#include "frontend/files/failure.hpp"
#include "frontend/files/json.hpp"

namespace rungproof {

struct PartFile {
  std::string name, text;
};

struct JoinedReport {
  std::string text;
  Exit exit = Exit::Clean;  ///< the worst of the parts
};

using JoinResult = std::variant<JoinedReport, Failure>;

/// By the form of the first file: JSON, SARIF or JUnit. All parts of one run have to be there, each once.
JoinResult joinParts(const std::vector<PartFile>& files);

/// What a part says of itself: "3/8" of --shard, and how its run ended.
struct PartMark {
  std::uint32_t part = 0, of = 0;
  int exit = 0;
  Json programs = Json::array();  ///< what its verdicts depend on (partJson() in report_part.hpp)
};
/// The mark as a value of JSON has it; nothing if it is none.
std::optional<PartMark> markOf(const Json& mark);

/// A part as far as it is compared with others.
struct NamedPart {
  const std::string& file;
  const Json& programs;
};
/// Why the two are not of one run: other texts, another CPU, other options.
std::optional<Failure> differenceOfRuns(const NamedPart& a, const NamedPart& b);
/// The places of the files by the number of their part, or what is missing or wrong.
std::variant<std::vector<std::size_t>, Failure> orderOfParts(const std::vector<PartFile>& files,
                                                             const std::vector<std::optional<PartMark>>& marks);
Exit worstExit(const std::vector<std::optional<PartMark>>& marks);

JoinResult joinJson(const std::vector<PartFile>& files);
JoinResult joinSarif(const std::vector<PartFile>& files);
JoinResult joinJunit(const std::vector<PartFile>& files);

}  // namespace rungproof
