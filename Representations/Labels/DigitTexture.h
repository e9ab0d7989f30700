// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::DigitTexture
 * @brief The digits of labels in one texture, rendered by VTK, in the color of each element type,
 * with an outline.
 *
 * The outline is white for dark colors and black for bright ones, so that labels are readable on
 * any background.
 */
#ifndef camaron_DigitTexture_h
#define camaron_DigitTexture_h

#include "LabelChoice.h"

#include "vtkNew.h"     // for the texture
#include "vtkTexture.h" // for the texture

namespace camaron
{
class DigitTexture
{
public:
  DigitTexture();

  /// Renders the digits if their look has changed. False if VTK cannot render text.
  bool Update(const LabelStyle& style, int dotsPerInch);

  const DigitSize& GetSize() const { return this->Size; }
  /// Texture coordinates of a digit with its margin: left, bottom, right, top. @a digit may be '-'.
  std::array<float, 4> GetPlace(char digit, LabelKind kind, bool isRim) const;
  vtkTexture* GetTexture() { return this->Texture; }

private:
  vtkNew<vtkTexture> Texture;
  DigitSize Size;
  int FontSize = 0;
  int DotsPerInch = 0;
  OfLabelKinds<Color> Colors;
};
}

#endif
