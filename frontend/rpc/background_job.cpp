// What a child process is told of the server, and the result that comes from it.
#include "frontend/rpc/background_job.hpp"

#include "engine/platform/names.hpp"
#include "frontend/files/held_state.hpp"

namespace rungproof {

namespace {

std::string jobRequestText(const Json& asked) {
  Json held = Json::array();
  for (const auto& [name, text] : allHeldTexts())
    held.push_back({{"name", name}, {"text", text.text}, {"encoding", static_cast<unsigned>(text.encoding)}});
  return Json{{"held", std::move(held)}, {"root", pathName(inputsConfinedTo())}, {"asked", asked}}.dump();
}

}  // namespace

std::optional<Json> takeJobRequest(const std::string& request) {
  const std::optional<Json> json = Json::read(request);
  const Json* const held = json ? json->find("held") : nullptr;
  const Json* const root = json ? json->find("root") : nullptr;
  const Json* const asked = json ? json->find("asked") : nullptr;
  if (held == nullptr || root == nullptr || asked == nullptr) return std::nullopt;
  for (const Json& text : held->items()) {
    const Json* const name = text.find("name");
    const Json* const content = text.find("text");
    const Json* const encoding = text.find("encoding");
    if (name == nullptr || content == nullptr || encoding == nullptr) return std::nullopt;
    holdText(name->text(), {content->text(), static_cast<TextEncoding>(encoding->natural().value_or(0))});
  }
  confineInputs(root->text());
  return *asked;
}

BackgroundJob::BackgroundJob(const JobRequest& request)
    : child_(*request.worker, jobRequestText(request.asked), ChildKind::Job) {}

bool BackgroundJob::take() {
  if (child_.output().take(text_) != ByteSource::Taken::End) return false;
  hasEndedWell_ = child_.wait() == 0;
  return true;
}

}  // namespace rungproof
