#include "web/api.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/base/version.hpp"
#include "web/answers.hpp"

namespace taut::web {
namespace {

using Json = nlohmann::ordered_json;

ApiReply as_json(int status, const Json& json) {
  return {.status = status, .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

ApiReply no_method() { return refusal(405, "there is no such method here"); }
ApiReply nothing() { return refusal(404, "there is nothing of that name"); }
ApiReply no_job() { return refusal(404, "there is no such job; of those that have ended only the latest are kept"); }

ApiReply refusal_of(const FolderError& error) {
  switch (error.kind) {
    case FolderError::Kind::outside:
    case FolderError::Kind::no_deck:
      return refusal(403, error.message);
    case FolderError::Kind::missing:
      return refusal(404, error.message);
    case FolderError::Kind::too_large:
      return refusal(413, error.message);
    default:
      return refusal(500, error.message);
  }
}

Json entry_of(const JobNews& news) {
  return {{"id", news.id},
          {"name", news.name},
          {"state", to_text(news.state)},
          {"stopping", news.stopping},
          {"took", 1000 * news.took},
          {"progress", {{"what", news.progress.what}, {"done", news.progress.done}, {"words", news.progress.words}}}};
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream in(path);
  for (std::string part; std::getline(in, part, '/');) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

ApiReply files(const Folder& folder) {
  const Folder::Listing found = folder.list();
  return as_json(200, {{"names", found.names}, {"whole", found.whole}});
}

ApiReply file(const ApiRequest& request, const Folder& folder) {
  const auto name = request.query.find("name");
  if (name == request.query.end()) return refusal(400, "the name of a file is missing");
  if (request.method == "PUT") {
    const auto done = folder.save(name->second, request.body);
    return done ? as_json(200, {{"saved", name->second}}) : refusal_of(done.error());
  }
  if (request.method != "GET") return no_method();
  auto text = folder.open(name->second);
  if (!text) return refusal_of(text.error());
  return {.type = "text/plain; charset=utf-8", .body = std::move(*text)};
}

ApiReply all_jobs(const ApiRequest& request, Jobs& jobs) {
  if (request.method == "GET") {
    Json list = Json::array();
    for (const JobNews& news : jobs.list()) list.push_back(entry_of(news));
    return as_json(200, {{"jobs", std::move(list)}});
  }
  if (request.method != "POST") return no_method();
  try {
    const auto id = jobs.add(asked_deck(request.body));
    if (!id) return refusal(503, "too many calculations are waiting; stop some, or try again");
    return as_json(201, {{"id", *id}});
  } catch (const std::invalid_argument& e) {
    return refusal(400, e.what());
  }
}

ApiReply part_of_job(const std::string& id, const std::string& what, Jobs& jobs) {
  if (what == "events") return {.type = "text/event-stream", .events_of = id};
  if (what == "deck") {
    const auto deck = jobs.deck(id);
    return deck ? ApiReply{.body = to_json(*deck)} : no_job();
  }
  const bool report = what == "report";
  if (!report && what != "json" && what != "pictures") return nothing();
  const auto end = jobs.end(id);
  if (!end || !end->result) return refusal(404, "this job has no result");
  // as a text: the page shows a report in a frame without rights, and nothing else may
  return {.type = report ? "text/plain; charset=utf-8" : "application/json", .body = part_of(*end->result, what)};
}

ApiReply one_job(const ApiRequest& request, const std::vector<std::string>& parts, Jobs& jobs) {
  const std::string& id = parts[2];
  const auto news = jobs.news(id);
  if (!news) return no_job();
  const std::string what = parts.size() > 3 ? parts[3] : "";
  if (parts.size() > 4) return nothing();
  if (request.method == "GET" && !what.empty()) return part_of_job(id, what, jobs);
  if (request.method == "GET") {
    const auto end = jobs.end(id);
    return end ? ApiReply{.body = *end->answer} : as_json(202, entry_of(*news));
  }
  if (request.method == "POST" && what == "stop") return jobs.stop(id) ? as_json(202, {{"id", id}}) : no_job();
  if (request.method == "DELETE" && what.empty()) return jobs.drop(id) ? as_json(200, {{"id", id}}) : no_job();
  return no_method();
}

}  // namespace

ApiReply refusal(int status, const std::string& why) { return as_json(status, {{"error", why}}); }

std::string event_of(const JobNews& news) {
  return fmt::format("event: {}\ndata: {}\n\n", news.ended() ? "done" : "progress",
                     entry_of(news).dump(-1, ' ', false, Json::error_handler_t::replace));
}

ApiReply answer(const ApiRequest& request, const Folder& folder, Jobs& jobs) {
  const std::vector<std::string> parts = parts_of(request.path);
  if (parts.size() < 2 || parts[0] != "api") return nothing();
  const std::string& what = parts[1];
  if (what == "jobs") return parts.size() == 2 ? all_jobs(request, jobs) : one_job(request, parts, jobs);
  if (parts.size() > 2) return nothing();
  if (what == "file") return file(request, folder);
  if (what != "hello" && what != "schema" && what != "files") return nothing();
  if (request.method != "GET") return no_method();
  if (what == "files") return files(folder);
  if (what == "schema") return {.body = page_schema()};
  return as_json(200, {{"version", version}, {"folder", folder.path().string()}});
}

}  // namespace taut::web
