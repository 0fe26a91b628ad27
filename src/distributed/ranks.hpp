#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "distributed/messages.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// What came from a rank.
struct Received {
  int from = 0;
  Bytes bytes;
};

/// The ranks of a communicator: all that the library does by MPI. Every call is collective, and is made by all ranks in
/// the same order. A call that is not answered within the patience throws Error, as does one that MPI refuses; no other
/// call is possible then.
class Ranks {
 public:
  /// `communicator` is what MPI_Comm_c2f tells; messages go by a duplicate of it. Throws Error where MPI is not
  /// initialised, or the communicator is none.
  Ranks(int communicator, double patience_seconds);
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int count() const { return count_; }
  /// By this rank to others, in messages of `exchange` and `of_all`, since it was made.
  [[nodiscard]] std::uint64_t bytes_sent() const { return bytes_sent_; }
  /// Reductions, and barriers of `exchange` and `of_all`, since it was made.
  [[nodiscard]] std::uint64_t collectives() const { return collectives_; }
  /// For messages and other ranks, since it was made.
  [[nodiscard]] double seconds_waited() const { return seconds_waited_; }

  /// Each number becomes the sum of that of all ranks, or the least of them. The same bits on all of them.
  void add_up(std::span<std::uint64_t> numbers);
  void find_least(std::span<double> numbers);

  /// What each rank gives, by rank.
  [[nodiscard]] std::vector<Bytes> of_all(const Bytes& own);
  /// The least rank that gives something else than rank 0, if any does: the same answer on all of them.
  [[nodiscard]] std::optional<std::ptrdiff_t> unlike_first(const Bytes& own);

  /// Sends each message to its rank and returns those that came here, ascending by the rank they are from. It takes as
  /// many messages as there are ranks that have something for each other, and one barrier. (T. Hoefler, C. Siebert,
  /// A. Lumsdaine, "Scalable communication protocols for dynamic sparse data exchange", 2010.)
  [[nodiscard]] std::vector<Received> exchange(std::map<int, MessageWriter>& messages);

  /// Does `work`, which is no call of this class, and tells whether it said true on any rank. Where it throws on some,
  /// all ranks throw Error with what the least of these has to say: "rank 1: …".
  bool all_do(FunctionRef<bool()> work);

 private:
  struct Handle;
  struct Sending;

  /// The message of an exception that `work` throws; empty where it throws none.
  [[nodiscard]] static std::string trouble_in(FunctionRef<bool()> work, bool& answer);
  void require_usable() const;
  /// Throws Error naming the call when MPI has refused it.
  void check(int code, const char* call);
  /// Calls `is_done` until it is.
  void wait(FunctionRef<bool()> is_done);
  /// Whole numbers are added up, of others the least is found.
  template <class Number>
  void reduce(std::span<Number> numbers);
  void send_and_receive(Sending& sending, std::vector<Received>& received);
  void receive_what_is_there(int tag, std::vector<Received>& received);

  std::unique_ptr<Handle> handle_;
  double patience_seconds_;
  int rank_ = 0;
  int count_ = 1;
  int exchanges_ = 0;
  std::uint64_t bytes_sent_ = 0;
  std::uint64_t collectives_ = 0;
  double seconds_waited_ = 0;
  std::string broken_;  ///< why no more calls are possible
};

}  // namespace toccata
