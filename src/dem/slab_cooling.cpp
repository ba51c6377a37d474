#include "dem/slab_cooling.hpp"

#include <cmath>
#include <numbers>

namespace vug {

namespace {

constexpr int terms = 1000;              // enough for diffusion lengths down to 4e-3 of the height
constexpr double cold_beyond = 8;        // diffusion length over the height: 4/pi exp(-(pi/4)^2 8^2) = 9e-18 is left
constexpr double negligible_decay = 40;  // exp(-40) = 4e-18

/// The root of a tan a = biot in (n pi, n pi + pi / 2), by bisection of a sin a - biot cos a.
double root(int n, double biot) {
  double low = n * std::numbers::pi, high = low + std::numbers::pi / 2;
  const double sign = n % 2 == 0 ? 1 : -1;
  for (int halving = 0; halving < 60; ++halving) {
    const double a = 0.5 * (low + high);
    (sign * (a * std::sin(a) - biot * std::cos(a)) > 0 ? high : low) = a;
  }
  return 0.5 * (low + high);
}

}  // namespace

SlabCooling::SlabCooling(double drop, double height, double biot) : drop_(drop), height_(height) {
  if (std::isfinite(biot))
    for (int n = 0; n < terms; ++n) roots_.push_back(root(n, biot));
}

double SlabCooling::change(double depth, double length) const {
  return roots_.empty() ? of_a_cold_face(depth, length) : through_a_film(depth, length);
}

double SlabCooling::of_a_cold_face(double depth, double length) const {
  if (length > cold_beyond * height_) return -drop_;
  double sum = 0, sign = 1;
  for (double image = 0; image < 6 * length; image += 2 * height_, sign = -sign)  // erfc(6) = 2e-17
    sum += sign * (std::erfc((image + depth) / length) + std::erfc((image + 2 * height_ - depth) / length));
  return -drop_ * sum;
}

double SlabCooling::through_a_film(double depth, double length) const {
  const double time = length * length / (4 * height_ * height_);
  double left = 0;
  for (const double a : roots_) {
    if (a * a * time > negligible_decay) break;
    left += 4 * std::sin(a) / (2 * a + std::sin(2 * a)) * std::cos(a * (1 - depth / height_)) * std::exp(-a * a * time);
  }
  return -drop_ * (1 - left);
}

double SlabCooling::mean_change(double length) const {
  constexpr int samples = 2000;
  double mean = 0;
  for (int k = 0; k < samples; ++k) mean += change(height_ * (k + 0.5) / samples, length) / samples;
  return mean;
}

double SlabCooling::stress(double modulus, double expansion, double depth, double length) const {
  return -modulus * expansion * (change(depth, length) - mean_change(length));
}

}  // namespace vug
