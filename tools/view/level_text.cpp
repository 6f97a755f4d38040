// SPDX-License-Identifier: Apache-2.0
// Every edit is parsed again: what it changed must be the entry alone.
#include "view/level_text.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "sky/base/error.h"
#include "sky/base/toml_table.h"
#include "view/toml_statements.h"

namespace welkin::view {
namespace {

using Kind = TomlStatement::Kind;
constexpr std::size_t kNowhere = std::string_view::npos;
constexpr const char* kLevelFileName = "level.toml";

[[noreturn]] void refuseEdit(const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", kLevelFileName, why));
}

std::string numberText(double metres) {
  std::string text = fmt::format("{:.3f}", std::round(metres * 1e3) / 1e3 + 0.0);
  while (text.back() == '0' && text[text.size() - 2] != '.') text.pop_back();
  return text == "-0.0" ? "0.0" : text;
}

template <std::size_t N>
std::string listText(const std::array<double, N>& numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < N; ++i) text += (i > 0 ? ", " : "") + numberText(numbers[i]);
  return text + "]";
}

template <std::size_t N>
std::optional<std::array<double, N>> listOfNumbers(const toml::node* node) {
  const toml::array* list = node == nullptr ? nullptr : node->as_array();
  if (list == nullptr || list->size() != N) return std::nullopt;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::optional<double> value = (*list)[i].value<double>();
    if (!value || !(*list)[i].is_number()) return std::nullopt;
    numbers[i] = *value;
  }
  return numbers;
}

const char* newlineOf(std::string_view text) {
  return text.find("\r\n") == kNowhere ? "\n" : "\r\n";
}

/// The end of the line that `at` is in, before its line break.
std::size_t lineEnd(std::string_view text, std::size_t at) {
  std::size_t end = text.find('\n', at);
  if (end == kNowhere) return text.size();
  return end > at && text[end - 1] == '\r' ? end - 1 : end;
}

bool isBlankIn(std::string_view text, std::size_t from, std::size_t to) {
  return text.substr(from, to - from).find_first_not_of(" \t\r\n") == kNowhere;
}

/// Lines are added before `at`, where a line begins or the text ends.
std::string withLines(const std::string& text, std::size_t at, const std::string& lines) {
  const bool joins = at > 0 && text[at - 1] != '\n';
  return text.substr(0, at) + (joins ? newlineOf(text) : "") + lines + text.substr(at);
}

std::optional<TomlStatement> addStatement(const std::vector<TomlStatement>& statements) {
  for (const TomlStatement& s : statements)
    if (s.kind == Kind::value &&
        ((s.table == "probes" && s.key == "add") || (s.table.empty() && s.key == "probes.add")))
      return s;
  return std::nullopt;
}

std::string appended(const std::string& text, const TomlList& list, const std::string& entry) {
  if (list.entry.empty()) return text.substr(0, list.open + 1) + entry + text.substr(list.open + 1);
  const TomlList::Entry& last = list.entry.back();
  const std::size_t line = text.rfind('\n', last.begin);
  const bool own_line = line != kNowhere && line > list.open && isBlankIn(text, line, last.begin);
  if (!own_line) return text.substr(0, last.end) + ", " + entry + text.substr(last.end);
  const std::string indented = newlineOf(text) + text.substr(line + 1, last.begin - line - 1) + entry;
  const std::size_t end = lineEnd(text, last.end);
  const bool comma_here = last.comma != kNowhere && last.comma < end;
  if (list.close < end || (last.comma != kNowhere && !comma_here))
    return text.substr(0, last.end) + "," + indented + text.substr(last.end);
  if (comma_here) return text.substr(0, end) + indented + "," + text.substr(end);
  return text.substr(0, last.end) + "," + text.substr(last.end, end - last.end) + indented + text.substr(end);
}

std::string withoutEntry(const std::string& text, const TomlList& list, std::size_t number) {
  const TomlList::Entry& entry = list.entry[number];
  std::string result = text;
  std::size_t begin = entry.begin, end = entry.end;
  if (entry.comma != kNowhere) {
    if (isBlankIn(text, entry.end, entry.comma))
      end = entry.comma + 1;
    else
      result.erase(entry.comma, 1);  // a comment stands before it
    if (number + 1 < list.entry.size())
      while (end < list.close && (result[end] == ' ' || result[end] == '\t')) ++end;
  }
  result.erase(begin, end - begin);
  if (entry.comma == kNowhere && number > 0) {
    const std::size_t comma = list.entry[number - 1].comma;
    const bool near = text.substr(comma + 1, begin - comma - 1).find_first_not_of(" \t") == kNowhere;
    result.erase(comma, near ? begin - comma : 1);
    begin = near ? comma : begin - 1;
  }
  // A line that held nothing else goes, too.
  const std::size_t line = begin == 0 ? kNowhere : result.rfind('\n', begin - 1);
  const std::size_t line_end = result.find('\n', begin);
  if (line != kNowhere && line_end != kNowhere && line >= list.open && isBlankIn(result, line, line_end))
    result.erase(line, line_end - line);
  return result;
}

void requireSame(const toml::table& wanted, const std::string& text) {
  bool same = false;
  try {
    same = base::parseToml(kLevelFileName, text) == wanted;
  } catch (const base::Error&) {  // the file is written in a way that the edit did not expect
  }
  if (!same) refuseEdit("[probes] or [[room]] is written in a way that is not edited here; edit the file by hand");
}

toml::array& addOf(toml::table& root) {
  toml::table& probes = root.emplace<toml::table>("probes").first->second.ref<toml::table>();
  return probes.emplace<toml::array>("add").first->second.ref<toml::array>();
}

