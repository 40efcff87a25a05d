// Places of located variables, and addresses that name the same bytes on some controllers: what the number of %MW1
// counts is open (Choice::IecAddressUnit), and where the low byte of a word lies (Choice::IecByteOrder). Each address
// has a place of its own. By the readings in which addresses meet, what is written to one of them goes into the others
// too.
#include <tuple>

#include "frontend/iec/iec_lowering.hpp"
#include "ir/iec/walk.hpp"

namespace rungproof::iec {

namespace {

/// The bits that an address names, counted in bytes or in units of its own size; nothing: it has another form.
std::optional<std::pair<std::int64_t, std::int64_t>> bitsOf(const std::string& address, bool inBytes) {
  static const std::map<char, std::int64_t> sizes = {{'X', 1}, {'B', 8}, {'W', 16}, {'D', 32}, {'L', 64}};
  const bool hasSize = address.size() > 3 && sizes.contains(address[2]);
  const std::size_t first = hasSize ? 3 : 2;
  const std::int64_t size = hasSize ? sizes.at(address[2]) : 1;
  const std::size_t point = address.find('.');
  const std::string number = address.substr(first, point == std::string::npos ? point : point - first);
  if (number.empty() || number.size() > 6 || number.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const std::int64_t unit = std::stoll(number);
  if (size > 1)
    return point != std::string::npos ? std::nullopt : std::optional(std::pair(unit * (inBytes ? 8 : size), size));
  if (point == std::string::npos) return std::pair(unit, size);
  const bool isBit = point + 2 == address.size() && address[point + 1] >= '0' && address[point + 1] <= '7';
  return isBit ? std::optional(std::pair(unit * 8 + address[point + 1] - '0', size)) : std::nullopt;
}

const Type& typeByPrefix(const std::string& address) {
  switch (address.size() > 2 ? address[2] : '\0') {
    case 'B': return *elementaryType("BYTE");
    case 'W': return *elementaryType("WORD");
    case 'D': return *elementaryType("DWORD");
    case 'L': return *elementaryType("LWORD");
    default: return *elementaryType("BOOL");
  }
}

/// With the size of bits, which may be left out: %I0.0 is %IX0.0.
std::string withSize(const std::string& address) {
  const bool hasSize = address.size() > 2 && std::string_view("XBWDL").find(address[2]) != std::string_view::npos;
  return hasSize ? address : fmt::format("{}X{}", address.substr(0, 2), address.substr(2));
}

bool meet(std::int64_t a, std::int64_t aEnd, std::int64_t b, std::int64_t bEnd) { return a < bEnd && b < aEnd; }

}  // namespace

/// How many values of the size of its address a variable takes.
std::int64_t Lowering::extentOf(const VariableSyntax& variable) {
  const Type* type = variable.type != nullptr ? types_.resolve(*variable.type) : nullptr;
  std::int64_t count = 1;
  for (; type != nullptr && type->kind == Kind::Array; type = type->element) {
    for (const auto& [low, high] : type->bounds) count *= high - low + 1;
  }
  return type != nullptr && type->kind == Kind::Struct ? std::max<std::int64_t>(count, 2) : count;
}

/// Addresses whose bits meet where words are counted in bytes, or in words.
void Lowering::findSharedAddresses() {
  struct Used {
    VariableSyntax syntax;
    std::int64_t count = 1;  ///< of values that lie there in a row
    bool isDeclared = false;
  };
  std::map<std::string, Used> all;
  const auto add = [&](const VariableSyntax& variable, bool isDeclared) {
    if (variable.address.size() <= 2 || variable.address[0] != '%') return;
    Used& used = all[withSize(foldedName(variable.address))];
    if (isDeclared) used.count = std::max(used.count, extentOf(variable));
    if (used.syntax.address.empty() || (isDeclared && !used.isDeclared)) used.syntax = variable;
    used.isDeclared = used.isDeclared || isDeclared;
  };
  for (const VariableSyntax& variable : project_.globals) add(variable, true);
  for (const BlockSyntax& block : project_.blocks) {
    for (const VariableSyntax& variable : block.variables) add(variable, true);
    eachStatementOf(block, [&](const Statement& one, const Statements&, std::size_t) {
      eachExpression(one, [&](const Expr& expr) {
        if (expr.parts.empty()) return;
        VariableSyntax direct;
        direct.address = expr.parts[0].name;
        direct.span = expr.span;
        add(direct, false);
      });
    });
  }
  struct Range {
    const std::string* address;
    std::int64_t begin, end;
  };
  std::set<std::string> meeting;
  for (const bool inBytes : {false, true}) {
    std::vector<Range> ranges;
    for (const auto& [address, used] : all) {
      if (const auto bits = bitsOf(address, inBytes))
        ranges.push_back({&address, bits->first, bits->first + bits->second * used.count});
    }
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      for (std::size_t k = i + 1; k < ranges.size(); ++k) {
        const std::string &a = *ranges[i].address, &b = *ranges[k].address;
        if (a[1] != b[1] || !meet(ranges[i].begin, ranges[i].end, ranges[k].begin, ranges[k].end)) continue;
        // Nobody who counts in bytes lets his words overlap; elements of an array lie side by side for everybody.
        if (a[2] == b[2] && inBytes) continue;
        meeting.insert({a, b});
        if (all.at(a).count > 1 || all.at(b).count > 1) apart_.insert({a, b});
      }
    }
  }
  for (const std::string& address : meeting) {
    Used& used = all.at(address);
    const Type* declared = used.isDeclared && used.syntax.type != nullptr ? types_.resolve(*used.syntax.type) : nullptr;
    const Type& type = declared != nullptr && declared->bytes > 0 ? *declared : typeByPrefix(address);
    const auto offset = located(used.syntax, type);
    const auto inUnits = bitsOf(address, false), inBytes = bitsOf(address, true);
    if (!offset || !inUnits || !inBytes) continue;
    if (apart_.contains(address))
      unmodelledPlaces_.emplace_back(*offset, *offset + type.bytes);
    else
      shared_.push_back(
          {address[1], *offset, &type, inUnits->first, inBytes->first, static_cast<int>(inUnits->second)});
  }
}

bool Lowering::isApartAt(std::uint32_t offset) const {
  return std::ranges::any_of(unmodelledPlaces_,
                             [&](const auto& range) { return range.first <= offset && offset < range.second; });
}

/// What has been written to a place goes into those that it meets, byte by byte.
void Lowering::writeThrough(std::uint32_t offset) {
  const auto from = std::ranges::find(shared_, offset, &SharedPlace::offset);
  if (from == shared_.end()) return;
  for (const SharedPlace& to : shared_) {
    if (to.area != from->area || to.offset == offset) continue;
    if (meet(from->inUnits, from->inUnits + from->bits, to.inUnits, to.inUnits + to.bits))
      mergeBytes(*from, to, from->inUnits, to.inUnits, "size");
    if (meet(from->inBytes, from->inBytes + from->bits, to.inBytes, to.inBytes + to.bits) &&
        from->type->width != to.type->width)
      mergeBytes(*from, to, from->inBytes, to.inBytes, "byte");
  }
}

/// By one reading of the unit: a byte of a word lies at the address of its rank, or from the other end.
void Lowering::mergeBytes(const SharedPlace& from, const SharedPlace& to, std::int64_t fromBit, std::int64_t toBit,
                          std::string_view unit) {
  const Type &given = *from.type, &kept = *to.type;
  if (!given.isValue() || !kept.isValue()) return;
  const auto reads = [&](Choice choice, std::string_view reading) {
    const auto& values = choiceInfo(choice).values;
    emit("READING", {static_cast<std::int64_t>(choice), std::ranges::find(values, reading) - values.begin()});
  };
  for (const std::string_view order : {"little", "big"}) {
    // The absolute bit at which the bit of that rank lies.
    const auto placeOf = [&](std::int64_t first, int bits, int rank) {
      const int bytes = bits / 8, byte = rank / 8;
      return bits < 8 ? first : first + 8 * (order == "little" ? byte : bytes - 1 - byte) + rank % 8;
    };
    const int step = std::min(from.bits, to.bits) < 8 ? 1 : 8;
    for (int rank = 0; rank < from.bits; rank += step) {
      for (int other = 0; other < to.bits; other += step) {
        if (placeOf(fromBit, from.bits, rank) != placeOf(toBit, to.bits, other)) continue;
        reads(Choice::IecAddressUnit, unit);
        reads(Choice::IecByteOrder, order);
        emit("AND", {1});
        load(kept, to.offset);
        load(kept, to.offset);
        const std::uint64_t mask = ((std::uint64_t{1} << step) - 1) << other;
        constant(static_cast<std::int64_t>(~mask), kept.width);
        emit("AND", {kept.width});
        load(given, from.offset);
        constant(rank, 32);
        emit("SHR", {given.width});
        emit("RESIZE", {given.width, kept.width, 0});
        constant(static_cast<std::int64_t>(mask >> other), kept.width);
        emit("AND", {kept.width});
        constant(other, 32);
        emit("SHL", {kept.width});
        emit("OR", {kept.width});
        emit("SEL", {kept.width});
        emitPlace("STORE", kept, to.offset);
        for (std::uint32_t i = to.offset; i < to.offset + kept.bytes && i < mostBytes; ++i) noteWritten(i);
      }
    }
  }
}

/// Inputs that meet have the same bits: the last of them tells them to the others.
void Lowering::joinInputs() {
  for (const SharedPlace& place : shared_) {
    if (place.area == 'I') writeThrough(place.offset);
  }
}

/// The place of an address; the same address is the same place. Nothing if it is none.
std::optional<std::uint32_t> Lowering::located(const VariableSyntax& syntax, const Type& type) {
  const std::string address = foldedName(syntax.address);
  const bool isLegal = address.size() >= 3 && (address[1] == 'I' || address[1] == 'Q' || address[1] == 'M');
  if (!isLegal) return std::nullopt;
  const bool isIncomplete = address.find('*') != std::string::npos;
  const std::string key = isIncomplete ? fmt::format("{}{}", address, places_.size()) : withSize(address);
  const auto [at, isNew] = places_.emplace(key, next_);
  if (!isNew) return at->second;
  at->second = allocate(type.bytes);
  if (!isIncomplete) {
    addressNames_.emplace_back(key.substr(1), at->second);
    if (key[2] == 'X') addressNames_.emplace_back(key.substr(1, 1) + key.substr(3), at->second);
  }
  if (address[1] == 'I') freeVariable(type, at->second, syntax.span, true);
  return at->second;
}

}  // namespace rungproof::iec
