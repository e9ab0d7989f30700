// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/Orientation.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// A sum without rounding: non-overlapping numbers, the largest last.
class ExpandedSum
{
public:
  void AddProduct(double a, double b)
  {
    const double product = a * b;
    this->Add(std::fma(a, b, -product));
    this->Add(product);
  }
  double GetLargest() const { return this->Size > 0 ? this->Parts[this->Size - 1] : 0; }

private:
  void Add(double sum)
  {
    int kept = 0;
    for (int i = 0; i < this->Size; ++i)
    {
      const double part = this->Parts[i], total = sum + part, virtualPart = total - sum;
      const double rest = (sum - (total - virtualPart)) + (part - virtualPart);
      if (rest != 0)
      {
        this->Parts[kept++] = rest;
      }
      sum = total;
    }
    if (sum != 0)
    {
      this->Parts[kept++] = sum;
    }
    this->Size = kept;
  }

  static constexpr int MaxParts = 12; // of six products
  double Parts[MaxParts];
  int Size = 0;
};
}

//------------------------------------------------------------------------------
double OrientExactly(const Vector& a, const Vector& b, const Vector& c)
{
  ExpandedSum sum;
  sum.AddProduct(a.X, b.Y);
  sum.AddProduct(-a.Y, b.X);
  sum.AddProduct(b.X, c.Y);
  sum.AddProduct(-b.Y, c.X);
  sum.AddProduct(c.X, a.Y);
  sum.AddProduct(-c.Y, a.X);
  return sum.GetLargest();
}
}
