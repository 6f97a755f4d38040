// SPDX-License-Identifier: Apache-2.0
// The words of a command, read one after the other.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace welkin::view {

/// Splits a line at blanks. Text in double quotes is one word, and "#" starts a comment. Throws Error(content) for a
/// quote that does not end.
std::vector<std::string> wordsOf(std::string_view line);

/// Every function throws Error(content) that names the command, the word and what is allowed.
class Words {
 public:
  /// `words` begins with the command's name and must outlive the object.
  explicit Words(const std::vector<std::string>& words) : words_(words) {}

  bool done() const { return next_ == words_.size(); }
  /// A finite number in [low, high].
  double number(const char* what, double low, double high);
  /// A whole number in [low, high].
  std::size_t count(const char* what, std::size_t low, std::size_t high);
  /// Index of one of the allowed words.
  std::size_t choice(const char* what, std::initializer_list<const char*> allowed);
  /// Whether the word is "on"; else it is "off".
  bool isOn(const char* what) { return choice(what, {"off", "on"}) == 1; }
  const std::string& text(const char* what);
  /// Whether the next word is this one, which is then read.
  bool take(std::string_view word);
  /// Refuses further words.
  void end() const;

 private:
  [[noreturn]] void refuse(const char* what, const std::string& allowed) const;

  const std::vector<std::string>& words_;
  std::size_t next_ = 1;
};

}  // namespace welkin::view
