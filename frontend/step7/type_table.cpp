// From the syntax of declarations to structures.
#include "frontend/step7/type_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "frontend/step7/operand_binder.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

using s7300::Field;
using s7300::Structure;
using s7300::Type;
using s7300::TypeKind;

namespace {

constexpr std::uint64_t longestStructure = 65535;

/// Types that stand in each other; STEP 7 takes 8 levels.
constexpr std::size_t deepestTypes = 100;

/// Bits of a value, without what fills an array up to an even number of bytes.
std::uint64_t bitsOfView(const Type& type) {
  if (type.kind == TypeKind::Bool) return 1;
  const bool isRow = type.kind == TypeKind::Array && type.element != nullptr && type.bounds.size() == 1;
  if (!isRow) return s7300::sizeOf(type) * 8;
  const std::uint64_t each =
      s7300::startsEven(*type.element) ? s7300::sizeOf(*type.element) * 8 : bitsOfView(*type.element);
  return type.bounds[0].count() * each;
}

bool isAmongSections(Section section, std::initializer_list<Section> sections) {
  return std::ranges::find(sections, section) != sections.end();
}

}  // namespace

Type TypeTable::named(const TypeSyntax& syntax) {
  Type type;
  const BlockName& name = *syntax.named;
  const auto unknown = [&](std::string message) {
    doubtType(name.span);
    reports_.reportOnce(Syntax::TypeUndefined, name.span, std::move(message), {}, 0);
    return type;
  };
  const std::optional<BlockKey> key = catalogue_.keyOf(name);
  if (!key) return unknown(fmt::format("nothing defines the type {}", toString(name)));
  if (key->kind != BlockKind::Udt && key->kind != BlockKind::Fb && key->kind != BlockKind::Sfb)
    return unknown(fmt::format("{} is no type", toString(name)));
  if (inProgress_.contains(*key)) return unknown(fmt::format("{} contains itself", toString(name)));
  if (inProgress_.size() >= deepestTypes && !made_.contains(*key))
    return unknown(fmt::format("{} stands in {} types that contain each other, more than are read", toString(name),
                               inProgress_.size()));
  const std::shared_ptr<const Structure> found = structure(*key);
  if (found == nullptr) return unknown(fmt::format("nothing defines the type {}", toString(name)));
  const Doubt doubt = doubtOf(*key);
  doubt_.add(doubt);
  if (doubt.type && found->size == 0) return type;  // nothing is left of it, however often it is doubled
  type.kind = TypeKind::Struct;
  type.structure = found;
  type.name = fmt::format("{} {}", blockKindName(key->kind), key->number);
  return type;
}

Type TypeTable::resolve(const TypeSyntax& syntax) {
  if (syntax.named) return named(syntax);
  Type type = syntax.elementary;
  if (type.kind == TypeKind::Unknown) doubtType(syntax.span);  // has been reported
  if (type.kind == TypeKind::Array) {
    type.bounds = syntax.bounds;
    const Type element = resolve(*syntax.element);
    if (element.kind == TypeKind::Unknown) return Type{};
    type.element = std::make_shared<Type>(element);
  } else if (type.kind == TypeKind::Struct) {
    auto structure = std::make_shared<Structure>();
    append(syntax.fields, {Section::Static}, *structure);
    layOut(*structure);
    type.structure = std::move(structure);
  }
  return type;
}

std::optional<Field> TypeTable::field(const DeclarationSyntax& declaration) {
  Field field;
  field.name = declaration.name.text;
  field.span = declaration.name.span;
  field.section = declaration.section;
  field.type = resolve(*declaration.type);
  if (s7300::sizeOf(field.type) > longestStructure) {
    doubtType(declaration.name.span);
    reports_.report(Syntax::NotModelled, declaration.name.span,
                    fmt::format("{} has more than {} bytes", field.name, longestStructure));
    return std::nullopt;
  }
  if (declaration.initial.empty() || field.type.kind == TypeKind::Unknown) return field;
  std::vector<std::uint8_t> scratch(s7300::sizeOf(field.type));
  if (const auto fault = s7300::writeValues(field.type, declaration.initial, 0, 0, scratch)) {
    const Constant& value = declaration.initial[std::min(fault->value, declaration.initial.size() - 1)];
    doubt_.add({false, true, value.span});
    reports_.report(Syntax::ValueOfType, value.span,
                    fault->tooMany ? fmt::format("{} has fewer elements than values", field.name)
                                   : fmt::format("the value is no {}", s7300::toString(field.type)));
  } else {
    field.initial = declaration.initial;
  }
  return field;
}

