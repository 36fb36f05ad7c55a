#include "platform/child_process.h"

#include "platform/spawn.h"
#include "platform/stop.h"

#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>
#include <utility>

namespace coif::platform {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kLook{20};    ///< How soon a requested stop is noticed.
constexpr milliseconds kGrace{200};  ///< Time for a worker to end by itself.
constexpr std::uint64_t kMostNoteBytes = 4096;
constexpr auto kNever = Clock::time_point::max();

Clock::time_point after(std::uint32_t limit) {
  return limit == ChildLimits::kForever ? kNever : Clock::now() + seconds(limit);
}

/// Collects a child's answer from the parts that arrive. The child may have been taken over by its input, so nothing
/// that it says about itself is trusted.
class Answer {
 public:
  explicit Answer(const ChildSettings& settings) : settings_(settings) {}

  /// False where it is more than it may be, or makes no sense.
  bool take(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      if (is_answer_) {
        body_.insert(body_.end(), bytes.begin(), bytes.end());
        return body_.size() <= frame_.bytes;
      }
      const std::size_t wanted = has_frame_ ? std::size_t(frame_.bytes) : sizeof frame_;
      const std::size_t count = std::min(bytes.size(), wanted - part_.size());
      part_.insert(part_.end(), bytes.begin(), bytes.begin() + std::ptrdiff_t(count));
      bytes = bytes.subspan(count);
      if (part_.size() == wanted && !(has_frame_ ? end_note() : begin_frame())) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_whole() const { return is_answer_ && body_.size() == frame_.bytes; }
  [[nodiscard]] Bytes take_body() { return std::move(body_); }
  [[nodiscard]] Clock::time_point part_end() const { return part_end_; }

 private:
  bool begin_frame() {
    std::memcpy(&frame_, part_.data(), sizeof frame_);
    part_.clear();
    if (frame_.bytes > settings_.limits.output_bytes - received_) return false;
    received_ += frame_.bytes;
    is_answer_ = frame_.kind == JobFrame::Kind::kAnswer;
    if (is_answer_) return true;
    if (frame_.kind != JobFrame::Kind::kNote || frame_.bytes > kMostNoteBytes) return false;
    has_frame_ = true;
    return frame_.bytes > 0 || end_note();
  }

  bool end_note() {
    has_frame_ = false;
    part_end_ = after(settings_.limits.part_seconds);
    if (settings_.on_note) settings_.on_note({reinterpret_cast<const char*>(part_.data()), part_.size()});
    part_.clear();
    return true;
  }

  const ChildSettings& settings_;
  std::uint64_t received_ = 0;  ///< Bytes, announced ones included.
  Bytes part_;                  ///< The received part of a frame's header, or of a note.
  JobFrame frame_;
  bool has_frame_ = false, is_answer_ = false;
  Bytes body_;
  Clock::time_point part_end_ = after(settings_.limits.part_seconds);
};

/// A process that does a job. Destroying this object early, by a limit or an exception, kills it and waits for it.
class Child {
 public:
  /// `request` and `settings` must outlive the object.
  Child(const Job& job, std::span<const std::uint8_t> request, const ChildSettings& settings)
      : settings_(settings), request_(request), answer_(settings), end_(after(settings.limits.seconds)) {
    const bool is_reader = settings.kind == ChildKind::kReader;
    Spawned spawned = spawn(job, is_reader);
    result_.code = spawned.error;
    if (spawned.error != 0) return;
    header_ = {request.size(), settings.limits.memory_bytes, settings.limits.seconds, is_reader, getpid(), 0};
    line_ = std::move(spawned.line);
    process_ = spawned.process;
    result_.end = ChildResult::End::kFinished;
    send_some();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  [[nodiscard]] bool is_running() const { return process_ > 0; }
  [[nodiscard]] pollfd waits_for() const {
    const bool has_more = sent_ < sizeof header_ + request_.size() && !is_asked_to_stop_;
    return {line_.get(), short(has_more ? POLLIN | POLLOUT : POLLIN), 0};
  }
  [[nodiscard]] Clock::time_point next_deadline() const {
    return is_asked_to_stop_ ? kill_at_ : std::min(end_, answer_.part_end());
  }

  /// Runs after poll(): transfers data, and enforces the limits.
  void go_on(short events) {
    if ((events & POLLOUT) != 0) send_some();
    if ((events & (POLLIN | POLLHUP | POLLERR)) != 0) receive_some();
    if (!is_running() || Clock::now() < next_deadline()) return;
    if (is_asked_to_stop_) return release(result_.end);
    result_.is_part = answer_.part_end() < end_;
    ask_to_stop(ChildResult::End::kTooSlow);
  }

  /// Nobody wants the answer any more, for that reason.
  void ask_to_stop(ChildResult::End why) {
    if (!is_running() || is_asked_to_stop_) return;
    result_.end = why;
    if (settings_.kind == ChildKind::kReader) return release(why);
    is_asked_to_stop_ = true;
    kill_at_ = Clock::now() + kGrace;
    shutdown(line_.get(), SHUT_WR);
  }

  [[nodiscard]] ChildResult take_result() {
    if (result_.end == ChildResult::End::kFinished) result_.output = answer_.take_body();
    return std::move(result_);
  }

 private:
  void send_some() {
    while (sent_ < sizeof header_ + request_.size()) {
      const bool is_head = sent_ < sizeof header_;
      const auto head = std::as_bytes(std::span(&header_, 1)).subspan(is_head ? sent_ : 0);
      const auto body = std::as_bytes(request_).subspan(is_head ? 0 : sent_ - sizeof header_);
      const auto bytes = is_head ? head : body;
      const ssize_t count = send(line_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
      if (count < 0) sent_ = sizeof header_ + request_.size();  // The child has ended; its status says why.
      if (count >= 0) sent_ += std::size_t(count);
    }
  }

  /// Reads data while the child runs, so that neither waits for the other; at the end of the data waits for the child.
  void receive_some() {
    std::uint8_t block[1 << 16];
    const ssize_t count = recv(line_.get(), block, sizeof block, MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (count <= 0) return finish();
    if (is_asked_to_stop_) return;
    if (!answer_.take({block, std::size_t(count)})) release(ChildResult::End::kTooMuchOutput);
  }

  /// The child has closed its line, but need not have ended. If it cannot be waited for (the host ignores SIGCHLD),
  /// only its answer can be judged.
  void finish() {
    int status = 0;
    const auto last = next_deadline();
    for (;;) {
      const pid_t done = waitpid(process_, &status, last == kNever ? 0 : WNOHANG);
      if (done == process_) break;
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) {
        status = 0;
        break;
      }
      if (Clock::now() >= last) return release(is_asked_to_stop_ ? result_.end : ChildResult::End::kTooSlow);
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    process_ = 0;
    if (!is_asked_to_stop_) judge(status);
  }

  void judge(int status) {
    if (WIFSIGNALED(status)) {
      result_.end = WTERMSIG(status) == SIGXCPU ? ChildResult::End::kTooSlow : ChildResult::End::kCrashed;
      result_.code = WTERMSIG(status);
      result_.by_signal = true;
    } else if (WEXITSTATUS(status) != 0 || !answer_.is_whole()) {
      result_.code = WEXITSTATUS(status);
      result_.end = result_.code == kExitOutOfMemory ? ChildResult::End::kOutOfMemory : ChildResult::End::kCrashed;
    }
  }

  /// Ends it at once.
  void release(ChildResult::End why) {
    result_.end = why;
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
  }

  const ChildSettings& settings_;
  std::span<const std::uint8_t> request_;
  JobHeader header_;
  std::size_t sent_ = 0;
  Answer answer_;
  Clock::time_point end_, kill_at_ = kNever;
  bool is_asked_to_stop_ = false;
  Descriptor line_;
  pid_t process_ = -1;
  ChildResult result_;
};

using Children = std::vector<std::unique_ptr<Child>>;

/// Waits until one of them is no longer running.
void wait_for_one(const Children& children, const std::stop_token& stop) {
  const auto is_running = [](const auto& child) { return child->is_running(); };
  while (std::ranges::all_of(children, is_running)) {
    std::vector<pollfd> waiting;
    auto wake = stop.stop_possible() ? Clock::now() + kLook : kNever;
    for (const auto& child : children) {
      waiting.push_back(child->waits_for());
      wake = std::min(wake, child->next_deadline());
    }
    const auto left = wake == kNever ? milliseconds(-1) : std::chrono::ceil<milliseconds>(wake - Clock::now());
    const int longest = wake == kNever ? -1 : int(std::clamp<std::int64_t>(left.count(), 0, 1 << 30));
    if (poll(waiting.data(), waiting.size(), longest) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < children.size(); ++i) {
      children[i]->go_on(waiting[i].revents);
      if (stop.stop_requested()) children[i]->ask_to_stop(ChildResult::End::kTooSlow);
    }
  }
}

}  // namespace

ChildResult run_in_child(const Job& job, std::span<const std::uint8_t> request, const ChildSettings& settings) {
  throw_if_stopped(settings.stop);
  Children child;
  child.push_back(std::make_unique<Child>(job, request, settings));
  wait_for_one(child, settings.stop);
  ChildResult result = child[0]->take_result();
  if (result.end == ChildResult::End::kTooSlow) throw_if_stopped(settings.stop);
  return result;
}

std::vector<std::optional<Bytes>> run_in_processes(const Job& job, const std::vector<Bytes>& requests, unsigned jobs) {
  const ChildSettings settings{.kind = ChildKind::kWorker};
  std::vector<std::optional<Bytes>> answers(requests.size());
  Children running;
  std::vector<std::size_t> index;  // Indices of the running ones.
  for (std::size_t next = 0; next < requests.size() || !running.empty();) {
    for (; next < requests.size() && running.size() < std::max(jobs, 1u); ++next) {
      running.push_back(std::make_unique<Child>(job, requests[next], settings));
      index.push_back(next);
    }
    wait_for_one(running, {});
    for (std::size_t i = running.size(); i-- > 0;) {
      if (running[i]->is_running()) continue;
      ChildResult result = running[i]->take_result();
      if (result.end == ChildResult::End::kFinished) answers[index[i]] = std::move(result.output);
      running.erase(running.begin() + std::ptrdiff_t(i));
      index.erase(index.begin() + std::ptrdiff_t(i));
    }
  }
  return answers;
}

}  // namespace coif::platform
