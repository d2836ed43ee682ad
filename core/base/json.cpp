// JSON in and out. The library parses and escapes; its events build our own values, with limits on depth and
// count, so that no hostile text can exhaust the stack or the memory.
#include "core/base/json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace netwright {

namespace {

constexpr std::size_t kDeepest = 64;

/// Takes the parser's events. Containers under construction wait on a stack and are handed to their parent
/// when they close.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(std::size_t max_values) : max_values_(max_values) {}

  bool null() override { return place(Json()); }
  bool boolean(bool value) override { return place(Json(value)); }
  bool number_integer(number_integer_t value) override { return place(Json(std::int64_t{value})); }
  bool number_unsigned(number_unsigned_t value) override {
    // Beyond 2^63 only the rounded value is kept, as for any number with a fraction.
    if (value > static_cast<number_unsigned_t>(INT64_MAX)) return place(Json(static_cast<double>(value)));
    return place(Json(static_cast<std::int64_t>(value)));
  }
  bool number_float(number_float_t value, const string_t&) override { return place(Json(value)); }
  bool string(string_t& value) override { return place(Json(std::move(value))); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json(Json::Object())); }
  bool start_array(std::size_t) override { return open(Json(Json::Array())); }
  bool key(string_t& value) override {
    keys_.back() = std::move(value);
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    error_position = position;
    return false;
  }

  Json result;
  std::size_t error_position = 0;
  const char* refusal = nullptr;

 private:
  bool place(Json value) {
    if (++n_values_ > max_values_) {
      refusal = "it holds too many values";
      return false;
    }
    if (open_.empty())
      result = std::move(value);
    else if (open_.back().object() != nullptr)
      open_.back().set(std::move(keys_.back()), std::move(value));
    else
      open_.back().add(std::move(value));
    return true;
  }
  bool open(Json container) {
    if (open_.size() >= kDeepest) {
      refusal = "it is nested too deeply";
      return false;
    }
    open_.push_back(std::move(container));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    Json done = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return place(std::move(done));
  }

  std::size_t max_values_;
  std::size_t n_values_ = 0;
  std::vector<Json> open_;
  std::vector<std::string> keys_;
};

std::string place_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(position == 0 ? 0 : position - 1, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column = before.size() - (last_break == std::string_view::npos ? 0 : last_break + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

void append_fraction(std::string& out, double value, int digits) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  std::array<char, 40> buffer{};
  char* const end = buffer.data() + buffer.size();
  const auto done = digits > 0 ? std::to_chars(buffer.data(), end, value, std::chars_format::general, digits)
                               : std::to_chars(buffer.data(), end, value);
  out.append(buffer.data(), done.ptr);
}

bool is_plain(const Json& value) { return value.array() == nullptr && value.object() == nullptr; }

class Writer {
 public:
  explicit Writer(const JsonLook& look) : look_(look) {}

  void write(const Json& value, int depth) {
    if (const auto* const array = value.array()) {
      const bool is_short = !look_.is_indented || std::all_of(array->begin(), array->end(), is_plain);
      begin('[');
      for (const Json& item : *array) {
        separate(&item == array->data(), is_short, depth + 1);
        write(item, depth + 1);
      }
      end(']', is_short || array->empty(), depth);
    } else if (const auto* const object = value.object()) {
      begin('{');
      for (const auto& member : *object) {
        separate(&member == object->data(), !look_.is_indented, depth + 1);
        out += quoted(member.first) + (look_.is_indented ? ": " : ":");
        write(member.second, depth + 1);
      }
      end('}', !look_.is_indented || object->empty(), depth);
    } else {
      write_plain(value);
    }
  }

  std::string out;

 private:
  static std::string quoted(const std::string& words) {
    return nlohmann::json(words).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  void begin(char bracket) { out += bracket; }
  void separate(bool is_first, bool is_on_one_line, int depth) {
    if (!is_first) out += is_on_one_line && look_.is_indented ? ", " : ",";
    if (!is_on_one_line) new_line(depth);
  }
  void end(char bracket, bool is_on_one_line, int depth) {
    if (!is_on_one_line) new_line(depth);
    out += bracket;
  }
  void new_line(int depth) {
    out += '\n';
    out.append(static_cast<std::size_t>(depth) * 2, ' ');
  }
  void write_plain(const Json& value) {
    if (const auto* const words = value.text())
      out += quoted(*words);
    else if (const auto flag = value.boolean())
      out += *flag ? "true" : "false";
    else if (const auto integer = value.integer())
      out += std::to_string(*integer);
    else if (const auto number = value.number())
      append_fraction(out, *number, look_.significant_digits);
    else
      out += "null";
  }

  JsonLook look_;
};

}  // namespace

std::optional<bool> Json::boolean() const {
  const auto* const value = std::get_if<bool>(&value_);
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

std::optional<double> Json::number() const {
  if (const auto* const value = std::get_if<double>(&value_)) return *value;
  if (const auto* const value = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*value);
  return std::nullopt;
}

std::optional<std::int64_t> Json::integer() const {
  const auto* const value = std::get_if<std::int64_t>(&value_);
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

const Json* Json::find(std::string_view key) const {
  const Object* const members = object();
  if (members == nullptr) return nullptr;
  const auto found =
      std::find_if(members->begin(), members->end(), [&](const auto& member) { return member.first == key; });
  return found == members->end() ? nullptr : &found->second;
}

Json& Json::set(std::string key, Json value) {
  if (is_null()) value_ = Object();
  std::get<Object>(value_).emplace_back(std::move(key), std::move(value));
  return *this;
}

Json& Json::add(Json item) {
  if (is_null()) value_ = Array();
  std::get<Array>(value_).push_back(std::move(item));
  return *this;
}

Json parse_json(std::string_view text, const std::string& name, std::size_t max_values) {
  Builder builder(max_values);
  if (nlohmann::json::sax_parse(text, &builder)) return std::move(builder.result);
  if (builder.refusal != nullptr)
    throw Error(ErrorKind::Read, name + " cannot be read: " + builder.refusal + ".");
  throw Error(ErrorKind::Read, name + " is not valid JSON: something unexpected stands at " +
                                   place_of(text, builder.error_position) + ".");
}

std::string to_text(const Json& value, const JsonLook& look) {
  Writer writer(look);
  writer.write(value, 0);
  return std::move(writer.out);
}

}  // namespace netwright
