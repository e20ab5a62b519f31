// A thread that answers the newest question; those that it overtakes are never looked at.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace plinian::window {

template <class Question, class Answer>
class NewestWorker {
 public:
  using AnswerPtr = std::shared_ptr<const Answer>;

  /// work: called on the thread; must not throw. wake: called there when there is an answer; must not block.
  NewestWorker(std::function<Answer(const Question&)> work, std::function<void()> wake)
      : work_(std::move(work)), wake_(std::move(wake)), thread_([this] { run(); }) {}
  ~NewestWorker() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    news_.notify_one();
    thread_.join();
  }
  NewestWorker(const NewestWorker&) = delete;
  NewestWorker& operator=(const NewestWorker&) = delete;

  void ask(Question question) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::move(question);
    }
    news_.notify_one();
  }
  /// The newest answer, or null before the first.
  AnswerPtr answer() const {
    const std::lock_guard lock(mutex_);
    return answer_;
  }
  /// Lets go of the answer, and of a question that was not begun.
  void forget() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    answer_ = nullptr;
  }

 private:
  void run() {
    while (true) {
      std::optional<Question> question;
      {
        std::unique_lock lock(mutex_);
        news_.wait(lock, [this] { return stopping_ || waiting_; });
        if (stopping_) return;
        question = std::exchange(waiting_, std::nullopt);
      }
      auto answer = std::make_shared<const Answer>(work_(*question));
      {
        const std::lock_guard lock(mutex_);
        answer_ = std::move(answer);
      }
      wake_();
    }
  }

  std::function<Answer(const Question&)> work_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable news_;
  std::optional<Question> waiting_;
  AnswerPtr answer_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses the rest
};

}  // namespace plinian::window
