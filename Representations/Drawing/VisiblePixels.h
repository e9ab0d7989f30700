// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::VisiblePixels
 * @brief The triangle of a mesh that is visible in each pixel, and its depth.
 *
 * The mesh is drawn once more into an off-screen framebuffer, which is read back from the graphics
 * card.
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
    const TextureBuffer* Visible; ///< see VisibleTriangles; null: all triangles in the mesh's table
    std::size_t NumberOfTriangles;
    const InspectionStyle& Style;
    vtkProperty* Property; ///< for face culling
    vtkMatrix4x4* ToDisplay;
    int Width;
    int Height;
  };

  /**
   * Requires that the context is current; restores the state of OpenGL.
   *
   * @throw std::runtime_error if the graphics card cannot do it
   */
  void Draw(vtkOpenGLRenderWindow* window, const Scene& scene);

  /// By rows from the bottom: Nothing, or 1 + (triangle << 1 | side).
  const std::vector<std::uint32_t>& GetEntries() const { return this->Entries; }
  /// From 0 (near) to 1 (far).
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
