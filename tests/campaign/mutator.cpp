#include "mutator.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace vug::campaign {

namespace {

constexpr std::size_t longest = 1 << 16;

/// What readers stumble over.
const std::vector<std::string> hostile{"nan",
                                       "inf",
                                       "-inf",
                                       "-1",
                                       "0",
                                       "-0.0",
                                       "1e308",
                                       "1e309",
                                       "1e-320",
                                       "1e-9",
                                       "2147483648",
                                       "4294967296",
                                       "9223372036854775807",
                                       "9223372036854775808",
                                       "99999999999999999999",
                                       "0x7fffffff",
                                       "1.",
                                       ".5",
                                       "1e",
                                       "+",
                                       "_1",
                                       "true",
                                       "false",
                                       "1979-05-27",
                                       "[",
                                       "]",
                                       "[[",
                                       "]]",
                                       "{",
                                       "}",
                                       "\"",
                                       "\"\"\"",
                                       "'''",
                                       "=",
                                       ".",
                                       ",",
                                       "#",
                                       "\n",
                                       "\r",
                                       "\t",
                                       std::string(1, '\0'),
                                       "\x1b[31m",
                                       "\xff\xfe",
                                       "\xef\xbb\xbf",
                                       "\xd2\x8f",
                                       "\xe2\x80\xae",
                                       "\\u0000",
                                       "\\",
                                       "/",
                                       "../",
                                       "/dev/zero",
                                       "%s%n",
                                       "{}",
                                       "{:999999999}",
                                       std::string(8, '\xff'),
                                       std::string(4, '\0'),
                                       std::string(300, '['),
                                       std::string(2000, '9'),
                                       std::string(300, 'a')};

/// The words and numbers of a text; nothing of binary data but what looks like one.
std::set<std::string> words_of(const std::vector<std::string>& corpus) {
  std::set<std::string> words;
  const auto of_word = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '-' || c == '$'; };
  for (const std::string& text : corpus)
    for (auto at = text.begin(); at != text.end();) {
      const auto end = std::find_if_not(at, text.end(), of_word);
      if (end - at > 1 && end - at < 40) words.emplace(at, end);
      at = std::find_if(end, text.end(), of_word);
    }
  return words;
}

/// A piece of `text`: most of the time a short one.
std::string piece_of(const std::string& text, Random& random) {
  const std::size_t most = random.below(4) == 0 ? text.size() : std::min<std::size_t>(text.size(), 64);
  return text.substr(random.below(text.size()), random.below(most + 1));
}

/// The line around a place.
std::pair<std::size_t, std::size_t> line_at(const std::string& data, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : data.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1, end = data.find('\n', begin);
  return {begin, (end == std::string::npos ? data.size() : end + 1) - begin};
}

}  // namespace

Mutator::Mutator(std::vector<std::string> corpus) : corpus_(std::move(corpus)) {
  const std::set<std::string> words = words_of(corpus_);
  words_.assign(words.begin(), words.end());
  words_.insert(words_.end(), hostile.begin(), hostile.end());
}

std::string Mutator::input(std::uint64_t seed, std::uint64_t index) const {
  Random random(Random(seed).next() + index);
  std::string data = corpus_[random.below(corpus_.size())];
  for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) change(data, random);
  if (data.size() > longest) data.resize(longest);
  return data;
}

void Mutator::change(std::string& data, Random& random) const {
  const std::size_t at = random.below(data.size() + 1);
  const std::size_t inside = random.below(data.size());
  switch (data.empty() ? 5 : random.below(11)) {
    case 0:
      data[inside] = static_cast<char>(data[inside] ^ 1 << random.below(8));
      break;
    case 1:
      data[inside] = static_cast<char>(random.next());
      break;
    case 2:
      data.resize(inside);
      break;
    case 3:
      data.erase(inside, 1 + random.below(random.below(4) == 0 ? data.size() : 16));
      break;
    case 4:
      data.insert(at, piece_of(data, random));
      break;
    case 5:
      data.insert(at, words_[random.below(words_.size())]);
      break;
    case 6: {  // a word in place of another
      const auto of_word = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '-'; };
      std::size_t begin = inside, end = inside;
      while (begin > 0 && of_word(data[begin - 1])) --begin;
      while (end < data.size() && of_word(data[end])) ++end;
      data.replace(begin, end - begin, words_[random.below(words_.size())]);
      break;
    }
    case 7: {  // a line again, elsewhere
      const auto [begin, size] = line_at(data, inside);
      const std::string line = data.substr(begin, size);
      data.insert(line_at(data, random.below(data.size())).first, line);
      break;
    }
    case 8: {
      const auto [begin, size] = line_at(data, inside);
      data.erase(begin, size);
      break;
    }
    case 9:
      data.insert(at, piece_of(corpus_[random.below(corpus_.size())], random));
      break;
    default: {  // a whole number of four or eight bytes
      const std::uint64_t values[] = {0,
                                      1,
                                      0x7f,
                                      0xff,
                                      0x7fffffff,
                                      0x80000000,
                                      0xffffffff,
                                      ~std::uint64_t{0} >> 1,
                                      ~std::uint64_t{0},
                                      random.next()};
      std::uint64_t value = values[random.below(std::size(values))];
      const bool big_end_first = random.below(2) == 0;
      const std::size_t bytes = random.below(2) == 0 ? 4 : 8;
      for (std::size_t k = 0; k < bytes; ++k, value >>= 8) {
        const std::size_t place = inside + (big_end_first ? bytes - 1 - k : k);
        if (place < data.size()) data[place] = static_cast<char>(value);
      }
    }
  }
}

}  // namespace vug::campaign
