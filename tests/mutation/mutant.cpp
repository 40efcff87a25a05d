// Collecting sites and answering which change is to be made.
#include "tests/mutation/mutant.hpp"

#include <algorithm>
#include <array>

#include "ir/desc.hpp"

namespace rungproof::mutation {

namespace {

struct OpInfo {
  std::string_view name;
  std::vector<std::string_view> changes;
};

const OpInfo& infoOf(Op op) {
  static const std::array<OpInfo, static_cast<std::size_t>(Op::count)> table = {{
      {"constant", {"inverted"}},
      {"not", {"left out"}},
      {"and", {"inverted", "or"}},
      {"or", {"inverted", "and"}},
      {"xor", {"inverted", "or"}},
      {"select truth", {"other one"}},
      {"literal", {"plus 1"}},
      {"add", {"sub", "plus 1"}},
      {"sub", {"add", "turned round"}},
      {"mul", {"add", "plus 1"}},
      {"udiv", {"urem", "plus 1"}},
      {"urem", {"udiv", "plus 1"}},
      {"sdiv", {"udiv", "plus 1"}},
      {"srem", {"urem", "plus 1"}},
      {"bit and", {"or", "xor"}},
      {"bit or", {"and"}},
      {"bit xor", {"or", "and"}},
      {"bit not", {"left out", "negated"}},
      {"shift left", {"shift right", "one more"}},
      {"shift right", {"shift left", "one more"}},
      {"equal", {"inverted", "at least"}},
      {"below", {"inverted", "at most"}},
      {"at most", {"inverted", "below"}},
      {"signed below", {"inverted", "at most", "unsigned"}},
      {"signed at most", {"inverted", "below", "unsigned"}},
      {"select", {"other one"}},
      {"zero extension", {"lowest bit inverted"}},
      {"sign extension", {"zero extension", "lowest bit inverted"}},
      {"extract", {"lowest bit inverted", "highest bit inverted"}},
      {"concatenation", {"high part inverted", "low part inverted"}},
      {"bit", {"inverted"}},
      {"bit to number", {"inverted"}},
      {"real add", {"real sub", "real mul"}},
      {"real sub", {"real add", "turned round"}},
      {"real mul", {"real div", "real add"}},
      {"real div", {"real mul", "turned round"}},
      {"real function", {"next function", "argument itself"}},
      {"real equal", {"inverted", "at least"}},
      {"real below", {"inverted", "at most"}},
      {"real legal", {"inverted"}},
      {"integer to real", {"plus 1", "unsigned"}},
      {"real to integer", {"other rounding", "plus 1"}},
      {"load", {"inverted"}},
      {"save", {"left out", "inverted"}},
      {"register", {"inverted"}},
      {"set register", {"left out", "inverted"}},
      {"external", {"lowest bit inverted"}},
      {"report", {"left out"}},
      {"signal", {"left out", "next index"}},
      {"instruction",
       {"does nothing", "top inverted after it", "second level inverted after it", "third level inverted after it"}},
      {"text", {"removed", "one place later", "one place earlier"}},
  }};
  return table[static_cast<std::size_t>(op)];
}

constexpr int mostVisits = 5;

/// "void rungproof::Machine<D>::when(Bool, Body&&) [with D = ...]": "when".
std::string nameOfFunction(std::string_view signature) {
  std::string_view name = signature.substr(0, signature.find('('));
  if (name.ends_with('>')) {
    int depth = 0;
    do {
      depth += name.back() == '>' ? 1 : name.back() == '<' ? -1 : 0;
      name.remove_suffix(1);
    } while (depth > 0);
  }
  for (const char separator : {':', ' '}) {
    if (const std::size_t at = name.rfind(separator); at != std::string_view::npos) name.remove_prefix(at + 1);
  }
  return std::string(name);
}

}  // namespace

std::string_view opName(Op op) { return infoOf(op).name; }
std::span<const std::string_view> changesOf(Op op) { return infoOf(op).changes; }

Mutation& Mutation::instance() {
  static Mutation mutation;
  return mutation;
}

std::uint8_t Mutation::fileOf(const char* path) {
  if (const auto found = fileNumbers_.find(path); found != fileNumbers_.end()) return found->second;
  const std::string_view text = path;
  const std::string name(text.substr(text.rfind('/') + 1));
  auto at = std::find(files_.begin(), files_.end(), name);
  if (at == files_.end()) at = files_.insert(files_.end(), name);
  const auto number = static_cast<std::uint8_t>(at - files_.begin());
  fileNumbers_.emplace(path, number);
  return number;
}

const Desc* Mutation::desc() const {
  if (timer_ != nullptr) return timer_;
  if (running_.current == nullptr || *running_.current == nullptr) return nullptr;
  const bool isRestoring = *running_.frame == 9 && !*running_.inInterrupt;  // after the routine's last instruction
  return isRestoring ? nullptr : (*running_.current)->desc;
}

Site Mutation::siteOf(Op op, const Where& where, const Desc& desc) {
  Site site;
  site.opcode = desc.opcode;
  site.file = fileOf(where.file_name());
  site.line = static_cast<std::uint16_t>(where.line());
  site.column = static_cast<std::uint16_t>(where.column());
  site.op = op;
  const std::string& name = files_[site.file];
  const auto [function, isNew] = functions_.try_emplace({site.file, site.line});
  if (isNew) function->second = nameOfFunction(where.function_name());
  if (isShared(name) && function->second != "repeat" && !function->second.ends_with("Text")) {
    site.ordinal = static_cast<std::uint8_t>(std::min(++visits_[site], mostVisits));
  }
  return site;
}

int Mutation::change(Op op, const Where& where) {
  if ((test_ < 0 && !isActive_) || isPaused_) return 0;
  const Desc* of = desc();
  if (of == nullptr || (isActive_ && (of->opcode != active_.site.opcode || op != active_.site.op))) return 0;
  const Site site = siteOf(op, where, *of);
  if (isActive_) return site == active_.site ? active_.change : 0;
  sites_[site].insert(test_);
  return 0;
}

int Mutation::changeOfWhole(Op op, const Desc& desc) {
  if (isPaused_) return 0;
  Site site;
  site.opcode = desc.opcode;
  site.op = op;
  if (isActive_) return site == active_.site ? active_.change : 0;
  if (test_ >= 0) sites_[site].insert(test_);
  return 0;
}

}  // namespace rungproof::mutation
