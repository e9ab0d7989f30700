// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::DigitTexture
 * @brief The digits of labels as one picture, written by VTK, in the color of each kind, with a
 * rim around them.
 *
 * The rim is white for dark colors and black for bright ones, so that a label is readable before
 * anything.
 */
#ifndef camaron_DigitTexture_h
#define camaron_DigitTexture_h

#include "LabelChoice.h"

#include "vtkNew.h" // for the texture

class vtkTexture;

namespace camaron
{
class DigitTexture
{
public:
  DigitTexture();
  ~DigitTexture();

  /// Writes the digits anew if they have to look otherwise. False when VTK has no text.
  bool Update(const LabelStyle& style, int dotsPerInch);

  const DigitSize& GetSize() const { return this->Size; }
  /// Where in the texture: left, bottom, right, top; a digit with its margin. @a digit may be '-'.
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
