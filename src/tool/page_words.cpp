// See page_words.h.
#include "tool/page_words.h"

#include <cstdlib>
#include <ctime>

#include "tool/commands.h"

namespace ups::tool {
namespace {

// For a shell.
std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

bool is_of(const std::string& word, const std::string& option) {
  return word == option || word.compare(0, option.size() + 1, option + "=") == 0;
}

}  // namespace

std::string date_text() {
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(epoch, &end, 10);
    if (end != epoch && *end == '\0' && seconds >= 0) now = std::time_t(seconds);
  }
  const std::tm* parts = std::gmtime(&now);
  char text[64];
  if (!parts || std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", parts) == 0) return {};
  return text;
}

std::string command_text(const std::vector<std::string>& arguments, const ups_result_info& info) {
  std::string text = "ups";
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    bool left_out = false;
    for (const char* option : {"--time", "--target-error", "--iterations", "--seed"})
      left_out = left_out || is_of(word, option);
    if (!left_out)
      text.append(" ").append(quoted(word));
    else if (word.find('=') == std::string::npos)
      ++i;  // its value
  }
  return text + " --iterations " + std::to_string(info.iterations) + " --seed " + std::to_string(info.seed);
}

std::string replay_text(const std::vector<std::string>& arguments, const std::string& scene, const std::string& sample) {
  const std::vector<OptionWord> options = options_of_samples();
  std::string text = "ups replay " + quoted(scene);
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    for (const OptionWord& option : options) {
      if (!is_of(word, option.name)) continue;
      text += " " + quoted(word);
      if (option.has_value && word == option.name && i + 1 < arguments.size()) text += " " + quoted(arguments[++i]);
      break;
    }
  }
  return text + " --sample " + quoted(sample);
}

}  // namespace ups::tool
