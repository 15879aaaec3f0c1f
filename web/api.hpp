#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "web/folder.hpp"
#include "web/jobs.hpp"

/// What the page asks `taut serve`, without the HTTP around it (serve.cpp).
///
///   GET    /api/hello              {version, folder}
///   GET    /api/schema             schema of decks
///   GET    /api/files              {names: [..], whole}: the decks and tables of the folder
///   GET    /api/file?name=NAME     its text
///   PUT    /api/file?name=NAME     writes it
///   GET    /api/jobs               {jobs: [{id, name, state, stopping, took (ms), progress: {what, done,
///                                  words}}]}, the oldest first
///   POST   /api/jobs               {text, name, files, set} -> 201 {id}; 503 while too many wait
///   GET    /api/jobs/ID            {page, places} or {failure}, as the engine of a browser answers; 202 with the
///                                  job's entry of the list while it has not ended
///   GET    /api/jobs/ID/deck       {text, name, files, set}
///   GET    /api/jobs/ID/report     of the result; also json (result.json), pictures
///   GET    /api/jobs/ID/events     server-sent events: "progress" with the job's entry of the list whenever that
///                                  changes, and "done" at its end
///   POST   /api/jobs/ID/stop       it ends early with what it has
///   DELETE /api/jobs/ID            stops and forgets it
///
/// A refusal is {error} with its status: 400 no deck, 403 outside the folder, 404, 405, 413 too large, 503.
namespace taut::web {

struct ApiRequest {
  std::string method;
  std::string path;
  std::map<std::string, std::string> query;
  std::string body = {};
};

struct ApiReply {
  int status = 200;
  std::string type = "application/json";
  std::string body = {};
  std::string events_of = {};  ///< id of a job: its events are the body
};

/// The largest body of a request: a deck of 16 MB with its files, in JSON.
inline constexpr std::size_t largest_body = std::size_t{48} * 1024 * 1024;

/// Answers everything below /api/. May be called from several threads at the same time.
ApiReply answer(const ApiRequest& request, const Folder& folder, Jobs& jobs);

/// A refusal in the words of a person.
ApiReply refusal(int status, const std::string& why);

/// An event of a job for its reader: "event: progress\ndata: {..}\n\n".
std::string event_of(const JobNews& news);

}  // namespace taut::web
