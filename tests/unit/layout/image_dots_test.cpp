// Taxels from drawings and tables: dots are found at their places and projected onto the skin.
#include "core/layout/generators/image_dots.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/layout/generators/place.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace taxel {
namespace {

MeshIndex plate() {
  return MeshIndex(std::make_shared<TriMesh>(make_box(dvec3(0.02, 0.02, 0.001))));
}

/// Returns an image in which '#' is black, '.' is white and '+' is grey.
GreyImage drawn(const std::vector<std::string>& rows) {
  GreyImage image{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows)
    for (const char c : row) image.grey.push_back(c == '#' ? 0 : c == '+' ? 128 : 255);
  return image;
}

const std::vector<std::string> kThree = {"##......",  //
                                         "##...#..",  //
                                         "....#...",  //
                                         "...+...#"};

TEST(ImageDots, AreFoundAtTheirPlaces) {
  EXPECT_EQ(dots_of(drawn(kThree), {}), (std::vector<dvec2>{{1, 1}, {5, 2}, {7.5, 3.5}})) << "corners hang together";
  ImageDots dots;
  dots.threshold = 129;
  EXPECT_EQ(dots_of(drawn(kThree), dots)[1], dvec2(4.5, 2.5)) << "three in a diagonal";
  dots.least_pixels = 2;
  EXPECT_EQ(dots_of(drawn(kThree), dots).size(), 2U) << "dust";
  dots = {};
  dots.light = true;
  EXPECT_EQ(dots_of(drawn({"#.#", "###", "+##"}), dots), (std::vector<dvec2>{{1.5, 0.5}, {0.5, 2.5}}));
}

TEST(ImageDots, ArePlacedOnTheSkinInTheOrientationOfTheImage) {
  ImageDots dots;
  dots.width = 0.008;  // a pixel is a millimetre
  dots.center = {0.001, 0.002, 0.01};
  dots.radius = 0.004;
  const std::vector<Taxel> above = image_dots(drawn(kThree), dots, plate()).taxels;
  ASSERT_EQ(above.size(), 3U);
  const dvec3 expected(0.001 - 0.003, 0.002 + 0.001, 0.001);
  EXPECT_LT(glm::distance(above[0].center, expected), 1e-17);
  EXPECT_GT(above[0].normal.z, 0.9);
  EXPECT_EQ(above[2].id, 2);
  EXPECT_EQ(above[2].radius, 0.004);

  // Seen from below, x points to the left.
  dots.center.z = -0.01;
  dots.normal = {0, 0, -2};
  dots.along_row = {-3, 0, 1};
  const std::vector<Taxel> below = image_dots(drawn(kThree), dots, plate()).taxels;
  EXPECT_LT(glm::distance(below[0].center, dvec3(0.001 + 0.003, 0.003, -0.001)), 1e-17);
}

TEST(ImageDots, NameTheMistakeInErrors) {
  const auto complaint = [](const GreyImage& image, const auto& change) {
    ImageDots dots;
    dots.center.z = 0.01;
    change(dots);
    return test::complaint_of([&] { image_dots(image, dots, plate()); });
  };
  const auto nothing = [](ImageDots&) {};
  EXPECT_EQ(complaint(drawn(kThree), nothing), "accepted");
  EXPECT_EQ(complaint(drawn({"..."}), nothing), "image: picture: has no dot darker than 128");
  EXPECT_EQ(complaint({}, nothing), "image: picture: must have pixels, is 0 x 0");
  EXPECT_EQ(complaint(drawn(kThree), [](ImageDots& d) { d.threshold = 0; }),
            "image: threshold: must be 1 to 255, is 0");
  EXPECT_EQ(complaint(drawn(kThree), [](ImageDots& d) { d.width = -1; }),
            "image: width: must be finite and greater than 0, is -1");
  EXPECT_EQ(complaint(drawn(kThree), [](ImageDots& d) { d.along_row = d.normal; }),
            "image: along_row: must not be parallel to normal");
  EXPECT_EQ(complaint(drawn(kThree), [](ImageDots& d) { d.width = 0.16; }).substr(0, 45),
            "image: dot 0 at pixel (1, 1): the ray from [-");
}

std::string png_of(int width, int height, int channels, const std::vector<std::uint8_t>& pixels) {
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, width, height, channels, pixels.data(), width * channels);
  return bytes;
}

