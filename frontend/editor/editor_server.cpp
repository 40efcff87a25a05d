// The life of the server, its documents, and the way of each message.
#include "frontend/editor/editor_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/cli/cli.hpp"
#include "frontend/editor/diagnostics.hpp"
#include "frontend/files/disk_file.hpp"

namespace rungproof {

namespace {

TextEncoding encodingOnDisk(const Context& context, const std::string& path) {
  Settings settings;
  if (context.readSettings(path, settings)) settings = {};
  const TextEncoding named = *encodingNamed(settings.text(Opt::Encoding));
  if (named != TextEncoding::Auto) return named;
  releaseText(path);
  const std::optional<std::string> bytes = bytesOfInput(path);
  return bytes ? decode(*bytes, TextEncoding::Auto).encoding : TextEncoding::Utf8;
}

const Json* memberOf(const Json& json, std::initializer_list<std::string_view> path) {
  const Json* at = &json;
  for (const std::string_view key : path) {
    at = at->find(key);
    if (at == nullptr) return nullptr;
  }
  return at;
}

std::string textOf(const Json& json, std::initializer_list<std::string_view> path) {
  const Json* const member = memberOf(json, path);
  return member == nullptr ? std::string() : member->text();
}

Json capabilities() {
  return {{"positionEncoding", "utf-16"},
          {"textDocumentSync", Json{{"openClose", true}, {"change", 2}, {"save", Json{{"includeText", false}}}}},
          {"hoverProvider", true},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentSymbolProvider", true},
          {"workspaceSymbolProvider", true},
          {"completionProvider", Json{{"triggerCharacters", Json::array({" ", ",", ":", "@"})}}},
          {"codeActionProvider", Json{{"codeActionKinds", Json::array({"quickfix", "source.fixAll.rungproof"})}}},
          {"inlayHintProvider", true},
          {"codeLensProvider", Json{{"resolveProvider", false}}},
          {"executeCommandProvider", Json{{"commands", Json::array({"rungproof.prove", "rungproof.show"})}}}};
}

}  // namespace

std::span<const EditorServer::Notification> EditorServer::notifications() {
  static constexpr std::array<Notification, 6> rows = {{
      {"textDocument/didOpen", &EditorServer::didOpen},
      {"textDocument/didChange", &EditorServer::didChange},
      {"textDocument/didSave", &EditorServer::didSave},
      {"textDocument/didClose", &EditorServer::didClose},
      {"workspace/didChangeWatchedFiles", &EditorServer::filesChanged},
      {"workspace/didChangeConfiguration", &EditorServer::filesChanged},
  }};
  return rows;
}

Exit EditorServer::run() {
  serve();
  return isShutDown_ ? Exit::Clean : Exit::Found;
}

void EditorServer::handle(const RpcMessage& message) {
  if (message.method == "exit") return stop();
  if (!message.isRequest()) {
    if (!isInitialized_ || isShutDown_) return;
    for (const Notification& row : notifications()) {
      if (row.method == message.method) (this->*row.take)(message.params);
    }
    return;
  }
  if (!isInitialized_ && message.method != "initialize")
    return refuse(message.id, RpcCode::NotInitialized, "the first request is 'initialize'");
  if (isShutDown_) return refuse(message.id, RpcCode::InvalidRequest, "the server has been shut down");
  if (message.method == "workspace/executeCommand") return executeCommand(message);
  const auto row = std::ranges::find(requests(), message.method, &Request::method);
  if (row == requests().end())
    return refuse(message.id, RpcCode::MethodNotFound, fmt::format("there is no method '{}'", message.method));
  Answer answer = (this->*row->answer)(message);
  if (const RpcFault* fault = std::get_if<RpcFault>(&answer)) return refuse(message.id, fault->code, fault->message);
  reply(*message.id, std::move(std::get<Json>(answer)));
}

EditorServer::Answer EditorServer::initialize(const RpcMessage& message) {
  if (isInitialized_) return RpcFault{RpcCode::InvalidRequest, "the server is initialized already"};
  isInitialized_ = true;
  std::string root = textOf(message.params, {"rootUri"});
  if (const Json* const folders = message.params.find("workspaceFolders"); folders != nullptr && !folders->empty())
    root = textOf(folders->items().front(), {"uri"});
  if (root.starts_with("file://")) folder_ = pathOfUri(root, folder_);
  const Json* const refresh = memberOf(message.params, {"capabilities", "workspace", "codeLens", "refreshSupport"});
  refreshesLenses_ = refresh != nullptr && refresh->isTrue();
  return Json{{"capabilities", capabilities()},
              {"serverInfo", Json{{"name", "rungproof"}, {"version", programVersion()}}}};
}

EditorServer::Answer EditorServer::shutdown(const RpcMessage&) {
  isShutDown_ = true;
  return Json(nullptr);
}

EditorServer::Open* EditorServer::openOf(const Json& params) {
  const auto found = open_.find(textOf(params, {"textDocument", "uri"}));
  return found == open_.end() ? nullptr : &found->second;
}

void EditorServer::didOpen(const Json& params) {
  Document document;
  document.uri = textOf(params, {"textDocument", "uri"});
  document.text = textOf(params, {"textDocument", "text"});
  const Json* const text = memberOf(params, {"textDocument", "text"});
  if (document.uri.empty() || text == nullptr || text->kind() != Json::Kind::Text) return;
  document.path = pathOfUri(document.uri, folder_);
  if (const Json* const version = memberOf(params, {"textDocument", "version"}))
    document.version = static_cast<std::int64_t>(version->natural().value_or(0));
  holdText(document.path, {document.text, encodingOnDisk(context_, document.path)});
  Open& open = open_[document.uri];
  open.document = std::move(document);
  makeStale(open);
}

void EditorServer::didChange(const Json& params) {
  Open* const open = openOf(params);
  const Json* const changes = params.find("contentChanges");
  if (open == nullptr || changes == nullptr) return;
  Document& document = open->document;
  for (const Json& change : changes->items()) {
    if (!applyChange(document, change))
      notify("window/logMessage", {{"type", 1}, {"message", "a change without a text was left out"}});
  }
  if (const Json* const version = memberOf(params, {"textDocument", "version"}))
    document.version = static_cast<std::int64_t>(version->natural().value_or(0));
  const HeldText* const held = heldText(document.path);
  holdText(document.path, {document.text, held == nullptr ? TextEncoding::Utf8 : held->encoding});
  makeStale(*open);
}

/// What lies on the disk has changed: configurations and tables count anew for all documents.
void EditorServer::didSave(const Json&) { makeAllStale(); }
void EditorServer::filesChanged(const Json&) { makeAllStale(); }

void EditorServer::didClose(const Json& params) {
  Open* const open = openOf(params);
  if (open == nullptr) return;
  const std::string uri = open->document.uri;
  releaseText(open->document.path);
  open_.erase(uri);
  notify("textDocument/publishDiagnostics", {{"uri", uri}, {"diagnostics", Json::array()}});
  makeAllStale();
}

void EditorServer::makeAllStale() {
  for (auto& [uri, open] : open_) {
    open.checked.reset();
    open.isPublished = false;
  }
}

/// The document, and those whose program reads it too.
void EditorServer::makeStale(Open& changed) {
  changed.isPublished = false;
  changed.checked.reset();
  for (auto& [uri, open] : open_) {
    if (open.checked == nullptr) continue;
    const SourceSet& sources = *open.checked->program().sources;
    const std::string name = nameInProject(changed.document.path, open.checked->settings().root());
    for (std::uint32_t i = 0; i < sources.size() && open.checked != nullptr; ++i) {
      if (sources.file(i).name() != name) continue;
      open.checked.reset();
      open.isPublished = false;
    }
  }
}

const CheckedDocument& EditorServer::checked(Open& open) {
  if (open.checked == nullptr) open.checked = std::make_unique<const CheckedDocument>(context_, open.document);
  return *open.checked;
}

void EditorServer::publish(Open& open) {
  const CheckedDocument& document = checked(open);
  Json diagnostics = diagnosticsOf(document);
  addVerdicts(document, open.verdicts, diagnostics);
  notify("textDocument/publishDiagnostics",
         {{"uri", document.uri()}, {"version", document.version()}, {"diagnostics", std::move(diagnostics)}});
  open.isPublished = true;
}

void EditorServer::settle() {
  for (auto& [uri, open] : open_) {
    if (!open.isPublished) publish(open);
  }
}

}  // namespace rungproof
