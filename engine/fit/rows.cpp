#include "engine/fit/rows.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/fit/clones.h"

namespace vamp::fit {
namespace {

// Eight floats: one register where there are wide ones, two elsewhere.
typedef float Lanes __attribute__((vector_size(32)));
constexpr size_t kLanes = 8, kChunk = 512;

inline Lanes load(const float* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof(v));
  return v;
}
inline void store(float* p, Lanes v) { std::memcpy(p, &v, sizeof(v)); }
inline float sum(Lanes v) { return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7])); }

// A x B dot products over `n` floats, kept in registers.
template <int A, int B>
inline void dot_block(const float* a, const float* b, size_t length, size_t n, double* out, size_t stride) {
  Lanes acc[A][B] = {};
  const size_t whole = n / kLanes * kLanes;
  for (size_t k = 0; k < whole; k += kLanes) {
    Lanes y[B];
    for (int j = 0; j < B; ++j) y[j] = load(b + static_cast<size_t>(j) * length + k);
    for (int i = 0; i < A; ++i) {
      const Lanes x = load(a + static_cast<size_t>(i) * length + k);
      for (int j = 0; j < B; ++j) acc[i][j] += x * y[j];
    }
  }
  for (size_t i = 0; i < A; ++i)
    for (size_t j = 0; j < B; ++j) {
      float rest = 0;
      for (size_t k = whole; k < n; ++k) rest += a[i * length + k] * b[j * length + k];
      out[i * stride + j] += static_cast<double>(sum(acc[i][j]) + rest);
    }
}

template <int A>
inline void dot_strip(const float* a, const float* b, size_t nb, size_t length, size_t n, double* out, size_t stride) {
  size_t j = 0;
  for (; j + 3 <= nb; j += 3) dot_block<A, 3>(a, b + j * length, length, n, out + j, stride);
  for (; j < nb; ++j) dot_block<A, 1>(a, b + j * length, length, n, out + j, stride);
}

template <int R, int V>
inline void combine_block(const float* c, size_t n, const float* x, size_t length, float* out) {
  Lanes acc[R][V];
  for (size_t r = 0; r < R; ++r)
    for (size_t v = 0; v < V; ++v) acc[r][v] = load(out + r * length + v * kLanes);
  for (size_t j = 0; j < n; ++j) {
    Lanes y[V];
    for (size_t v = 0; v < V; ++v) y[v] = load(x + j * length + v * kLanes);
    for (size_t r = 0; r < R; ++r) {
      const float factor = c[r * n + j];
      for (size_t v = 0; v < V; ++v) acc[r][v] += factor * y[v];
    }
  }
  for (size_t r = 0; r < R; ++r)
    for (size_t v = 0; v < V; ++v) store(out + r * length + v * kLanes, acc[r][v]);
}

template <int R>
inline void combine_strip(const float* c, size_t n, const float* x, size_t length, size_t wide, float* out) {
  size_t k = 0;
  for (; k + 3 * kLanes <= wide; k += 3 * kLanes) combine_block<R, 3>(c, n, x + k, length, out + k);
  for (; k < wide; ++k)
    for (size_t r = 0; r < R; ++r) {
      float value = out[r * length + k];
      for (size_t j = 0; j < n; ++j) value += c[r * n + j] * x[j * length + k];
      out[r * length + k] = value;
    }
}

}  // namespace

VAMP_CLONES void dot_rows(const float* a, size_t na, const float* b, size_t nb, size_t length, double* out) {
  std::fill(out, out + na * nb, 0.0);
  for (size_t first = 0; first < length; first += kChunk) {
    const size_t n = std::min(kChunk, length - first);
    size_t i = 0;
    for (; i + 4 <= na; i += 4) dot_strip<4>(a + i * length + first, b + first, nb, length, n, out + i * nb, nb);
    for (; i < na; ++i) dot_strip<1>(a + i * length + first, b + first, nb, length, n, out + i * nb, nb);
  }
}

void gram_rows(const float* a, size_t na, size_t length, double* out) {
  // Strips of rows against all up to themselves; the rest is their mirror.
  constexpr size_t kStrip = 16;
  std::vector<double> strip;
  for (size_t first = 0; first < na; first += kStrip) {
    const size_t rows = std::min(kStrip, na - first), columns = first + rows;
    strip.resize(rows * columns);
    dot_rows(a + first * length, rows, a, columns, length, strip.data());
    for (size_t i = 0; i < rows; ++i)
      for (size_t j = 0; j <= first + i; ++j)
        out[(first + i) * na + j] = out[j * na + first + i] = strip[i * columns + j];
  }
}

VAMP_CLONES void add_combinations(const float* coefficients, size_t rows, const float* x, size_t n, size_t length,
                                  float* out) {
  constexpr size_t kWide = 20 * 3 * kLanes;  // of each row of x, so that all rows stay in the cache
  for (size_t first = 0; first < length; first += kWide) {
    const size_t wide = std::min(kWide, length - first);
    size_t r = 0;
    for (; r + 4 <= rows; r += 4)
      combine_strip<4>(coefficients + r * n, n, x + first, length, wide, out + r * length + first);
    for (; r < rows; ++r) combine_strip<1>(coefficients + r * n, n, x + first, length, wide, out + r * length + first);
  }
}

VAMP_CLONES void floats_from_halves(const uint16_t* halves, size_t stride, size_t count, const float* factor,
                                    float* out) {
  // Exponent and mantissa moved into a float and scaled by the difference of the biases: exact, subnormals included.
  for (size_t i = 0; i < count; ++i) {
    const uint32_t bits = halves[i * stride];
    const float magnitude = std::bit_cast<float>((bits & 0x7fffu) << 13) * 0x1p112f;
    out[i] = std::bit_cast<float>(std::bit_cast<uint32_t>(magnitude) | (bits & 0x8000u) << 16) * factor[i];
  }
}

}  // namespace vamp::fit
