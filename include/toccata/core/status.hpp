#pragma once

namespace toccata {

/// How far an answer can be trusted. Every answer carries one; nothing is ever guessed silently.
enum class Status {
  exact,          ///< the answer is the mathematical truth for the given doubles
  undecided,      ///< lies within the stated bound of the boundary; the answer is the safe one (contact)
  not_converged,  ///< a bounded iteration ended early; the answer is on the safe side
};

}  // namespace toccata
