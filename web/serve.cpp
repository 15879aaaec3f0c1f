#include "web/serve.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "taut/app/job.hpp"
#include "web/access.hpp"
#include "web/api.hpp"
#include "web/folder.hpp"
#include "web/jobs.hpp"
#include "web/page_files.hpp"

namespace taut::web {
namespace {

namespace fs = std::filesystem;

/// A thread waits with each open request. Readers of events have one each for as long as a job runs, so there are
/// always threads left for short questions.
constexpr std::size_t http_threads = 48;
constexpr int most_readers = 24;
/// A reader that is gone is noticed when something is written to it.
constexpr std::chrono::milliseconds heartbeat{1000};
constexpr std::size_t short_body = std::size_t{1024} * 1024;
constexpr std::size_t longest_path = 1000;  // the server's own matching of paths goes as deep as they are long

/// The threads of the server. Its matching of a header takes a frame of the stack for each letter.
class Waiters : public httplib::TaskQueue {
 public:
  explicit Waiters(std::size_t count) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack);
    for (std::size_t i = 0; i < count; ++i) {
      pthread_t thread{};
      if (pthread_create(&thread, &attributes, &Waiters::entry, this) == 0) threads_.push_back(thread);
    }
    pthread_attr_destroy(&attributes);
    if (threads_.empty()) throw std::runtime_error("no thread can be made");
  }
  void enqueue(std::function<void()> task) override {
    {
      const std::lock_guard lock(turn_);
      tasks_.push_back(std::move(task));
    }
    more_.notify_one();
  }
  void shutdown() override {
    {
      const std::lock_guard lock(turn_);
      closing_ = true;
    }
    more_.notify_all();
    for (const pthread_t thread : threads_) pthread_join(thread, nullptr);
    threads_.clear();
  }

