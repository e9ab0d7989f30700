// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelChoice.h"

#include "VisiblePixels.h"

#include "vtkMatrix4x4.h"

#include <cmath>
#include <functional>
#include <string>
#include <tuple>

namespace camaron
{
namespace
{
/// Size, in pixels, of the blocks that record where labels are.
constexpr int Block = 4;
/// Candidates that are tried per label, to limit the time if labels already cover the mesh.
constexpr std::size_t TriesPerLabel = 200;
/// Distance in pixels within which a triangle is searched around its vertex, whose pixel it need
/// not cover.
constexpr int Reach = 2;

int RoundDown(double value)
{
  return static_cast<int>(std::floor(value));
}
}

//------------------------------------------------------------------------------
LabelChoice::LabelChoice(const LabelMesh& mesh, const LabelStyle& style, const Picture& picture)
  : Mesh(mesh)
  , Style(style)
  , Of(picture)
  , TakenWidth((picture.Width + Block - 1) / Block)
  , Taken(static_cast<std::size_t>(TakenWidth) * ((picture.Height + Block - 1) / Block))
{
}

//------------------------------------------------------------------------------
bool LabelChoice::Candidate::operator>(const Candidate& other) const
{
  const auto key = [](const Candidate& candidate)
  {
    return std::make_tuple(
      candidate.Distance, candidate.Kind, candidate.First, candidate.Second, candidate.Entry);
  };
  return key(*this) > key(other);
}

//------------------------------------------------------------------------------
std::vector<IdLabel> LabelChoice::Choose()
{
  this->Gather();
  const auto isFarther = std::greater<Candidate>();
  auto end = this->Candidates.end();
  std::make_heap(this->Candidates.begin(), end, isFarther);
  std::vector<IdLabel> labels;
  const auto size = static_cast<std::size_t>(this->Style.MaxLabels);
  for (std::size_t tries = TriesPerLabel * size;
    tries > 0 && labels.size() < size && end != this->Candidates.begin(); --tries)
  {
    std::pop_heap(this->Candidates.begin(), end, isFarther);
    --end;
    IdLabel label;
    if (this->Try(*end, label))
    {
      labels.push_back(label);
    }
  }
  return labels;
}

//------------------------------------------------------------------------------
void LabelChoice::Gather()
{
  this->HasPoint.resize(this->Style.Has(LabelKind::Point) ? this->Mesh.GetNumberOfPoints() : 0);
  this->HasFace.resize(2 * this->Mesh.GetNumberOfFaces());
  this->HasCell.resize(this->Of.Entries ? this->Mesh.GetNumberOfCells() : 0);
  if (this->Of.Entries)
  {
    for (const std::uint32_t entry : *this->Of.Entries)
    {
      this->GatherEntry(entry);
    }
    return;
  }
  std::vector<bool> isKnown(2 * this->Mesh.GetNumberOfTriangles());
  std::uint32_t last = VisiblePixels::Nothing;
  for (const std::uint32_t pixel : this->Of.Pixels.GetEntries())
  {
    if (pixel != last && pixel != VisiblePixels::Nothing && !isKnown[pixel - 1])
    {
      isKnown[pixel - 1] = true;
      this->GatherEntry(pixel - 1);
    }
    last = pixel;
  }
}

//------------------------------------------------------------------------------
void LabelChoice::GatherEntry(std::uint32_t entry)
{
  const std::array<std::uint32_t, 4>& triangle = this->Mesh.GetTriangle(entry >> 1);
  const std::uint32_t face = this->Mesh.GetFace(entry), cell = this->Mesh.GetCell(entry);
  if (this->Mesh.IsHidden(cell))
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    const std::uint32_t point = triangle[i], next = triangle[(i + 1) % 3];
    // If cells are moved, each cell has its points at its own positions.
    if (this->Style.Has(LabelKind::Point) && !this->Mesh.IsGhostPoint(point) &&
      (this->Mesh.MovesCells() || !this->HasPoint[point]))
    {
      this->HasPoint[point] = true;
      this->Add(LabelKind::Point, point, 0, entry);
    }
    if (this->Style.Has(LabelKind::Edge) && (triangle[3] & (1u << i)))
    {
      this->Add(LabelKind::Edge, std::min(point, next), std::max(point, next), entry);
    }
  }
  const std::size_t side = 2 * static_cast<std::size_t>(face) + (entry & 1u);
  if (this->HasFace[side])
  {
    return;
  }
  this->HasFace[side] = true;
  if (this->Style.Has(LabelKind::Face))
  {
    this->Add(LabelKind::Face, face, 0, entry);
  }
  if (this->Style.Has(LabelKind::Cell) && (!this->Of.Entries || !this->HasCell[cell]))
  {
    if (this->Of.Entries)
    {
      this->HasCell[cell] = true;
    }
    this->Add(LabelKind::Cell, cell, 0, entry);
  }
}

