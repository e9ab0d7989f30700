// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FeedbackProgram
 * @brief Shaders that write rows of a table instead of pixels (transform feedback of OpenGL 3.2).
 *
 * VTK's vtkTransformFeedback supports no integer outputs and compiles its shaders again for every
 * buffer. All methods require that the context of the window is current and that none of VTK's
 * programs is in use (see vtkOpenGLShaderCache::ReleaseCurrentShader).
 */
#ifndef camaron_FeedbackProgram_h
#define camaron_FeedbackProgram_h

#include <cstddef>    // for counts
#include <cstdint>    // for starts of blocks
#include <functional> // for draw calls
#include <vector>     // for starts of blocks

namespace camaron
{
class TextureBuffer;
struct ShapeUniforms;

class FeedbackProgram
{
public:
  FeedbackProgram() = default;
  FeedbackProgram(const FeedbackProgram&) = delete;
  FeedbackProgram& operator=(const FeedbackProgram&) = delete;

  /**
   * Compiles the shaders at the first call. Throws std::runtime_error if that fails: "The graphics
   * card cannot <purpose>: ", and the reason.
   *
   * @param geometry may be null: then every input point writes one row
   * @param output name of the shader variable that is written
   */
  void Build(const char* purpose, const char* vertex, const char* geometry, const char* output);

  /// Makes the program current, for setting uniforms and for Run.
  void Use() const;
  void SetUniform(const char* name, int value) const;
  void SetUniform(const char* name, float value) const;
  /// Sets the uniforms of InShape.glsl.
  void SetShape(const ShapeUniforms& shape) const;
  /// Binds @a table to texture unit @a unit as the sampler @a name.
  void SetTable(const char* name, const TextureBuffer& table, int unit) const;

  /**
   * Runs the vertex shader for @a numberOfPoints points and writes to the rows of @a output. Rows
   * that exceed its size are lost.
   *
   * @return the number of rows written
   */
  std::size_t Run(std::size_t numberOfPoints, TextureBuffer& output) const;

  /**
   * Runs the shaders for all points that @a draw draws with DrawBlocks; @a draw may set uniforms
   * between its calls. If @a output is too small for all rows, it is enlarged and @a draw is called
   * a second time.
   *
   * @return the number of rows written
   */
  std::size_t RunToEnd(TextureBuffer& output, const std::function<void()>& draw) const;
  /**
   * Draws the points of the wanted blocks; adjacent blocks share a draw call.
   *
   * @param starts the first point of each block, and the end of the last one
   */
  void DrawBlocks(const std::vector<std::uint32_t>& starts,
    const std::function<bool(std::size_t block)>& isWanted) const;

  void Release();

private:
  std::size_t Run(TextureBuffer& output, const std::function<void()>& draw) const;
  void Draw(std::size_t firstPoint, std::size_t numberOfPoints) const;

  unsigned int Program = 0;
  unsigned int VertexArray = 0;
  unsigned int Query = 0;
};
}

#endif
