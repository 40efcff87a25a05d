// Results that are kept from one run to the next: what a command printed, under everything that it depends on - the
// program itself, the arguments, the names below the folders that were given, and the bytes of every file that was read
// or looked for. An entry is signed with a key of this user that lies outside the folder of the cache: one that was
// changed, or made by somebody else or by another program, is not believed. Tested by tests/cli/result_cache_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/command.hpp"

namespace rungproof {

struct KeptResult {
  std::string out, err;  ///< what was printed to either
  Exit exit = Exit::Clean;
};

class ResultCache {
 public:
  /// Nothing is kept if `folder` is empty, belongs to somebody else or is open to all, if texts are held in place of
  /// files, or if this user can have no key. Links in the folder are not followed.
  /// `question`: everything that was asked; `given`: files and folders of the command line.
  ResultCache(std::string folder, std::string question, const std::vector<std::string>& given);

  /// The result of an earlier run, if all that it depended on is as it was.
  std::optional<KeptResult> find() const;
  /// Keeps the result of the run that ends now; what it has read is known by then. Nothing is kept where one of these
  /// files may have changed since the run began, or where the folder cannot be written.
  void keep(const KeptResult& result) const;

  /// Why nothing is kept although a folder is named; empty if there is nothing to say.
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
  std::string file_;  ///< of the entry; empty: nothing is kept
  std::string question_;
  std::string key_;
  std::int64_t begin_ = 0;  ///< of the run, ns since 1970
};

/// A run that prints to its context; it says whether more time could say more.
using KeptWork = std::function<Exit(Context& context, bool& isFinal)>;
/// Repeats what is kept, or makes the run and keeps it if it is final and its exit code 0 or 1.
Exit repeatOrRun(const ResultCache& cache, Context& context, const KeptWork& work);

/// What a stream gets, as progress on a terminal overwrites itself: without it.
std::string withoutProgress(std::string_view text);

}  // namespace rungproof