//------------------------------------------------------------------------------
void LabelChoice::Add(
  LabelKind kind, std::uint32_t first, std::uint32_t second, std::uint32_t entry)
{
  Candidate candidate{ 0, kind, first, second, entry };
  const Place place = this->GetPlace(candidate);
  double pixel[2], depth;
  if (this->Mesh.IsCutAway(place) || !this->Project(place, pixel, depth))
  {
    return;
  }
  const double from[4] = { place[0], place[1], place[2], 1 };
  double inView[4];
  this->Of.ToView->MultiplyPoint(from, inView);
  candidate.Distance = static_cast<float>(this->Of.IsParallel
      ? -inView[2]
      : std::sqrt(inView[0] * inView[0] + inView[1] * inView[1] + inView[2] * inView[2]));
  this->Candidates.push_back(candidate);
}

//------------------------------------------------------------------------------
Place LabelChoice::GetPlace(const Candidate& candidate) const
{
  const std::uint32_t cell = this->Mesh.GetCell(candidate.Entry);
  switch (candidate.Kind)
  {
    case LabelKind::Point:
      return this->Mesh.GetPoint(candidate.First, cell);
    case LabelKind::Edge:
    {
      const Place a = this->Mesh.GetPoint(candidate.First, cell);
      const Place b = this->Mesh.GetPoint(candidate.Second, cell);
      return { { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 } };
    }
    case LabelKind::Cell:
      if (this->Of.Entries)
      {
        return this->Mesh.GetCellCenter(cell);
      }
      break;
    default:
      break;
  }
  return this->Mesh.GetFaceCenter(this->Mesh.GetFace(candidate.Entry), cell);
}

//------------------------------------------------------------------------------
// False if the position is outside the view.
bool LabelChoice::Project(const Place& place, double pixel[2], double& depth) const
{
  const double from[4] = { place[0], place[1], place[2], 1 };
  double at[4];
  this->Of.ToDisplay->MultiplyPoint(from, at);
  if (!(at[3] > 0) ||
    !(std::abs(at[0]) < at[3] && std::abs(at[1]) < at[3] && std::abs(at[2]) < at[3]))
  {
    return false;
  }
  pixel[0] = (at[0] / at[3] + 1) / 2 * this->Of.Width;
  pixel[1] = (at[1] / at[3] + 1) / 2 * this->Of.Height;
  depth = (at[2] / at[3] + 1) / 2;
  return true;
}

//------------------------------------------------------------------------------
bool LabelChoice::IsPartOf(const Candidate& candidate, std::uint32_t entry) const
{
  const std::array<std::uint32_t, 4>& triangle = this->Mesh.GetTriangle(entry >> 1);
  const auto has = [&](std::uint32_t point)
  { return triangle[0] == point || triangle[1] == point || triangle[2] == point; };
  const bool isSameCell = this->Mesh.GetCell(entry) == this->Mesh.GetCell(candidate.Entry);
  switch (candidate.Kind)
  {
    case LabelKind::Point:
      return has(candidate.First) && (isSameCell || !this->Mesh.MovesCells());
    case LabelKind::Edge:
      return has(candidate.First) && has(candidate.Second) &&
        (isSameCell || !this->Mesh.MovesCells());
    default:
      return isSameCell && this->Mesh.GetFace(entry) == this->Mesh.GetFace(candidate.Entry);
  }
}