/// Whether the view of `seen` can be read; a finding says why not. `hasPlaces`: the fields lie in an instance or in
/// local data; parameters of an FC lie where its caller says.
bool TypeTable::isView(const DeclarationSyntax& declaration, const Field& view, const Field* seen, bool hasPlaces) {
  const std::string& name = declaration.name.text;
  const std::string fault = [&]() -> std::string {
    if (seen == nullptr) return fmt::format("{}: nothing declares {} before its view", name, declaration.view);
    const bool isHandedOn = seen->section == Section::InOut && s7300::isComplex(seen->type);
    if (!hasPlaces || isHandedOn || isNumberType(seen->type.kind))
      return fmt::format("{}: a view of a parameter that its caller holds is not covered", name);
    if (!declaration.initial.empty()) return fmt::format("{}: a view has no start value", name);
    const bool isKnown = seen->type.kind != TypeKind::Unknown && view.type.kind != TypeKind::Unknown;
    const std::uint64_t bits = bitsOfView(view.type), most = bitsOfView(seen->type);
    if (isKnown && bits > most)
      return fmt::format("{} has {} bits, more than {} with {}", name, bits, seen->name, most);
    return {};
  }();
  if (fault.empty()) return true;
  doubtType(declaration.span);
  reports_.report(Syntax::Declaration7, declaration.span, fault);
  return false;
}

void TypeTable::append(const std::vector<DeclarationSyntax>& declarations, std::initializer_list<Section> sections,
                       Structure& structure) {
  std::unordered_map<std::string, std::size_t> fieldOf;  // by folded name
  for (std::size_t i = 0; i < structure.fields.size(); ++i)
    fieldOf.emplace(s7300::foldedName(structure.fields[i].name), i);
  for (const DeclarationSyntax& declaration : declarations) {
    if (!isAmongSections(declaration.section, sections)) continue;
    std::optional<Field> made = field(declaration);
    if (!made) continue;
    if (!declaration.view.empty()) {
      const auto seen = fieldOf.find(s7300::foldedName(declaration.view));
      const bool hasPlaces = isAmongSections(Section::Static, sections) || isAmongSections(Section::Temp, sections);
      if (!isView(declaration, *made, seen == fieldOf.end() ? nullptr : &structure.fields[seen->second], hasPlaces))
        continue;
      made->viewOf = structure.fields[seen->second].name;
      if (made->section != Section::Temp) made->section = Section::Static;  // no parameter of a call
    }
    const auto [twin, isNew] = fieldOf.emplace(s7300::foldedName(made->name), structure.fields.size());
    if (!isNew) {
      const Span first = structure.fields[twin->second].span;
      doubtType(made->span);
      reports_.report(Syntax::Declaration7, made->span, fmt::format("{} is declared twice", made->name));
      if (first.length > 0) reports_.relate(first, "the first declaration");
      continue;
    }
    structure.fields.push_back(std::move(*made));
  }
}

void TypeTable::checkSize(const Structure& structure, const BlockSyntax& block) {
  if (structure.size <= longestStructure) return;
  doubtType(block.heading);
  reports_.report(Syntax::NotModelled, block.heading,
                  fmt::format("the block has {} bytes, more than {}", structure.size, longestStructure));
}

std::optional<BlockKey> TypeTable::instanceOf(const BlockSyntax& block) const {
  if (block.kind != BlockKind::Db || block.type == nullptr || !block.type->named) return std::nullopt;
  const std::optional<BlockKey> key = catalogue_.keyOf(*block.type->named);
  return key && (key->kind == BlockKind::Fb || key->kind == BlockKind::Sfb) ? key : std::nullopt;
}

bool TypeTable::isOpaque(BlockKey key) const {
  const CatalogueEntry* entry = key.kind == BlockKind::Db ? catalogue_.entry(key) : nullptr;
  const std::optional<BlockKey> of = entry != nullptr ? instanceOf(*entry->syntax) : std::nullopt;
  return of && of->kind == BlockKind::Sfb && s7300::libraryBlock(BlockType::Sfb, of->number) == nullptr &&
         catalogue_.entry(*of) == nullptr;
}

