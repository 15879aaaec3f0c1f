#include "web/jobs.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <exception>
#include <utility>

namespace taut::web {

struct Jobs::Kept {
  long number = 0;
  AskedDeck deck;
  JobNews news;
  JobEnd end;
  std::atomic<bool> goes_on = true;
  std::chrono::steady_clock::time_point told;
};

namespace {

std::size_t size_of(const AskedDeck& deck) {
  std::size_t bytes = deck.text.size();
  for (const auto& [name, text] : deck.files) bytes += name.size() + text.size();
  return bytes;
}

}  // namespace

std::string_view to_text(JobState state) {
  switch (state) {
    case JobState::waiting:
      return "waiting";
    case JobState::running:
      return "running";
    case JobState::done:
      return "done";
    case JobState::stopped:
      return "stopped";
    default:
      return "failed";
  }
}

Jobs::Jobs(JobLimits limits, Solver solver) : limits_(limits), solver_(std::move(solver)) {
  for (int i = 0; i < std::max(limits_.threads, 1); ++i) threads_.emplace_back([this] { work(); });
}

Jobs::~Jobs() {
  {
    const std::lock_guard lock(turn_);
    closing_ = true;
    queue_.clear();
    for (const auto& [_, job] : jobs_) job->goes_on = false;
  }
  more_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::optional<std::string> Jobs::add(AskedDeck deck) {
  auto job = std::make_shared<Kept>();
  job->deck = std::move(deck);
  job->news.name = job->deck.name;
  const std::lock_guard lock(turn_);
  std::size_t bytes = size_of(job->deck);
  for (const auto& other : queue_) bytes += size_of(other->deck);
  if (queue_.size() >= limits_.waiting || bytes > limits_.bytes) return std::nullopt;
  job->number = ++last_;
  job->news.id = std::to_string(job->number);
  jobs_.emplace(job->number, job);
  queue_.push_back(job);
  more_.notify_one();
  return job->news.id;
}

std::shared_ptr<Jobs::Kept> Jobs::find(const std::string& id) const {
  long number = 0;
  const auto [end, code] = std::from_chars(id.data(), id.data() + id.size(), number);
  if (code != std::errc{} || end != id.data() + id.size()) return nullptr;
  const auto found = jobs_.find(number);
  return found == jobs_.end() ? nullptr : found->second;
}

std::vector<JobNews> Jobs::list() const {
  const std::lock_guard lock(turn_);
  std::vector<JobNews> all;
  all.reserve(jobs_.size());
  for (const auto& [_, job] : jobs_) all.push_back(job->news);
  return all;
}

std::optional<JobNews> Jobs::news(const std::string& id) const {
  const std::lock_guard lock(turn_);
  const auto job = find(id);
  if (!job) return std::nullopt;
  return job->news;
}

std::optional<JobEnd> Jobs::end(const std::string& id) const {
  const std::lock_guard lock(turn_);
  const auto job = find(id);
  if (!job || !job->news.ended()) return std::nullopt;
  return job->end;
}

std::optional<AskedDeck> Jobs::deck(const std::string& id) const {
  const std::lock_guard lock(turn_);
  const auto job = find(id);
  if (!job) return std::nullopt;
  return job->deck;
}

std::optional<JobNews> Jobs::wait(const std::string& id, long seen, std::chrono::milliseconds longest) const {
  std::unique_lock lock(turn_);
  const auto job = find(id);
  if (!job) return std::nullopt;
  changed_.wait_for(lock, longest, [&] { return job->news.version != seen; });
  return job->news;
}

bool Jobs::stop(const std::string& id) {
  const std::lock_guard lock(turn_);
  const auto job = find(id);
  if (!job) return false;
  if (job->news.ended()) return true;
  job->goes_on = false;
  job->news.stopping = true;
  ++job->news.version;
  if (std::erase(queue_, job) > 0) {
    job->news.state = JobState::stopped;
    job->end.answer = std::make_shared<const std::string>(failure("stopped before it began"));
    forget_old();
  }
  changed_.notify_all();
  return true;
}

bool Jobs::drop(const std::string& id) {
  if (!stop(id)) return false;
  const std::lock_guard lock(turn_);
  const auto job = find(id);
  if (job) jobs_.erase(job->number);
  return true;
}

void Jobs::work() {
  while (true) {
    std::shared_ptr<Kept> job;
    {
      std::unique_lock lock(turn_);
      more_.wait(lock, [&] { return closing_ || !queue_.empty(); });
      if (closing_) return;
      job = queue_.front();
      queue_.pop_front();
      job->news.state = JobState::running;
      ++job->news.version;
    }
    changed_.notify_all();
    calculate(*job);
  }
}

/// A few times a second: who listens is told all that has changed, and would get nothing else done.
void Jobs::tell(Kept& job, const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (now - job.told < std::chrono::milliseconds(100)) return;
  job.told = now;
  {
    const std::lock_guard lock(turn_);
    job.news.progress = progress;
    ++job.news.version;
  }
  changed_.notify_all();
}

void Jobs::calculate(Kept& job) {
  const auto began = std::chrono::steady_clock::now();
  JobEnd end;
  JobState state = JobState::failed;
  try {
    auto result = std::make_shared<const Result>(solver_(job.deck, [&](const Progress& progress) {
      tell(job, progress);
      return job.goes_on.load();
    }));
    end.answer = std::make_shared<const std::string>(answer_of(*result, job.deck.text));
    state = result->interrupted ? JobState::stopped : JobState::done;
    end.result = std::move(result);
  } catch (const std::exception& e) {
    end.answer = std::make_shared<const std::string>(failure(e.what()));
  }
  {
    const std::lock_guard lock(turn_);
    job.end = std::move(end);
    job.news.state = state;
    job.news.took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    ++job.news.version;
    forget_old();
  }
  changed_.notify_all();
}

/// Called with the turn taken.
void Jobs::forget_old() {
  std::size_t count = 0, bytes = 0;
  for (auto at = jobs_.end(); at != jobs_.begin();) {
    --at;
    const Kept& job = *at->second;
    if (!job.news.ended()) continue;
    bytes += size_of(job.deck) + (job.end.answer ? job.end.answer->size() : 0);
    ++count;
    if (count > limits_.ended || (count > 1 && bytes > limits_.bytes)) at = jobs_.erase(at);
  }
}

}  // namespace taut::web