TEST(GreyImages, AreRead) {
  const test::TempFolder folder;
  const std::vector<std::uint8_t> pixels = {0, 127, 255, 1, 2, 3};
  const GreyImage image = read_grey_image(folder.write("a.png", png_of(3, 2, 1, pixels)));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.grey, pixels);
}

TEST(GreyImages, TreatTransparentPixelsAsWhite) {
  const test::TempFolder folder;
  const std::vector<std::uint8_t> pixels = {0, 0, 0, 0, 100, 100, 100, 255, 0, 0, 0, 51};
  EXPECT_EQ(read_grey_image(folder.write("a.png", png_of(3, 1, 4, pixels))).grey,
            (std::vector<std::uint8_t>{255, 100, 204}));
}

TEST(GreyImages, NameFilesThatAreNoImages) {
  const test::TempFolder folder;
  const auto complaint = [](const std::filesystem::path& path) {
    return test::complaint_of([&] { read_grey_image(path); });
  };
  const auto text = folder.write("a.txt", "no picture");
  EXPECT_EQ(complaint(text), text.string() + ": is no picture that can be read: unknown image type");
  EXPECT_NE(complaint(folder / "none.png").find("no such file"), std::string::npos);
  std::vector<std::uint8_t> noise(3000);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<std::uint8_t>(i * i % 251);
  const std::string png = png_of(50, 60, 1, noise);
  for (std::size_t size = 0; size + 20 < png.size(); size += 7)
    EXPECT_NE(complaint(folder.write("half.png", png.substr(0, size))), "accepted") << size << " of " << png.size();
  std::string huge = png;
  huge[18] = huge[22] = 0x4E;  // 20 018 x 20 028 pixels
  EXPECT_NE(complaint(folder.write("huge.png", huge)).find("pixels, more than 100000000"), std::string::npos);
}

TEST(OntoSkin, KeepsAllButPlaceAndNormal) {
  const MeshIndex skin(std::make_shared<TriMesh>(make_icosphere(0.01, 5)));
  std::vector<Taxel> taxels = {{7, "a", {0.012, 0, 0}, {0, 1, 0}, 0.002, {}},
                               {3, "b", {0, 0, 0.009}, {1, 0, 0}, 0.003, {{{0, 0.02, 0}, {1, 0, 0}, 0.001}}}};
  const std::vector<Taxel> placed = onto_skin(taxels, skin);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(placed[i].id, taxels[i].id);
    EXPECT_EQ(placed[i].name, taxels[i].name);
    EXPECT_EQ(placed[i].radius, taxels[i].radius);
    EXPECT_NEAR(skin.closest_point(placed[i].center).distance, 0, 1e-15);
    EXPECT_GT(glm::dot(placed[i].normal, glm::normalize(taxels[i].center)), 0.9999);
  }
  EXPECT_NEAR(glm::length(placed[1].subtaxels[0].center), 0.01, 1e-5);
  EXPECT_GT(placed[1].subtaxels[0].normal.y, 0.9999);
}

TEST(OntoSkin, NamesPointsFarFromTheSkin) {
  const MeshIndex skin(std::make_shared<TriMesh>(make_box(dvec3(0.01))));
  std::vector<Taxel> taxels = {{7, "a", {0.012, 0, 0}, {0, 1, 0}, 0.002, {}},
                               {9, "", {12, 0, 0}, {0, 1, 0}, 0.002, {}}};
  EXPECT_EQ(test::complaint_of([&] { onto_skin(taxels, skin, 0.005); }),
            "points: taxel 9: is 11.99 m from the surface, more than 0.005 m: is the unit another one?");
  taxels[1].center.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::complaint_of([&] { onto_skin(taxels, skin); }).substr(0, 32), "points: taxel 9: must be finite,");
}

}  // namespace
}  // namespace taxel
