// SPDX-License-Identifier: BSD-3-Clause
// What scenes can be told: components, cut planes, opacity, scale bar, ranges; and the check of pictures.
#include "core/error.h"
#include "tests/vtkio/made_run.h"
#include "tests/vtkio/pixels.h"
#include "vtkio/display_unit.h"
#include "vtkio/legend.h"
#include "vtkio/montage.h"
#include "vtkio/palette.h"
#include "vtkio/particles_to_vtk.h"
#include "vtkio/picture_check.h"
#include "vtkio/robust_range.h"
#include "vtkio/scale_bar.h"
#include "vtkio/scene.h"
#include "vtkio/shells_to_vtk.h"
#include "vtkio/snapshot.h"
#include "vtkio/visible_shell.h"
#include "vtkio/write_png.h"

#include <catch2/catch.hpp>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <fstream>
#include <iterator>

using namespace birdstrike;
using Catch::Matchers::Contains;

namespace {

Frame made_frame(double late = 0)
{
  return {late * 4e-3, particles_to_vtk(made_bird(0.008, late), 0), plate_to_vtk(made_plate(), 0)};
}

SnapshotOptions small(View view = View::side)
{
  SnapshotOptions options;
  options.width = 480;
  options.height = 270;
  options.view = view;
  options.cut = false;
  return options;
}

bool is_black(const unsigned char* c) { return c[0] < 60 && c[1] < 60 && c[2] < 60; }
bool is_reddish(const unsigned char* c) { return c[0] > c[1] + 20 && c[0] > c[2] + 20; }

vtkSmartPointer<vtkImageData> canvas_of(int width, int height, unsigned char value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int k = 0; k < 3; ++k)
        static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[k] = value;
  return image;
}

void paint(vtkImageData& image, int x0, int x1, int y0, int y1, std::array<unsigned char, 3> colour)
{
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        static_cast<unsigned char*>(image.GetScalarPointer(x, y, 0))[k] = colour[k];
}

} // namespace

TEST_CASE("a field is an array, a vector's length or a component", "[pictures]")
{
  const auto bird = particles_to_vtk(made_bird(0.02), 0);
  vtkDataArray& velocity = *bird->GetPointData()->GetArray("velocity");
  const auto length = find_shown_array(*bird->GetPointData(), "velocity");
  const auto z = find_shown_array(*bird->GetPointData(), "velocity_z");
  REQUIRE(length);
  REQUIRE(z);
  CHECK(z->value(3) == velocity.GetComponent(3, 2));
  CHECK(length->value(3) == Approx(std::hypot(velocity.GetComponent(3, 0), velocity.GetComponent(3, 1),
                                              velocity.GetComponent(3, 2))));
  CHECK_FALSE(find_shown_array(*bird->GetPointData(), "pressure_x")); // no vector
  CHECK_FALSE(find_shown_array(*bird->GetPointData(), "velocity_w"));
  CHECK(display_unit("velocity_x").unit == "m/s");
  CHECK(display_unit("von_mises").unit == "MPa");
  CHECK(si_unit_of_array("thickness") == "m");
  CHECK(si_unit_of_array("unheard_of").empty());
  CHECK_THAT(names_of_arrays(*bird->GetPointData()), Contains("velocity (or velocity_x, _y, _z)"));
}

TEST_CASE("one scale holds 98 % of the worst frame, and single particles do not move it", "[pictures]")
{
  vtkNew<vtkDoubleArray> values;
  for (int k = 0; k < 1000; ++k)
    values->InsertNextValue(k * 1e4); // 0 to 10 MPa
  RobustRange calm;
  calm.add({values, -1});
  CHECK(calm.range()[0] == 0);
  CHECK(calm.range()[1] == Approx(9.8e6));
  values->InsertNextValue(1e12);
  values->InsertNextValue(std::nan(""));
  RobustRange disturbed;
  disturbed.add({values, -1});
  CHECK(disturbed.range() == calm.range());

  vtkNew<vtkDoubleArray> densities;
  for (int k = 0; k <= 100; ++k)
    densities->InsertNextValue(600 + k);
  RobustRange narrow; // an end far from zero stays there
  narrow.add({densities, -1});
  CHECK(narrow.range()[0] == Approx(600));
  CHECK(narrow.range()[1] == Approx(700));
  RobustRange all;
  all.add({densities, -1}, 1.0);
  CHECK(all.high() == 700);

  CHECK(RobustRange().range() == std::array<double, 2>{0, 1});
  vtkNew<vtkDoubleArray> same;
  same->InsertNextValue(5);
  RobustRange single;
  single.add({same, -1});
  CHECK(single.range()[1] > single.range()[0]);
  CHECK(rounded_outwards(12345, true) == Approx(13000));
  CHECK(rounded_outwards(-12345, true) == Approx(-12000));
  CHECK(rounded_outwards(0.098, true) == Approx(0.098));
}

