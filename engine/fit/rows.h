#pragma once
// Products of rows of floats: what clustering, fits and residuals are made of. Sums run in a fixed order (the same bits
// for any number of threads); float within 512 terms, double between.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vamp::fit {

// Rows of floats that follow one another in memory.
struct Rows {
  size_t count = 0, length = 0;
  std::vector<float> data;

  Rows() = default;
  Rows(size_t rows, size_t row_length) : count(rows), length(row_length), data(rows * row_length) {}
  float* row(size_t i) { return data.data() + i * length; }
  const float* row(size_t i) const { return data.data() + i * length; }
};

// out[i * nb + j] = sum over k of a[i * length + k] * b[j * length + k].
void dot_rows(const float* a, size_t na, const float* b, size_t nb, size_t length, double* out);

// All pairs of one set: the Gram matrix, both halves.
void gram_rows(const float* a, size_t na, size_t length, double* out);

// out[r * length + k] += sum over j of coefficients[r * n + j] * x[j * length + k].
void add_combinations(const float* coefficients, size_t rows, const float* x, size_t n, size_t length, float* out);

// Halves to floats times a factor each: out[i] = halves[i * stride] * factor[i]. Infinity and NaN come out as large
// finite numbers.
void floats_from_halves(const uint16_t* halves, size_t stride, size_t count, const float* factor, float* out);

}  // namespace vamp::fit
