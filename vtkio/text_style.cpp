// SPDX-License-Identifier: BSD-3-Clause
// How text looks in all pictures.
#include "vtkio/text_style.h"

#include <vtkCoordinate.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <filesystem>

namespace birdstrike {

namespace {

// Where the usual distributions keep a plain sans-serif font.
const std::string& font_file()
{
  static const std::string found = [] {
    for (const char* file :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
          "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
          "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf"})
      if (std::filesystem::exists(file))
        return std::string(file);
    return std::string();
  }();
  return found;
}

} // namespace

void set_text_style(vtkTextProperty& style, int pixels, const std::array<double, 3>& colour)
{
  if (font_file().empty()) {
    style.SetFontFamilyToArial();
  } else {
    style.SetFontFamily(VTK_FONT_FILE);
    style.SetFontFile(font_file().c_str());
  }
  style.SetFontSize(pixels);
  style.SetColor(colour[0], colour[1], colour[2]);
  style.BoldOff();
  style.ItalicOff();
  style.ShadowOff();
}

vtkSmartPointer<vtkTextActor> make_text(const std::string& text, double x, double y, int pixels,
                                        Anchor anchor, const std::array<double, 3>& colour)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  vtkTextProperty& style = *actor->GetTextProperty();
  set_text_style(style, pixels, colour);
  style.SetVerticalJustificationToCentered();
  if (anchor == Anchor::left)
    style.SetJustificationToLeft();
  else if (anchor == Anchor::centre)
    style.SetJustificationToCentered();
  else
    style.SetJustificationToRight();
  actor->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
  actor->SetPosition(x, y);
  return actor;
}

namespace {
constexpr double wide = 0.62; // a letter over its height
}

int fitting_font(int font, double width, std::size_t letters)
{
  return std::max(6, std::min(font, static_cast<int>(width / (wide * static_cast<double>(letters)))));
}

std::size_t fitting_letters(int font, double width)
{
  return static_cast<std::size_t>(std::max(1.0, width / (wide * font)));
}

std::array<double, 3> readable_on(const std::array<double, 3>& background)
{
  const double brightness = 0.299 * background[0] + 0.587 * background[1] + 0.114 * background[2];
  return brightness > 0.5 ? std::array<double, 3>{0, 0, 0} : std::array<double, 3>{1, 1, 1};
}

} // namespace birdstrike