TEST_CASE("a cut keeps what lies behind the plane, of target and bird", "[pictures]")
{
  const auto plate = plate_to_vtk(made_plate(), 0); // 0.6 m along y, 0.5 m along z
  double bounds[6];
  visible_shell(*plate, HalfSpace{{1, 0.1}, 1})->GetBounds(bounds);
  CHECK(bounds[2] == Approx(0.1));
  CHECK(bounds[3] == Approx(0.3));
  visible_shell(*plate, HalfSpace{{2, -0.07}, -1})->GetBounds(bounds);
  CHECK(bounds[4] == Approx(-0.25));
  CHECK(bounds[5] == Approx(-0.07));

  // From above the camera looks down: what lies above the plane goes, and the lungs are seen.
  SnapshotOptions options = small(View::top);
  options.legend = false;
  options.plane = {2, 0.015};
  const Frame frame = made_frame();
  options.cut = true;
  REQUIRE(kept(options)->sign == -1);
  Snapshot open(options, bounds_of(frame));
  CHECK(count(Pixels(*open.draw(frame)), 0, 1, 0.1, 0.9, is_reddish) > 60);
  options.cut = false;
  Snapshot whole(options, bounds_of(frame));
  const auto is_lung = [](const unsigned char* c) {
    return c[0] > 80 && c[0] > 2.5 * c[1] && c[0] > 2.5 * c[2];
  };
  CHECK(count(Pixels(*whole.draw(frame)), 0, 1, 0.1, 0.9, is_lung) == 0);
  CHECK(cut_text({1, 0}) == "cut at y = 0");
  CHECK(cut_text({0, -0.012}) == "cut at x = -12 mm");
}

TEST_CASE("through a target that is not solid the bird behind it is seen", "[pictures]")
{
  const Frame frame = made_frame();
  SnapshotOptions options = small(View::front);
  options.legend = false;
  options.axes = false;
  // From behind: the same particles, moved to the other side of the plate.
  vtkNew<vtkUnstructuredGrid> behind;
  behind->DeepCopy(frame.bird);
  for (vtkIdType i = 0; i < behind->GetNumberOfPoints(); ++i) {
    const double* p = behind->GetPoint(i);
    behind->GetPoints()->SetPoint(i, p[0] + 0.6, p[1], p[2]);
  }
  const Frame passed{0, behind.Get(), frame.target};
  const auto brown = [](const unsigned char* c) { return c[0] > c[2] + 12; };
  Snapshot solid(options, bounds_of(passed));
  const int hidden = count(Pixels(*solid.draw(passed)), 0.25, 0.75, 0.1, 0.8, brown);
  options.target_opacity = 0.4;
  Snapshot glass(options, bounds_of(passed));
  const int seen = count(Pixels(*glass.draw(passed)), 0.25, 0.75, 0.1, 0.8, brown);
  CHECK(hidden == 0);
  CHECK(seen > 500);
  options.target_opacity = 1.5;
  CHECK_THROWS_WITH(Snapshot(options, bounds_of(passed)), Contains("opacity 1.5"));
}

TEST_CASE("the scale bar is as long as it says", "[pictures]")
{
  CHECK(round_length(0.19) == Approx(0.1));
  CHECK(round_length(0.2) == Approx(0.2));
  CHECK(round_length(7) == Approx(5));
  CHECK(length_text(0.05) == "50 mm");
  CHECK(length_text(2) == "2 m");

  // Against the plate, 0.6 m wide from the front: dark bar over light plate.
  Frame frame = made_frame();
  frame.bird = nullptr;
  SnapshotOptions options = small(View::front);
  options.scale_bar = true;
  options.axes = options.time_stamp = false;
  Snapshot snapshot(options, bounds_of(frame));
  const auto image = snapshot.draw(frame);
  const Pixels p(*image);
  const double canvas = snapshot.canvas()[2];
  int plate_pixels = 0, longest = 0;
  for (int x = 0; x < canvas; ++x)
    plate_pixels += is_drawn(p.at(x, p.height / 2));
  for (int y = 0; y < p.height / 5; ++y) {
    int row = 0;
    for (int x = static_cast<int>(canvas); x < p.width; ++x)
      row += is_black(p.at(x, y));
    longest = std::max(longest, row);
  }
  const double length = longest * 0.6 / plate_pixels; // [m]
  CHECK(length == Approx(round_length(length * 1.02)).epsilon(0.03));
  CHECK(longest > 20);
}