void TypeTable::Doubt::add(const Doubt& other) {
  const bool isNew = (other.type && !type) || (other.value && !type && !value);
  if (isNew) cause = other.cause;
  type = type || other.type;
  value = value || other.value;
}

TypeTable::Doubt TypeTable::doubtOf(BlockKey key) const {
  const auto found = doubts_.find(key);
  return found == doubts_.end() ? Doubt{} : found->second;
}

std::shared_ptr<const Structure> TypeTable::structure(BlockKey key) {
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  const Doubt before = std::exchange(doubt_, {});
  inProgress_.insert(key);
  std::shared_ptr<const Structure> structure = make(key);
  inProgress_.erase(key);
  if (doubt_.type || doubt_.value) doubts_.emplace(key, doubt_);
  doubt_ = before;
  made_.emplace(key, structure);
  return structure;
}

std::shared_ptr<const Structure> TypeTable::make(BlockKey key) {
  const CatalogueEntry* entry = catalogue_.entry(key);
  if (entry == nullptr) {
    if (key.kind != BlockKind::Sfb) return nullptr;
    const s7300::LibraryBlock* library = s7300::libraryBlock(BlockType::Sfb, key.number);
    return library != nullptr ? s7300::interfaceOf(*library) : nullptr;
  }
  const BlockSyntax& block = *entry->syntax;
  if (!block.declarationsRead) doubtType(block.heading);
  auto structure = std::make_shared<Structure>();
  if (key.kind == BlockKind::Fb || key.kind == BlockKind::Sfb) {
    append(block.declarations, {Section::Input, Section::Output, Section::InOut, Section::Static}, *structure);
    layOutInstance(*structure);
  } else if (isOpaque(key)) {
    doubtType(block.heading);
  } else if (block.type != nullptr) {
    const Type type = resolve(*block.type);
    if (type.kind == TypeKind::Struct && type.structure != nullptr) return type.structure;
    if (type.kind != TypeKind::Unknown) {  // DATA_BLOCK of an array: one field without a name
      Field field;
      field.type = type;
      structure->fields.push_back(std::move(field));
      layOut(*structure);
    }
  } else {
    append(block.declarations, {Section::Static}, *structure);
    layOut(*structure);
  }
  checkSize(*structure, block);
  return structure;
}

TypeTable::Doubt TypeTable::doubtOf(const BlockSyntax& block) const {
  const auto found = partDoubts_.find(&block);
  Doubt doubt = found == partDoubts_.end() ? Doubt{} : found->second;
  if (!block.declarationsRead) doubt.add({true, false, block.heading});
  return doubt;
}

template <class Make>
std::shared_ptr<const Structure> TypeTable::partOf(const BlockSyntax& block, Make&& make) {
  const Doubt before = std::exchange(doubt_, {});
  auto structure = std::make_shared<Structure>();
  make(*structure);
  partDoubts_[&block].add(doubt_);
  doubt_ = before;
  return structure;
}

std::shared_ptr<const Structure> TypeTable::parameters(const BlockSyntax& block) {
  const auto [known, isNew] = parameters_.try_emplace(&block);
  if (!isNew) return known->second;
  known->second = partOf(block, [&](Structure& structure) {
    append(block.declarations, {Section::Input, Section::Output, Section::InOut}, structure);
    std::ranges::stable_sort(structure.fields, {}, &Field::section);
    if (block.type == nullptr) return;
    Field value;
    value.type = resolve(*block.type);
    if (value.type.kind == TypeKind::Void) return;
    value.name = "RET_VAL";
    value.section = Section::Output;
    value.span = block.heading;
    const auto first =
        std::ranges::find_if(structure.fields, [](const Field& field) { return field.section != Section::Input; });
    structure.fields.insert(first, std::move(value));
  });
  return known->second;
}

std::shared_ptr<const Structure> TypeTable::constants(const BlockSyntax& block) {
  return partOf(block, [&](Structure& structure) { append(block.constants, {Section::Static}, structure); });
}

std::shared_ptr<const Structure> TypeTable::temporary(const BlockSyntax& block) {
  return partOf(block, [&](Structure& structure) {
    append(block.declarations, {Section::Temp}, structure);
    layOut(structure);
    checkSize(structure, block);
  });
}

}  // namespace rungproof::step7
