// Every operation on packs against plain loops: this host's own, and the portable ones in registers of every size.
#include "kernels/packs/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace vug {
namespace {

#if !defined(__CUDACC__) && !defined(__HIPCC__)

template <class Number, class Operations>
struct Ways {
  using T = Number;
  using P = Operations;
};

template <class Way>
class Packs : public testing::Test {
 protected:
  using Number = typename Way::T;
  using Numbers = std::array<Number, 3 * pack_size>;

  /// Calls test(numbers, lanes) with random ones and with all lanes and none of them.
  template <class Test>
  void visit(const Test& test) {
    std::uniform_real_distribution<Number> number(-1, 1);
    for (int k = 0; k < 300; ++k) {
      Numbers numbers;
      for (Number& n : numbers) n = number(random);
      test(numbers, k == 0 ? 0U : k == 1 ? 255U : static_cast<std::uint32_t>(random() % 256));
    }
  }
  /// Lane by lane, to the bit.
  template <class Expected>
  static void expect(const typename Way::P::Pack& pack, const Expected& expected) {
    for (int l = 0; l < pack_size; ++l) ASSERT_EQ(pack[l], expected(l)) << "lane " << l;
  }
  static bool has(std::uint32_t lanes, int l) { return lanes >> l & 1; }

  std::mt19937 random{11};
};

using All =
    testing::Types<Ways<double, PackOf<double>>, Ways<float, PackOf<float>>, Ways<double, PortablePack<double, 16>>,
                   Ways<float, PortablePack<float, 16>>, Ways<double, PortablePack<double, 32>>,
                   Ways<float, PortablePack<float, 32>>, Ways<double, PortablePack<double, 64>>>;
TYPED_TEST_SUITE(Packs, All);

TYPED_TEST(Packs, LoadAndStoreAnywhere) {
  using P = typename TypeParam::P;
  using T = typename TypeParam::T;
  this->visit([&](const auto& n, std::uint32_t lanes) {
    this->expect(P::load(&n[3]), [&](int l) { return n[3 + l]; });
    this->expect(P::load(&n[3], lanes), [&](int l) { return this->has(lanes, l) ? n[3 + l] : T(0); });
    auto all = n, some = n;
    P::store(&all[5], P::load(&n[13]));
    P::store(&some[5], lanes, P::load(&n[13]));
    for (int i = 0; i < static_cast<int>(n.size()); ++i) {
      const bool inside = i >= 5 && i < 5 + pack_size;
      ASSERT_EQ(all[i], inside ? n[i + 8] : n[i]) << i;
      ASSERT_EQ(some[i], inside && this->has(lanes, i - 5) ? n[i + 8] : n[i]) << i;
    }
  });
}

TYPED_TEST(Packs, ReadAndWriteNoLaneThatIsNotMeant) {
  using P = typename TypeParam::P;
  using T = typename TypeParam::T;
  this->visit([&](const auto& n, std::uint32_t lanes) {
    const int count = std::popcount(lanes);
    const std::uint32_t first = P::first(lanes);
    std::vector<T> last(&n[0], &n[count]);  // sanitizers see what reads or writes beyond
    this->expect(P::load(last.data(), first), [&](int l) { return l < count ? n[l] : T(0); });
    int next = 0;
    this->expect(P::spread(lanes, last.data()), [&](int l) { return this->has(lanes, l) ? n[next++] : T(0); });
    P::store(last.data(), first, P::load(last.data(), first) * T(2));
    for (int l = 0; l < count; ++l) ASSERT_EQ(last[l], n[l] * T(2));
  });
}

TYPED_TEST(Packs, CalculateLaneByLane) {
  using P = typename TypeParam::P;
  using T = typename TypeParam::T;
  this->visit([&](const auto& n, std::uint32_t) {
    const T s = n[20];
    const auto a = P::load(&n[0]), b = P::load(&n[8]);
    this->expect(a + b * a - b / a, [&](int l) { return n[l] + n[8 + l] * n[l] - n[8 + l] / n[l]; });
    this->expect(s - a / s, [&](int l) { return s - n[l] / s; });
    this->expect((s + a) * s, [&](int l) { return (s + n[l]) * s; });
    this->expect(s / (-a + s) - s, [&](int l) { return s / (-n[l] + s) - s; });
    auto c = a;
    c += b;
    c *= s;
    c -= a;
    c /= b;
    this->expect(c, [&](int l) { return ((n[l] + n[8 + l]) * s - n[l]) / n[8 + l]; });
  });
}

TYPED_TEST(Packs, GatherAndScatter) {
  using P = typename TypeParam::P;
  this->visit([&](const auto& n, std::uint32_t) {
    int at[pack_size];
    for (int l = 0; l < pack_size; ++l) at[l] = (l * 5 + 3) % 24;
    std::shuffle(at, at + pack_size, this->random);
    this->expect(P::gather(n.data(), at), [&](int l) { return n[at[l]]; });
    auto found = n, expected = n;
    P::scatter(found.data(), at, P::load(&n[7]));
    for (int l = 0; l < pack_size; ++l) expected[at[l]] = n[7 + l];
    ASSERT_EQ(found, expected);
  });
}

TYPED_TEST(Packs, ChooseLanes) {
  using P = typename TypeParam::P;
  using T = typename TypeParam::T;
  this->visit([&](const auto& n, std::uint32_t lanes) {
    const auto a = P::load(&n[0]), b = P::load(&n[8]);
    this->expect(P::blend(lanes, a, b), [&](int l) { return this->has(lanes, l) ? n[8 + l] : n[l]; });
    T spread[pack_size];
    int count = 0;
    for (int l = 0; l < pack_size; ++l) spread[l] = this->has(lanes, l) ? n[1 + count++] : T(0);
    this->expect(P::spread(lanes, &n[1]), [&](int l) { return spread[l]; });
    EXPECT_EQ(P::first(lanes), (1U << count) - 1);
    const auto order = static_cast<std::uint32_t>(this->random());
    this->expect(P::pick(order, a, b), [&](int l) { return n[order >> 4 * l & 15]; });
    this->expect(P::pick(order, a), [&](int l) { return n[order >> 3 * l & 7]; });
  });
}

TYPED_TEST(Packs, CompareAndAdd) {
  using P = typename TypeParam::P;
  using T = typename TypeParam::T;
  this->visit([&](const auto& n, std::uint32_t lanes) {
    auto above = n;  // in one lane only, or nowhere
    const int one = static_cast<int>(lanes % pack_size);
    for (int l = 0; l < pack_size; ++l) above[l] = n[8 + l];
    EXPECT_FALSE(P::any_above(P::load(&above[0]), P::load(&n[8])));
    above[one] = std::nextafter(n[8 + one], T(2));
    EXPECT_TRUE(P::any_above(P::load(&above[0]), P::load(&n[8])));
    EXPECT_FALSE(P::any_above(P::load(&n[8]), P::load(&above[0])));
    above[one] = std::numeric_limits<T>::quiet_NaN();
    EXPECT_FALSE(P::any_above(P::load(&above[0]), P::load(&n[8])));
    alignas(64) double sums[pack_size];
    for (int l = 0; l < pack_size; ++l) sums[l] = 0.1 * l;
    P::add_to(sums, P::load(&n[0]));
    for (int l = 0; l < pack_size; ++l) ASSERT_EQ(sums[l], 0.1 * l + static_cast<double>(n[l])) << l;
  });
}

#endif

}  // namespace
}  // namespace vug