TEST_CASE("a picture that is empty, black or cut off is found out", "[pictures]")
{
  const Colour white{1, 1, 1}, dark{0.09, 0.1, 0.13};
  const auto blank = canvas_of(100, 80, 255);
  CHECK(fault_of(check_picture(*blank, white)) == "it is empty");
  paint(*blank, 30, 60, 20, 50, {200, 140, 60});
  CHECK(fault_of(check_picture(*blank, white)).empty());
  paint(*blank, 60, 100, 30, 40, {200, 140, 60}); // over an eighth of the right side
  CHECK_THAT(fault_of(check_picture(*blank, white)), Contains("cut off: 12 %"));
  CHECK(fault_of(check_picture(*blank, {0, 0, 90, 80}, white)) == fault_of(check_picture(*blank, white)));
  CHECK(fault_of(check_picture(*canvas_of(100, 80, 0), white)) == "it is black");
  const auto night = canvas_of(100, 80, 0);
  paint(*night, 0, 100, 0, 80, {23, 26, 33});
  CHECK(fault_of(check_picture(*night, dark)) == "it is empty");

  // The real thing: whole, then with a box that is too small, then with nothing in it.
  const Frame frame = made_frame();
  Snapshot whole(small(), bounds_of(frame));
  CHECK(fault_of(check_picture(*whole.draw(frame), whole.canvas(), white)).empty());
  Snapshot near(small(), {-0.2, 0, -0.1, 0.1, -0.1, 0.1});
  CHECK_THAT(fault_of(check_picture(*near.draw(frame), near.canvas(), white)), Contains("cut off"));
  SnapshotOptions bare = small();
  bare.axes = false;
  Snapshot nothing(bare, bounds_of(frame));
  CHECK(fault_of(check_picture(*nothing.draw({0, nullptr, nullptr}), nothing.canvas(), white)) ==
        "it is empty");
}

TEST_CASE("axes, scale bar and legend do not fill an empty picture", "[pictures]")
{
  const Frame frame = made_frame(), none{0, nullptr, nullptr};
  for (const bool legend : {true, false}) {
    SnapshotOptions options = small();
    options.legend = legend;
    options.axes = options.scale_bar = true;
    Snapshot snapshot(options, bounds_of(frame));
    CHECK(fault_of(snapshot.check(*snapshot.draw(none), none)) == "it is empty");
    CHECK(fault_of(snapshot.check(*snapshot.draw(frame), frame)).empty());
    const std::vector<Frame> panels{frame, none};
    MontageOptions montage;
    montage.snapshot = options;
    std::vector<PictureCheck> checks;
    draw_montage(panels, bounds_of(frame), montage, &checks);
    REQUIRE(checks.size() == 2);
    CHECK(fault_of(checks[0]).empty());
    CHECK(fault_of(checks[1]) == "it is empty");
    checks.clear();
    draw_montage({none, frame}, bounds_of(frame), montage, &checks); // the first panel has the axes
    CHECK(fault_of(checks.at(0)) == "it is empty");
  }
}

TEST_CASE("particles beyond the sides are told of, though few of them meet a side", "[pictures]")
{
  const Frame frame = made_frame();
  Bounds bounds = bounds_of(frame);
  bounds[4] = -0.06, bounds[5] = 0.05; // from the side: without the keel and the head's top
  for (const std::size_t k : {0, 1})
    bounds[k] *= 0.4;
  const SnapshotOptions options = small();
  Snapshot snapshot(options, bounds);
  const PictureCheck check = snapshot.check(*snapshot.draw(frame), frame);
  CHECK(check.outside > 0.05);
  PictureCheck alone;
  alone.drawn = 1;
  alone.outside = 0.03;
  CHECK_THAT(fault_of(alone), Contains("cut off: 3 % of the bird's particles"));
  alone.outside = 0.01;
  CHECK(fault_of(alone).empty());
}

