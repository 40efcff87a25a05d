// The requests of the editor server: their parameters, and the part that answers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "frontend/editor/code_action.hpp"
#include "frontend/editor/completion.hpp"
#include "frontend/editor/coverage_hints.hpp"
#include "frontend/editor/cursor.hpp"
#include "frontend/editor/editor_server.hpp"
#include "frontend/editor/formatting.hpp"
#include "frontend/editor/hover.hpp"
#include "frontend/editor/inlay_hints.hpp"
#include "frontend/editor/navigation.hpp"
#include "frontend/editor/picture.hpp"
#include "frontend/editor/rename.hpp"
#include "frontend/editor/semantic_tokens.hpp"

namespace rungproof {

namespace {

RpcFault notOpen() { return {RpcCode::InvalidParams, "the document is not open"}; }
RpcFault noPlace() { return {RpcCode::InvalidParams, "the place must have a line and a character"}; }

std::optional<std::pair<ClientPlace, ClientPlace>> rangeFrom(const Json& params) {
  const Json* const range = params.find("range");
  const auto begin = range == nullptr ? std::nullopt : placeFrom(range->find("start"));
  const auto end = range == nullptr ? std::nullopt : placeFrom(range->find("end"));
  if (!begin || !end) return std::nullopt;
  return std::pair(*begin, *end);
}

Form formNamed(std::string_view name) { return name == "fbd" ? Form::Fbd : name == "stl" ? Form::Stl : Form::Ladder; }

}  // namespace

std::span<const EditorServer::Request> EditorServer::requests() {
  static constexpr std::array<Request, 19> rows = {{
      {"initialize", &EditorServer::initialize},
      {"shutdown", &EditorServer::shutdown},
      {"textDocument/hover", &EditorServer::hover},
      {"textDocument/definition", &EditorServer::definition},
      {"textDocument/references", &EditorServer::references},
      {"textDocument/documentHighlight", &EditorServer::documentHighlight},
      {"textDocument/prepareRename", &EditorServer::prepareRename},
      {"textDocument/rename", &EditorServer::rename},
      {"textDocument/foldingRange", &EditorServer::foldingRange},
      {"textDocument/semanticTokens/full", &EditorServer::semanticTokens},
      {"textDocument/inlayHint", &EditorServer::inlayHint},
      {"textDocument/formatting", &EditorServer::formatting},
      {"textDocument/rangeFormatting", &EditorServer::formatting},
      {"textDocument/documentSymbol", &EditorServer::documentSymbol},
      {"textDocument/completion", &EditorServer::completion},
      {"textDocument/codeAction", &EditorServer::codeAction},
      {"textDocument/codeLens", &EditorServer::codeLens},
      {"workspace/symbol", &EditorServer::workspaceSymbol},
      {"rungproof/network", &EditorServer::network},
  }};
  return rows;
}

EditorServer::Answer EditorServer::hover(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  return place ? Answer(hoverAt(checked(*open), *place)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::definition(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  return place ? Answer(definitionsAt(checked(*open), *place)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::references(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  if (!place) return noPlace();
  const Json* const context = message.params.find("context");
  const Json* const declaration = context == nullptr ? nullptr : context->find("includeDeclaration");
  return referencesAt(checked(*open), *place, declaration != nullptr && declaration->isTrue());
}

EditorServer::Answer EditorServer::documentHighlight(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  return place ? Answer(highlightsAt(checked(*open), *place)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::prepareRename(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  return place ? Answer(renameRange(checked(*open), *place)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::rename(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  const Json* const name = message.params.find("newName");
  if (!place) return noPlace();
  if (name == nullptr) return RpcFault{RpcCode::InvalidParams, "the new name is missing"};
  std::variant<Json, std::string> edit = renameAt(checked(*open), *place, name->text());
  if (const std::string* fault = std::get_if<std::string>(&edit)) return RpcFault{RpcCode::RequestFailed, *fault};
  return std::move(std::get<Json>(edit));
}

EditorServer::Answer EditorServer::foldingRange(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  return open == nullptr ? Answer(notOpen()) : Answer(foldsOf(checked(*open)));
}

EditorServer::Answer EditorServer::semanticTokens(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  return open == nullptr ? Answer(notOpen()) : Answer(semanticTokensOf(checked(*open)));
}

EditorServer::Answer EditorServer::inlayHint(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto range = rangeFrom(message.params);
  if (!range) return noPlace();
  Json hints = inlayHintsIn(checked(*open), range->first, range->second);
  const Json covered = coverageHints(checked(*open), open->document.path);
  for (const Json& hint : covered.items()) {
    const auto place = placeFrom(hint.find("position"));
    if (place && range->first <= *place && *place <= range->second) hints.push_back(hint);
  }
  return hints;
}

/// Of the whole document, or of the lines of a range.
EditorServer::Answer EditorServer::formatting(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  FormatStyle style;
  const Json* const options = message.params.find("options");
  const Json* const tabSize = options == nullptr ? nullptr : options->find("tabSize");
  if (tabSize != nullptr)
    style.tabSize = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(tabSize->natural().value_or(4), 1, 16));
  const auto range = rangeFrom(message.params);
  const std::uint32_t last = range ? range->second.line : std::numeric_limits<std::uint32_t>::max();
  return formattingEdits(checked(*open), style, range ? range->first.line : 0, last);
}

EditorServer::Answer EditorServer::documentSymbol(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  return open == nullptr ? Answer(notOpen()) : Answer(outlineOf(checked(*open)));
}

EditorServer::Answer EditorServer::workspaceSymbol(const RpcMessage& message) {
  const Json* const query = message.params.find("query");
  Json list = Json::array();
  for (auto& [uri, open] : open_) addSymbols(checked(open), query == nullptr ? std::string() : query->text(), list);
  return list;
}

EditorServer::Answer EditorServer::completion(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  return place ? Answer(completionsAt(checked(*open), *place)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::codeAction(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto range = rangeFrom(message.params);
  return range ? Answer(codeActionsIn(checked(*open), range->first, range->second)) : Answer(noPlace());
}

EditorServer::Answer EditorServer::codeLens(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  return open == nullptr ? Answer(notOpen()) : Answer(lensesOf(checked(*open), open->verdicts));
}

EditorServer::Answer EditorServer::network(const RpcMessage& message) {
  Open* const open = openOf(message.params);
  if (open == nullptr) return notOpen();
  const auto place = placeFrom(message.params.find("position"));
  const Json* const form = message.params.find("form");
  return place ? pictureAt(*open, *place, form == nullptr ? std::string() : form->text()) : Answer(noPlace());
}

EditorServer::Answer EditorServer::pictureAt(Open& open, ClientPlace place, std::string_view form) {
  const CheckedDocument& document = checked(open);
  const Cursor cursor = cursorAt(document, document.offset(place));
  if (cursor.network != nullptr) {
    const EditorPicture picture = pictureOf(document, *cursor.pou, *cursor.network, formNamed(form));
    return Json{{"heading", picture.heading}, {"text", picture.text}, {"svg", picture.svg}};
  }
  return RpcFault{RpcCode::RequestFailed, "no network stands there"};
}

/// rungproof.prove URI NAME; rungproof.show URI PLACE [lad|fbd|stl].
void EditorServer::executeCommand(const RpcMessage& message) {
  const Json* const command = message.params.find("command");
  const Json* const arguments = message.params.find("arguments");
  const std::string name = command == nullptr ? std::string() : command->text();
  const std::vector<Json> values = arguments == nullptr ? std::vector<Json>() : arguments->items();
  if (name != "rungproof.prove" && name != "rungproof.show")
    return refuse(message.id, RpcCode::InvalidParams, fmt::format("there is no command '{}'", name));
  const auto open = open_.find(values.empty() ? std::string() : values[0].text());
  if (open == open_.end() || values.size() < 2)
    return refuse(message.id, RpcCode::InvalidParams, "the arguments are an open document and what is meant in it");
  if (name == "rungproof.prove") return startProof(message, open->second, values[1].text());
  const auto place = placeFrom(&values[1]);
  const Answer answer =
      place ? pictureAt(open->second, *place, values.size() > 2 ? values[2].text() : std::string()) : noPlace();
  if (const RpcFault* fault = std::get_if<RpcFault>(&answer)) return refuse(message.id, fault->code, fault->message);
  reply(*message.id, std::get<Json>(answer));
}

void EditorServer::startProof(const RpcMessage& message, Open& open, const std::string& name) {
  const CheckedDocument& document = checked(open);
  if (goalNamed(document, name) == nullptr)
    return refuse(message.id, RpcCode::InvalidParams, fmt::format("no property is called '{}'", name));
  const Json* const token = message.params.find("workDoneToken");
  const std::optional<Json> progress = token == nullptr ? std::nullopt : std::optional(*token);
  if (progress)
    notify("$/progress", {{"token", *progress},
                          {"value", Json{{"kind", "begin"}, {"title", "Proving " + name}, {"cancellable", true}}}});
  const Json id = *message.id;
  const std::string uri = document.uri();
  const std::int64_t version = document.version();
  begin(id, proofOf(document, name, context_.given),
        [this, id, uri, name, version, progress](const std::optional<std::string>& printed) {
          const ProofVerdict verdict = verdictFrom(printed, name, version);
          if (progress) notify("$/progress", {{"token", *progress}, {"value", Json{{"kind", "end"}}}});
          if (verdict.word.empty()) {
            refuse(id, RpcCode::RequestFailed, verdict.message);
          } else {
            reply(id, verdict.row);
          }
          finishProof(uri, name, verdict);
        });
}

void EditorServer::finishProof(const std::string& uri, const std::string& name, const ProofVerdict& verdict) {
  const bool isGood = verdict.word == "PROVED" || verdict.word == "REACHABLE";
  const bool isBad = verdict.word.empty() || verdict.word == "VIOLATED" || verdict.word == "UNREACHABLE";
  notify("window/showMessage", {{"type", isGood  ? 3
                                         : isBad ? 1
                                                 : 2},
                                {"message", verdict.message.substr(0, verdict.message.find('\n'))}});
  const auto open = open_.find(uri);
  if (open == open_.end()) return;
  open->second.verdicts[name] = verdict;
  open->second.isPublished = false;
  if (refreshesLenses_) ask("workspace/codeLens/refresh", nullptr);
}

}  // namespace rungproof
