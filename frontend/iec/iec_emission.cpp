// Instructions of the machine: loads, stores, indices of arrays.
#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/iec_tree.hpp"
#include "ir/iec/isa.hpp"

namespace rungproof::iec {

void Lowering::emit(std::string_view mnemonic, std::initializer_list<std::int64_t> numbers) {
  Instruction made;
  made.desc = iecInstructions().named(mnemonic);
  CHECK(made.desc != nullptr, "the machine has the instruction");
  for (const std::int64_t number : numbers) made.operands.push_back(rungproof::constant(number));
  made.span = span_;
  made.mnemonicLength = made.span.length;
  network_->instructions.push_back(std::move(made));
}

void Lowering::emitPlace(std::string_view mnemonic, const Type& type, std::uint32_t offset) {
  emit(type.width == 1 ? std::string(mnemonic) + ".BIT" : std::string(mnemonic));
  Operand place = direct(Area::V, widthOfBits(type.width), offset);
  place.span = span_;
  last().operands.push_back(std::move(place));
}

void Lowering::load(const Type& type, std::uint32_t offset) { emitPlace("LOAD", type, offset); }

void Lowering::store(const Type& type, std::uint32_t offset) {
  emitPlace("STORE", type, offset);
  for (std::uint32_t i = offset; i < offset + type.bytes && i < mostBytes; ++i) noteWritten(i);
  if (!shared_.empty()) writeThrough(offset);
}

void Lowering::noteWritten(std::uint32_t byte) {
  if (isWritten_.size() <= byte) isWritten_.resize(byte + 1);
  isWritten_[byte] = 1;
}

void Lowering::constant(std::int64_t value, int width) {
  const std::uint64_t mask = width >= 64 ? ~0ULL : (1ULL << width) - 1;
  emit("CONST", {static_cast<std::int64_t>(static_cast<std::uint64_t>(value) & mask), width});
}

/// Pushes the number of the element among all that the computed indices reach, in steps of the least stride.
void Lowering::pushIndex(Scope& scope, const Reference& reference) {
  std::uint32_t least = ~0U;
  for (const Reference::Index& index : reference.indices) least = std::min(least, index.stride);
  bool isFirst = true;
  for (const Reference::Index& index : reference.indices) {
    const Type* type = value(scope, *index.index, nullptr);
    if (type == nullptr || !type->isNumber()) refuse(index.index->span, "an index is a whole number");
    // What does not fit into 32 bits with a sign is the greatest or least number that does: outside of every array.
    if (type->isLong() && type->isSigned) {
      constant(-2147483648LL, 64);
      emit("MAX", {64, 1});
    }
    if (type->width >= 32 && (type->isLong() || !type->isSigned)) {
      constant(2147483647, type->width);
      emit("MIN", {type->width, type->isSigned ? 1 : 0});
    }
    emit("RESIZE", {type->width, 32, type->isSigned ? 1 : 0});
    if (index.low != 0) {
      constant(index.low, 32);
      emit("SUB", {32});
    }
    emit("INDEX", {index.count});
    if (index.stride % least != 0) refuse(index.index->span, "arrays of such elements in arrays are not modelled");
    if (index.stride != least) {
      constant(index.stride / least, 32);
      emit("MUL", {32});
    }
    if (!std::exchange(isFirst, false)) emit("ADD", {32});
  }
}

void Lowering::element(std::string_view mnemonic, const Reference& reference) {
  std::uint32_t least = ~0U, reach = 0;
  for (const Reference::Index& index : reference.indices) {
    least = std::min(least, index.stride);
    reach += (index.count - 1) * index.stride;
  }
  emit(mnemonic);
  last().operands.push_back(direct(Area::V, Width::Byte, reference.offset));
  for (const std::int64_t number : {std::int64_t{reach + reference.type->bytes}, std::int64_t{least},
                                    std::int64_t{std::max(reference.type->width, 8)}})
    last().operands.push_back(rungproof::constant(number));
  if (mnemonic == "LOAD.ELEMENT") return;
  for (std::uint32_t i = reference.offset; i < reference.offset + reach + reference.type->bytes; ++i) noteWritten(i);
}

void Lowering::readReference(Scope& scope, const Reference& reference) {
  if (reference.indices.empty()) {
    load(*reference.type, reference.offset);
  } else {
    pushIndex(scope, reference);
    element("LOAD.ELEMENT", reference);
    if (reference.type->width == 1) emit("RESIZE", {8, 1, 0});
  }
  if (!reference.bit) return;
  constant(*reference.bit, 32);
  emit("SHR", {reference.type->width});
  emit("RESIZE", {reference.type->width, reference.partType->width, 0});
}

void Lowering::prepareWrite(Scope& scope, const Reference& reference) {
  if (!reference.indices.empty()) pushIndex(scope, reference);
}

void Lowering::writeReference(Scope& scope, const Reference& reference) {
  if (reference.bit) {
    if (!reference.indices.empty()) refuse(network_->span, "a bit of a computed element is not modelled");
    const int width = reference.type->width, part = reference.partType->width;
    emit("RESIZE", {part, width, 0});
    constant(*reference.bit, 32);
    emit("SHL", {width});
    load(*reference.type, reference.offset);
    constant(~(((std::int64_t{1} << part) - 1) << *reference.bit), width);
    emit("AND", {width});
    emit("OR", {width});
    return store(*reference.type, reference.offset);
  }
  static_cast<void>(scope);
  if (reference.indices.empty()) return store(*reference.type, reference.offset);
  if (reference.type->width == 1) emit("RESIZE", {1, 8, 0});
  element("STORE.ELEMENT", reference);
}

/// Arrays and structures, value by value.
void Lowering::copy(Scope& scope, const Reference& from, const Reference& to) {
  std::vector<ExprPtr> held;
  const Reference source = withHeldIndices(scope, from, held), target = withHeldIndices(scope, to, held);
  copyParts(scope, source, target);
}

/// Indices of a whole that is copied part by part are computed once: a part may be what an index reads.
Reference Lowering::withHeldIndices(Scope& scope, Reference at, std::vector<ExprPtr>& held) {
  if (at.type->isValue()) return at;
  for (Reference::Index& index : at.indices) {
    const Type* type = value(scope, *index.index, elementaryType("DINT"));
    const std::string name = fmt::format("__INDEX_{}", scope.self->names.size());
    Variable made;
    made.type = type;
    made.offset = allocate(type->bytes);
    scope.self->names.emplace(name, made);
    store(*type, made.offset);
    index.index = held.emplace_back(pathOf({name}, index.index->span)).get();
  }
  return at;
}

void Lowering::copyParts(Scope& scope, const Reference& from, const Reference& to) {
  if (isText(from.type)) {
    if (!from.indices.empty())
      refuse(network_->span, "a text in an array with a computed index is not modelled", Syntax::IecNotModelled);
    return copyText(scope, {from.offset, from.type->bytes}, to, network_->span);
  }
  if (from.type->isValue()) {
    prepareWrite(scope, to);
    readReference(scope, from);
    return writeReference(scope, to);
  }
  const auto part = [&](const Type& type, std::uint32_t offset) {
    Reference source = from, target = to;
    source.type = target.type = &type;
    source.offset += offset;
    target.offset += offset;
    copyParts(scope, source, target);
  };
  if (from.type->kind == Kind::Struct) {
    for (const Field& field : from.type->fields) part(*field.type, field.offset);
  } else if (from.type->kind == Kind::Array) {
    const std::uint32_t size = from.type->element->bytes;
    if (size == 0 || from.type->bytes / size > 1000) refuse(network_->span, "the array is too long to be copied");
    for (std::uint32_t at = 0; at < from.type->bytes; at += size) part(*from.type->element, at);
  } else {
    refuse(network_->span, fmt::format("values of type {} are not modelled", from.type->name));
  }
}

}  // namespace rungproof::iec
