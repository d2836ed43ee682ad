// The kinds and limits of JSON members.
#include "core/project/json_fields.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/project/shape_bytes.h"

namespace netwright {

namespace {

/// A name from a file, fit to be shown.
std::string shown(std::string_view key) {
  constexpr std::size_t kLongest = 40;
  std::string text(key.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

}  // namespace

JsonFields::JsonFields(const Json* json, std::string file, std::string place)
    : json_(json), file_(std::move(file)), place_(std::move(place)) {
  if (json_ != nullptr && json_->object() == nullptr)
    refuse_damaged(file_, place_ + " is not what it should be");
}

void JsonFields::refuse(std::string_view key, const std::string& what) const {
  refuse_damaged(file_, "“" + std::string(key) + "” of " + place_ + " " + what);
}

const Json* JsonFields::find(std::string_view key) {
  known_.push_back(key);
  return json_ == nullptr ? nullptr : json_->find(key);
}

bool JsonFields::has(std::string_view key) const { return json_ != nullptr && json_->find(key) != nullptr; }

std::int64_t JsonFields::integer(std::string_view key, std::int64_t low, std::int64_t high,
                                 std::int64_t otherwise) {
  const Json* const member = find(key);
  if (member == nullptr) return otherwise;
  const auto value = member->integer();
  if (!value || *value < low || *value > high) refuse(key, "is not a number it could be");
  return *value;
}

double JsonFields::number(std::string_view key, double low, double high, double otherwise) {
  const Json* const member = find(key);
  if (member == nullptr) return otherwise;
  const auto value = member->number();
  if (!value || !(*value >= low && *value <= high)) refuse(key, "is not a number it could be");
  return *value;
}

bool JsonFields::flag(std::string_view key, bool otherwise) {
  const Json* const member = find(key);
  if (member == nullptr) return otherwise;
  const auto value = member->boolean();
  if (!value) refuse(key, "is neither true nor false");
  return *value;
}

std::string JsonFields::text(std::string_view key, const std::string& otherwise) {
  const Json* const member = find(key);
  if (member == nullptr) return otherwise;
  if (member->text() == nullptr) refuse(key, "is no text");
  return *member->text();
}

int JsonFields::choice(std::string_view key, std::span<const std::string_view> words, int otherwise) {
  if (!has(key)) {
    find(key);
    return otherwise;
  }
  const std::string word = text(key, "");
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) refuse(key, "is a word that this Netwright does not know; a newer one may");
  return static_cast<int>(found - words.begin());
}

const Json::Array* JsonFields::array(std::string_view key) {
  const Json* const member = find(key);
  if (member == nullptr) return nullptr;
  if (member->array() == nullptr) refuse(key, "is no list");
  return member->array();
}

const Json* JsonFields::object(std::string_view key) {
  const Json* const member = find(key);
  if (member != nullptr && member->object() == nullptr) refuse(key, "is no group of values");
  return member;
}

std::vector<std::string> JsonFields::texts(std::string_view key) {
  std::vector<std::string> all;
  const Json::Array* const items = array(key);
  if (items == nullptr) return all;
  for (const Json& item : *items) {
    if (item.text() == nullptr) refuse(key, "holds something that is no text");
    all.push_back(*item.text());
  }
  return all;
}

std::vector<int> JsonFields::integers_of(std::string_view key, const Json::Array& items, int low,
                                         int high) const {
  std::vector<int> all;
  all.reserve(items.size());
  for (const Json& item : items) {
    const auto value = item.integer();
    if (!value || *value < low || *value > high) refuse(key, "holds a number that cannot be");
    all.push_back(static_cast<int>(*value));
  }
  return all;
}

std::vector<int> JsonFields::integers(std::string_view key, int low, int high) {
  const Json::Array* const items = array(key);
  return items == nullptr ? std::vector<int>() : integers_of(key, *items, low, high);
}

std::vector<std::vector<int>> JsonFields::integer_lists(std::string_view key, int low, int high) {
  std::vector<std::vector<int>> lists;
  const Json::Array* const items = array(key);
  if (items == nullptr) return lists;
  for (const Json& item : *items) {
    if (item.array() == nullptr) refuse(key, "holds something that is no list");
    lists.push_back(integers_of(key, *item.array(), low, high));
  }
  return lists;
}

std::vector<double> JsonFields::numbers(std::string_view key, double low, double high) {
  std::vector<double> all;
  const Json::Array* const items = array(key);
  if (items == nullptr) return all;
  for (const Json& item : *items) {
    const auto value = item.number();
    if (!value || !(*value >= low && *value <= high)) refuse(key, "holds a number that cannot be");
    all.push_back(*value);
  }
  return all;
}

void JsonFields::finish() const {
  if (json_ == nullptr) return;
  for (const auto& [key, value] : *json_->object()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    throw Error(ErrorKind::Read, file_ + " was saved by a newer Netwright (" + place_ + " has “" +
                                     shown(key) +
                                     "”, which this one does not know); update Netwright to open it.");
  }
}

}  // namespace netwright
