#include "progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "environment.hpp"

namespace toccata::command {

namespace {

/// How often a line is told where there is no terminal.
Seconds line_pause() {
  using namespace std::chrono_literals;
  return seconds_of_environment("TOCCATA_PROGRESS_SECONDS", 1min, 24h, "a day");
}

std::string duration_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      terminal_(isatty(STDERR_FILENO) != 0),
      line_pause_(terminal_ ? Seconds{} : line_pause()),
      shower_([this] { keep_showing(); }) {}

ProgressBar::~ProgressBar() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  over_.notify_one();
  shower_.join();
  if (drawn_) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::callback() {
  return [this](std::size_t done, std::size_t total) {
    const std::lock_guard lock(mutex_);
    done_ = done;
    total_ = total;
  };
}

void ProgressBar::keep_showing() {
  std::unique_lock lock(mutex_);
  Seconds pause = terminal_ ? Seconds(0.5) : line_pause_;
  while (!over_.wait_for(lock, pause, [this] { return is_over_; })) {
    show();
    pause = terminal_ ? Seconds(0.1) : line_pause_;
  }
}

void ProgressBar::show() {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::string so_far = total_ == 0 ? "" : fmt::format(" {}/{}", done_, total_);
  const std::string left = time_left(seconds);
  if (!terminal_) {
    fmt::print(stderr, "toccata: {}{}, {}{}\n", label_, so_far, duration_text(seconds), left);
    return;
  }
  drawn_ = true;
  constexpr std::size_t width = 32;
  const std::size_t filled = total_ == 0 ? 0 : width * done_ / total_;
  const std::string bar = total_ == 0 ? "" : fmt::format(" [{:#<{}}{:.<{}}]", "", filled, "", width - filled);
  fmt::print(stderr, "\r{}{}{}, {:.0f} s{}\033[K", label_, bar, so_far, seconds, left);
  std::fflush(stderr);
}

std::string ProgressBar::time_left(double seconds) const {
  constexpr double soonest = 2;  // before it nothing can be told
  if (seconds < soonest || done_ == 0 || done_ >= total_) return {};
  const double rate = static_cast<double>(done_) / seconds, left = static_cast<double>(total_ - done_) / rate;
  return fmt::format(", {:.3g} a second, some {} left", rate, duration_text(left));
}

}  // namespace toccata::command