TEST_CASE("a window holds what is seen, cut or not, and the picture holds the window", "[pictures]")
{
  const Frame frame = made_frame(0.5);
  const Bounds everywhere{-9, 9, -9, 9, -9, 9};
  for (const View view : {View::side, View::front, View::top, View::isometric, View::behind})
    for (const bool cut : {false, true}) {
      SnapshotOptions options = small(view);
      options.cut = cut;
      options.plane = {1, 0.02};
      hold_bird(options.window, *frame.bird, options, everywhere);
      hold_target(options.window, *frame.target, options);
      Snapshot snapshot(options, bounds_of(frame));
      const auto image = snapshot.draw(frame);
      const PictureCheck check = snapshot.check(*image, frame);
      CHECK(check.border == 0);
      CHECK(check.outside == 0);
      // And no more than that: it reaches two sides that face each other within the margin.
      const auto canvas = snapshot.canvas();
      const Pixels p(*image);
      int left = p.width, right = 0, low = p.height, high = 0;
      for (int y = 0; y < canvas[3]; ++y)
        for (int x = 0; x < canvas[2]; ++x)
          if (is_drawn(p.at(x, y)) && !(x < 80 && y < 60)) { // not the axes
            left = std::min(left, x), right = std::max(right, x);
            low = std::min(low, y), high = std::max(high, y);
          }
      CHECK(((right - left) > 0.92 * canvas[2] || (high - low) > 0.92 * canvas[3]));
    }
  SnapshotOptions options = small();
  hold_bird(options.window, *frame.bird, options, {9, 10, 9, 10, 9, 10});
  CHECK_FALSE(options.window); // nothing lies there
}

TEST_CASE("times on pictures have digits enough to be told apart", "[pictures]")
{
  CHECK(digits_of({0, 1e-3, 2e-3}) == 3);
  CHECK(digits_of({}) == 3);
  CHECK(digits_of({1e-3, 1e-3}) == 3);
  CHECK(digits_of({0, 1e-6, 3e-6}) == 3);
  CHECK(digits_of({3e-6, 0, 3.4e-6}) == 4);
  CHECK(digits_of({0, 2e-9}) == 6);
  CHECK(time_text(1.23456e-3, 3) == "1.235 ms");
  CHECK(time_text(3.4e-6, 4) == "0.0034 ms");
}