template <std::size_t N>
toml::array arrayOf(const std::array<double, N>& numbers) {
  toml::array list;
  for (const double number : numbers) list.push_back(std::stod(numberText(number)));
  return list;
}

TomlList addListOf(const std::string& text, std::size_t number) {
  const std::optional<TomlStatement> add = addStatement(statementsOf(text));
  const TomlList list = add && text.compare(add->value, 1, "[") == 0 ? listAt(text, add->value) : TomlList{};
  if (number >= list.entry.size())
    refuseEdit(fmt::format("there is no probe by hand with number {}; it has {}", number, list.entry.size()));
  return list;
}

}  // namespace

HandPlaced handPlacedOf(std::string_view text) {
  const toml::table root = base::parseToml(kLevelFileName, text);
  HandPlaced placed;
  if (const toml::array* add = root.at_path("probes.add").as_array())
    for (const toml::node& node : *add)
      if (const auto place = listOfNumbers<3>(&node)) placed.probes.push_back(*place);
  if (const toml::array* rooms = root["room"].as_array())
    for (const toml::node& node : *rooms)
      if (const toml::table* room = node.as_table())
        if (const auto box = listOfNumbers<6>(room->get("box"))) placed.rooms.push_back(*box);
  return placed;
}

std::string withProbe(const std::string& text, const ProbePlace& place) {
  toml::table wanted = base::parseToml(kLevelFileName, text);
  if (!wanted.contains("probes") || wanted["probes"].is_table()) addOf(wanted).push_back(arrayOf(place));
  const std::vector<TomlStatement> statements = statementsOf(text);
  const std::string entry = listText(place), newline = newlineOf(text);
  std::string result;
  if (const auto add = addStatement(statements)) {
    if (text.compare(add->value, 1, "[") == 0) result = appended(text, listAt(text, add->value), entry);
  } else {
    const TomlStatement *header = nullptr, *dotted = nullptr;
    for (const TomlStatement& s : statements) {
      if (s.kind == Kind::table && s.table == "probes") header = &s;
      if (s.kind == Kind::value && s.table.empty() && s.key.starts_with("probes.")) dotted = &s;
    }
    if (header != nullptr)
      result = withLines(text, header->behind, "add = [" + entry + "]" + newline);
    else if (dotted != nullptr)
      result = withLines(text, dotted->behind, "probes.add = [" + entry + "]" + newline);
    else
      result = withLines(text, text.size(), newline + "[probes]" + newline + "add = [" + entry + "]" + newline);
  }
  requireSame(wanted, result);
  return result;
}

std::string withProbeMoved(const std::string& text, std::size_t number, const ProbePlace& place) {
  const TomlList::Entry entry = addListOf(text, number).entry[number];
  const TomlList numbers = text.compare(entry.begin, 1, "[") == 0 ? listAt(text, entry.begin) : TomlList{};
  if (numbers.entry.size() != 3)
    refuseEdit(fmt::format("the probe by hand with number {} has no three numbers", number));
  std::string result = text;
  for (std::size_t i = 3; i-- > 0;)
    result.replace(numbers.entry[i].begin, numbers.entry[i].end - numbers.entry[i].begin, numberText(place[i]));
  toml::table wanted = base::parseToml(kLevelFileName, text);
  addOf(wanted).replace(addOf(wanted).cbegin() + static_cast<std::ptrdiff_t>(number), arrayOf(place));
  requireSame(wanted, result);
  return result;
}

std::string withoutProbe(const std::string& text, std::size_t number) {
  const std::string result = withoutEntry(text, addListOf(text, number), number);
  toml::table wanted = base::parseToml(kLevelFileName, text);
  addOf(wanted).erase(addOf(wanted).cbegin() + static_cast<std::ptrdiff_t>(number));
  requireSame(wanted, result);
  return result;
}

std::string withRoom(const std::string& text, const RoomBox& box) {
  toml::table wanted = base::parseToml(kLevelFileName, text);
  if (!wanted.contains("room") || wanted["room"].is_array())
    wanted.emplace<toml::array>("room").first->second.ref<toml::array>().push_back(toml::table{{"box", arrayOf(box)}});
  std::size_t at = text.size();
  bool in_room = false;
  for (const TomlStatement& s : statementsOf(text)) {
    if (s.kind != Kind::value) in_room = s.kind == Kind::list_table && s.table == "room";
    if (in_room) at = s.behind;
  }
  const std::string newline = newlineOf(text);
  const std::string result = withLines(text, at, newline + "[[room]]" + newline + "box = " + listText(box) + newline);
  requireSame(wanted, result);
  return result;
}

std::string withoutRoom(const std::string& text, std::size_t number) {
  std::string result = text;
  std::size_t seen = 0, removed = 0;
  bool inside = false;
  for (const TomlStatement& s : statementsOf(text)) {
    const bool is_room = s.kind == Kind::list_table && s.table == "room";
    if (s.kind != Kind::value) inside = is_room && seen++ == number;
    if (!inside) continue;
    const bool alone = isBlankIn(text, s.end, lineEnd(text, s.end));
    std::size_t end = alone ? s.behind : s.end;
    while (!alone && (text[end] == ' ' || text[end] == '\t')) ++end;  // a comment stays
    result.erase(s.begin - removed, end - s.begin);
    removed += end - s.begin;
  }
  if (number >= seen) refuseEdit(fmt::format("there is no room with number {}; it has {}", number, seen));
  toml::table wanted = base::parseToml(kLevelFileName, text);
  toml::array& rooms = *wanted["room"].as_array();
  rooms.erase(rooms.cbegin() + static_cast<std::ptrdiff_t>(number));
  if (rooms.empty()) wanted.erase("room");
  requireSame(wanted, result);
  return result;
}

}  // namespace welkin::view
