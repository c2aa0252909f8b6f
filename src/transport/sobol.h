// Owen-scrambled Sobol points: the first dimensions of a path, stratified over all samples of a batch.
// Direction numbers: Joe, Kuo 2008 ("new-joe-kuo-6"), first 21 dimensions. Scrambling by hashing: Laine, Karras 2011;
// Burley 2020, "Practical Hash-based Owen Scrambling".
#pragma once
#include <array>
#include <cstdint>

namespace ups {

inline constexpr int sobol_dimensions = 21;

namespace sobol_detail {

struct Primitive {
  int degree, a;
  std::array<uint32_t, 7> m;
};
inline constexpr std::array<Primitive, sobol_dimensions - 1> primitives = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

constexpr uint32_t reverse_bits(uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  return __builtin_bswap32(x);
}

// Bits reversed, as the scrambling wants them, of all 16 values of each four bits of an index.
using Table = std::array<std::array<std::array<uint32_t, 16>, 8>, sobol_dimensions>;
constexpr Table make_table() {
  std::array<std::array<uint32_t, 32>, sobol_dimensions> v{};
  for (int i = 0; i < 32; ++i) v[0][i] = 1u << (31 - i);
  for (int d = 1; d < sobol_dimensions; ++d) {
    const Primitive& p = primitives[d - 1];
    for (int i = 0; i < 32; ++i) {
      if (i < p.degree) {
        v[d][i] = p.m[i] << (31 - i);
        continue;
      }
      v[d][i] = v[d][i - p.degree] ^ (v[d][i - p.degree] >> p.degree);
      for (int k = 1; k < p.degree; ++k)
        if ((p.a >> (p.degree - 1 - k)) & 1) v[d][i] ^= v[d][i - k];
    }
  }
  Table out{};
  for (int d = 0; d < sobol_dimensions; ++d)
    for (int bit = 0; bit < 32; ++bit)
      for (int k = 0; k < 16; ++k)
        if (k >> bit % 4 & 1) out[d][bit / 4][k] ^= reverse_bits(v[d][bit]);
  return out;
}
inline constexpr Table table = make_table();

// Nested uniform scramble of the reversed number; constants of Vegdahl 2021,
// which fix the weak low bits of the original.
constexpr uint32_t laine_karras(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

}  // namespace sobol_detail

// Point `index` of a dimension, scrambled by seed: 32 random-looking bits, stratified over indices.
constexpr uint32_t sobol_owen(uint32_t index, int dimension, uint32_t seed) {
  uint32_t x = 0;
  for (int k = 0; index; index >>= 4, ++k) x ^= sobol_detail::table[dimension][k][index & 15];
  return sobol_detail::reverse_bits(sobol_detail::laine_karras(x, seed));
}

}  // namespace ups
