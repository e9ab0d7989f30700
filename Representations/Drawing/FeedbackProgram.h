// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FeedbackProgram
 * @brief Shaders that compute rows of a table instead of pixels (transform feedback of OpenGL 3.2).
 *
 * VTK's vtkTransformFeedback knows no integer outputs and has its shaders compiled anew for every
 * buffer. All methods need the context of the window current, and none of VTK's programs in use
 * (see vtkOpenGLShaderCache::ReleaseCurrentShader).
 */
#ifndef camaron_FeedbackProgram_h
#define camaron_FeedbackProgram_h

#include <cstddef>    // for counts
#include <cstdint>    // for where blocks begin
#include <functional> // for what is drawn
#include <string>     // for errors
#include <vector>     // for where blocks begin

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
   * Compiles the shaders, once.
   * @param geometry null: every input point gives one output row
   * @param output the name of the variable that is written
   * @return true when the program is ready; else GetError says why not
   */
  bool Build(const char* vertex, const char* geometry, const char* output);
  const std::string& GetError() const { return this->Error; }

  /// Makes the program the current one, for the uniforms that follow and for Run.
  void Use() const;
  void SetUniform(const char* name, int value) const;
  void SetUniform(const char* name, float value) const;
  /// The uniforms of InShape.glsl.
  void SetShape(const ShapeUniforms& shape) const;
  /// Makes @a table the sampler @a name, through texture unit @a unit.
  void SetTable(const char* name, const TextureBuffer& table, int unit) const;

  /**
   * Runs the vertex shader for @a numberOfPoints points and writes to the rows of @a output, as
   * many as it has at most.
   * @return the number of rows written
   */
  std::size_t Run(std::size_t numberOfPoints, TextureBuffer& output) const;

  /**
   * The same for all points that @a draw draws, which calls DrawBlocks and may set uniforms
   * between. When
   * @a output has no room for all rows it gets more, and @a draw is called once more.
   */
  std::size_t RunToEnd(TextureBuffer& output, const std::function<void()>& draw) const;
  /// @param starts where the points of each block begin, and the end; those of wanted neighbors
  /// are drawn together
  void DrawBlocks(const std::vector<std::uint32_t>& starts,
    const std::function<bool(std::size_t block)>& isWanted) const;

  void Release();

private:
  std::size_t Run(TextureBuffer& output, const std::function<void()>& draw) const;
  void Draw(std::size_t firstPoint, std::size_t numberOfPoints) const;

  unsigned int Program = 0;
  unsigned int VertexArray = 0;
  unsigned int Query = 0;
  std::string Error;
};
}

#endif
