// The baseline file.
#include "frontend/linting/baseline.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "analysis/read_errors.hpp"
#include "engine/platform/names.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/files/json.hpp"
#include "frontend/linting/fingerprint.hpp"

namespace rungproof {

namespace {

constexpr unsigned formatVersion = 1;

/// The readers' errors and the tool's own findings are never part of a baseline.
bool belongsIn(const Finding& finding) { return !isReadError(finding) && !finding.rule.starts_with("SUP"); }

using Key = std::pair<std::string, std::string>;  // file, fingerprint

Key keyOf(const Finding& finding, const SourceSet& sources) {
  const std::string& name = sources.file(finding.span.file).name();
  return {std::filesystem::path(name).lexically_normal().generic_string(), fingerprintOf(finding, sources)};
}

}  // namespace

Baseline baselineOf(const Report& report) {
  std::map<std::tuple<std::string, std::string, std::string>, BaselineEntry> sorted;  // file, rule, fingerprint
  for (const Finding& finding : report.findings) {
    if (!belongsIn(finding)) continue;
    const auto [file, fingerprint] = keyOf(finding, *report.sources);
    const auto [entry, isNew] = sorted.emplace(std::tuple(file, finding.rule, fingerprint),
                                               BaselineEntry{fingerprint, finding.rule, file, finding.message});
    if (!isNew) ++entry->second.count;
  }
  Baseline baseline;
  for (auto& [key, entry] : sorted) baseline.entries.push_back(std::move(entry));
  return baseline;
}

std::string toJson(const Baseline& baseline) {
  std::string text = fmt::format("{{\n  \"rungproof_baseline\": {},\n  \"findings\": [", formatVersion);
  for (std::size_t i = 0; i < baseline.entries.size(); ++i) {
    const BaselineEntry& entry = baseline.entries[i];
    const Json row = {{"fingerprint", entry.fingerprint},
                      {"rule", entry.rule},
                      {"file", entry.file},
                      {"count", entry.count},
                      {"message", entry.message}};
    text += fmt::format("{}\n    {}", i == 0 ? "" : ",", row.dump());
  }
  return text + (baseline.entries.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::optional<Failure> readBaseline(const std::string& text, const std::string& name, Baseline& baseline) {
  const Failure damaged = {"the baseline file is damaged", name,
                           "write it again with 'rungproof baseline FILE... > " + name + "'"};
  const std::optional<Json> json = Json::read(text);
  const Json* findings = json ? json->find("findings") : nullptr;
  if (findings == nullptr || findings->kind() != Json::Kind::Array) return damaged;
  const Json* version = json->find("rungproof_baseline");
  if (version == nullptr || version->natural() != formatVersion) {
    return Failure{"the baseline file has a form that this version does not know", name, damaged.help};
  }
  std::size_t from = 0;
  for (const Json& row : findings->items()) {
    const auto textAt = [&row](std::string_view key) {
      const Json* value = row.find(key);
      return value != nullptr && value->kind() == Json::Kind::Text ? std::optional(value->text()) : std::nullopt;
    };
    const auto fingerprint = textAt("fingerprint"), rule = textAt("rule"), ofFile = textAt("file");
    if (!fingerprint || !rule || !ofFile) return damaged;
    BaselineEntry entry{*fingerprint, *rule, *ofFile, textAt("message").value_or("")};
    if (const Json* count = row.find("count"); count != nullptr && count->natural()) entry.count = *count->natural();
    const std::size_t at = text.find(entry.fingerprint, from);
    if (at != std::string::npos) {
      entry.offset = static_cast<std::uint32_t>(at);
      from = at + entry.fingerprint.size();
    }
    baseline.entries.push_back(std::move(entry));
  }
  return std::nullopt;
}

std::optional<Failure> readBaselineFile(const std::string& name, Baseline& baseline, std::string& text) {
  std::optional<std::string> bytes = bytesOfInput(name);
  if (!bytes)
    return Failure{"the baseline file cannot be read", name,
                   "write one with 'rungproof baseline FILE... > " + name + "'"};
  text = std::move(*bytes);
  return readBaseline(text, name, baseline);
}

namespace {

/// Whether two names may be spellings of one file: one ends in the other, folder by folder.
bool mayBeSameFile(const std::string& a, const std::string& b) {
  const auto parts = [](const std::string& name) {
    std::vector<std::string> result;
    for (const std::filesystem::path& part : std::filesystem::path(name).lexically_normal()) {
      if (part == ".." || part == "." || part == "/") continue;
      result.push_back(pathName(part));
    }
    return result;
  };
  const std::vector<std::string> left = parts(a), right = parts(b);
  const std::size_t count = std::min(left.size(), right.size());
  return count > 0 && std::equal(left.end() - static_cast<std::ptrdiff_t>(count), left.end(),
                                 right.end() - static_cast<std::ptrdiff_t>(count));
}

/// Removes from the findings what the entries allow; what is left of each entry's count, by entry.
std::vector<std::size_t> subtract(const Baseline& baseline, const SourceSet& sources, std::vector<Finding>& findings) {
  std::vector<std::size_t> left;
  std::map<std::string, std::vector<std::size_t>> byFingerprint;
  for (const BaselineEntry& entry : baseline.entries) {
    byFingerprint[entry.fingerprint].push_back(left.size());
    left.push_back(entry.count);
  }
  // Without a root of the project a file may be named from another folder than when the baseline was written.
  for (const bool bySpelling : {true, false}) {
    std::erase_if(findings, [&](const Finding& finding) {
      if (!belongsIn(finding)) return false;
      const auto [file, fingerprint] = keyOf(finding, sources);
      const auto entries = byFingerprint.find(fingerprint);
      if (entries == byFingerprint.end()) return false;
      for (const std::size_t i : entries->second) {
        const std::string& known = baseline.entries[i].file;
        if (left[i] == 0 || !(bySpelling ? known == file : mayBeSameFile(known, file))) continue;
        --left[i];
        return true;
      }
      return false;
    });
  }
  return left;
}

/// Whether the report is about that file: of others nobody knows whether the findings are still there.
bool isRead(const BaselineEntry& entry, const SourceSet& sources) {
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    if (mayBeSameFile(entry.file, sources.file(i).name())) return true;
  }
  return false;
}

}  // namespace

Baseline prunedBaseline(const Baseline& baseline, const Report& report) {
  std::vector<Finding> findings = report.findings;
  const std::vector<std::size_t> left = subtract(baseline, *report.sources, findings);
  Baseline pruned;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const bool isKnown = isRead(baseline.entries[i], *report.sources);
    if (isKnown && left[i] == baseline.entries[i].count) continue;
    pruned.entries.push_back(baseline.entries[i]);
    if (isKnown) pruned.entries.back().count -= left[i];
  }
  return pruned;
}

void applyBaseline(const Baseline& baseline, std::uint32_t file,
                   const std::function<bool(std::string_view)>& isSelected, Report& report) {
  const std::size_t before = report.findings.size();
  const std::vector<std::size_t> left = subtract(baseline, *report.sources, report.findings);
  report.baselined += before - report.findings.size();
  // Rules hold back where a text could not be read: what they do not report may still be there.
  if (std::ranges::any_of(report.findings, isReadError)) return;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const BaselineEntry& entry = baseline.entries[i];
    const std::size_t rest = left[i];
    if (rest == 0 || !isSelected(entry.rule) || !isRead(entry, *report.sources)) continue;
    Finding& stale = report.findings.emplace_back();
    stale.rule = "SUP003";
    stale.severity = Severity::Note;
    stale.span = {file, entry.offset, static_cast<std::uint32_t>(entry.fingerprint.size())};
    stale.message =
        fmt::format("{} in {} is gone{}: {}", entry.rule, entry.file,
                    rest < entry.count ? fmt::format(" in {} of {} places", rest, entry.count) : "", entry.message);
    stale.help = "write the baseline again to remove the entry";
  }
}

}  // namespace rungproof
