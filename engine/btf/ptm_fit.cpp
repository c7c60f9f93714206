// Polynomial texture maps from measurements.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/btf/picture_curve.h"
#include "engine/btf/ptm.h"
#include "engine/btf/ptm_basis.h"

namespace vamp {
namespace {

using Coefficients = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // a column a texel and polynomial
using Codes = Eigen::Matrix<double, Eigen::Dynamic, 3>;         // a row a light

Codes codes_of(const Btf& btf, size_t texel, std::span<const size_t> lights, PictureCurve curve) {
  Codes codes(static_cast<Eigen::Index>(lights.size()), 3);
  for (Eigen::Index i = 0; i < codes.rows(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c) {
      const float light = btf.at(texel, 0, lights[static_cast<size_t>(i)], static_cast<size_t>(c));
      codes(i, c) = 255 * code_of(double{light}, curve);
    }
  return codes;
}

// The mean colour, its brightest channel at 255; white where there is none.
Eigen::Vector3d colour_of(const Codes& codes) {
  const Eigen::Vector3d mean = codes.colwise().mean();
  const double brightest = mean.maxCoeff();
  if (!(brightest > 0)) return Eigen::Vector3d::Constant(255);
  return (mean * (255 / brightest)).array().round();
}

// A scale and bias for each term that let the bytes reach its smallest and largest coefficient.
void round_to_bytes(const Coefficients& coefficients, Ptm& ptm) {
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double low = coefficients.row(k).minCoeff(), high = coefficients.row(k).maxCoeff();
    // One code of 256 is left over, because the bias is a whole number. All equal: one code stands for the value.
    double scale = (high - low) / 254;
    if (!(scale > 1e-6 * std::max(std::abs(low), 1.0))) scale = std::max(std::abs(low), 1.0) / 254;
    ptm.scale[static_cast<size_t>(k)] = static_cast<float>(scale);
    ptm.bias[static_cast<size_t>(k)] = static_cast<int>(std::lround(-low / scale));
  }
  for (Eigen::Index column = 0; column < coefficients.cols(); ++column)
    for (size_t k = 0; k < 6; ++k) {
      const double byte = coefficients(static_cast<Eigen::Index>(k), column) / double{ptm.scale[k]} + ptm.bias[k];
      ptm.coefficients.push_back(static_cast<uint8_t>(std::clamp(std::lround(byte), 0l, 255l)));
    }
}

}  // namespace

Result<Ptm> fit_ptm(const Btf& btf, std::span<const size_t> lights, bool has_luminance, PictureCurve curve) {
  Ptm ptm;
  ptm.has_luminance = has_luminance;
  ptm.width = btf.info().width;
  ptm.height = btf.info().height;
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(lights.size()), 6);
  for (size_t i = 0; i < lights.size(); ++i) {
    const auto row = ptm_basis(btf.info().lights[lights[i]]);
    for (size_t k = 0; k < 6; ++k) basis(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = row[k];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(basis);
  if (solver.rank() < 6)
    return fail(ErrorKind::failed, "", "lights", "six or more that do not lie on one conic",
                std::to_string(lights.size()));

  const size_t texels = btf.texel_count();
  const auto columns = static_cast<Eigen::Index>(texels);
  Coefficients coefficients(6, has_luminance ? columns : 3 * columns);
  for (size_t t = 0; t < texels; ++t) {
    const Codes codes = codes_of(btf, t, lights, curve);
    const auto column = static_cast<Eigen::Index>(t);
    if (!has_luminance) {
      for (Eigen::Index c = 0; c < 3; ++c) coefficients.col(c * columns + column) = solver.solve(codes.col(c));
      continue;
    }
    // code = luminance * colour / 255 in the sense of least squares over the channels.
    const Eigen::Vector3d colour = colour_of(codes);
    coefficients.col(column) = solver.solve(codes * colour * (255 / colour.squaredNorm()));
    for (Eigen::Index c = 0; c < 3; ++c) ptm.colours.push_back(static_cast<uint8_t>(colour[c]));
  }
  round_to_bytes(coefficients, ptm);
  return ptm;
}

}  // namespace vamp
