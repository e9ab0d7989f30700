// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::VisiblePixels
 * @brief Which triangle of a mesh is seen in which pixel, and how far away.
 *
 * The mesh is drawn once more, out of sight, and the picture is fetched from the graphics card.
 */
#ifndef camaron_VisiblePixels_h
#define camaron_VisiblePixels_h

#include <cstddef> // for sizes
#include <cstdint> // for the pixels
#include <vector>  // for the pixels

class vtkMatrix4x4;
class vtkOpenGLRenderWindow;
class vtkProperty;

namespace camaron
{
class InspectionMesh;
class TextureBuffer;
struct InspectionStyle;

class VisiblePixels
{
public:
  static constexpr std::uint32_t Nothing = 0;

  struct Scene
  {
    const InspectionMesh& Mesh;
    const TextureBuffer* Visible; ///< see VisibleTriangles; null: the triangles that are stored
    std::size_t NumberOfTriangles;
    const InspectionStyle& Style;
    vtkProperty* Property; ///< tells which sides of faces are left out
    vtkMatrix4x4* ToDisplay;
    int Width;
    int Height;
  };

  /**
   * Needs the context current; leaves the state of OpenGL as it was.
   * @throw std::runtime_error when the graphics card refuses
   */
  void Draw(vtkOpenGLRenderWindow* window, const Scene& scene);

  /// Row by row from below: Nothing or 1 + (triangle << 1 | side).
  const std::vector<std::uint32_t>& GetEntries() const { return this->Entries; }
  /// From 0, near, to 1.
  const std::vector<float>& GetDepths() const { return this->Depths; }

  void Release();

private:
  void Resize(int width, int height);
  void DrawTriangles(vtkOpenGLRenderWindow* window, const Scene& scene);

  unsigned int Framebuffer = 0;
  unsigned int Buffers[2] = { 0, 0 };
  unsigned int VertexArray = 0;
  int Size[2] = { 0, 0 };
  std::vector<std::uint32_t> Entries;
  std::vector<float> Depths;
};
}

#endif