namespace {

//! Relative luminance, as the Web Content Accessibility Guidelines have it.
double luminance(const std::array<double, 3>& colour)
{
  double sum = 0;
  constexpr double share[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t k = 0; k < 3; ++k)
    sum += share[k] * (colour[k] <= 0.04045 ? colour[k] / 12.92 : std::pow((colour[k] + 0.055) / 1.055, 2.4));
  return sum;
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

//! Mean of the pixels in the middle of the picture, half as wide and high.
std::array<double, 3> middle_of(const Frame& frame, const SnapshotOptions& options, const Bounds& bounds)
{
  Snapshot snapshot(options, bounds);
  const auto image = snapshot.draw(frame);
  const Pixels p(*image);
  std::array<double, 3> sum{};
  double count = 0;
  for (int y = p.height / 4; y < 3 * p.height / 4; ++y)
    for (int x = 3 * p.width / 8; x < 5 * p.width / 8; ++x, ++count)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += p.at(x, y)[k] / 255.0;
  for (double& part : sum)
    part /= count;
  return sum;
}

} // namespace

TEST_CASE("every part stands out from the plate by 2 : 1 in luminance", "[pictures][palette]")
{
  for (const char* name : {"head", "neck", "torso", "bones", "wings", "lungs", "legs", "beak"})
    CHECK(contrast(luminance(part_colour(name, 0)), luminance(plain_target)) >= 2);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(contrast(luminance(part_colour("anything", k)), luminance(plain_target)) >= 2);

  // As they are drawn: a plate without and with a great many lines; a wall of balls, lit.
  for (const View view : {View::front, View::isometric, View::behind})
    for (const Colour& background : {Colour{1, 1, 1}, Colour{0.09, 0.10, 0.13}})
      for (const int elements : {1, 40, 300}) {
        SnapshotOptions options = small(view);
        options.legend = options.axes = options.time_stamp = false;
        options.background = background;
        const auto plate = plate_to_vtk(make_rigid_plate(2, 2, 0.01, elements, elements), 0);
        const double ground =
            luminance(middle_of({0, nullptr, plate}, options, {-0.4, 0.4, -0.4, 0.4, -0.4, 0.4}));
        for (const char* name : {"head", "neck", "torso", "bones", "wings", "lungs"}) {
          INFO(name << ", view " << static_cast<int>(view) << ", " << elements << " elements");
          Particles ball;
          ball.parts.push_back({name, Linear{1000, 2e9}, 0, 0});
          ball.resize(1);
          ball.x[0] = ball.y[0] = ball.z[0] = 0;
          ball.vx[0] = ball.vy[0] = ball.vz[0] = ball.energy[0] = ball.pressure[0] = 0;
          ball.sound_speed[0] = ball.smoothing_length[0] = 1;
          ball.mass[0] = 64000, ball.density[0] = 1000;
          ball.part[0] = 0, ball.id[0] = 0;
          const Frame frame{0, particles_to_vtk(ball, 0), nullptr};
          CHECK(contrast(luminance(middle_of(frame, options, {-2, 2, -2, 2, -2, 2})), ground) >= 2);
        }
      }
}

TEST_CASE("a bird and a target that both show a field have maps and titles of their own", "[pictures]")
{
  const Frame frame = made_frame();
  SnapshotOptions options = small(View::isometric);
  options.colour_by = "pressure";
  options.range = {{1e9, 2e9}}; // the lowest colour everywhere, of both
  CHECK(ranges_of({frame}, options).target_map == ColourMap::viridis);
  options.target_field = "peak_contact_pressure";
  options.target_range = {{1e12, 2e12}};
  CHECK(ranges_of({frame}, options).target_map == ColourMap::heat);
  CHECK(ranges_of({{0, nullptr, frame.target}}, options).target_map == ColourMap::viridis);
  Snapshot snapshot(options, bounds_of(frame));
  const auto image = snapshot.draw(frame);
  const Pixels p(*image);
  const auto violet = [](const unsigned char* c) { return c[2] > c[1] + 10 && c[0] > c[1] && c[1] < 60; };
  const auto pale = [](const unsigned char* c) {
    return c[0] > 180 && c[1] > 170 && c[2] > 150 && c[0] > c[2] + 4;
  };
  CHECK(count(p, 0.1, 0.7, 0.1, 0.9, violet) > 2000); // the bird
  CHECK(count(p, 0.1, 0.7, 0.1, 0.9, pale) > 3000);   // the plate
  // Darker the higher the value: lightness falls all the way.
  const auto map = make_colour_map(0, 1, ColourMap::heat);
  double before = 1;
  for (double value = 0; value <= 1; value += 0.125) {
    std::array<double, 3> colour{};
    map->GetColor(value, colour.data());
    CHECK(luminance(colour) < before);
    before = luminance(colour);
  }

  const Rectangle upright{0, 0, 77, 200}, lying{0, 0, 400, 50};
  for (const Rectangle& place : {upright, lying}) {
    CHECK(bar_title_font(place, "pressure", 10) == 10);
    CHECK(bar_title_font(place, "peak_contact_pressure", 10) == 10); // on several lines
    CHECK(bar_title_font(place, "a_word_that_is_far_tooooooooooooooooooooooooo_long", 10) < 10);
  }
}

TEST_CASE("a picture for print says how large it is", "[pictures]")
{
  const TemporaryFolder folder;
  write_png(*canvas_of(64, 64, 200), folder.path / "p.png", 300);
  std::ifstream in(folder.path / "p.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  REQUIRE(bytes.size() > 54);
  CHECK(bytes.substr(37, 4) == "pHYs");
  const auto number = [&](std::size_t at) {
    unsigned int value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = 256 * value + static_cast<unsigned char>(bytes[at + k]);
    return value;
  };
  CHECK(number(33) == 9);     // bytes of data
  CHECK(number(41) == 11811); // 300 dots per inch, per metre
  CHECK(number(45) == 11811);
  CHECK(bytes[49] == 1); // of a metre
  // The checksum of this very chunk as other programs write it.
  CHECK(number(50) == 0x78a53f76);
}