 private:
  static constexpr std::size_t stack = std::size_t{64} * 1024 * 1024;  // of addresses: memory is taken when used
  static void* entry(void* self) {
    static_cast<Waiters*>(self)->work();
    return nullptr;
  }
  void work() {
    while (true) {
      std::function<void()> task;
      {
        std::unique_lock lock(turn_);
        more_.wait(lock, [&] { return closing_ || !tasks_.empty(); });
        if (tasks_.empty()) return;
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      task();
    }
  }

  std::mutex turn_;
  std::condition_variable more_;
  std::deque<std::function<void()>> tasks_;
  bool closing_ = false;
  std::vector<pthread_t> threads_;
};

/// The text at `path` of the deck's folder: a deck of anybody may name any file of the machine.
io::FileReader reader_of(const Folder& folder) {
  return [&folder](const std::string& path) -> tl::expected<std::string, io::Unreadable> {
    auto text = folder.read(path);
    if (text) return std::move(*text);
    return tl::unexpected(
        io::Unreadable{.message = text.error().message, .missing = text.error().kind == FolderError::Kind::missing});
  };
}

std::string token_of(const httplib::Request& request) {
  const std::string header = request.get_header_value("X-Taut-Token");
  return header.empty() ? request.get_param_value("token") : header;
}

void put(httplib::Response& response, const ApiReply& reply) {
  response.status = reply.status;
  response.set_content(reply.body, reply.type);
}

/// Bytes of the body of a request; empty where the request does not say it, or says it twice.
std::optional<std::size_t> length_of(const httplib::Request& request) {
  if (request.has_header("Transfer-Encoding") || request.get_header_value_count("Content-Length") != 1) {
    return std::nullopt;
  }
  const std::string length = request.get_header_value("Content-Length");
  std::size_t bytes = 0;
  const auto [end, code] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  const bool number = code == std::errc{} && end == length.data() + length.size();
  return number ? std::optional(bytes) : std::nullopt;
}

/// Why the body of a request is not read; empty: it is.
std::optional<ApiReply> unreadable_body(const httplib::Request& request) {
  const auto bytes = length_of(request);
  if (request.method == "GET" || request.method == "DELETE") {
    const bool says_so = request.has_header("Transfer-Encoding") || request.has_header("Content-Length");
    if (says_so && bytes != 0) return refusal(400, "this request has no body");
    return std::nullopt;
  }
  // its length is known before it is read: the server bounds no other body
  if (!bytes) return refusal(411, "the length of the body is missing");
  if (*bytes > largest_body) return refusal(413, fmt::format("more than {} MB", largest_body / 1024 / 1024));
  if (request.has_header("Content-Encoding")) return refusal(415, "a packed body is not read");
  const std::string type = request.get_header_value("Content-Type");
  if (*bytes > 0 && !type.starts_with("application/json") && !type.starts_with("text/plain")) {
    return refusal(415, "the body is neither application/json nor text/plain");
  }
  return std::nullopt;
}

/// Reads what is short and throws it away: of a connection that is closed with something unread the answer may be lost.
void throw_away(const httplib::Request& request, const httplib::ContentReader& reader) {
  const std::size_t bytes = length_of(request).value_or(0);
  if (bytes > 0 && bytes <= short_body && !request.has_header("Content-Encoding")) {
    reader([](const char*, std::size_t) { return true; });
  }
}

class Server {
 public:
  Server(Folder folder, Access access, ServedPage page)
      : folder_(std::move(folder)), access_(std::move(access)), page_(std::move(page)) {
    http_.new_task_queue = [] { return new Waiters(http_threads); };
    http_.set_socket_options([](socket_t socket) {
      // not SO_REUSEPORT, the server's own choice: with it two programs have one port, and neither knows
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    // a connection keeps a thread: one that is idle, or is read by nobody, has it not for long
    http_.set_keep_alive_max_count(1);
    http_.set_keep_alive_timeout(1);
    http_.set_read_timeout(2);
    http_.set_payload_max_length(largest_body);
    http_.set_default_headers({{"Content-Security-Policy", policy(page_.nonce)},
                               {"X-Content-Type-Options", "nosniff"},
                               {"X-Frame-Options", "DENY"},
                               {"Referrer-Policy", "no-referrer"},
                               {"Cross-Origin-Opener-Policy", "same-origin"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Cache-Control", "no-store"}});
    // before the server looks for a handler, as far as no body is to be read
    http_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      const bool handler_reads = has_body(request) && request.path.size() <= longest_path;
      const auto why = handler_reads ? std::nullopt : turned_away(request);
      if (why) put(response, *why);
      return why ? httplib::Server::HandlerResponse::Handled : httplib::Server::HandlerResponse::Unhandled;
    });
    http_.Get(".*",
              [this](const httplib::Request& request, httplib::Response& response) { handle(request, {}, response); });
    const auto with_body = [this](const httplib::Request& request, httplib::Response& response,
                                  const httplib::ContentReader& reader) {
      if (const auto why = turned_away(request)) {
        throw_away(request, reader);
        return put(response, *why);
      }
      std::string body;
      const auto take = [&body](const char* data, std::size_t bytes) {
        body.append(data, bytes);
        return body.size() <= largest_body;
      };
      if (length_of(request).value_or(0) > 0 && !reader(take))
        return put(response, refusal(400, "the body ends early"));
      handle(request, std::move(body), response);
    };
    http_.Post(".*", with_body).Put(".*", with_body).Delete(".*", with_body);
    http_.set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
      put(response, refusal(500, "an error of taut"));
    });
  }

  /// The port that it listens at; empty: that port is taken.
  std::optional<int> bind(int port) {
    const bool any = port == 0;
    if (any) port = http_.bind_to_any_port("127.0.0.1");
    if (port <= 0 || (!any && !http_.bind_to_port("127.0.0.1", port))) return std::nullopt;
    access_.port = port;
    return port;
  }

  void run(const std::function<bool()>& goes_on) {
    std::atomic<bool> ended = false;
    std::thread listening([&] {
      http_.listen_after_bind();
      ended = true;
    });
    while (goes_on() && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    closing_ = true;
    // the server knows how to end only once it has begun
    while (!http_.is_running() && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    http_.stop();
    listening.join();
  }

 private:
  static bool has_body(const httplib::Request& request) {
    return request.method == "POST" || request.method == "PUT" || request.method == "DELETE";
  }

  /// Why a request is not answered; empty: it is.
  std::optional<ApiReply> turned_away(const httplib::Request& request) const {
    const Caller caller{.host = request.get_header_value("Host"),
                        .origin = request.get_header_value("Origin"),
                        .token = token_of(request)};
    if (request.get_header_value_count("Host") > 1 || request.get_header_value_count("Origin") > 1) {
      return refusal(400, "a header stands twice");
    }
    if (const auto why = refused(caller, access_)) return refusal(403, *why);
    if (request.path.size() > longest_path) return refusal(414, "the path is too long");
    if (request.method != "GET" && !has_body(request)) return refusal(405, "there is no such method here");
    return unreadable_body(request);
  }

  void handle(const httplib::Request& request, std::string body, httplib::Response& response) {
    const auto file = page_.files.find(request.path);
    if (request.method == "GET" && file != page_.files.end()) {
      response.set_content(file->second.text, file->second.type);
      return;
    }
    ApiRequest asked{.method = request.method, .path = request.path, .query = {}, .body = std::move(body)};
    for (const auto& [key, value] : request.params) asked.query.emplace(key, value);
    const ApiReply reply = answer(asked, folder_, jobs_);
    if (reply.events_of.empty()) return put(response, reply);
    if (readers_.fetch_add(1) >= most_readers) {
      --readers_;
      return put(response, refusal(503, "too many pages read events; close some"));
    }
    send_events(reply.events_of, response);
  }

  void send_events(const std::string& id, httplib::Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, id, seen = -1L](std::size_t, httplib::DataSink& sink) mutable {
          const auto news = jobs_.wait(id, seen, heartbeat);
          const bool goes_on = news && !closing_;
          const std::string text = news && news->version != seen ? event_of(*news) : std::string(": \n\n");
          if (news) seen = news->version;
          if (!sink.write(text.data(), text.size())) return false;
          if (!goes_on || news->ended()) sink.done();
          return true;
        },
        [this](bool) { --readers_; });
  }

  Folder folder_;
  Access access_;
  ServedPage page_;
  std::atomic<int> readers_ = 0;
  std::atomic<bool> closing_ = false;
  Jobs jobs_{JobLimits{.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U))},
             [this](const AskedDeck& deck, const std::function<bool(const Progress&)>& goes_on) {
               app::Job job = job_of(deck, reader_of(folder_));
               job.progress = goes_on;
               return app::run(job);
             }};
  httplib::Server http_;  // the last: its threads use all the others
};

