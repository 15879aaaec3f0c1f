#pragma once
#include <string>
#include <vector>

namespace taut {

/// States of which something is to be told, as stretches: each of neighbouring states of one analysis.
class Stretches {
 public:
  /// The next state of an analysis; every state is shown, in order. `why`: what the warning says of this state; empty:
  /// the warning leaves it out. `words`: its name, "load path, in, x = 12 m".
  void take(const std::string& why, const std::string& words, const std::string& analysis);
  bool any() const { return !all_.empty(); }
  /// "load path, in, x = 12 m to x = 14 m (3 states); x = 20 m: ...", with the reason of the first.
  std::string words() const;
  /// The same without the reason.
  std::string places() const;
  /// The same of few stretches; of more of them the first and the last, and how many are between.
  std::string few_places() const;
  /// "load path, in, x = 12 m to x = 14 m (3 states) and on 1 more stretch: ...".
  std::string words_of_first() const;

 private:
  struct Stretch {
    std::string from, to;  ///< words of its first and last state
    int states = 0;

    /// `other`: a state told just before, of which common words are left out.
    [[nodiscard]] std::string words(const std::string& other) const;
  };
  std::vector<Stretch> all_;
  std::string why_, analysis_;  ///< of the first; of the last state that was taken
  bool open_ = false;           ///< whether the last state that was taken is in the last stretch
};

}  // namespace taut
