#include "distributed/ranks.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <limits>
#include <new>
#include <thread>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

namespace toccata {
namespace {

/// In how many of these a message is sent, so that it may be of 16 GB: MPI counts with an int.
constexpr std::size_t bytes_of_unit = sizeof(std::uint64_t);

/// Filled up to whole units, and behind them how long it was.
std::vector<std::uint64_t> in_units(const Bytes& bytes) {
  std::vector<std::uint64_t> units((bytes.size() + bytes_of_unit - 1) / bytes_of_unit + 1);
  if (!bytes.empty()) std::memcpy(units.data(), bytes.data(), bytes.size());
  units.back() = bytes.size();
  if (units.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Error("more than 16 GB are to be sent to one rank in one message: use more ranks");
  return units;
}

Bytes out_of_units(std::span<const std::uint64_t> units) {
  Bytes bytes(units.back());
  if (!bytes.empty()) std::memcpy(bytes.data(), units.data(), bytes.size());
  return bytes;
}

}  // namespace

struct Ranks::Handle {
  MPI_Comm communicator = MPI_COMM_NULL;
};

/// Messages on their way.
struct Ranks::Sending {
  std::vector<std::pair<int, std::vector<std::uint64_t>>> messages;  ///< and where they go
  std::vector<MPI_Request> requests;
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool has_all_received = false;  ///< what this rank sent
};

Ranks::Ranks(int communicator, double patience_seconds)
    : handle_(std::make_unique<Handle>()), patience_seconds_(patience_seconds) {
  int is_initialised = 0;
  MPI_Initialized(&is_initialised);
  if (is_initialised == 0) throw Error("MPI is not initialised: call MPI_Init or MPI_Init_thread first");
  const MPI_Comm given = MPI_Comm_f2c(communicator);
  if (given == MPI_COMM_NULL) throw Error("the communicator is none: give what MPI_Comm_c2f tells of one");
  check(MPI_Comm_dup(given, &handle_->communicator), "MPI_Comm_dup");
  // Errors come back to `check`.
  check(MPI_Comm_set_errhandler(handle_->communicator, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
  check(MPI_Comm_rank(handle_->communicator, &rank_), "MPI_Comm_rank");
  check(MPI_Comm_size(handle_->communicator, &count_), "MPI_Comm_size");
}

Ranks::~Ranks() {
  int is_over = 0;
  MPI_Finalized(&is_over);
  if (is_over == 0 && broken_.empty() && handle_->communicator != MPI_COMM_NULL) MPI_Comm_free(&handle_->communicator);
}

void Ranks::require_usable() const {
  if (!broken_.empty()) throw Error(broken_);
}

void Ranks::check(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  broken_ = fmt::format("rank {}: {} failed: {}", rank_, call, std::string(text, static_cast<std::size_t>(length)));
  throw Error(broken_);
}

void Ranks::wait(FunctionRef<bool()> is_done) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  ++collectives_;
  while (!is_done()) {
    const double waited = seconds();
    if (waited > patience_seconds_) {
      broken_ = fmt::format(
          "rank {}: the other ranks have not answered for {} s: one of them has ended, or calls something else", rank_,
          patience_seconds_);
      throw Error(broken_);
    }
    // Ranks may share a core.
    if (waited > 0.1)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    else
      std::this_thread::yield();
  }
  seconds_waited_ += seconds();
}

namespace {

bool is_complete(MPI_Request& request, int& code) {
  int done = 0;
  code = MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return code != MPI_SUCCESS || done != 0;
}

/// What MPI still writes to when a wait is given up stays allocated: it belongs to MPI for good.
template <class T>
class LentToMpi {
 public:
  explicit LentToMpi(T value) : value_(std::make_unique<T>(std::move(value))) {}
  T& operator*() { return *value_; }
  T* operator->() { return value_.get(); }
  template <class Wait>
  void during(const Wait& wait) {
    try {
      wait();
    } catch (...) {
      static_cast<void>(value_.release());
      throw;
    }
  }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace

template <class Number>
void Ranks::reduce(std::span<Number> numbers) {
  require_usable();
  if (count_ == 1 || numbers.empty()) return;
  LentToMpi lent(std::vector<Number>(numbers.begin(), numbers.end()));
  MPI_Request request = MPI_REQUEST_NULL;
  int code = MPI_SUCCESS;
  constexpr bool is_sum = std::is_same_v<Number, std::uint64_t>;
  check(MPI_Iallreduce(MPI_IN_PLACE, lent->data(), static_cast<int>(lent->size()), is_sum ? MPI_UINT64_T : MPI_DOUBLE,
                       is_sum ? MPI_SUM : MPI_MIN, handle_->communicator, &request),
        "MPI_Iallreduce");
  lent.during([&] { wait([&] { return is_complete(request, code); }); });
  check(code, "MPI_Iallreduce");
  std::copy(lent->begin(), lent->end(), numbers.begin());
}

void Ranks::add_up(std::span<std::uint64_t> numbers) { reduce(numbers); }

void Ranks::find_least(std::span<double> numbers) { reduce(numbers); }

std::vector<Bytes> Ranks::of_all(const Bytes& own) {
  std::map<int, MessageWriter> messages;
  for (int to = 0; to < count_; ++to) messages[to].put_all(std::span<const std::byte>(own));
  std::vector<Bytes> all;
  for (const Received& received : exchange(messages)) all.push_back(MessageReader(received.bytes).get_all<std::byte>());
  return all;
}

std::optional<std::ptrdiff_t> Ranks::unlike_first(const Bytes& own) {
  const std::vector<Bytes> all = of_all(own);
  const auto other = std::ranges::find_if(all, [&](const Bytes& one) { return one != all.front(); });
  return other == all.end() ? std::nullopt : std::optional(other - all.begin());
}

void Ranks::receive_what_is_there(int tag, std::vector<Received>& received) {
  int is_there = 0;
  MPI_Status status;
  check(MPI_Iprobe(MPI_ANY_SOURCE, tag, handle_->communicator, &is_there, &status), "MPI_Iprobe");
  if (is_there == 0) return;
  int count = 0;
  check(MPI_Get_count(&status, MPI_UINT64_T, &count), "MPI_Get_count");
  std::vector<std::uint64_t> units(static_cast<std::size_t>(count));
  check(MPI_Recv(units.data(), count, MPI_UINT64_T, status.MPI_SOURCE, tag, handle_->communicator, MPI_STATUS_IGNORE),
        "MPI_Recv");
  received.push_back({status.MPI_SOURCE, out_of_units(units)});
}

std::vector<Received> Ranks::exchange(std::map<int, MessageWriter>& messages) {
  require_usable();
  std::vector<Received> received;
  LentToMpi sending{Sending{}};
  for (auto& [to, message] : messages) {
    if (message.is_empty()) continue;
    Bytes bytes = message.take();
    if (to == rank_) {
      received.push_back({rank_, std::move(bytes)});
    } else {
      bytes_sent_ += bytes.size();
      sending->messages.push_back({to, in_units(bytes)});
    }
  }
  if (count_ > 1) sending.during([&] { send_and_receive(*sending, received); });
  std::sort(received.begin(), received.end(), [](const Received& a, const Received& b) { return a.from < b.from; });
  return received;
}

void Ranks::send_and_receive(Sending& sending, std::vector<Received>& received) {
  // A rank that is ahead begins the next exchange while others are not through with this one.
  const int tag = exchanges_++ % 1024;
  sending.requests.resize(sending.messages.size(), MPI_REQUEST_NULL);
  for (std::size_t i = 0; i < sending.messages.size(); ++i) {
    const auto& [to, units] = sending.messages[i];
    // Complete only once it is received: when those of all ranks are, nothing is on its way any more.
    check(MPI_Issend(units.data(), static_cast<int>(units.size()), MPI_UINT64_T, to, tag, handle_->communicator,
                     &sending.requests[i]),
          "MPI_Issend");
  }
  wait([&] {
    receive_what_is_there(tag, received);
    int is_done = 0;
    if (sending.has_all_received) {
      check(MPI_Test(&sending.barrier, &is_done, MPI_STATUS_IGNORE), "MPI_Test");
      return is_done != 0;
    }
    check(
        MPI_Testall(static_cast<int>(sending.requests.size()), sending.requests.data(), &is_done, MPI_STATUSES_IGNORE),
        "MPI_Testall");
    if (is_done != 0) {
      check(MPI_Ibarrier(handle_->communicator, &sending.barrier), "MPI_Ibarrier");
      sending.has_all_received = true;
    }
    return false;
  });
}

std::string Ranks::trouble_in(FunctionRef<bool()> work, bool& answer) {
  try {
    answer = work();
    return {};
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return error.what();
  }
}

bool Ranks::all_do(FunctionRef<bool()> work) {
  require_usable();
  bool answer = false;
  std::string trouble = trouble_in(work, answer);
  // The least rank that has trouble, and whether any said true.
  std::array<double, 2> least{static_cast<double>(trouble.empty() ? count_ : rank_), answer ? 0.0 : 1.0};
  find_least(least);
  const int troubled = static_cast<int>(least[0]);
  if (troubled == count_) return least[1] == 0;
  std::map<int, MessageWriter> messages;
  if (rank_ == troubled)
    for (int to = 0; to < count_; ++to) messages[to].put_text(trouble);
  for (const Received& received : exchange(messages)) trouble = MessageReader(received.bytes).get_text();
  throw Error(fmt::format("rank {}: {}", troubled, trouble));
}

}  // namespace toccata