tl::unexpected<ServeError> no_files(std::string message) {
  return tl::unexpected(ServeError{.of_files = true, .message = std::move(message)});
}

}  // namespace

tl::expected<void, ServeError> serve(const ServeOptions& options,
                                     const std::function<void(const std::string& address)>& ready,
                                     const std::function<bool()>& goes_on) {
  std::error_code failed;
  const auto places = page_places(options.page, fs::read_symlink("/proc/self/exe", failed));
  const auto place = page_in(places);
  if (!place) {
    return no_files(
        fmt::format("the page is not there: it is neither in {} nor in {}; './dev web' in the source tree makes it, "
                    "--page names it",
                    places[0].string(), places[1].string()));
  }
  try {
    const std::string token = new_token();
    Server server(Folder(options.folder), {.port = 0, .token = token}, read_page(*place, token));
    const auto port = server.bind(options.port);
    if (!port) {
      return tl::unexpected(
          ServeError{.message = fmt::format(
                         "port {} of 127.0.0.1 is taken, or not yours to take; without --port a free one is chosen",
                         options.port)});
    }
    ready(fmt::format("http://127.0.0.1:{}/?token={}", *port, token));
    server.run(goes_on);
    return {};
  } catch (const fs::filesystem_error& e) {
    return no_files(fmt::format("'{}' can't be served: {}", options.folder, e.code().message()));
  } catch (const std::runtime_error& e) {
    return no_files(e.what());
  }
}

}  // namespace taut::web
