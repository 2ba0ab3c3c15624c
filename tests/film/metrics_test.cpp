// Image metrics against values worked by hand.

#include "render/film/metrics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "render/core/error.h"

using namespace ropelight;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Image rowOf(std::initializer_list<Rgb> pixels) {
  Image image(int(pixels.size()), 1);
  image.pixels = pixels;
  return image;
}

Image greyRow(std::initializer_list<float> values) {
  Image image(int(values.size()), 1);
  std::size_t i = 0;
  for (float value : values) image.pixels[i++] = Rgb(value);
  return image;
}

}  // namespace

TEST_CASE("Metrics of four grey pixels agree with the sums on paper") {
  const Image a = greyRow({1.5f, 2.0f, 0.5f, 0.75f});
  const Image b = greyRow({1.0f, 2.0f, 0.0f, 1.0f});
  // Errors ½, 0, ½, −¼: squares ¼, 0, ¼, 1/16, sum 9/16, mean 9/64.
  // mean(b²) = (1 + 4 + 0 + 1)/4 = 3/2, so ε = 0.015, and the relative squares are
  // ¼/1.015, 0, ¼/0.015, (1/16)/1.015: 0.3125/1.015 + 16.666667 in all.
  const Metrics metrics = compareImages(a, b);
  CHECK(metrics.epsilon == doctest::Approx(0.015).epsilon(1e-12));
  CHECK(metrics.mse == doctest::Approx(9.0 / 64.0).epsilon(1e-12));
  CHECK(metrics.rmse == doctest::Approx(0.375).epsilon(1e-12));
  CHECK(metrics.relMse == doctest::Approx((0.3125 / 1.015 + 0.25 / 0.015) / 4.0).epsilon(1e-12));
  CHECK(metrics.relMseTrimmed == doctest::Approx(metrics.relMse).epsilon(1e-12));         // ⌊0.001·4⌋ = 0 pixels
  CHECK(metrics.psnr == doctest::Approx(10.0 * std::log10(256.0 / 9.0)).epsilon(1e-12));  // peak 2
  CHECK(metrics.meanError == doctest::Approx(0.1875).epsilon(1e-12));                     // ¾/4
  CHECK(metrics.maxError == 0.5);
  CHECK(metrics.mean[1] == doctest::Approx(1.1875).epsilon(1e-12));
  CHECK(metrics.meanReference[1] == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(metrics.pixels == 4);
}

TEST_CASE("Channels count alike and keep apart") {
  const Metrics metrics = compareImages(rowOf({Rgb(1, 2, 3), Rgb(0, 0, 0)}), rowOf({Rgb(1, 4, 2), Rgb(0, 0, 8)}));
  // Errors 0, −2, 1 and 0, 0, −8: squares 4 + 1 + 64 = 69 over six values.
  CHECK(metrics.mse == doctest::Approx(11.5).epsilon(1e-12));
  CHECK(metrics.meanError == doctest::Approx(-1.5).epsilon(1e-12));
  CHECK(metrics.maxError == 8.0);
  CHECK(metrics.mean == std::array<double, 3>{0.5, 1.0, 1.5});
  CHECK(metrics.meanReference == std::array<double, 3>{0.5, 2.0, 5.0});
  // mean(b²) = (1 + 16 + 4 + 64)/6 = 85/6.
  CHECK(metrics.epsilon == doctest::Approx(0.85 / 6.0).epsilon(1e-12));
  CHECK(metrics.rmse == doctest::Approx(3.391164991562634).epsilon(1e-12));  // √11.5
  CHECK(metrics.psnr == doctest::Approx(7.454821336).epsilon(1e-9));         // peak 8: 10 log₁₀(64/11.5)
  // Relative squares 4/(16 + ε) and 1/(4 + ε) in one pixel, 64/(64 + ε) in the other, three channels each.
  const double e = 0.85 / 6.0;
  CHECK(metrics.relMse == doctest::Approx((4 / (16 + e) + 1 / (4 + e) + 64 / (64 + e)) / 6.0).epsilon(1e-12));
}

TEST_CASE("A fixed epsilon replaces the default") {
  const Metrics metrics = compareImages(greyRow({1.1f}), greyRow({1.0f}), {.epsilon = 0.01});
  const double error = double(1.1f) - 1.0;
  CHECK(metrics.relMse == doctest::Approx(error * error / 1.01).epsilon(1e-12));
  CHECK(metrics.epsilon == 0.01);
}

TEST_CASE("The trimmed relMSE drops the pixels whose channel mean is worst") {
  // With b = 1 and ε = 0 the relative squares are (4, 0, 0), mean 4/3; (2.25, 2.25, 2.25), mean 9/4; and (¼, ¼, ¼).
  const Image a = rowOf({Rgb(3, 1, 1), Rgb(2.5f), Rgb(1.5f)});
  const Image b = greyRow({1.0f, 1.0f, 1.0f});
  const Metrics metrics = compareImages(a, b, {.epsilon = 0.0, .trimmed = 0.34});
  CHECK(metrics.relMse == doctest::Approx((4.0 / 3.0 + 2.25 + 0.25) / 3.0).epsilon(1e-12));
  CHECK(metrics.relMseTrimmed == doctest::Approx((4.0 / 3.0 + 0.25) / 2.0).epsilon(1e-12));
}

TEST_CASE("By default one pixel in a thousand is trimmed") {
  Image a(100, 20), b(100, 20);
  for (Rgb& pixel : b.pixels) pixel = Rgb(1.0f);
  a = b;
  for (int x : {3, 50, 99}) a.at(x, 7) = Rgb(float(x));  // 2000 pixels: the two worst of three go
  const Metrics metrics = compareImages(a, b, {.epsilon = 1.0});
  CHECK(metrics.relMseTrimmed == doctest::Approx(4.0 / 2.0 / 1998.0).epsilon(1e-12));
  CHECK(metrics.relMse == doctest::Approx((4.0 + 49.0 * 49.0 + 98.0 * 98.0) / 2.0 / 2000.0).epsilon(1e-12));
}

TEST_CASE("Pixels that are not finite are counted and left out of every sum") {
  const Image a = rowOf({Rgb(2), Rgb(notANumber, 0, 0), Rgb(5), Rgb(infinity)});
  const Image b = rowOf({Rgb(1), Rgb(100), Rgb(0, -infinity, 0), Rgb(notANumber)});
  const Metrics metrics = compareImages(a, b);
  CHECK(metrics.nonFinite == 2);
  CHECK(metrics.nonFiniteReference == 2);
  CHECK(metrics.pixels == 1);
  CHECK(metrics.mse == 1.0);
  CHECK(metrics.epsilon == doctest::Approx(0.01).epsilon(1e-12));
  CHECK(metrics.rmse == 1.0);
  CHECK(metrics.relMse == doctest::Approx(1.0 / 1.01).epsilon(1e-12));
  CHECK(metrics.relMseTrimmed == doctest::Approx(1.0 / 1.01).epsilon(1e-12));
  CHECK(metrics.psnr == 0.0);  // peak 1, MSE 1
  CHECK(metrics.meanError == 1.0);
  CHECK(metrics.maxError == 1.0);
  CHECK(metrics.mean[0] == 2.0);
  CHECK(metrics.meanReference[0] == 1.0);
}

TEST_CASE("What is trimmed is a share of the finite pixels") {
  // Relative squares 1, 4 and 9; ⌊0.34·3⌋ = 1 goes, where ⌊0.34·6⌋ would be 2.
  const Image a = greyRow({2.0f, notANumber, 3.0f, infinity, 4.0f, notANumber});
  const Metrics metrics = compareImages(a, greyRow({1, 1, 1, 1, 1, 1}), {.epsilon = 0.0, .trimmed = 0.34});
  CHECK(metrics.relMse == doctest::Approx(14.0 / 3.0).epsilon(1e-12));
  CHECK(metrics.relMseTrimmed == doctest::Approx(2.5).epsilon(1e-12));
}

TEST_CASE("Without a finite pixel every value is NaN") {
  const Metrics metrics = compareImages(greyRow({notANumber}), greyRow({1.0f}));
  CHECK(metrics.pixels == 0);
  for (double value : {metrics.mse, metrics.rmse, metrics.relMse, metrics.relMseTrimmed, metrics.psnr,
                       metrics.meanError, metrics.maxError, metrics.mean[0], metrics.meanReference[2]})
    CHECK(std::isnan(value));
}

TEST_CASE("Black and equal images have no error, and an error against black is infinite without epsilon") {
  const Metrics black = compareImages(Image(2, 2), Image(2, 2));
  CHECK(black.relMse == 0.0);
  CHECK(black.relMseTrimmed == 0.0);
  CHECK(std::isinf(black.psnr));
  const Metrics lit = compareImages(greyRow({1.0f}), Image(1, 1));
  CHECK(std::isinf(lit.relMse));
  CHECK(lit.psnr == -std::numeric_limits<double>::infinity());
}

TEST_CASE("The largest floats do not overflow the sums") {
  const Metrics metrics = compareImages(greyRow({3e38f, 3e38f}), greyRow({-3e38f, -3e38f}));
  CHECK(metrics.rmse == doctest::Approx(6e38).epsilon(1e-6));
  CHECK(metrics.relMse == doctest::Approx(4.0 / 1.01).epsilon(1e-6));
}

TEST_CASE("Images of different sizes are refused with both sizes") {
  const char* message = "the images differ in size: 3 x 2 and 2 x 3 pixels; compare images of the same film size";
  CHECK_THROWS_WITH_AS(compareImages(Image(3, 2), Image(2, 3)), message, Error);
  CHECK_THROWS_WITH_AS(errorImage(Image(3, 2), Image(2, 3)), message, Error);
}

TEST_CASE("The error image is red where too bright, blue where too dark, green where not finite") {
  const Image b = greyRow({1.0f, 1.0f, 1.0f, 1.0f});
  const Image a = rowOf({Rgb(1.5f), Rgb(0.75f), Rgb(1.0f), Rgb(1, notANumber, 1)});
  const Image error = errorImage(a, b, {.epsilon = 0.0});
  CHECK(error.at(0, 0).x == doctest::Approx(0.5f));
  CHECK(error.at(0, 0).z == 0.0f);
  CHECK(error.at(1, 0).z == doctest::Approx(0.25f));
  CHECK(error.at(1, 0).x == 0.0f);
  CHECK(error.at(2, 0) == Rgb(0.0f));
  CHECK(error.at(3, 0) == Rgb(0, 1, 0));
}

TEST_CASE("Tile means cover the whole image, the last tiles what is left") {
  Image image(5, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) image.at(x, y) = Rgb(float(x), float(y), 1.0f);
  image.at(4, 2).z = notANumber;
  const Image means = tileMeans(image, 2);
  REQUIRE(means.width == 3);
  REQUIRE(means.height == 2);
  CHECK(means.at(0, 0) == Rgb(0.5f, 0.5f, 1.0f));
  CHECK(means.at(1, 0) == Rgb(2.5f, 0.5f, 1.0f));
  CHECK(means.at(2, 0) == Rgb(4.0f, 0.5f, 1.0f));
  CHECK(means.at(1, 1) == Rgb(2.5f, 2.0f, 1.0f));
  CHECK(std::isnan(means.at(2, 1).z));
  CHECK(tileMeans(image, 2147483647).width == 1);
}
