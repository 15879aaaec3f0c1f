#pragma once
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "web/answers.hpp"

namespace taut::web {

/// How many jobs there may be.
struct JobLimits {
  int threads = 1;            ///< jobs at work at the same time
  std::size_t waiting = 200;  ///< jobs in the queue
  std::size_t ended = 100;    ///< of the jobs that have ended so many are kept, the latest
  /// Of the decks in the queue, and of the decks and answers of the jobs that have ended; the latest one is kept
  /// always.
  std::size_t bytes = std::size_t{256} * 1024 * 1024;
};

enum class JobState { waiting, running, done, stopped, failed };
std::string_view to_text(JobState state);

/// What there is to say of a job at one moment.
struct JobNews {
  std::string id = {};
  std::string name = {};  ///< of its deck
  JobState state = JobState::waiting;
  Progress progress = {};
  bool stopping = false;  ///< it was asked to stop
  double took = 0;        ///< time at work, s
  long version = 0;       ///< changes with everything above

  bool ended() const { return state != JobState::waiting && state != JobState::running; }
};

/// A job that has ended. `result` is empty where it has none: failed, or stopped before it began.
struct JobEnd {
  std::shared_ptr<const Result> result;
  std::shared_ptr<const std::string> answer;  ///< {page, places} or {failure}
};

/// Calculates decks on some threads, in the order in which they come, whoever looks or does not. A job lives here and
/// not in a connection: it goes on when its page is closed, and what it has found is kept until later ones push it out.
/// All members may be called from any thread.
class Jobs {
 public:
  /// Calculates a deck; `goes_on` is to be called from time to time, and false ends the calculation early.
  using Solver = std::function<Result(const AskedDeck& deck, const std::function<bool(const Progress&)>& goes_on)>;

  Jobs(JobLimits limits, Solver solver);
  ~Jobs();  ///< stops all jobs and waits for their ends
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  std::optional<std::string> add(AskedDeck deck);  ///< its id; empty: the queue is full
  std::vector<JobNews> list() const;               ///< the oldest first
  std::optional<JobNews> news(const std::string& id) const;
  std::optional<JobEnd> end(const std::string& id) const;  ///< empty: there is no such job, or it has not ended
  std::optional<AskedDeck> deck(const std::string& id) const;

  /// Waits until a job has another version than `seen`, at most so long. Empty: there is no such job.
  std::optional<JobNews> wait(const std::string& id, long seen, std::chrono::milliseconds longest) const;

  /// Asks a job to end early with what it has. One that waits in the queue ends at once, without a result. False: there
  /// is no such job.
  bool stop(const std::string& id);

  /// Stops a job and forgets it. False: there is no such job.
  bool drop(const std::string& id);

 private:
  struct Kept;
  void work();
  void calculate(Kept& job);
  void tell(Kept& job, const Progress& progress);
  void forget_old();
  std::shared_ptr<Kept> find(const std::string& id) const;

  const JobLimits limits_;
  const Solver solver_;
  mutable std::mutex turn_;  ///< for all that follows
  mutable std::condition_variable changed_;
  std::condition_variable more_;
  std::map<long, std::shared_ptr<Kept>> jobs_;
  std::deque<std::shared_ptr<Kept>> queue_;
  long last_ = 0;
  bool closing_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace taut::web
