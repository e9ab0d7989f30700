// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DigitTexture.h"

#include "vtkImageData.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace camaron
{
namespace
{
constexpr char Digits[] = "0123456789-";
constexpr int NumberOfDigits = 11;
/// Rows of the texture: for each element type the digits, then their outlines.
constexpr int NumberOfRows = 2 * NumberOfLabelKinds;

/// How much of each pixel the digits cover, from 0 to 255. They are next to each other, each in its
/// own cell.
struct Coverage
{
  int Width = 0, Height = 0; // of a cell
  std::vector<unsigned char> Pixels;

  int GetRowSize() const { return NumberOfDigits * this->Width; }
  unsigned char& At(int x, int y) { return this->Pixels[y * this->GetRowSize() + x]; }
  unsigned char Get(int x, int y) const { return this->Pixels[y * this->GetRowSize() + x]; }
};

//------------------------------------------------------------------------------
// The pixels of a text that VTK has rendered, relative to the start of the text.
struct Glyph
{
  vtkNew<vtkImageData> Image;
  int Extent[4] = { 0, -1, 0, -1 };

  bool Write(vtkTextProperty* property, const std::string& text, int dotsPerInch)
  {
    int size[2];
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (!renderer || !renderer->RenderString(property, text, this->Image, size, dotsPerInch))
    {
      return false;
    }
    std::copy_n(this->Image->GetExtent(), 4, this->Extent);
    return true;
  }
  int GetCoverage(int x, int y)
  {
    return static_cast<unsigned char*>(this->Image->GetScalarPointer(x, y, 0))[3];
  }
  bool IsRowEmpty(int y)
  {
    int x = this->Extent[0];
    for (; x <= this->Extent[1] && this->GetCoverage(x, y) == 0; ++x)
    {
    }
    return x > this->Extent[1];
  }
};

//------------------------------------------------------------------------------
// Distance from the start of a digit to that of the next one.
int FindAdvance(vtkTextProperty* property, int dotsPerInch)
{
  int advance = 1;
  for (int i = 0; i < NumberOfDigits; ++i)
  {
    const std::string one(1, Digits[i]);
    int single[4], pair[4];
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (renderer->GetBoundingBox(property, one, single, dotsPerInch) &&
      renderer->GetBoundingBox(property, one + one, pair, dotsPerInch))
    {
      advance = std::max(advance, (pair[1] - pair[0]) - (single[1] - single[0]));
    }
  }
  return advance;
}

//------------------------------------------------------------------------------
// False if VTK cannot render text.
bool WriteDigits(vtkTextProperty* property, int dotsPerInch, DigitSize& size, Coverage& coverage)
{
  std::array<Glyph, NumberOfDigits> glyphs;
  int bottom = VTK_INT_MAX, top = VTK_INT_MIN;
  for (int i = 0; i < NumberOfDigits; ++i)
  {
    Glyph& glyph = glyphs[i];
    if (!glyph.Write(property, std::string(1, Digits[i]), dotsPerInch))
    {
      return false;
    }
    for (int y = glyph.Extent[2]; y <= glyph.Extent[3]; ++y)
    {
      if (!glyph.IsRowEmpty(y))
      {
        bottom = std::min(bottom, y);
        top = std::max(top, y);
      }
    }
  }
  size.Width = FindAdvance(property, dotsPerInch);
  size.Height = std::max(top - bottom + 1, 1);
  size.Margin = std::max(size.Height / 8, 1) + 1;
  coverage.Width = size.Width + 2 * size.Margin;
  coverage.Height = size.Height + 2 * size.Margin;
  coverage.Pixels.assign(static_cast<std::size_t>(coverage.GetRowSize()) * coverage.Height, 0);
  for (int i = 0; i < NumberOfDigits; ++i)
  {
    Glyph& glyph = glyphs[i];
    for (int y = std::max(glyph.Extent[2], bottom); y <= std::min(glyph.Extent[3], top); ++y)
    {
      for (int x = glyph.Extent[0]; x <= glyph.Extent[1]; ++x)
      {
        const int column = size.Margin + x;
        if (column >= 0 && column < coverage.Width)
        {
          coverage.At(i * coverage.Width + column, size.Margin + y - bottom) =
            static_cast<unsigned char>(glyph.GetCoverage(x, y));
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The digits, dilated on all sides.
Coverage MakeRims(const Coverage& digits, int width)
{
  Coverage rims = digits;
  for (int y = 0; y < digits.Height; ++y)
  {
    for (int x = 0; x < digits.GetRowSize(); ++x)
    {
      const int first = x / digits.Width * digits.Width, last = first + digits.Width - 1;
      unsigned char largest = 0;
      for (int j = std::max(y - width, 0); j <= std::min(y + width, digits.Height - 1); ++j)
      {
        for (int i = std::max(x - width, first); i <= std::min(x + width, last); ++i)
        {
          const bool isNear = (i - x) * (i - x) + (j - y) * (j - y) <= width * width + 1;
          largest = isNear ? std::max(largest, digits.Get(i, j)) : largest;
        }
      }
      rims.At(x, y) = largest;
    }
  }
  return rims;
}

//------------------------------------------------------------------------------
// By luminance, Rec. 709.
bool IsBright(const Color& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2] > 0.5;
}

//------------------------------------------------------------------------------
void Paint(vtkImageData* image, int row, const Coverage& coverage, const Color& color)
{
  for (int y = 0; y < coverage.Height; ++y)
  {
    auto* pixel =
      static_cast<unsigned char*>(image->GetScalarPointer(0, row * coverage.Height + y, 0));
    for (int x = 0; x < coverage.GetRowSize(); ++x)
    {
      for (int k = 0; k < 3; ++k)
      {
        *pixel++ = static_cast<unsigned char>(std::lround(255 * color[k]));
      }
      *pixel++ = coverage.Get(x, y);
    }
  }
}
}

//------------------------------------------------------------------------------
DigitTexture::DigitTexture()
{
  this->Texture->InterpolateOff();
  this->Texture->RepeatOff();
  this->Texture->SetColorModeToDirectScalars();
}

//------------------------------------------------------------------------------
bool DigitTexture::Update(const LabelStyle& style, int dotsPerInch)
{
  if (this->FontSize == style.FontSize && this->DotsPerInch == dotsPerInch &&
    this->Colors == style.Colors)
  {
    return true;
  }
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial();
  property->BoldOn();
  property->SetFontSize(std::max(style.FontSize, 1));
  property->SetColor(1, 1, 1);
  property->SetJustificationToLeft();
  property->SetVerticalJustificationToBottom();
  Coverage digits;
  if (!WriteDigits(property, dotsPerInch, this->Size, digits))
  {
    return false;
  }
  const Coverage rims = MakeRims(digits, this->Size.Margin - 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(digits.GetRowSize(), NumberOfRows * digits.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int kind = 0; kind < NumberOfLabelKinds; ++kind)
  {
    const Color& color = style.Colors[kind];
    Paint(image, 2 * kind, digits, color);
    Paint(image, 2 * kind + 1, rims, IsBright(color) ? Color{ { 0, 0, 0 } } : Color{ { 1, 1, 1 } });
  }
  this->Texture->SetInputData(image);
  this->FontSize = style.FontSize;
  this->DotsPerInch = dotsPerInch;
  this->Colors = style.Colors;
  return true;
}

//------------------------------------------------------------------------------
std::array<float, 4> DigitTexture::GetPlace(char digit, LabelKind kind, bool isRim) const
{
  const char* found = std::strchr(Digits, digit);
  const float column = static_cast<float>(found ? found - Digits : 0);
  const float row = static_cast<float>(2 * static_cast<int>(kind) + (isRim ? 1 : 0));
  return { { column / NumberOfDigits, row / NumberOfRows, (column + 1) / NumberOfDigits,
    (row + 1) / NumberOfRows } };
}
}