//------------------------------------------------------------------------------
// Whether a pixel near that of the element shows the element.
bool LabelChoice::IsSeen(const Candidate& candidate, const double pixel[2]) const
{
  const int column = RoundDown(pixel[0]), row = RoundDown(pixel[1]);
  const std::vector<std::uint32_t>& entries = this->Of.Pixels.GetEntries();
  for (int y = std::max(row - Reach, 0); y <= std::min(row + Reach, this->Of.Height - 1); ++y)
  {
    for (int x = std::max(column - Reach, 0); x <= std::min(column + Reach, this->Of.Width - 1);
      ++x)
    {
      const std::uint32_t entry = entries[static_cast<std::size_t>(y) * this->Of.Width + x];
      if (entry != VisiblePixels::Nothing && this->IsPartOf(candidate, entry - 1))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkIdType LabelChoice::GetId(const Candidate& candidate) const
{
  switch (candidate.Kind)
  {
    case LabelKind::Point:
      return this->Mesh.GetPointId(candidate.First);
    case LabelKind::Edge:
      return this->Mesh.GetEdgeId(candidate.First, candidate.Second);
    case LabelKind::Face:
      return this->Mesh.GetFaceId(candidate.Entry);
    default:
      return this->Mesh.GetCellId(candidate.First);
  }
}

//------------------------------------------------------------------------------
// If the rectangle is inside the view and free of labels, marks it as covered and returns true.
bool LabelChoice::Take(const Rectangle& rectangle)
{
  if (rectangle.Left < 0 || rectangle.Bottom < 0 || rectangle.Right > this->Of.Width ||
    rectangle.Top > this->Of.Height)
  {
    return false;
  }
  for (const bool marks : { false, true })
  {
    for (int y = rectangle.Bottom / Block; y <= (rectangle.Top - 1) / Block; ++y)
    {
      for (int x = rectangle.Left / Block; x <= (rectangle.Right - 1) / Block; ++x)
      {
        const std::size_t block = static_cast<std::size_t>(y) * this->TakenWidth + x;
        if (marks)
        {
          this->Taken[block] = true;
        }
        else if (this->Taken[block])
        {
          return false;
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double LabelChoice::FindDepth(const Rectangle& rectangle, double depth) const
{
  const std::vector<float>& depths = this->Of.Pixels.GetDepths();
  for (int y = rectangle.Bottom; y < rectangle.Top; ++y)
  {
    const auto row = depths.begin() + static_cast<std::ptrdiff_t>(y) * this->Of.Width;
    depth = std::min<double>(depth, *std::min_element(row + rectangle.Left, row + rectangle.Right));
  }
  return depth;
}

//------------------------------------------------------------------------------
bool LabelChoice::HasLabel(std::uint32_t entryOfFace) const
{
  const auto face = static_cast<std::uint64_t>(this->Mesh.GetFace(entryOfFace));
  return this->Done[static_cast<int>(LabelKind::Face)].count(face << 32) > 0;
}

//------------------------------------------------------------------------------
bool LabelChoice::Try(const Candidate& candidate, IdLabel& label)
{
  std::unordered_set<std::uint64_t>& done = this->Done[static_cast<int>(candidate.Kind)];
  const std::uint64_t key = static_cast<std::uint64_t>(candidate.First) << 32 | candidate.Second;
  const Place place = this->GetPlace(candidate);
  double pixel[2], depth;
  if (done.count(key) || !this->Project(place, pixel, depth) ||
    (!this->Of.Entries && !this->IsSeen(candidate, pixel)))
  {
    return false;
  }
  label.Id = this->GetId(candidate);
  if (label.Id == ElementNumbers::None)
  {
    return false;
  }
  const DigitSize& digits = this->Of.Digits;
  const int width = static_cast<int>(std::to_string(label.Id).size()) * digits.Width;
  if (candidate.Kind == LabelKind::Point)
  {
    label.Left = RoundDown(pixel[0]) + digits.Margin + 1;
    label.Bottom = RoundDown(pixel[1]) + digits.Margin + 1;
  }
  else
  {
    label.Left = RoundDown(pixel[0] - 0.5 * width);
    label.Bottom = RoundDown(pixel[1] - 0.5 * digits.Height);
    // The label of the face may be at the same position.
    if (candidate.Kind == LabelKind::Cell && !this->Of.Entries && this->HasLabel(candidate.Entry))
    {
      label.Bottom += digits.Height + 2 * digits.Margin + Block;
    }
  }
  const Rectangle rectangle = { label.Left - digits.Margin, label.Bottom - digits.Margin,
    label.Left + width + digits.Margin, label.Bottom + digits.Height + digits.Margin };
  if (!this->Take(rectangle))
  {
    return false;
  }
  done.insert(key);
  label.Kind = candidate.Kind;
  label.At = this->Mesh.AddMiddle(place);
  label.Depth = this->FindDepth(rectangle, depth);
  return true;
}
}
